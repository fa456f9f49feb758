# What the toolchain files share. Only what is compiled for the target is found, and headers.cmake adds what needs no compiling.
foreach(kind LIBRARY INCLUDE PACKAGE)
    set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_PROJECT_quell_INCLUDE ${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
