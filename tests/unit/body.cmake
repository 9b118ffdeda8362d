farrier_test(body_test unit
  ${CMAKE_CURRENT_LIST_DIR}/body/body_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/body/own_math_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/body/rigid_body_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/body/scene_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(body_test PRIVATE farrier_body)

if(TARGET farrier_body_engine)
  farrier_test(body_engine_test unit
    ${CMAKE_CURRENT_LIST_DIR}/body/engine_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/body/physics_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
  target_link_libraries(body_engine_test PRIVATE farrier_body_engine farrier_robot)
  target_compile_definitions(body_engine_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
else()
  message(STATUS "unit/body_engine_test is skipped: it needs the packages of deploy/packages/body.txt")
endif()
