farrier_test(world_test unit ${CMAKE_CURRENT_LIST_DIR}/world/scene_file_test.cpp)
target_link_libraries(world_test PRIVATE farrier_world)
target_compile_definitions(world_test PRIVATE FARRIER_SCENES="${PROJECT_SOURCE_DIR}/deploy/scenes/")

if(TARGET farrier_body_world)
  farrier_test(body_world_test unit ${CMAKE_CURRENT_LIST_DIR}/world/actuators_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/world/body_world_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
  target_link_libraries(body_world_test PRIVATE farrier_body_world)
  target_compile_definitions(body_world_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

  farrier_test(body_robot_test unit ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/body_robot_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
  target_link_libraries(body_robot_test PRIVATE farrier_sim_bridge_core)
  target_compile_definitions(body_robot_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

  farrier_test(body_trial_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/body_trial_test.cpp)
  target_link_libraries(body_trial_test PRIVATE farrier_body_trial)
  target_compile_definitions(body_trial_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/"
    FARRIER_SCENES="${PROJECT_SOURCE_DIR}/deploy/scenes/")

  farrier_test(trot_trial_test unit ${CMAKE_CURRENT_LIST_DIR}/trials/push_limit_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/trials/body_adaptation_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/trials/body_contenders_test.cpp ${CMAKE_CURRENT_LIST_DIR}/trials/trot_trial_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/trials/trot_faults_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
  target_link_libraries(trot_trial_test PRIVATE farrier_body_trial)
  target_compile_definitions(trot_trial_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
else()
  message(STATUS "unit/body_world_test, unit/body_trial_test and unit/trot_trial_test are skipped: they need the packages of deploy/packages/body.txt")
endif()
