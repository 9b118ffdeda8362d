# What the documents say, and what is made of them: by the label docs. Each source is an entry of CTest.
set(docs_dir ${CMAKE_CURRENT_LIST_DIR})
set(docs_tests links site commands man completion format tidy controller prose touched_files readme)
if(TARGET farrier_body_world)
  list(APPEND docs_tests locomotion)
endif()
set(sources ${docs_tests})
list(TRANSFORM sources REPLACE "(.+)" "${docs_dir}/\\1_test.cpp")
farrier_test_executable(docs_test ${sources} ${docs_dir}/documents.cpp ${docs_dir}/prose.cpp
  ${docs_dir}/../architecture/source_tree.cpp)
target_include_directories(docs_test PRIVATE ${docs_dir})
target_link_libraries(docs_test PRIVATE farrier_cli_manual farrier_trace)
target_compile_definitions(docs_test PRIVATE FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
  FARRIER_COMMAND="$<TARGET_FILE:farrier>" FARRIER_SITE="${PROJECT_BINARY_DIR}/site"
  FARRIER_ASK_ZSH="${docs_dir}/ask.zsh" FARRIER_BUILD_DIR="${PROJECT_BINARY_DIR}")
# The libraries of find_package(farrier), which controller_test installs.
set(installed ${FARRIER_EXPORTED} locomotion_app wire_fastdds)
list(TRANSFORM installed PREPEND farrier_)
add_dependencies(docs_test farrier ${FARRIER_PROCESSES} ${installed})
foreach(name IN LISTS docs_tests)
  farrier_suites(docs_test docs ${docs_dir}/${name}_test.cpp)
endforeach()
farrier_suites(docs_test long ${docs_dir}/tidy_test.cpp NAME long_tidy_test ENVIRONMENT FARRIER_TIDY_ALL=1)
