farrier_test(joint_node_test unit
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/gains_check_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/arming_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/dither_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/fault_events_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/flow_law_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/flow_inversion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/gains_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/force_lost_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/missing_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/reference_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/stance_lead_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/standing_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(joint_node_test PRIVATE farrier_joint_node_core farrier_supervisor_core)

farrier_test(bus_faults_test unit ${CMAKE_CURRENT_LIST_DIR}/bus_faults/bus_faults_test.cpp)
target_link_libraries(bus_faults_test PRIVATE farrier_bus_faults)

farrier_test(nodes_test unit
  ${CMAKE_CURRENT_LIST_DIR}/estimator_service/estimator_service_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/trials/hide_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/sensor_chain_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/sensor_effects_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/sim_world_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/sim_world_contact_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/sim_world_load_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sim_bridge/trace_thread_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/joint_node/summariser_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/adaptive_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/first_gains_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/known_loads_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/law_check_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/orders_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/physics_update_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/slot_news_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/slot_pair_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/slot_update_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/succession_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/supervisor_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/supervisor/update_method_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../support/allocation_guard.cpp)
target_link_libraries(nodes_test PRIVATE farrier_estimator_service_core farrier_sim_bridge_app
  farrier_supervisor_core farrier_joint_node_core farrier_hide)

farrier_test(participant_test unit
  ${CMAKE_CURRENT_LIST_DIR}/participant/arrival_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant/greeting_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant/ports_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant/silence_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/participant/realtime_loop_test.cpp)
target_link_libraries(participant_test PRIVATE farrier_participant)

farrier_test(recorder_test unit
  ${CMAKE_CURRENT_LIST_DIR}/recorder/run_recording_test.cpp)
target_link_libraries(recorder_test PRIVATE farrier_recorder)

farrier_test(bench_test unit
  ${CMAKE_CURRENT_LIST_DIR}/bench/bench_tick_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/bench/parts_test.cpp)
target_link_libraries(bench_test PRIVATE farrier_bench farrier_bench_parts)
if(TARGET farrier_body_trial)
  target_sources(bench_test PRIVATE ${CMAKE_CURRENT_LIST_DIR}/bench/bench_body_test.cpp)
endif()

foreach(test IN ITEMS joint_node_test nodes_test recorder_test bench_test)
  target_compile_definitions(${test} PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
endforeach()

farrier_test(faults_test unit ${CMAKE_CURRENT_LIST_DIR}/faults/faults_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/faults/ground_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/faults/safety_table_test.cpp)
target_link_libraries(faults_test PRIVATE farrier_faults)
target_compile_definitions(faults_test PRIVATE FARRIER_ROBOTS="${PROJECT_SOURCE_DIR}/deploy/robots/")
