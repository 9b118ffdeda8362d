farrier_test(studies_test unit
  ${CMAKE_CURRENT_LIST_DIR}/thesis/walking_cycle_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/reproduce_claims_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/reproduce_run_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/studies_chirp_figures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/studies_registry_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/studies_rig_run_test.cpp)
target_link_libraries(studies_test PRIVATE farrier_thesis_report nlohmann_json::nlohmann_json)
target_compile_definitions(studies_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")

farrier_test(wiring_trials_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/wiring_trials_test.cpp)
target_link_libraries(wiring_trials_test PRIVATE farrier_wiring_trials)
target_compile_definitions(wiring_trials_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
farrier_test(truth_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/truth_test.cpp)
target_link_libraries(truth_test PRIVATE farrier_truth)
target_compile_definitions(truth_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots")
