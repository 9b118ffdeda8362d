farrier_test(estimation_test unit
  ${CMAKE_CURRENT_LIST_DIR}/estimation_rls_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_rls_safety_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_directional_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_gate_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_joint_methods_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_methods_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_joint_memory_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_joint_safety_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_poles_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_prediction_errors_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_stable_map_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_washout_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/allocation_guard.cpp)
target_link_libraries(estimation_test PRIVATE farrier_estimation)

farrier_test(estimation_grey_box_test unit
  ${CMAKE_CURRENT_LIST_DIR}/estimation_grey_box_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation_grey_box_safety_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/allocation_guard.cpp)
target_link_libraries(estimation_grey_box_test PRIVATE farrier_estimation)
