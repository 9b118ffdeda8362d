farrier_test(plant_test unit
  ${CMAKE_CURRENT_LIST_DIR}/plant/joint_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/integrator_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/create_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/force_dynamics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/linear_forms_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/flexible_load_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/friction_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/lean_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/follow_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/lines_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/linear_model_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/linkage_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/oil_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/supply_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/terms_steady_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/terms_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/valve_hysteresis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/wavy_friction_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(plant_test PRIVATE test_solvers farrier_plant)

farrier_test(electric_joint_test unit ${CMAKE_CURRENT_LIST_DIR}/plant/electric_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plant/rigid_drive_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(electric_joint_test PRIVATE farrier_plant)
