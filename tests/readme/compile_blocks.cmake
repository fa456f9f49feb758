# Compiles every ```cpp block of some pages, and of each that defines a pipeline `denoise` what running it takes, pixel by pixel and in packs:
# kernels are templates, in which a compiler finds little wrong before they are used.
#     cmake -DROOT=. "-DPAGES=docs/*.md" -DCOMPILER=g++ -DINCLUDE=include -DFOLDER=/tmp/blocks -P compile_blocks.cmake
cmake_minimum_required(VERSION 3.22)
get_filename_component(ROOT "${ROOT}" ABSOLUTE)
set(runs "
void run_what_is_shown(quell::Extent size) {
    quell::Frame frame{size, denoise}; quell::History history{size, denoise};
    static_cast<void>(quell::run(denoise, frame, history, quell::Serial{}));
    static_cast<void>(quell::run(denoise, frame, history, quell::Simd{}));
}
")
# PARSED_HEADER: a folder with quell/quell.hpp.gch, or none.
set(includes -I${INCLUDE})
if(PARSED_HEADER)
    list(PREPEND includes -I${PARSED_HEADER})
endif()
file(GLOB pages LIST_DIRECTORIES false RELATIVE ${ROOT} ${ROOT}/${PAGES})
set(total 0)
foreach(page IN LISTS pages)
    file(READ ${ROOT}/${page} text)
    string(REPLACE ";" "<semicolon>" text "${text}")
    string(REPLACE "[" "<open>" text "${text}")
    string(REPLACE "]" "<close>" text "${text}")
    string(REGEX MATCHALL "```cpp\n[^`]*```" blocks "${text}")
    # A block that holds a backtick is one that the pattern above passes over.
    string(REGEX MATCHALL "```cpp\n" begun "${text}")
    list(LENGTH blocks count)
    list(LENGTH begun expected)
    if(NOT count EQUAL expected)
        message(FATAL_ERROR "${page}: ${expected} C++ blocks begin and ${count} end; leave backticks out of their code")
    endif()
    string(MAKE_C_IDENTIFIER "${page}" name)
    set(number 0)
    foreach(block IN LISTS blocks)
        math(EXPR number "${number} + 1")
        string(REGEX REPLACE "^```cpp\n|```$" "" code "${block}")
        string(REPLACE "<semicolon>" ";" code "${code}")
        string(REPLACE "<open>" "[" code "${code}")
        string(REPLACE "<close>" "]" code "${code}")
        if(code MATCHES "(^|\n)constexpr auto denoise =")
            string(APPEND code "${runs}")
        endif()
        file(WRITE ${FOLDER}/${name}_${number}.cpp "${code}")
        execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra ${includes} ${FOLDER}/${name}_${number}.cpp
            RESULT_VARIABLE failed)
        if(failed)
            message(FATAL_ERROR "C++ block ${number} of ${page} does not compile")
        endif()
    endforeach()
    math(EXPR total "${total} + ${count}")
endforeach()
if(total EQUAL 0)
    message(FATAL_ERROR "${PAGES} in ${ROOT}: no C++ block")
endif()
message(STATUS "${total} blocks compile")
