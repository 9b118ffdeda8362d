farrier_test(monitor_test unit
  ${CMAKE_CURRENT_LIST_DIR}/monitor/feed.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/metrics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/phases_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/robot_view_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/supply_view_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/table_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/terminal_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/monitor/watch_test.cpp)
target_link_libraries(monitor_test PRIVATE farrier_control farrier_monitor farrier_monitor_displays farrier_participant
  farrier_recorder test_http)
target_compile_definitions(monitor_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/"
  FARRIER_MONITORING="${PROJECT_SOURCE_DIR}/deploy/monitoring/")
