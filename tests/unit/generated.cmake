# Tables the documentation prints from the code.
foreach(table IN ITEMS cli:docs/cli.md topics:idl/README.md effects:docs/effects.md events:docs/events.md faults:docs/faults.md figures:docs/figures.md metrics:docs/metrics.md parameters:docs/parameters.md safety:docs/architecture.md)
  string(REPLACE ":" ";" parts ${table})
  list(GET parts 0 name)
  list(GET parts 1 file)
  add_test(NAME architecture/table_of_${name}_is_not_stale
    COMMAND ${CMAKE_COMMAND} -DCOMMAND=$<TARGET_FILE:farrier> -DTABLE=${name} -DFILE=${PROJECT_SOURCE_DIR}/${file}
      -P ${CMAKE_CURRENT_LIST_DIR}/../architecture/compare_table.cmake)
  set_tests_properties(architecture/table_of_${name}_is_not_stale PROPERTIES LABELS architecture)
endforeach()

farrier_test(fast_datagram_test unit ${CMAKE_CURRENT_LIST_DIR}/bus_fastdds/cyclone_acknack_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/bus_fastdds/cyclone_handshake_test.cpp ${CMAKE_CURRENT_LIST_DIR}/bus_fastdds/gathered_datagram_test.cpp)
target_link_libraries(fast_datagram_test PRIVATE farrier_bus_fastdds)
