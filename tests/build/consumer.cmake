# A project that uses quell: from an installed package, from one whose user has GLM and xsimd only, and from its sources.
foreach(way package package_bare subdirectory)
    add_test(NAME consumer/${way}
        COMMAND ${CMAKE_COMMAND} -D WAY=${way} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILT=${PROJECT_BINARY_DIR}
            -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer_${way} -D COMPILER=${CMAKE_CXX_COMPILER} -D "GENERATOR=${CMAKE_GENERATOR}"
            -D THREADS=$<TARGET_EXISTS:quell_threads> -D EXR=$<TARGET_EXISTS:quell_exr>
            -P ${CMAKE_CURRENT_SOURCE_DIR}/build_consumer.cmake)
endforeach()

# A host of the Debian package. It is unpacked, not installed.
find_program(QUELL_DPKG_DEB dpkg-deb)
find_program(QUELL_PKG_CONFIG NAMES pkg-config pkgconf)
mark_as_advanced(QUELL_DPKG_DEB QUELL_PKG_CONFIG)
add_test(NAME consumer/debian
    COMMAND ${CMAKE_COMMAND} -D DPKG_DEB=${QUELL_DPKG_DEB} -D PKG_CONFIG=${QUELL_PKG_CONFIG} -D CPACK=${CMAKE_CPACK_COMMAND}
        -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILT=${PROJECT_BINARY_DIR} -D VERSION=${PROJECT_VERSION}
        -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer_debian -D COMPILER=${CMAKE_CXX_COMPILER} -D "GENERATOR=${CMAKE_GENERATOR}"
        -D THREADS=$<TARGET_EXISTS:quell_threads> -D EXR=$<TARGET_EXISTS:quell_exr>
        -P ${CMAKE_CURRENT_SOURCE_DIR}/debian_package.cmake)
set_tests_properties(consumer/debian PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
