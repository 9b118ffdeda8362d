# Real processes over real DDS, started as a user would.
function(farrier_system_test name label duration)
  farrier_test(${name} ${label} ${ARGN} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/farrier_command.cpp)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  target_link_libraries(${name} PRIVATE nlohmann_json::nlohmann_json Threads::Threads)
  target_compile_definitions(${name} PRIVATE FARRIER_COMMAND="$<TARGET_FILE:farrier>"
    FARRIER_JOINT_NODE="$<TARGET_FILE:joint_node>"
    FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots" FARRIER_TRACE_DURATION="${duration}")
  add_dependencies(${name} product)
endfunction()

farrier_system_test(trace_identity_test system 1.5 ${CMAKE_CURRENT_LIST_DIR}/trace_identity_test.cpp)
farrier_system_test(long_trace_identity_test long 12 ${CMAKE_CURRENT_LIST_DIR}/trace_identity_test.cpp)
farrier_system_test(process_failure_test system 0 ${CMAKE_CURRENT_LIST_DIR}/process_failure_test.cpp)
farrier_system_test(command_line_test system 0 ${CMAKE_CURRENT_LIST_DIR}/command_line_test.cpp)
farrier_system_test(bench_parts_test system 0 ${CMAKE_CURRENT_LIST_DIR}/bench_parts_test.cpp)
farrier_system_test(reproduce_test system 0 ${CMAKE_CURRENT_LIST_DIR}/reproduce_test.cpp)
farrier_system_test(diagnose_test system 0 ${CMAKE_CURRENT_LIST_DIR}/diagnose_test.cpp)
farrier_system_test(diagnose_scaled_test system 0 ${CMAKE_CURRENT_LIST_DIR}/diagnose_scaled_test.cpp)
target_compile_definitions(diagnose_scaled_test PRIVATE FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
farrier_system_test(process_end_test system 0 ${CMAKE_CURRENT_LIST_DIR}/process_end_test.cpp)
farrier_system_test(surroundings_test system 0 ${CMAKE_CURRENT_LIST_DIR}/surroundings_test.cpp)
farrier_system_test(traffic_test system 0 ${CMAKE_CURRENT_LIST_DIR}/traffic_test.cpp)
farrier_system_test(robots_system_test system 0 ${CMAKE_CURRENT_LIST_DIR}/robots_system_test.cpp)
farrier_system_test(security_system_test system 0 ${CMAKE_CURRENT_LIST_DIR}/security_system_test.cpp)
# The processes without the command, as systemd starts them.
farrier_test(service_test system ${CMAKE_CURRENT_LIST_DIR}/service_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/farrier_command.cpp)
target_link_libraries(service_test PRIVATE farrier_deploy nlohmann_json::nlohmann_json)
target_compile_definitions(service_test PRIVATE FARRIER_PREFIX="${PROJECT_BINARY_DIR}"
  FARRIER_COMMAND="${PROJECT_BINARY_DIR}/bin/farrier" FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
add_dependencies(service_test ${FARRIER_PROCESSES})
# The processes of a deployment on its hosts, which are network namespaces; DDS: over which vendors, a run each.
function(farrier_hosts_test name label duration)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "DDS")
  list(JOIN arg_DDS "\",\"" vendors)
  farrier_system_test(${name} ${label} "${duration}" ${arg_UNPARSED_ARGUMENTS}
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/deployed_robot.cpp
    ${PROJECT_SOURCE_DIR}/tests/support/frame_relay.cpp ${PROJECT_SOURCE_DIR}/tests/support/network_namespaces.cpp)
  target_link_libraries(${name} PRIVATE farrier_deploy farrier_runtime)
  target_compile_definitions(${name} PRIVATE FARRIER_PREFIX="${PROJECT_BINARY_DIR}" FARRIER_VENDORS="${vendors}")
  add_dependencies(${name} ${FARRIER_PROCESSES})
endfunction()
# Every run of the tests takes both vendors at once; each alone is for the long trials.
farrier_hosts_test(three_hosts_test system 0.3 ${CMAKE_CURRENT_LIST_DIR}/three_hosts_test.cpp DDS mixed)
farrier_hosts_test(long_three_hosts_test long 3 ${CMAKE_CURRENT_LIST_DIR}/three_hosts_test.cpp DDS cyclone fast mixed)
farrier_test(frame_relay_test system ${CMAKE_CURRENT_LIST_DIR}/frame_relay_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/frame_relay.cpp ${PROJECT_SOURCE_DIR}/tests/support/network_namespaces.cpp)
target_link_libraries(frame_relay_test PRIVATE farrier_core farrier_runtime Threads::Threads)
function(farrier_cable_test name label source)
  farrier_hosts_test(${name} ${label} 0 ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${source}
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/robot_watch.cpp ${PROJECT_SOURCE_DIR}/cli/processes/pause_watch.cpp DDS ${ARGN})
  target_link_libraries(${name} PRIVATE farrier_bus_factory farrier_report_trot farrier_run farrier_trace)
endfunction()
foreach(name IN ITEMS cut_cable_test lossy_cable_test)
  farrier_cable_test(${name} realtime ${name}.cpp mixed)
  farrier_cable_test(long_${name} long ${name}.cpp cyclone fast)
endforeach()
find_package(CycloneDDS REQUIRED)  # whose imported targets are seen where it is found only
farrier_system_test(doctor_test system 0 ${CMAKE_CURRENT_LIST_DIR}/doctor_test.cpp
  ${PROJECT_SOURCE_DIR}/cli/processes/domain_lock.cpp ${PROJECT_SOURCE_DIR}/cli/processes/host_clock.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/network_namespaces.cpp)
target_compile_definitions(doctor_test PRIVATE FARRIER_PREFIX="${PROJECT_BINARY_DIR}")
target_link_libraries(doctor_test PRIVATE farrier_bus_cyclone farrier_bus_factory CycloneDDS::ddsc)
set_tests_properties(system/doctor_test PROPERTIES RUN_SERIAL FALSE)  # nothing it looks at runs a loop
farrier_system_test(echo_test system 0 ${CMAKE_CURRENT_LIST_DIR}/echo_test.cpp)
farrier_system_test(monitor_command_test system 0 ${CMAKE_CURRENT_LIST_DIR}/monitor_command_test.cpp)
farrier_system_test(monitor_page_test system 0 ${CMAKE_CURRENT_LIST_DIR}/monitor_page_test.cpp)
farrier_system_test(monitor_page_load_test long 0 ${CMAKE_CURRENT_LIST_DIR}/monitor_page_load_test.cpp
  ${PROJECT_SOURCE_DIR}/cli/processes/process_stat.cpp)
foreach(name IN ITEMS monitor_command_test monitor_page_test monitor_page_load_test)
  target_link_libraries(${name} PRIVATE test_http)
endforeach()
farrier_system_test(record_test system 0 ${CMAKE_CURRENT_LIST_DIR}/record_test.cpp)
target_compile_definitions(record_test PRIVATE FARRIER_VENDORS="cyclone")
farrier_system_test(long_record_test long 0 ${CMAKE_CURRENT_LIST_DIR}/record_test.cpp)
target_compile_definitions(long_record_test PRIVATE FARRIER_VENDORS="fast")
target_link_libraries(record_test PRIVATE farrier_bus)
target_link_libraries(long_record_test PRIVATE farrier_bus)
farrier_system_test(recorded_run_test system 0 ${CMAKE_CURRENT_LIST_DIR}/recorded_run_test.cpp)
target_link_libraries(recorded_run_test PRIVATE farrier_bus)
set_tests_properties(system/recorded_run_test PROPERTIES LABELS "system;ecosystem")  # replayed, the same estimates
farrier_system_test(network_test system 0 ${CMAKE_CURRENT_LIST_DIR}/network_test.cpp)
farrier_system_test(long_pause_test long 0 ${CMAKE_CURRENT_LIST_DIR}/long_pause_test.cpp)
farrier_system_test(diagnose_benchmark_test long 0 ${CMAKE_CURRENT_LIST_DIR}/diagnose_benchmark_test.cpp)
target_compile_definitions(diagnose_benchmark_test PRIVATE FARRIER_DOCS="${PROJECT_SOURCE_DIR}/docs")
set_tests_properties(long/diagnose_benchmark_test PROPERTIES TIMEOUT 3600)
farrier_system_test(realtime_test realtime 0 ${CMAKE_CURRENT_LIST_DIR}/realtime_test.cpp)
target_compile_definitions(realtime_test PRIVATE FARRIER_VENDORS="mixed")
farrier_system_test(long_realtime_test long 0 ${CMAKE_CURRENT_LIST_DIR}/realtime_test.cpp)
target_compile_definitions(long_realtime_test PRIVATE "FARRIER_VENDORS=\"cyclone\",\"fast\"")
farrier_system_test(soak_test realtime 5 ${CMAKE_CURRENT_LIST_DIR}/soak_test.cpp)
farrier_system_test(long_soak_test long 600 ${CMAKE_CURRENT_LIST_DIR}/soak_test.cpp)
set_tests_properties(long/long_soak_test PROPERTIES TIMEOUT 3600)
farrier_system_test(faults_command_test realtime 0 ${CMAKE_CURRENT_LIST_DIR}/faults_command_test.cpp)
farrier_system_test(estimator_death_test realtime 0 ${CMAKE_CURRENT_LIST_DIR}/estimator_death_test.cpp)
target_link_libraries(estimator_death_test PRIVATE farrier_trace farrier_signals)
# What a user would install, in a computer that has nothing else.
add_test(NAME long/packages_test COMMAND ${CMAKE_CURRENT_LIST_DIR}/../packages/run ${PROJECT_BINARY_DIR})
set_tests_properties(long/packages_test PROPERTIES LABELS long RUN_SERIAL TRUE SKIP_RETURN_CODE 77 TIMEOUT 3600)
