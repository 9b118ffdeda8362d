# A robot as a node of ROS 2, by the label ros.
set(ros_dir ${CMAKE_CURRENT_LIST_DIR})
find_package(CycloneDDS REQUIRED)  # whose imported targets are seen where it is found only
farrier_test(ros_node_test ros ${ros_dir}/graph_test.cpp ${ros_dir}/ros_node_test.cpp ${ros_dir}/wire_test.cpp)
target_link_libraries(ros_node_test PRIVATE farrier_bus_ros CycloneDDS::ddsc Threads::Threads)
