# cmake -DCOMMAND=<farrier> -DSHARE=<folder> -P write_manual.cmake: manual pages, compressed as Debian has them, and
# completions of the shells.
function(write_output file)
  execute_process(COMMAND ${COMMAND} ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${SHARE}/${file} "${text}")
endfunction()

file(REMOVE_RECURSE ${SHARE}/man/man1)  # of commands that are gone, too
execute_process(COMMAND ${COMMAND} man --out ${SHARE}/man/man1 COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages ${SHARE}/man/man1/*.1)
execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
write_output(bash-completion/completions/farrier completion bash)
write_output(zsh/vendor-completions/_farrier completion zsh)
write_output(fish/vendor_completions.d/farrier.fish completion fish)
