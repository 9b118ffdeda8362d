farrier_test(diagnosis_test unit
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/box_minimum_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/derive_velocity_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/electric_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/fit_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/load_starts_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/not_judged_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/recording_check_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/recording_fuzz_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/recording_times_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/scaled_recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/scaled_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/selection_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/telling_experiment_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/trace_recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnosis/what_can_be_told_test.cpp)
target_link_libraries(diagnosis_test PRIVATE farrier_diagnosis)
target_compile_definitions(diagnosis_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

farrier_test(calibration_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/calibration_test.cpp)
target_link_libraries(calibration_test PRIVATE farrier_blind)
farrier_test(blind_trials_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/blind_trials_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trials/blind_friction_test.cpp)
target_link_libraries(blind_trials_test PRIVATE farrier_blind)
target_compile_definitions(blind_trials_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

farrier_test(experiment_test unit
  ${CMAKE_CURRENT_LIST_DIR}/trials/experiment_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trials/wiring_evidence_test.cpp)
target_link_libraries(experiment_test PRIVATE farrier_blind farrier_diagnosis farrier_truth farrier_wiring_trials)
target_compile_definitions(experiment_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
