farrier_test(plant_test unit
  ${CMAKE_CURRENT_LIST_DIR}/plant_joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_integrator_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_create_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_force_dynamics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_linear_forms_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_friction_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_lines_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_linear_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_linkage_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_terms_steady_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant_terms_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(plant_test PRIVATE farrier_plant)

farrier_test(electric_joint_test unit ${CMAKE_CURRENT_LIST_DIR}/plant_electric_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(electric_joint_test PRIVATE farrier_plant)
