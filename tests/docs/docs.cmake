# What the documents say, and what is made of them: by the label docs.
function(farrier_docs_test name)
  farrier_test(${name} docs ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${name}.cpp ${ARGN})
  target_sources(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/documents.cpp)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  target_compile_definitions(${name} PRIVATE FARRIER_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    FARRIER_COMMAND="$<TARGET_FILE:farrier>" FARRIER_SITE="${PROJECT_BINARY_DIR}/site")
endfunction()

farrier_docs_test(links_test)
farrier_docs_test(site_test)
farrier_docs_test(commands_test)
target_link_libraries(commands_test PRIVATE farrier_cli_manual)
farrier_docs_test(man_test)
target_link_libraries(man_test PRIVATE farrier_cli_manual)
farrier_docs_test(completion_test)
target_compile_definitions(completion_test PRIVATE FARRIER_ASK_ZSH="${CMAKE_CURRENT_LIST_DIR}/ask.zsh")
add_dependencies(man_test farrier)
add_dependencies(completion_test farrier)
