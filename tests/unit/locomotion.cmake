farrier_test(locomotion_test unit
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/estimation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/force_distribution_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/joint_guard_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/own_controller_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/payload_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/planning_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/supply_guard_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/locomotion/trot_controller_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/allocation_guard.cpp)
target_link_libraries(locomotion_test PRIVATE farrier_locomotion)
