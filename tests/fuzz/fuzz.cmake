# Harnesses (harness.hpp): replayed by a test of every build; under the preset fuzz also one libFuzzer program each.
set(fuzz_dir ${CMAKE_CURRENT_LIST_DIR})
find_package(CycloneDDS REQUIRED)

if(FARRIER_FUZZ)
  add_custom_target(fuzz)
endif()

# farrier_fuzz(NAME SOURCES... HARNESSES...) declares a library with harnesses; what it links stays in lines of its own.
function(farrier_fuzz name)
  cmake_parse_arguments(PARSE_ARGV 1 fuzz "" "" "SOURCES;HARNESSES")
  add_library(${name} STATIC ${fuzz_SOURCES})
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)  # harnesses have names of their own
  target_link_libraries(${name} PUBLIC farrier_flags)
  target_compile_definitions(${name} PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
  if(NOT FARRIER_FUZZ)
    return()
  endif()
  foreach(harness IN LISTS fuzz_HARNESSES)
    add_executable(fuzz_${harness} ${fuzz_dir}/libfuzzer.cpp)
    target_compile_definitions(fuzz_${harness} PRIVATE FARRIER_HARNESS=${harness})
    target_link_libraries(fuzz_${harness} PRIVATE ${name})
    target_link_options(fuzz_${harness} PRIVATE -fsanitize=fuzzer)
    add_dependencies(fuzz fuzz_${harness})
  endforeach()
endfunction()

farrier_fuzz(fuzzed_faults SOURCES ${fuzz_dir}/arrow_fault.cpp HARNESSES arrow_fault)
target_link_libraries(fuzzed_faults PRIVATE farrier_bus_faults)

farrier_fuzz(fuzzed_codecs SOURCES ${fuzz_dir}/cyclone_codec.cpp ${fuzz_dir}/fast_codec.cpp
  HARNESSES cyclone_codec fast_codec cyclone_datagram)
target_link_libraries(fuzzed_codecs PRIVATE farrier_bus_cyclone CycloneDDS::ddsc
  farrier_bus_fastdds farrier_wire_fastdds)
# Cyclone's types of idl/.
target_include_directories(fuzzed_codecs SYSTEM PRIVATE ${PROJECT_BINARY_DIR}/lib/bus_cyclone)

farrier_fuzz(fuzzed_ports SOURCES ${fuzz_dir}/ports.cpp HARNESSES ports)
target_link_libraries(fuzzed_ports PRIVATE farrier_participant)

farrier_fuzz(fuzzed_journals SOURCES ${fuzz_dir}/journal.cpp HARNESSES journal)
target_link_libraries(fuzzed_journals PRIVATE farrier_recorder farrier_signals)

farrier_fuzz(fuzzed_files SOURCES ${fuzz_dir}/robot_file.cpp ${fuzz_dir}/scene_file.cpp ${fuzz_dir}/files.cpp
  ${fuzz_dir}/user_files.cpp
  HARNESSES robot_file scene_file recording scaled_recording trace run_file log_times dds_settings description)
target_link_libraries(fuzzed_files PRIVATE farrier_bus farrier_robot farrier_world farrier_diagnosis farrier_trace farrier_recording
  farrier_signals)

farrier_fuzz(fuzzed_viewers SOURCES ${fuzz_dir}/viewer.cpp HARNESSES foxglove_text)
target_link_libraries(fuzzed_viewers PRIVATE farrier_foxglove)

farrier_fuzz(fuzzed_ros SOURCES ${fuzz_dir}/ros.cpp HARNESSES ros_message urdf_file)
target_link_libraries(fuzzed_ros PRIVATE farrier_ros_bridge farrier_robot farrier_urdf)

farrier_fuzz(fuzzed_cores SOURCES ${fuzz_dir}/joint_core.cpp ${fuzz_dir}/adaptation_cores.cpp
  HARNESSES joint_node estimator_service supervisor)
target_link_libraries(fuzzed_cores PRIVATE farrier_joint_node_core farrier_estimator_service_core
  farrier_supervisor_core farrier_participant)

farrier_test(fuzz_replay_test unit ${fuzz_dir}/replay_test.cpp ${fuzz_dir}/harnesses.cpp)
target_link_libraries(fuzz_replay_test PRIVATE fuzzed_faults fuzzed_codecs fuzzed_ports fuzzed_journals fuzzed_files fuzzed_viewers
  fuzzed_ros fuzzed_cores)
target_compile_definitions(fuzz_replay_test PRIVATE FARRIER_CORPUS="${fuzz_dir}/corpus")
