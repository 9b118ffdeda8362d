set(contract_dir ${CMAKE_CURRENT_LIST_DIR})

add_library(contract_support STATIC ${contract_dir}/buses.cpp ${contract_dir}/peer.cpp ${contract_dir}/peer_roles.cpp)
target_link_libraries(contract_support PUBLIC farrier_flags farrier_bus PRIVATE farrier_bus_cyclone
  farrier_bus_factory farrier_security)
if(TARGET farrier_bus_fastdds)
  target_link_libraries(contract_support PRIVATE farrier_bus_fastdds)
  target_compile_definitions(contract_support PRIVATE FARRIER_HAVE_FASTDDS)
endif()

farrier_test_executable(contract_test ${contract_dir}/contract_main.cpp ${contract_dir}/conformance_delivery_test.cpp
  ${contract_dir}/conformance_matching_test.cpp ${contract_dir}/conformance_failure_test.cpp)
farrier_test_entry(contract_test contract contract_test --gtest_filter=-Bus/Failure.*)
farrier_test_entry(contract_failure_test contract contract_test --gtest_filter=Bus/Failure.*)  # leases of milliseconds
target_link_libraries(contract_test PRIVATE contract_support)

farrier_test(gathering_test contract ${contract_dir}/contract_main.cpp ${contract_dir}/gathering_test.cpp)
target_link_libraries(gathering_test PRIVATE contract_support farrier_pki)

farrier_test(contract_text_test contract ${contract_dir}/contract_text_test.cpp)
target_link_libraries(contract_text_test PRIVATE farrier_bus)

farrier_test(cyclone_bus_test contract ${contract_dir}/cyclone_bus_test.cpp)
target_link_libraries(cyclone_bus_test PRIVATE farrier_bus_cyclone)

farrier_test(cyclone_reception_test contract ${contract_dir}/cyclone_reception_test.cpp)
target_link_libraries(cyclone_reception_test PRIVATE farrier_bus_cyclone)

farrier_test(cyclone_waits_test system ${contract_dir}/cyclone_waits_test.cpp  # preloads: not with sanitizers
  ${PROJECT_SOURCE_DIR}/cli/processes/host_clock.cpp)
target_link_libraries(cyclone_waits_test PRIVATE farrier_bus_cyclone CycloneDDS::ddsc)
target_compile_definitions(cyclone_waits_test PRIVATE FARRIER_EXECUTABLES="$<TARGET_FILE_DIR:farrier_wall_clock>")
add_dependencies(cyclone_waits_test farrier_wall_clock)

farrier_test(inproc_bus_test contract ${contract_dir}/inproc_bus_test.cpp
  ${contract_dir}/../support/allocation_guard.cpp)
target_link_libraries(inproc_bus_test PRIVATE farrier_bus)

farrier_test(discovery_test system ${contract_dir}/contract_main.cpp ${contract_dir}/discovery_test.cpp)
target_link_libraries(discovery_test PRIVATE contract_support)

farrier_test(security_bus_test contract ${contract_dir}/security_test.cpp)
target_link_libraries(security_bus_test PRIVATE contract_support farrier_bus_factory farrier_bus_fastdds farrier_pki
  farrier_security farrier_tool_process)
# It waits for handshakes and refusals, with time enough for a busy machine.
set_tests_properties(contract/security_bus_test PROPERTIES RUN_SERIAL FALSE)

farrier_test(wire_bytes_test contract ${contract_dir}/wire_bytes_test.cpp ${contract_dir}/wire_bytes_cyclone.cpp
  ${contract_dir}/wire_bytes_fast.cpp)
set_target_properties(wire_bytes_test PROPERTIES UNITY_BUILD OFF)  # two vendors' types of one name
target_link_libraries(wire_bytes_test PRIVATE farrier_signals farrier_bus_cyclone CycloneDDS::ddsc farrier_bus_fastdds
  farrier_wire_fastdds)
target_include_directories(wire_bytes_test SYSTEM PRIVATE ${PROJECT_BINARY_DIR}/lib/bus_cyclone)  # its types of idl/
