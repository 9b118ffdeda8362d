# A real browser on the page: Debian's Chromium, driven by what package-lock.json pins. Without it the test is skipped.
find_program(FARRIER_NODE NAMES node nodejs)
set(browser_dir ${CMAKE_CURRENT_LIST_DIR})
set(browser_build ${PROJECT_BINARY_DIR}/browser)
add_executable(page_server EXCLUDE_FROM_ALL ${browser_dir}/page_server.cpp
  ${CMAKE_CURRENT_LIST_DIR}/../../support/made_up_robot.cpp)
target_link_libraries(page_server PRIVATE farrier_bus farrier_control farrier_core farrier_monitor farrier_monitor_displays
  farrier_participant farrier_report farrier_robot farrier_recording farrier_signals farrier_web)
if(FARRIER_NPM AND FARRIER_NODE)
  add_custom_command(OUTPUT ${browser_build}/node_modules/.package-lock.json
    COMMAND ${CMAKE_COMMAND} -E make_directory ${browser_build}
    COMMAND ${CMAKE_COMMAND} -E copy ${browser_dir}/package.json ${browser_dir}/package-lock.json ${browser_build}
    COMMAND ${FARRIER_NPM} ci --prefix ${browser_build} --no-audit --no-fund --loglevel=error
    DEPENDS ${browser_dir}/package.json ${browser_dir}/package-lock.json
    COMMENT "Fetching the driver of the browser" VERBATIM)
  file(GLOB browser_scripts CONFIGURE_DEPENDS ${browser_dir}/*.mjs)
  add_custom_command(OUTPUT ${browser_build}/browser_test.mjs
    COMMAND ${CMAKE_COMMAND} -E copy ${browser_scripts} ${browser_build} DEPENDS ${browser_scripts} VERBATIM)
  add_custom_target(browser_driver ALL DEPENDS ${browser_build}/node_modules/.package-lock.json ${browser_build}/browser_test.mjs)
  add_dependencies(browser_driver page_server farrier_page)
  add_dependencies(tier_ecosystem browser_driver)
  if(NOT TARGET tier_realtime)
    add_custom_target(tier_realtime)
  endif()
  add_dependencies(tier_realtime browser_driver product)
  add_test(NAME ecosystem/browser_test COMMAND ${FARRIER_NODE} ${browser_build}/browser_test.mjs $<TARGET_FILE:page_server>
    ${PROJECT_BINARY_DIR}/share/farrier/page ${PROJECT_SOURCE_DIR}/deploy/robots/hyq.yaml ${browser_build})
  # Its frame rate is of real time.
  set_tests_properties(ecosystem/browser_test PROPERTIES LABELS ecosystem RUN_SERIAL TRUE SKIP_RETURN_CODE 77 TIMEOUT 300)
  add_test(NAME realtime/trot_page_test COMMAND ${FARRIER_NODE} ${browser_build}/trot_page_test.mjs $<TARGET_FILE:farrier>
    ${browser_build})
  set_tests_properties(realtime/trot_page_test PROPERTIES LABELS realtime RUN_SERIAL TRUE SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()
