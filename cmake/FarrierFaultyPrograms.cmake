# Programs that `farrier faults` starts: the objects of each process, linked with fault injection. No other program has
# it, and robots get the package without them.
set(FARRIER_FAULTY_PROGRAMS)
foreach(process IN LISTS FARRIER_PROCESSES)
  set(program ${process}_with_faults)
  get_target_property(libraries ${process} LINK_LIBRARIES)
  add_executable(${program} $<TARGET_OBJECTS:${process}> $<TARGET_OBJECTS:farrier_fault_injection>)
  target_link_libraries(${program} PRIVATE ${libraries} farrier_participant farrier_bus_faults)
  list(APPEND FARRIER_FAULTY_PROGRAMS ${program})
endforeach()
add_dependencies(farrier_program_faults ${FARRIER_FAULTY_PROGRAMS})
