# A robot as a node of ROS 2, by the label ros.
set(ros_dir ${CMAKE_CURRENT_LIST_DIR})
find_package(CycloneDDS REQUIRED)  # whose imported targets are seen where it is found only
farrier_test(ros_node_test ros ${ros_dir}/graph_test.cpp ${ros_dir}/ros_node_test.cpp ${ros_dir}/wire_test.cpp)
target_link_libraries(ros_node_test PRIVATE farrier_bus_ros CycloneDDS::ddsc Threads::Threads)

farrier_test(ros_command_test ros ${ros_dir}/ros_command_test.cpp ${ros_dir}/../system/farrier_command.cpp)
if(TARGET farrier_body_world)
  target_sources(ros_command_test PRIVATE ${ros_dir}/velocity_command_test.cpp)
endif()
target_include_directories(ros_command_test PRIVATE ${ros_dir}/../system)
target_link_libraries(ros_command_test PRIVATE farrier_bus farrier_bus_ros farrier_cli_processes farrier_signals
  farrier_tool_process farrier_trace farrier_urdf nlohmann_json::nlohmann_json Threads::Threads)
target_compile_definitions(ros_command_test PRIVATE ${system_definitions})
add_dependencies(ros_command_test farrier farrier_program_ros bare_exchange ${FARRIER_PROCESSES})
