# Programs of others that must be able to use what Farrier makes. First npm's readers of recordings and its node of RTPS: what package-lock.json
# names is fetched into the build tree, once.
find_program(FARRIER_NPM npm)
set(ecosystem_dir ${CMAKE_CURRENT_LIST_DIR})
set(ros_peer ${PROJECT_SOURCE_DIR}/tests/ros/peer.mjs)
set(ecosystem_build ${PROJECT_BINARY_DIR}/ecosystem)
if(FARRIER_NPM)
  add_custom_command(OUTPUT ${ecosystem_build}/node_modules/.package-lock.json
    COMMAND ${CMAKE_COMMAND} -E make_directory ${ecosystem_build}
    COMMAND ${CMAKE_COMMAND} -E copy ${ecosystem_dir}/package.json ${ecosystem_dir}/package-lock.json
      ${ecosystem_dir}/decode_recording.mjs ${ecosystem_dir}/indexed_mcap.mjs ${ros_peer} ${ecosystem_build}
    COMMAND ${FARRIER_NPM} ci --prefix ${ecosystem_build} --no-audit --no-fund --loglevel=error
    DEPENDS ${ecosystem_dir}/package.json ${ecosystem_dir}/package-lock.json ${ecosystem_dir}/decode_recording.mjs
      ${ecosystem_dir}/indexed_mcap.mjs ${ros_peer}
    COMMENT "Fetching npm's readers of recordings and its node of RTPS" VERBATIM)
  add_custom_target(ecosystem_readers DEPENDS ${ecosystem_build}/node_modules/.package-lock.json)

  farrier_test(ecosystem_test ecosystem ${ecosystem_dir}/ecosystem_test.cpp)
  target_link_libraries(ecosystem_test PRIVATE farrier_recording farrier_bus farrier_signals
    farrier_tool_process nlohmann_json::nlohmann_json)
  target_compile_definitions(ecosystem_test PRIVATE FARRIER_ECOSYSTEM="${ecosystem_build}")
  add_dependencies(ecosystem_test ecosystem_readers)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/browser/browser.cmake)
