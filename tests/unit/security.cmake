farrier_test(security_test unit
  ${CMAKE_CURRENT_LIST_DIR}/security/credentials_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/security/pki_test.cpp)
target_link_libraries(security_test PRIVATE farrier_pki farrier_security)
