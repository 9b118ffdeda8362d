farrier_test(gait_test unit
  ${CMAKE_CURRENT_LIST_DIR}/gait/feed_forward_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait/leg_kinematics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait/params_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait/reference_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait/schedule_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gait/stepping_test.cpp)
target_link_libraries(gait_test PRIVATE farrier_gait)
