# The verbs of the command and the programs that run them: cli/verbs.def, which the command reads as well.
file(STRINGS ${PROJECT_SOURCE_DIR}/cli/verbs.def farrier_verb_lines REGEX "^FARRIER_VERB")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cli/verbs.def)

# Programs of the robot, whose names are too common for bin/: those of lib/core/processes.def.
file(STRINGS ${PROJECT_SOURCE_DIR}/lib/core/processes.def FARRIER_PROCESSES REGEX "^FARRIER_PROCESS")
list(TRANSFORM FARRIER_PROCESSES REPLACE "^FARRIER_PROCESS\\([A-Za-z]+, ([a-z_]+),.*" "\\1")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lib/core/processes.def)

# farrier_program(NAME SOURCES... [RUNS_PROCESSES]) declares the program NAME of cli/verbs.def: the command itself for
# "farrier", else the target farrier_program_<NAME>. For each of its verbs it declares the target verb_<verb>, which builds
# the command, the program and, with RUNS_PROCESSES, the processes of a robot.
function(farrier_program name)
  cmake_parse_arguments(PARSE_ARGV 1 program "RUNS_PROCESSES" "" "")
  set(target farrier_program_${name})
  if(name STREQUAL farrier)
    set(target farrier)
  endif()
  add_executable(${target} ${program_UNPARSED_ARGUMENTS})
  if(name STREQUAL farrier)
    set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
    install(TARGETS ${target} DESTINATION bin COMPONENT tools)
  else()
    set_target_properties(${target} PROPERTIES OUTPUT_NAME farrier-${name}
      RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/libexec/farrier)
    install(TARGETS ${target} DESTINATION libexec/farrier COMPONENT tools)
  endif()
  set_property(GLOBAL APPEND PROPERTY FARRIER_PROGRAMS ${target})
  set(needs farrier ${target})
  if(program_RUNS_PROCESSES)
    list(APPEND needs bare_exchange ${FARRIER_PROCESSES})
  endif()
  foreach(line IN LISTS farrier_verb_lines)
    if(line MATCHES "^FARRIER_VERB\\(([a-z]+), ${name}," AND NOT CMAKE_MATCH_1 STREQUAL test)
      add_custom_target(verb_${CMAKE_MATCH_1} DEPENDS ${needs})
    endif()
  endforeach()
endfunction()

# farrier_left_out(PART) says at configuration that a part is not built, and which packages it lacks.
function(farrier_left_out part)
  message(STATUS "farrier ${part} is left out: switched off, or without the packages of deploy/packages/${part}.txt")
endfunction()
