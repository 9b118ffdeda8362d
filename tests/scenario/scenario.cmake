farrier_test(scenario_test scenario
  ${CMAKE_CURRENT_LIST_DIR}/adaptation_wiring_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/adaptive_trot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/determinism_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/lifecycle_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/load_cycle_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/recorded_trot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/rig_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/rig_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/switching_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trace_checksum_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trot_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/update_logic_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/vary_test.cpp)
if(TARGET farrier_body_world)
  target_sources(scenario_test PRIVATE ${CMAKE_CURRENT_LIST_DIR}/walk_test.cpp)
  target_link_libraries(scenario_test PRIVATE farrier_body_trial)
endif()
target_link_libraries(scenario_test PRIVATE farrier_diagnosis farrier_hide farrier_offline farrier_report_trot farrier_thesis
  farrier_trials)
target_compile_definitions(scenario_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

farrier_test(tracking_gain_test scenario ${CMAKE_CURRENT_LIST_DIR}/tracking_gain_test.cpp)
target_link_libraries(tracking_gain_test PRIVATE farrier_tracking_gain)
target_compile_definitions(tracking_gain_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

farrier_test(robots_test scenario ${CMAKE_CURRENT_LIST_DIR}/robots_test.cpp)
target_link_libraries(robots_test PRIVATE farrier_report_trot farrier_trials)
target_compile_definitions(robots_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
