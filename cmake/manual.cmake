# cmake -DPROGRAM=taut -DFOLDER=share -P manual.cmake: writes FOLDER/man/man1/*.1, one page a subcommand, and what shells complete, from
# what the program itself says.
cmake_policy(SET CMP0057 NEW)

function(say output)
  execute_process(COMMAND ${PROGRAM} help ${ARGN} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${FOLDER}/${output} "${text}")
  set(text "${text}" PARENT_SCOPE)
endfunction()

# write_pages(NAME WORD...): the page of a subcommand and those of what is below it.
function(write_pages name)
  say(man/man1/${name}.1 ${ARGN} --as man)
  string(REGEX MATCHALL "\n\\\\fB[a-z\\\\-]+\\\\fR\\(1\\)\n" entries "${text}")
  foreach(entry IN LISTS entries)
    string(REGEX REPLACE "[\n]|\\\\fB|\\\\fR\\(1\\)" "" page "${entry}")
    string(REPLACE "\\-" "-" page "${page}")
    string(REGEX REPLACE ".*-" "" word "${page}")
    if(NOT page STREQUAL taut AND NOT word STREQUAL help)
      write_pages(${page} ${ARGN} ${word})
    endif()
  endforeach()
endfunction()

write_pages(taut)
say(bash-completion/completions/taut --as bash)
say(zsh/vendor-completions/_taut --as zsh)
say(fish/vendor_completions.d/taut.fish --as fish)
