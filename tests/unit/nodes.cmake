farrier_test(joint_node_test unit
  ${CMAKE_CURRENT_LIST_DIR}/gains_check_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_arming_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_dither_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_fault_events_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_flow_law_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_flow_inversion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_gains_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_force_lost_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_missing_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_reference_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_stance_lead_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node_standing_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(joint_node_test PRIVATE farrier_joint_node_core farrier_supervisor_core)

farrier_test(bus_faults_test unit ${CMAKE_CURRENT_LIST_DIR}/bus_faults_test.cpp)
target_link_libraries(bus_faults_test PRIVATE farrier_bus_faults)

farrier_test(nodes_test unit
  ${CMAKE_CURRENT_LIST_DIR}/estimator_service_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/lab_hide_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sensor_chain_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sensor_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_world_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_world_contact_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_world_load_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge_trace_thread_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/summariser_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_adaptive_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_first_gains_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_known_loads_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_orders_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_physics_update_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_slot_news_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_slot_pair_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_slot_update_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_succession_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor_update_method_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(nodes_test PRIVATE farrier_estimator_service_core farrier_sim_bridge_app
  farrier_supervisor_core farrier_joint_node_core farrier_hide)

farrier_test(participant_test unit
  ${CMAKE_CURRENT_LIST_DIR}/participant_arrival_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant_greeting_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant_ports_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant_silence_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/realtime_loop_test.cpp)
target_link_libraries(participant_test PRIVATE farrier_participant)

farrier_test(recorder_test unit
  ${CMAKE_CURRENT_LIST_DIR}/run_recording_test.cpp)
target_link_libraries(recorder_test PRIVATE farrier_recorder)

farrier_test(bench_test unit
  ${CMAKE_CURRENT_LIST_DIR}/bench_tick_test.cpp)
target_link_libraries(bench_test PRIVATE farrier_bench)

foreach(test IN ITEMS joint_node_test nodes_test recorder_test bench_test)
  target_compile_definitions(${test} PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
endforeach()

farrier_test(faults_test unit ${CMAKE_CURRENT_LIST_DIR}/faults_test.cpp)
target_link_libraries(faults_test PRIVATE farrier_faults)
target_compile_definitions(faults_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
