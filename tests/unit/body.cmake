farrier_test(body_test unit
  ${CMAKE_CURRENT_LIST_DIR}/body/body_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/body/rigid_body_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(body_test PRIVATE farrier_body)
