# Real processes over real DDS, started as a user would. The sources of one executable are compiled together; each is an
# entry of CTest. The long trials are the same suites with other vendors and durations.
set(system_dir ${CMAKE_CURRENT_LIST_DIR})
set(system_definitions FARRIER_COMMAND="$<TARGET_FILE:farrier>" FARRIER_JOINT_NODE="$<TARGET_FILE:joint_node>"
  FARRIER_PREFIX="${PROJECT_BINARY_DIR}" FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots" FARRIER_DOCS="${PROJECT_SOURCE_DIR}/docs"
  FARRIER_MONITORING="${PROJECT_SOURCE_DIR}/deploy/monitoring")

# One robot on this computer.
set(system_tests trace_identity process_failure command_line bench_parts reproduce diagnose diagnose_electric diagnose_scaled
  process_end
  surroundings robots_system security_system echo monitor_command monitor_page record recorded_run faults_refusals)
if(TARGET farrier_report_body)
  list(APPEND system_tests body/trial_body body/walk body/other_processor)
endif()
set(realtime_tests realtime soak faults_command estimator_death)
if(TARGET farrier_report_body)
  list(APPEND realtime_tests body/drive)
endif()
set(long_tests long_pause diagnose_benchmark monitor_page_load)
set(sources ${system_tests} ${realtime_tests} ${long_tests})
list(TRANSFORM sources REPLACE "(.+)" "${system_dir}/\\1_test.cpp")
set(prometheus_source ${system_dir}/../ecosystem/prometheus_test.cpp)
farrier_test_executable(system_test ${sources} ${prometheus_source} ${system_dir}/farrier_command.cpp)
target_include_directories(system_test PRIVATE ${system_dir})
target_link_libraries(system_test PRIVATE farrier_bus farrier_cli_processes farrier_signals farrier_tool_process
  farrier_trace nlohmann_json::nlohmann_json PkgConfig::httplib test_http Threads::Threads)
target_compile_definitions(system_test PRIVATE ${system_definitions})
add_dependencies(system_test product)
foreach(label IN ITEMS system realtime long)
  foreach(name IN LISTS ${label}_tests)
    farrier_suites(system_test ${label} ${system_dir}/${name}_test.cpp)
  endforeach()
endforeach()
farrier_suites(system_test long ${system_dir}/trace_identity_test.cpp NAME long_trace_identity_test
  ENVIRONMENT FARRIER_TEST_DURATION_S=12)
farrier_suites(system_test long ${system_dir}/record_test.cpp NAME long_record_test
  ENVIRONMENT FARRIER_TEST_VENDORS=fast)
farrier_suites(system_test long ${system_dir}/realtime_test.cpp NAME long_realtime_test
  ENVIRONMENT FARRIER_TEST_VENDORS=cyclone,fast)
farrier_suites(system_test long ${system_dir}/soak_test.cpp NAME long_soak_test
  ENVIRONMENT FARRIER_TEST_DURATION_S=600 FARRIER_TEST_VENDORS=cyclone,fast)
set_tests_properties(long/diagnose_benchmark_test long/long_soak_test PROPERTIES TIMEOUT 3600)
set_tests_properties(system/recorded_run_test PROPERTIES LABELS "system;ecosystem")  # replayed, the same estimates
set_tests_properties(system/reproduce_test PROPERTIES LABELS "system;thesis")  # all studies with seven seeds
# Debian's Prometheus, which the test looks for itself.
farrier_suites(system_test ecosystem ${prometheus_source})

# Several hosts, which are network namespaces, and what their networks and service managers do to the processes.
find_package(CycloneDDS REQUIRED)  # whose imported targets are seen where it is found only
set(sources three_hosts cut_cable lossy_cable frame_relay doctor service)
list(TRANSFORM sources REPLACE "(.+)" "${system_dir}/\\1_test.cpp")
farrier_test_executable(hosts_test ${sources} ${system_dir}/farrier_command.cpp ${system_dir}/deployed_robot.cpp
  ${system_dir}/robot_watch.cpp ${system_dir}/../support/frame_relay.cpp ${system_dir}/../support/network_namespaces.cpp)
target_include_directories(hosts_test PRIVATE ${system_dir})
target_link_libraries(hosts_test PRIVATE farrier_bus_cyclone farrier_bus_factory farrier_cli_processes farrier_core
  farrier_deploy farrier_report_trot farrier_run farrier_runtime farrier_trace CycloneDDS::ddsc
  nlohmann_json::nlohmann_json Threads::Threads)
target_compile_definitions(hosts_test PRIVATE ${system_definitions})
add_dependencies(hosts_test product)
foreach(name IN ITEMS three_hosts frame_relay doctor service)
  farrier_suites(hosts_test system ${system_dir}/${name}_test.cpp)
endforeach()
# Every run of the tests takes both vendors at once; each alone is for the long trials.
farrier_suites(hosts_test long ${system_dir}/three_hosts_test.cpp NAME long_three_hosts_test
  ENVIRONMENT FARRIER_TEST_DURATION_S=3 FARRIER_TEST_VENDORS=cyclone,fast,mixed)
foreach(name IN ITEMS cut_cable_test lossy_cable_test)
  farrier_suites(hosts_test realtime ${system_dir}/${name}.cpp)
  farrier_suites(hosts_test long ${system_dir}/${name}.cpp NAME long_${name}
    ENVIRONMENT FARRIER_TEST_DURATION_S=4 FARRIER_TEST_VENDORS=cyclone,fast)
endforeach()
set_tests_properties(system/doctor_test PROPERTIES RUN_SERIAL FALSE)  # nothing it looks at runs a loop

# What a user would install, in a computer that has nothing else.
add_test(NAME long/packages_test COMMAND ${CMAKE_CURRENT_LIST_DIR}/../packages/run ${PROJECT_BINARY_DIR})
set_tests_properties(long/packages_test PROPERTIES LABELS long RUN_SERIAL TRUE SKIP_RETURN_CODE 77 TIMEOUT 3600)
