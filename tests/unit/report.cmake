farrier_test(report_test unit
  ${CMAKE_CURRENT_LIST_DIR}/report_adaptation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_controllers_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_diagnosis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_extended_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_figures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_growth_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_hide_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_joint_poles_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_load_cycle_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_outcome_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_page_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_sample_text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_scaled_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_tracking_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_update_logic_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report_vary_test.cpp)
target_link_libraries(report_test PRIVATE farrier_report farrier_supervisor_core nlohmann_json::nlohmann_json)
target_compile_definitions(report_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")

farrier_test(recording_test unit ${CMAKE_CURRENT_LIST_DIR}/joint_recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/recording_csv_test.cpp)
target_link_libraries(recording_test PRIVATE farrier_recording farrier_run_file farrier_signals)
target_compile_definitions(recording_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
