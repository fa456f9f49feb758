# Each misuse must fail to compile, and the compiler's first error must contain the sentence in the file's first line.
file(GLOB misuses CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/compile_fail/*.cpp)
get_target_property(glm_include glm::glm INTERFACE_INCLUDE_DIRECTORIES)
get_target_property(xsimd_include xsimd INTERFACE_INCLUDE_DIRECTORIES)
foreach(misuse ${misuses})
    get_filename_component(name ${misuse} NAME_WE)
    add_test(NAME compile_fail/${name}
        COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER} -D SOURCE=${misuse}
            "-DINCLUDES=${quell_parsed_header};${PROJECT_SOURCE_DIR}/include;${glm_include};${xsimd_include}"
            -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_error.cmake)
    set_tests_properties(compile_fail/${name} PROPERTIES FIXTURES_REQUIRED parsed_header)
endforeach()
