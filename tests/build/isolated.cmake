# Each of OBJECTS (paths with commas between) must define one name that other files see, its function, and no weak one that the linker would
# take for another file's.
string(REPLACE "," ";" OBJECTS "${OBJECTS}")
foreach(object IN LISTS OBJECTS)
    get_filename_component(entry ${object} NAME_WE)
    execute_process(COMMAND ${NM} --extern-only --defined-only ${object} OUTPUT_VARIABLE names COMMAND_ERROR_IS_FATAL ANY)
    if(NOT names MATCHES "^[0-9a-f]+ T ${entry}\n$")
        message(FATAL_ERROR "${object} defines for others:\n${names}")
    endif()
    # Inline functions are in it, so that the test would see them.
    execute_process(COMMAND ${NM} --defined-only ${object} OUTPUT_VARIABLE names COMMAND_ERROR_IS_FATAL ANY)
    if(NOT names MATCHES " t _Z[^\n]*quell")
        message(FATAL_ERROR "${object} has no function of quell's:\n${names}")
    endif()
endforeach()
