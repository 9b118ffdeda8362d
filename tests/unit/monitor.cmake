farrier_test(monitor_test unit
  ${CMAKE_CURRENT_LIST_DIR}/monitor_feed.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor_metrics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor_robot_view_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor_table_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor_terminal_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor_watch_test.cpp)
target_link_libraries(monitor_test PRIVATE farrier_control farrier_monitor farrier_monitor_displays farrier_participant
  farrier_recorder test_http)
target_compile_definitions(monitor_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/"
  FARRIER_MONITORING="${PROJECT_SOURCE_DIR}/deploy/monitoring/")
