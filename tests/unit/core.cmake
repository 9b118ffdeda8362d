farrier_test(core_test unit
  ${CMAKE_CURRENT_LIST_DIR}/core_fault_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core_noise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core_result_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core_threads_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core_signals_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime_awake_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime_deadline_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime_histogram_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trace_file_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(core_test PRIVATE farrier_core farrier_signals farrier_runtime farrier_record)

farrier_test(mcap_test unit ${CMAKE_CURRENT_LIST_DIR}/mcap_test.cpp)
target_link_libraries(mcap_test PRIVATE farrier_mcap)
set_tests_properties(unit/mcap_test PROPERTIES LABELS "unit;ecosystem")  # files cut off at every byte

farrier_test(run_file_test unit
  ${CMAKE_CURRENT_LIST_DIR}/run_file_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals_cdr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals_journal_test.cpp)
target_link_libraries(run_file_test PRIVATE farrier_run_file farrier_signals)
