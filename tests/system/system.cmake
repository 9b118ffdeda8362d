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
farrier_system_test(reproduce_test system 0 ${CMAKE_CURRENT_LIST_DIR}/reproduce_test.cpp)
farrier_system_test(diagnose_test system 0 ${CMAKE_CURRENT_LIST_DIR}/diagnose_test.cpp)
farrier_system_test(diagnose_scaled_test system 0 ${CMAKE_CURRENT_LIST_DIR}/diagnose_scaled_test.cpp)
target_compile_definitions(diagnose_scaled_test PRIVATE FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
farrier_system_test(process_end_test system 0 ${CMAKE_CURRENT_LIST_DIR}/process_end_test.cpp)
farrier_system_test(surroundings_test system 0 ${CMAKE_CURRENT_LIST_DIR}/surroundings_test.cpp)
farrier_system_test(traffic_test system 0 ${CMAKE_CURRENT_LIST_DIR}/traffic_test.cpp)
farrier_system_test(network_test system 0 ${CMAKE_CURRENT_LIST_DIR}/network_test.cpp)
farrier_system_test(long_pause_test long 0 ${CMAKE_CURRENT_LIST_DIR}/long_pause_test.cpp)
farrier_system_test(realtime_test realtime 0 ${CMAKE_CURRENT_LIST_DIR}/realtime_test.cpp)
farrier_system_test(estimator_death_test realtime 0 ${CMAKE_CURRENT_LIST_DIR}/estimator_death_test.cpp)
target_link_libraries(estimator_death_test PRIVATE farrier_record farrier_signals)
# Real time is for a computer that has nothing else to do.
set_tests_properties(realtime/realtime_test realtime/estimator_death_test PROPERTIES RUN_SERIAL TRUE)
