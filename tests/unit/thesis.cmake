farrier_test(thesis_errata_test unit
  ${CMAKE_CURRENT_LIST_DIR}/thesis/thesis_errata_models_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/thesis_errata_control_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/thesis/thesis_errata_estimation_test.cpp)
target_link_libraries(thesis_errata_test PRIVATE test_solvers farrier_textbook farrier_estimation farrier_plant)
