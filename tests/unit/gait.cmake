farrier_test(gait_test unit
  ${CMAKE_CURRENT_LIST_DIR}/gait_feed_forward_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait_leg_kinematics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait_params_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait_reference_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait_schedule_test.cpp)
target_link_libraries(gait_test PRIVATE farrier_gait)
