# Code for one instruction set that can be linked beside code for others.
#
# Files of one program that are compiled for different instruction sets share inline functions of the standard library, GLM and other headers.
# The linker keeps one copy of each, which may be the one with instructions that the machine lacks. So all files for an instruction set are
# linked into one object, of which one function alone can be seen from outside.

# GNU ld takes functions out of their groups, by which the linker would find those of one name; objcopy hides names.
# With clang++, CMake's own choice are LLVM's programs, which lack the first.
find_program(QUELL_GNU_LD NAMES ld.bfd ld)
find_program(QUELL_GNU_OBJCOPY objcopy)
mark_as_advanced(QUELL_GNU_LD QUELL_GNU_OBJCOPY)
set(QUELL_CAN_ISOLATE OFF)
if(CMAKE_SYSTEM_NAME STREQUAL Linux AND CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64 AND QUELL_GNU_LD AND QUELL_GNU_OBJCOPY)
    execute_process(COMMAND ${QUELL_GNU_LD} --help OUTPUT_VARIABLE help ERROR_QUIET)
    if(help MATCHES "--force-group-allocation")
        set(QUELL_CAN_ISOLATE ON)
    endif()
endif()

# quell_isolated_code(variable code entry [more...])
# Links the objects of the object library `code`, and of `more`, into one, in which all names but that of the function `entry` are local. The variable is
# set to the object's path; it goes among the sources of a target in the same folder.
function(quell_isolated_code variable code entry)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${code}.o)
    # objcopy 2.40 does not hide what g++ makes unique in the whole program.
    set(all)
    foreach(part ${code} ${ARGN})
        target_compile_options(${part} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
        list(APPEND all $<TARGET_OBJECTS:${part}>)
    endforeach()
    add_custom_command(OUTPUT ${object}
        COMMAND ${QUELL_GNU_LD} -r --force-group-allocation -o ${object}.all ${all}
        COMMAND ${QUELL_GNU_OBJCOPY} --keep-global-symbol=${entry} ${object}.all ${object}
        COMMAND ${CMAKE_COMMAND} -E rm ${object}.all
        DEPENDS ${code} ${all} VERBATIM COMMAND_EXPAND_LISTS)
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
    set(${variable} ${object} PARENT_SCOPE)
endfunction()
