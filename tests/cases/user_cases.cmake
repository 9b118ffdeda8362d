# Inputs as users have them, of kinds that public reports showed: robots, DDS settings, CSV files. Each has the right
# answer of the commands. Labels: ctest -L cases.
set(cases_dir ${CMAKE_CURRENT_LIST_DIR})
set(user_cases robot_cases dds_cases)
set(sources ${user_cases})
list(TRANSFORM sources REPLACE "(.+)" "${cases_dir}/\\1_test.cpp")
farrier_test_executable(user_cases_test ${sources} ${cases_dir}/../system/farrier_command.cpp)
target_link_libraries(user_cases_test PRIVATE farrier_bus farrier_cli_processes farrier_core farrier_robot
  nlohmann_json::nlohmann_json)
target_compile_definitions(user_cases_test PRIVATE FARRIER_COMMAND="$<TARGET_FILE:farrier>"
  FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
add_dependencies(user_cases_test product)
foreach(name IN LISTS user_cases)
  farrier_suites(user_cases_test cases ${cases_dir}/${name}_test.cpp)
endforeach()

if(TARGET farrier_diagnosis)
  farrier_test(csv_cases_test cases ${cases_dir}/csv_cases_test.cpp ${cases_dir}/wiring_cases_test.cpp)
  target_link_libraries(csv_cases_test PRIVATE farrier_diagnosis farrier_truth)
  target_compile_definitions(csv_cases_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
endif()
