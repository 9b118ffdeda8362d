farrier_test(ros_messages_test unit
  ${CMAKE_CURRENT_LIST_DIR}/ros_messages/cdr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/ros_messages/type_hash_test.cpp)
target_link_libraries(ros_messages_test PRIVATE farrier_ros_messages)
