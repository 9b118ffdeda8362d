farrier_test(estimation_test unit
  ${CMAKE_CURRENT_LIST_DIR}/estimation/rls_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/rls_safety_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/directional_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/gate_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/grey_box_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/grey_box_safety_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/joint_methods_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/methods_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/joint_memory_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/joint_safety_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/poles_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/prediction_errors_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/stable_map_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/washout_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/allocation_guard.cpp)
set_target_properties(estimation_test PROPERTIES UNITY_BUILD_BATCH_SIZE 8)  # Eigen: a compiler process stays below 1.5 GB
target_link_libraries(estimation_test PRIVATE test_solvers farrier_textbook farrier_estimation)
