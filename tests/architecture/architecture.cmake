set(architecture_dir ${CMAKE_CURRENT_LIST_DIR})

farrier_test(architecture_test architecture ${architecture_dir}/source_tree.cpp ${architecture_dir}/target_graph.cpp
  ${architecture_dir}/layering_test.cpp ${architecture_dir}/rules_test.cpp ${architecture_dir}/self_test.cpp)
target_compile_definitions(architecture_test PRIVATE FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
