# farrier_plain_process(PROGRAM PURPOSE) declares the program of a process that lib/core/processes.def lists as `plain`.
# Its library is farrier_<PROGRAM>_app. PURPOSE is the first line of its help.
function(farrier_plain_process program purpose)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/plain_process.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/main.cpp @ONLY)
  add_executable(${program} ${CMAKE_CURRENT_BINARY_DIR}/main.cpp)
  target_link_libraries(${program} PRIVATE farrier_${program}_app farrier_process)
endfunction()
