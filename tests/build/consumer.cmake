# A project that uses quell: from an installed package, from one whose user has GLM and xsimd only, and from its sources.
foreach(way package package_bare subdirectory)
    add_test(NAME consumer/${way}
        COMMAND ${CMAKE_COMMAND} -D WAY=${way} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILT=${PROJECT_BINARY_DIR}
            -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer_${way} -D COMPILER=${CMAKE_CXX_COMPILER} -D "GENERATOR=${CMAKE_GENERATOR}"
            -D THREADS=$<TARGET_EXISTS:quell_threads> -D EXR=$<TARGET_EXISTS:quell_exr>
            -P ${CMAKE_CURRENT_SOURCE_DIR}/build_consumer.cmake)
endforeach()

# Hosts of the Debian packages. They are unpacked, not installed. What was not built is not among them.
foreach(program dpkg-deb dpkg-shlibdeps file cc)
    string(MAKE_C_IDENTIFIER ${program} name)
    string(TOUPPER ${name} name)
    find_program(QUELL_${name} ${program})
    mark_as_advanced(QUELL_${name})
endforeach()
find_program(QUELL_PKG_CONFIG NAMES pkg-config pkgconf)
mark_as_advanced(QUELL_PKG_CONFIG)
set(built)
if(TARGET quell-denoise)
    list(APPEND built -D TOOLS=$<TARGET_FILE:quell-denoise>)
endif()
if(TARGET quell_library_shared)
    list(APPEND built -D LIBRARY=$<TARGET_FILE:quell_library_shared> -D STATIC_LIBRARY=$<TARGET_FILE:quell_library_static>)
    list(APPEND built -D SHADERS_LIBRARY=$<TARGET_FILE:quell_library_shaders_shared>)
    if(TARGET quell_library_exr_shared)
        list(APPEND built -D EXR_LIBRARY=$<TARGET_FILE:quell_library_exr_shared>)
    endif()
endif()
if(TARGET quell_python)
    get_target_property(interpreter quell_python QUELL_INTERPRETER)
    list(APPEND built -D PYTHON=$<TARGET_FILE:quell_python_library> -D INTERPRETER=${interpreter})
endif()
add_test(NAME consumer/debian
    COMMAND ${CMAKE_COMMAND} -D DPKG_DEB=${QUELL_DPKG_DEB} -D DPKG_SHLIBDEPS=${QUELL_DPKG_SHLIBDEPS} -D FILE=${QUELL_FILE}
        -D PKG_CONFIG=${QUELL_PKG_CONFIG} -D C_COMPILER=${QUELL_CC} -D CPACK=${CMAKE_CPACK_COMMAND} ${built}
        -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILT=${PROJECT_BINARY_DIR} -D VERSION=${PROJECT_VERSION}
        -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer_debian -D COMPILER=${CMAKE_CXX_COMPILER} -D "GENERATOR=${CMAKE_GENERATOR}"
        -D THREADS=$<TARGET_EXISTS:quell_threads> -D EXR=$<TARGET_EXISTS:quell_exr>
        -P ${CMAKE_CURRENT_SOURCE_DIR}/debian_packages.cmake)
set_tests_properties(consumer/debian PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
