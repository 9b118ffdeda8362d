farrier_test(config_test unit
  ${CMAKE_CURRENT_LIST_DIR}/config/output_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config/reader_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config/text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config/yaml_test.cpp)
target_link_libraries(config_test PRIVATE farrier_config)

farrier_test(robot_test unit
  ${CMAKE_CURRENT_LIST_DIR}/robot/adaptation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/body_loads_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/body_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/deployment_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/estimator_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/effects_by_joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/electric_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/fuzz_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/hyq_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/locomotion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/mistakes_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/round_trip_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot/rig_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/chamber_oil_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/estimation/valve_flow_test.cpp
  ${PROJECT_SOURCE_DIR}/tests/support/allocation_guard.cpp)
target_link_libraries(robot_test PRIVATE farrier_robot)
target_compile_definitions(robot_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
