# find_package(farrier): targets farrier::process and what it is made of.
include(CMakeFindDependencyMacro)
find_dependency(CycloneDDS)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(Threads)
find_dependency(fastcdr)
find_dependency(fastrtps)
find_dependency(yaml-cpp)
include(${CMAKE_CURRENT_LIST_DIR}/farrier-targets.cmake)
