farrier_test(control_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control/discretise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/model_analysis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/transfer_function_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/riccati_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/riccati_slicot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/low_pass_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/lqr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/spectrum_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/delay_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/force_controller_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/probe_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/tracking_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_test PRIVATE test_solvers farrier_control farrier_textbook)

farrier_test(feedback_linearisation_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control/feedback_linearisation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(feedback_linearisation_test PRIVATE farrier_control farrier_plant)

farrier_test(control_design_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control/pole_placement_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/margins_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/switching_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_design_test PRIVATE test_solvers farrier_control farrier_textbook)

farrier_test(control_laws_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control/delay_predictor_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/effect_compensation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/effect_inverses_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/pid_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control/flow_inversion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_laws_test PRIVATE farrier_control farrier_plant)

farrier_test(control_darex_test unit ${CMAKE_CURRENT_LIST_DIR}/control/darex_test.cpp)
target_link_libraries(control_darex_test PRIVATE farrier_textbook)

# SLICOT, where installed, is a second opinion on the Riccati equation.
find_library(FARRIER_SLICOT_LIBRARY slicot)
find_library(FARRIER_LAPACK_LIBRARY lapack)
find_library(FARRIER_BLAS_LIBRARY blas)
if(FARRIER_SLICOT_LIBRARY AND FARRIER_LAPACK_LIBRARY AND FARRIER_BLAS_LIBRARY)
  foreach(test IN ITEMS control_test control_darex_test)
    target_compile_definitions(${test} PRIVATE FARRIER_HAVE_SLICOT=1)
    target_link_libraries(${test} PRIVATE
      ${FARRIER_SLICOT_LIBRARY} ${FARRIER_LAPACK_LIBRARY} ${FARRIER_BLAS_LIBRARY})
  endforeach()
endif()
