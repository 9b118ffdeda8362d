# Where things lie, in the build directory as below an installation's prefix, so that a command finds its processes and
# robot files by one rule (cli/base/installation.hpp):
#
#   bin/farrier               the command
#   libexec/farrier/          its other programs (farrier-<program>) and the processes
#   share/farrier/robots/     robot files
#   share/farrier/scenes/     scene files
#   share/farrier/foxglove/   layout for Foxglove and Lichtblick
#   share/farrier/monitoring/ configuration and alert rules for Prometheus
#   share/farrier/page/       the page of farrier monitor --web (tools/web/page)
#   share/man/, share/bash-completion/, share/zsh/, share/fish/    written by the command, where Debian looks for them
#   include/farrier/, lib/    for programs of the user's
#
# Three components, three packages: `cpack` in the build directory makes them.
set_target_properties(${FARRIER_PROCESSES} ${FARRIER_FAULTY_PROGRAMS} bare_exchange PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/libexec/farrier)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/farrier)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/deploy/robots ${PROJECT_BINARY_DIR}/share/farrier/robots SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/deploy/scenes ${PROJECT_BINARY_DIR}/share/farrier/scenes SYMBOLIC)

install(TARGETS ${FARRIER_PROCESSES} DESTINATION libexec/farrier COMPONENT runtime)
install(DIRECTORY deploy/robots deploy/scenes DESTINATION share/farrier COMPONENT runtime)
install(DIRECTORY deploy/foxglove deploy/monitoring deploy/ros2 DESTINATION share/farrier COMPONENT tools)
install(TARGETS bare_exchange farrier_wall_clock ${FARRIER_FAULTY_PROGRAMS} DESTINATION libexec/farrier COMPONENT tools)

# What a process of a robot is made of, for those who write one of their own.
set(FARRIER_EXPORTED core signals config runtime plant control estimation gait body locomotion robot bus cyclone_base bus_cyclone
  bus_fastdds bus_factory participant process security wire_gains)
foreach(library IN LISTS FARRIER_EXPORTED)
  if(NOT TARGET farrier_${library})
    continue()
  endif()
  set_target_properties(farrier_${library} PROPERTIES EXPORT_NAME ${library})
  install(TARGETS farrier_${library} EXPORT farrier DESTINATION lib/farrier COMPONENT dev)
  install(DIRECTORY lib/${library} DESTINATION include/farrier COMPONENT dev FILES_MATCHING
    PATTERN "*.hpp" PATTERN "*.def")
endforeach()
install(DIRECTORY ${PROJECT_BINARY_DIR}/from_idl/signals DESTINATION include/farrier COMPONENT dev FILES_MATCHING
  PATTERN "structs.hpp" PATTERN "field_lists.hpp")
install(TARGETS farrier_flags EXPORT farrier COMPONENT dev)
set_target_properties(farrier_flags PROPERTIES EXPORT_NAME flags)
# A process locomotion of the user's own: the ports of the shipped one.
set_target_properties(farrier_locomotion_app PROPERTIES EXPORT_NAME locomotion_app)
install(TARGETS farrier_locomotion_app EXPORT farrier DESTINATION lib/farrier COMPONENT dev)
install(DIRECTORY locomotion DESTINATION include/farrier COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
set(FARRIER_HAS_FAST_DDS OFF)
if(TARGET farrier_wire_fastdds)
  set(FARRIER_HAS_FAST_DDS ON)
  install(TARGETS farrier_wire_fastdds EXPORT farrier DESTINATION lib/farrier COMPONENT dev)
endif()
install(EXPORT farrier NAMESPACE farrier:: DESTINATION lib/cmake/farrier FILE farrier-targets.cmake COMPONENT dev)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/farrier-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_file(deploy/packaging/farrier-config.cmake.in farrier-config.cmake @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/farrier-config.cmake ${PROJECT_BINARY_DIR}/farrier-config-version.cmake
  DESTINATION lib/cmake/farrier COMPONENT dev)
install(DIRECTORY deploy/packaging/example docs/how-to/controller docs/how-to/locomotion
  DESTINATION share/doc/farrier-dev COMPONENT dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Farrier authors")
set(CPACK_PACKAGE_VENDOR "Farrier")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Torque control of hydraulic legged robots over DDS")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime tools dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Processes of a robot and robot files")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "The farrier command: run, measure, diagnose, deploy")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers and libraries for processes of your own: find_package(farrier)")
set(CPACK_COMPONENT_TOOLS_DEPENDS runtime)
# Reports are drawn by gnuplot, which needs a font.
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "gnuplot-nox, fonts-dejavu-core")
# Scrapes what "farrier monitor --prometheus" serves, on whichever computer that is.
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "prometheus")
# What its libraries are linked with and its headers include.
set(FARRIER_DEV_NEEDS cyclonedds-dev libeigen3-dev libssl-dev libsystemd-dev libtinyxml2-dev libyaml-cpp-dev)
if(FARRIER_HAS_FAST_DDS)
  list(APPEND FARRIER_DEV_NEEDS libfastcdr-dev libfastrtps-dev)
endif()
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
list(JOIN FARRIER_DEV_NEEDS ", " CPACK_DEBIAN_DEV_PACKAGE_DEPENDS)
foreach(component IN ITEMS RUNTIME TOOLS DEV)
  string(TOLOWER farrier-${component} CPACK_DEBIAN_${component}_PACKAGE_NAME)
endforeach()
include(CPack)
