farrier_test(urdf_test unit
  ${CMAKE_CURRENT_LIST_DIR}/urdf/comparison_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/urdf/urdf_reader_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/urdf/urdf_text_test.cpp)
target_link_libraries(urdf_test PRIVATE farrier_urdf)
target_compile_definitions(urdf_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")

# MuJoCo reads a URDF by itself.
if(TARGET farrier_body_engine)
  farrier_test(urdf_engine_test unit ${CMAKE_CURRENT_LIST_DIR}/urdf/urdf_engine_test.cpp)
  target_link_libraries(urdf_engine_test PRIVATE farrier_urdf ${FARRIER_MUJOCO_LIBRARY})
  target_compile_definitions(urdf_engine_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
endif()
