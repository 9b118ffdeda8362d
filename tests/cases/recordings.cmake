find_package(PkgConfig REQUIRED)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)
# Recordings of other writers and other clocks, files and outputs: what users have reported of products like this one.
set(cases_dir ${CMAKE_CURRENT_LIST_DIR})
farrier_test(mcap_forms_test cases ${cases_dir}/mcap_forms_test.cpp ${cases_dir}/any_mcap.cpp)
target_link_libraries(mcap_forms_test PRIVATE farrier_core farrier_mcap farrier_recording farrier_report farrier_robot
  farrier_signals PkgConfig::zstd)
target_compile_definitions(mcap_forms_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")

# The commands, started as a user would.
farrier_test_executable(recording_cases_test ${cases_dir}/recording_commands_test.cpp ${cases_dir}/outputs_test.cpp
  ${cases_dir}/memory_test.cpp ${cases_dir}/any_mcap.cpp
  ${PROJECT_SOURCE_DIR}/tests/system/farrier_command.cpp)
target_link_libraries(recording_cases_test PRIVATE farrier_mcap farrier_recording farrier_report farrier_robot
  farrier_signals farrier_trace nlohmann_json::nlohmann_json PkgConfig::zstd Threads::Threads)
target_compile_definitions(recording_cases_test PRIVATE FARRIER_COMMAND="$<TARGET_FILE:farrier>"
  FARRIER_PREFIX="${PROJECT_BINARY_DIR}" FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
add_dependencies(recording_cases_test farrier farrier_program_recording farrier_program_monitor farrier_program_diagnose)
foreach(name IN ITEMS recording_commands outputs memory)
  farrier_suites(recording_cases_test cases ${cases_dir}/${name}_test.cpp)
endforeach()
