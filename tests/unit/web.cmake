farrier_test(web_test unit
  ${CMAKE_CURRENT_LIST_DIR}/../support/made_up_robot.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/feed.cpp
  ${CMAKE_CURRENT_LIST_DIR}/web/frame_json_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/web/recording_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/web/server_test.cpp)
target_link_libraries(web_test PRIVATE farrier_body farrier_bus farrier_control farrier_core farrier_monitor farrier_report farrier_robot
  farrier_recording farrier_signals farrier_web PkgConfig::httplib nlohmann_json::nlohmann_json)
target_compile_definitions(web_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
