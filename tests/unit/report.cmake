farrier_test(report_test unit
  ${CMAKE_CURRENT_LIST_DIR}/report/adaptation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/controllers_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/diagnosis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/diagnosis_wiring_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/diagnosis_words_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/extended_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/figures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/growth_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/hide_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/joint_poles_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/outcome_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/page_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/pictures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/sample_text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/scaled_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/tracking_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/update_logic_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/vary_test.cpp)
target_link_libraries(report_test PRIVATE farrier_report_compare farrier_report_diagnosis farrier_report_trot
  farrier_supervisor_core nlohmann_json::nlohmann_json)
target_compile_definitions(report_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")

farrier_test(report_walk_test unit
  ${CMAKE_CURRENT_LIST_DIR}/report/walk_report_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/report/walk_test.cpp)
target_link_libraries(report_walk_test PRIVATE farrier_report_walk)
target_compile_definitions(report_walk_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")

farrier_test(without_body_test unit ${CMAKE_CURRENT_LIST_DIR}/cli/without_body_test.cpp
  ${PROJECT_SOURCE_DIR}/cli/trial/without_body.cpp)
target_link_libraries(without_body_test PRIVATE farrier_cli)

farrier_test(drive_steering_test unit ${CMAKE_CURRENT_LIST_DIR}/cli/steering_test.cpp)
target_link_libraries(drive_steering_test PRIVATE farrier_cli_drive)

if(TARGET farrier_report_body)
  farrier_test(report_body_test unit ${CMAKE_CURRENT_LIST_DIR}/report/body_test.cpp)
  target_link_libraries(report_body_test PRIVATE farrier_report_body)
endif()

farrier_test(recording_test unit ${CMAKE_CURRENT_LIST_DIR}/offline/joint_recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/playback/csv_files_test.cpp)
target_link_libraries(recording_test PRIVATE farrier_offline farrier_playback farrier_recording farrier_signals)
target_compile_definitions(recording_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
