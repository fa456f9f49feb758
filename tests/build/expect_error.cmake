# Compiles SOURCE, which must not compile; the first error must contain the sentence after "// error: " in its first line. What lies
# between #ifdef CORRECT and #else must compile, so that it is the misuse that fails and nothing else.
file(READ ${SOURCE} text)
if(NOT text MATCHES "^// error: ([^\n]+)\n")
    message(FATAL_ERROR "${SOURCE}: the first line must be '// error: <sentence that the compiler prints>'")
endif()
set(sentence "${CMAKE_MATCH_1}")

set(command ${COMPILER} -std=c++20 -fsyntax-only -Wfatal-errors)
foreach(include ${INCLUDES})
    if(include AND NOT include MATCHES "NOTFOUND|^/usr/include$")
        list(APPEND command -I${include})
    endif()
endforeach()

execute_process(COMMAND ${command} ${SOURCE} RESULT_VARIABLE failed ERROR_VARIABLE output)
if(NOT failed)
    message(FATAL_ERROR "${SOURCE} compiles, but should fail with: ${sentence}")
endif()
string(FIND "${output}" "${sentence}" found)
if(found EQUAL -1)
    message(FATAL_ERROR "${SOURCE} should fail with: ${sentence}\nbut the compiler's first error is:\n${output}")
endif()

execute_process(COMMAND ${command} -DCORRECT ${SOURCE} RESULT_VARIABLE failed ERROR_VARIABLE output)
if(failed)
    message(FATAL_ERROR "${SOURCE} does not compile where used correctly (-DCORRECT):\n${output}")
endif()
