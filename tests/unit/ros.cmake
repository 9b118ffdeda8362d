farrier_test(ros_messages_test unit
  ${CMAKE_CURRENT_LIST_DIR}/ros_messages/cdr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_messages/type_hash_test.cpp)
target_link_libraries(ros_messages_test PRIVATE farrier_ros_messages)

farrier_test(ros_view_test unit
  ${CMAKE_CURRENT_LIST_DIR}/ros_view/conversions_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_view/robot_messages_test.cpp)
target_link_libraries(ros_view_test PRIVATE farrier_body farrier_ros_view)
target_compile_definitions(ros_view_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

farrier_test(ros_bridge_test unit
  ${CMAKE_CURRENT_LIST_DIR}/ros_bridge/asked_joints_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_bridge/joint_references_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_bridge/ros2_control_example_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_bridge/velocity_commands_test.cpp)
target_link_libraries(ros_bridge_test PRIVATE farrier_ros_bridge)
target_compile_definitions(ros_bridge_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

if(TARGET farrier_foxglove)
  farrier_test(foxglove_viewers_test unit ${CMAKE_CURRENT_LIST_DIR}/foxglove/viewers_test.cpp)
  target_link_libraries(foxglove_viewers_test PRIVATE farrier_foxglove Threads::Threads)
endif()
