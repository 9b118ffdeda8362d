# Flags every target gets. What shapes a trace must not depend on the machine that builds it:
# no fused multiply-add contraction, no fast-math, no -march=native.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O2")  # no -DNDEBUG: ENSURE and assert stay in

# farrier_off_the_loop() has the targets of this folder compiled with less optimisation: no loop runs in them, and the
# compiler takes a fifth less time. Results do not depend on it.
macro(farrier_off_the_loop)
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    add_compile_options(-O1)
  endif()
endmacro()

# GCC collects what it no longer needs of its memory from 128 MB on and spends a tenth of its time on it; from 512 MB on, a
# twentieth.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options("SHELL:--param ggc-min-heapsize=524288")
endif()

add_library(farrier_flags INTERFACE)
target_compile_options(farrier_flags INTERFACE
  "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wshadow;-Wconversion;-Wno-sign-conversion>>"
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)
target_include_directories(farrier_flags INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR};${PROJECT_SOURCE_DIR}/lib>" $<INSTALL_INTERFACE:include/farrier>)

# Sanitizers, for our code and for what is generated from idl/. A finding ends the program: a test that only prints it
# would pass.
add_library(farrier_sanitizers INTERFACE)
if(FARRIER_SANITIZE)
  target_compile_options(farrier_sanitizers INTERFACE
    -fsanitize=${FARRIER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(farrier_sanitizers INTERFACE -fsanitize=${FARRIER_SANITIZE})
endif()
target_link_libraries(farrier_flags INTERFACE $<BUILD_INTERFACE:farrier_sanitizers>)

find_program(FARRIER_CCACHE ccache)
if(FARRIER_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${FARRIER_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${FARRIER_CCACHE})
endif()

# farrier_library(NAME SOURCES... ) declares lib target `farrier_<NAME>`; its edges stay in
# target_link_libraries lines of its own, which tests/architecture reads.
function(farrier_library name)
  add_library(farrier_${name} STATIC ${ARGN})
  target_link_libraries(farrier_${name} PUBLIC farrier_flags)
endfunction()

# Tests whose judgement does not depend on the computer's clock. They run at the same time as others, in network
# namespaces of their own, so that DDS domains and ports never meet.
set(FARRIER_PARALLEL_TESTS trace_identity_test process_failure_test process_end_test recorded_run_test command_line_test
  reproduce_test diagnose_test diagnose_electric_test diagnose_scaled_test robots_system_test security_system_test echo_test
  monitor_command_test monitor_page_test dds_cases_test memory_test outputs_test recording_commands_test
  bench_parts_test surroundings_test prometheus_test three_hosts_test security_bus_test readme_test
  contract_test gathering_test ros_node_test ros_command_test ros_ecosystem_test trial_body_test walk_test service_test
  other_processor_test faults_refusals_test)

# Tests that take longest among those that run at the same time, the longest first. CTest starts them first, also in a clean
# clone, where it has no times of its own: the last of them then does not run alone at the end.
set(FARRIER_LONGEST_TESTS walk_test tidy_test process_failure_test security_system_test trot_trial_test
  trace_identity_test trial_body_test security_bus_test monitor_command_test scenario_test echo_test doctor_test
  ros_command_test locomotion_test truth_test prometheus_test readme_test blind_trials_test diagnosis_test
  three_hosts_test recorded_run_test robot_test process_end_test completion_test reproduce_test format_test
  controller_test wiring_trials_test command_line_test)

# Tests that keep a processor busy from begin to end. Each takes two places of CTest; those that mostly wait take one.
# ./farrier test has six places for two processors.
set(FARRIER_BUSY_TESTS walk_test tidy_test trot_trial_test trial_body_test scenario_test locomotion_test truth_test
  readme_test blind_trials_test diagnosis_test robot_test reproduce_test format_test controller_test wiring_trials_test
  bench_test body_engine_test)

# farrier_test_entry(NAME LABEL EXECUTABLE ARGUMENTS...) has CTest run a test executable as <LABEL>/<NAME>; the target
# tier_<LABEL> builds it. Tests that start processes or hold leases of a few milliseconds have the machine to themselves,
# but for those of FARRIER_PARALLEL_TESTS.
function(farrier_test_entry name label executable)
  if(NOT TARGET tier_${label})
    add_custom_target(tier_${label})
  endif()
  add_dependencies(tier_${label} ${executable})
  set(own_network)
  if(name IN_LIST FARRIER_PARALLEL_TESTS)
    set(own_network ${PROJECT_SOURCE_DIR}/tests/support/own_network)
  endif()
  add_test(NAME ${label}/${name} COMMAND ${own_network} $<TARGET_FILE:${executable}> ${ARGN})
  set_tests_properties(${label}/${name} PROPERTIES LABELS ${label})
  list(FIND FARRIER_LONGEST_TESTS ${name} place)
  if(place GREATER_EQUAL 0)
    math(EXPR cost "100 - ${place}")
    set_tests_properties(${label}/${name} PROPERTIES COST ${cost})
  endif()
  if(name IN_LIST FARRIER_BUSY_TESTS)
    set_tests_properties(${label}/${name} PROPERTIES PROCESSORS 2)
  endif()
  if(FARRIER_SANITIZE)
    set(asan_options new_delete_type_mismatch=1)
    if(label STREQUAL contract)
      # Fast DDS 2.9 deletes parts of its readers by a base class of another size. Stacks through vendors' libraries, which
      # have no frame pointers, are for lsan.supp.
      set(asan_options new_delete_type_mismatch=0:fast_unwind_on_malloc=0)
    endif()
    # Debian's libraries are not instrumented: what they do to memory is not judged, what they lock counts.
    set_tests_properties(${label}/${name} PROPERTIES ENVIRONMENT
      "ASAN_OPTIONS=${asan_options};TSAN_OPTIONS=ignore_noninstrumented_modules=1;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/sanitizers/lsan.supp;UBSAN_OPTIONS=print_stacktrace=1")
  endif()
  if(label MATCHES "^(contract|system|realtime|long)$" AND NOT name IN_LIST FARRIER_PARALLEL_TESTS)
    set_tests_properties(${label}/${name} PROPERTIES RUN_SERIAL TRUE)
  endif()
endfunction()

# farrier_test_executable(NAME SOURCES...) declares a GoogleTest binary.
function(farrier_test_executable name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE farrier_flags GTest::gtest GTest::gtest_main)
endfunction()

# farrier_test(NAME LABEL SOURCES...) declares a GoogleTest binary that is one entry of CTest.
function(farrier_test name label)
  farrier_test_executable(${name} ${ARGN})
  farrier_test_entry(${name} ${label} ${name})
endfunction()

# farrier_suites(EXECUTABLE LABEL SOURCE [NAME name] [ENVIRONMENT NAME=value...]) makes the suites of one source of a test
# executable one entry of CTest, named as the source unless NAME is given. The suites are read from the source.
function(farrier_suites executable label source)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "NAME" "ENVIRONMENT")
  cmake_path(GET source STEM name)
  if(arg_NAME)
    set(name ${arg_NAME})
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(STRINGS ${source} suites REGEX "^TEST(_F|_P)?\\(")
  list(TRANSFORM suites REPLACE "^TEST(_F|_P)?\\(([A-Za-z0-9_]+),.*" "\\2")
  list(REMOVE_DUPLICATES suites)
  list(TRANSFORM suites REPLACE "(.+)" "\\1.*:*/\\1.*")
  list(JOIN suites ":" filter)
  farrier_test_entry(${name} ${label} ${executable} --gtest_filter=${filter})
  list(TRANSFORM arg_ENVIRONMENT REPLACE "=" "=set:")
  set_tests_properties(${label}/${name} PROPERTIES ENVIRONMENT_MODIFICATION "${arg_ENVIRONMENT}")
endfunction()
