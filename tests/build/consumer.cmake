# A project that uses quell: from an installed package, from one whose user has GLM and xsimd only, and from its sources.
foreach(way package package_bare subdirectory)
    add_test(NAME consumer/${way}
        COMMAND ${CMAKE_COMMAND} -D WAY=${way} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILT=${PROJECT_BINARY_DIR}
            -D WORK=${CMAKE_CURRENT_BINARY_DIR}/consumer_${way} -D COMPILER=${CMAKE_CXX_COMPILER} -D "GENERATOR=${CMAKE_GENERATOR}"
            -D THREADS=$<TARGET_EXISTS:quell_threads> -D EXR=$<TARGET_EXISTS:quell_exr>
            -P ${CMAKE_CURRENT_SOURCE_DIR}/build_consumer.cmake)
endforeach()
