farrier_test(core_test unit
  ${CMAKE_CURRENT_LIST_DIR}/core/fault_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core/noise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core/portable_math_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core/result_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/core/threads_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals/signals_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals/from_idl_test.cpp
  ${PROJECT_SOURCE_DIR}/lib/signals/from_idl/idl_file.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime/awake_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime/deadline_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/runtime/histogram_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trace/body_trace_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trace/supply_trace_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trace/trace_file_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(core_test PRIVATE farrier_core farrier_signals farrier_runtime farrier_trace)

farrier_test(mcap_test unit ${CMAKE_CURRENT_LIST_DIR}/mcap/mcap_test.cpp)
target_link_libraries(mcap_test PRIVATE farrier_mcap)
set_tests_properties(unit/mcap_test PROPERTIES LABELS "unit;ecosystem")  # files cut off at every byte

farrier_test(run_file_test unit
  ${CMAKE_CURRENT_LIST_DIR}/recording/recording_file_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals/cdr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/signals/journal_test.cpp)
target_link_libraries(run_file_test PRIVATE farrier_recording farrier_signals)
