farrier_test(deploy_test unit
  ${CMAKE_CURRENT_LIST_DIR}/deploy_bus_findings_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy_findings_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy_folder_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy_rendering_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/deploy_surroundings_test.cpp)
target_link_libraries(deploy_test PRIVATE farrier_deploy)
target_compile_definitions(deploy_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
