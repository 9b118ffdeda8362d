farrier_test(config_test unit
  ${CMAKE_CURRENT_LIST_DIR}/config_output_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config_reader_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config_text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/config_yaml_test.cpp)
target_link_libraries(config_test PRIVATE farrier_config)

farrier_test(robot_test unit
  ${CMAKE_CURRENT_LIST_DIR}/robot_adaptation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_deployment_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_estimator_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_effects_by_joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_electric_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_fuzz_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_hyq_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_mistakes_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_round_trip_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/robot_rig_test.cpp)
target_link_libraries(robot_test PRIVATE farrier_robot)
target_compile_definitions(robot_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
