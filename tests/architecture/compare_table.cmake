# cmake -DCOMMAND=<farrier> -DTABLE=<name> -DFILE=<file> -P compare_table.cmake: fails when FILE does not end with the
# table that `farrier tables <name>` prints.
execute_process(COMMAND ${COMMAND} tables ${TABLE} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "farrier tables ${TABLE} ended with status ${status}")
endif()
file(READ ${FILE} text)
string(FIND "${text}" "${printed}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${FILE} is stale: replace its table by what 'farrier tables ${TABLE}' prints")
endif()
