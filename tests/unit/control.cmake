farrier_test(control_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control_discretise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_model_analysis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_transfer_function_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_riccati_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_riccati_slicot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_low_pass_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_lqr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_spectrum_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_delay_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_force_controller_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_probe_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_tracking_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_test PRIVATE farrier_control)

farrier_test(feedback_linearisation_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control_feedback_linearisation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(feedback_linearisation_test PRIVATE farrier_control farrier_plant)

farrier_test(control_design_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control_pole_placement_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_margins_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_switching_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_design_test PRIVATE farrier_control)

farrier_test(control_laws_test unit
  ${CMAKE_CURRENT_LIST_DIR}/control_delay_predictor_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_effect_compensation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_effect_inverses_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_pid_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/control_flow_inversion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(control_laws_test PRIVATE farrier_control farrier_plant)

farrier_test(control_darex_test unit ${CMAKE_CURRENT_LIST_DIR}/control_darex_test.cpp)
target_link_libraries(control_darex_test PRIVATE farrier_control)

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
