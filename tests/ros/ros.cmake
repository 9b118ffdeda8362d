# A robot as a node of ROS 2, by the label ros.
set(ros_dir ${CMAKE_CURRENT_LIST_DIR})
find_package(CycloneDDS REQUIRED)  # whose imported targets are seen where it is found only
farrier_test(ros_node_test ros ${ros_dir}/graph_test.cpp ${ros_dir}/ros_node_test.cpp ${ros_dir}/wire_test.cpp)
target_link_libraries(ros_node_test PRIVATE farrier_bus_ros CycloneDDS::ddsc Threads::Threads)

# Writers as nodes of both vendors of ROS 2 have them.
add_library(ros_sender STATIC ${ros_dir}/sender.cpp)
target_link_libraries(ros_sender PUBLIC farrier_flags farrier_bus_ros PRIVATE CycloneDDS::ddsc GTest::gtest)
if(TARGET farrier_bus_fastdds)
  target_sources(ros_sender PRIVATE ${ros_dir}/fast_sender.cpp)
  target_link_libraries(ros_sender PRIVATE farrier_bus_fastdds fastrtps)
else()
  target_sources(ros_sender PRIVATE ${ros_dir}/without_fast_sender.cpp)
endif()

farrier_test(ros_command_test ros ${ros_dir}/joint_command_test.cpp
  ${ros_dir}/ros_command_test.cpp ${ros_dir}/../system/farrier_command.cpp)
if(TARGET farrier_body_world)
  target_sources(ros_command_test PRIVATE ${ros_dir}/velocity_command_test.cpp)
endif()
target_include_directories(ros_command_test PRIVATE ${ros_dir}/../system)
target_link_libraries(ros_command_test PRIVATE farrier_bus farrier_bus_ros farrier_cli_processes farrier_signals
  farrier_tool_process farrier_trace farrier_urdf ros_sender nlohmann_json::nlohmann_json Threads::Threads)
target_compile_definitions(ros_command_test PRIVATE ${system_definitions})
add_dependencies(ros_command_test farrier farrier_program_ros bare_exchange ${FARRIER_PROCESSES})

# Others' software, from npm: what package-lock.json names is fetched into the build tree, once. Without npm these tests are
# left out.
if(FARRIER_NPM AND TARGET farrier_foxglove AND TARGET farrier_body_world)
  set(ros_npm ${PROJECT_BINARY_DIR}/ros_npm)
  file(GLOB ros_scripts CONFIGURE_DEPENDS ${ros_dir}/npm/*.mjs)
  list(APPEND ros_scripts ${ros_dir}/../ecosystem/indexed_mcap.mjs)
  add_custom_command(OUTPUT ${ros_npm}/node_modules/.package-lock.json
    COMMAND ${CMAKE_COMMAND} -E make_directory ${ros_npm}
    COMMAND ${CMAKE_COMMAND} -E copy ${ros_dir}/npm/package.json ${ros_dir}/npm/package-lock.json ${ros_npm}
    COMMAND ${FARRIER_NPM} ci --prefix ${ros_npm} --no-audit --no-fund --loglevel=error
    DEPENDS ${ros_dir}/npm/package.json ${ros_dir}/npm/package-lock.json
    COMMENT "Fetching npm's readers of ROS 2 messages" VERBATIM)
  add_custom_command(OUTPUT ${ros_npm}/decoder.mjs
    COMMAND ${CMAKE_COMMAND} -E copy ${ros_scripts} ${ros_npm} DEPENDS ${ros_scripts} VERBATIM)
  add_custom_target(ros_readers DEPENDS ${ros_npm}/node_modules/.package-lock.json ${ros_npm}/decoder.mjs)

  farrier_test(ros_ecosystem_test ros ${ros_dir}/bag_test.cpp ${ros_dir}/foxglove_test.cpp
    ${ros_dir}/message_bytes_test.cpp ${ros_dir}/../system/farrier_command.cpp)
  target_include_directories(ros_ecosystem_test PRIVATE ${ros_dir}/../system)
  target_link_libraries(ros_ecosystem_test PRIVATE farrier_bus farrier_cli_processes farrier_playback farrier_recording
    farrier_ros_messages farrier_signals farrier_tool_process farrier_trace nlohmann_json::nlohmann_json Threads::Threads)
  target_compile_definitions(ros_ecosystem_test PRIVATE ${system_definitions} FARRIER_ROS_NPM="${ros_npm}"
    FARRIER_LAYOUT="${PROJECT_SOURCE_DIR}/deploy/foxglove/farrier.json")
  add_dependencies(ros_ecosystem_test ros_readers farrier farrier_program_monitor farrier_program_recording bare_exchange
    ${FARRIER_PROCESSES})
endif()

# A node of RTPS from npm looks at the robot; a minute of it is of the tests that take long.
if(TARGET ecosystem_readers)
  farrier_test_executable(ros_peer_test ${ros_dir}/peer_test.cpp ${ros_dir}/../system/farrier_command.cpp
    ${ros_dir}/../support/network_namespaces.cpp)
  target_include_directories(ros_peer_test PRIVATE ${ros_dir}/../system)
  target_link_libraries(ros_peer_test PRIVATE farrier_cli_processes farrier_tool_process farrier_trace
    nlohmann_json::nlohmann_json)
  target_compile_definitions(ros_peer_test PRIVATE ${system_definitions} FARRIER_ECOSYSTEM="${ecosystem_build}")
  add_dependencies(ros_peer_test farrier farrier_program_ros ecosystem_readers ${FARRIER_PROCESSES})
  farrier_test_entry(ros_peer_test ros ros_peer_test --gtest_filter=-*Minute*)
  farrier_test_entry(ros_peer_minute_test long ros_peer_test --gtest_filter=*Minute*)
endif()
