farrier_test(control_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control/darex_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/delay_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/delay_predictor_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/discretise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/effect_compensation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/effect_inverses_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/feedback_linearisation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/flow_inversion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/force_controller_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/low_pass_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/lqr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/margins_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/model_analysis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/pid_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/pole_placement_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/probe_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/riccati_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/riccati_slicot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/spectrum_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/switching_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/tracking_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/transfer_function_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
set_target_properties(control_test PROPERTIES UNITY_BUILD_BATCH_SIZE 8)  # Eigen: a compiler process stays below 1.5 GB
# SLICOT is a second opinion on the Riccati equation.
target_link_libraries(control_test PRIVATE test_solvers farrier_control farrier_plant farrier_textbook
  ${FARRIER_SLICOT_LIBRARY} ${FARRIER_LAPACK_LIBRARY} ${FARRIER_BLAS_LIBRARY})
