farrier_test(deploy_test unit
  ${CMAKE_CURRENT_LIST_DIR}/deploy/bus_findings_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy/findings_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy/folder_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy/rendering_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy/surroundings_test.cpp)
target_link_libraries(deploy_test PRIVATE farrier_deploy)
target_compile_definitions(deploy_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
