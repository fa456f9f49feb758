# libquell-exr: EXR files for libquell's hosts, in a library of its own, so that libquell does not need OpenEXR.
if(NOT TARGET quell_exr)
    message(STATUS "libquell-exr is left out: it wants OpenEXR 3 (apt install libopenexr-dev)")
    return()
endif()

# Channels of files by their names. quell for Python has it too.
add_library(quell_loaded_frame OBJECT loaded_frame.cpp)
target_link_libraries(quell_loaded_frame PRIVATE quell_develop_portable quell_exr)
# Thirty channels compile in two thirds of the time; reading waits for the file's compression anyway.
target_compile_options(quell_loaded_frame PRIVATE -O1)
add_library(quell_exr_code OBJECT exr_library.cpp)
target_link_libraries(quell_exr_code PRIVATE quell_develop_portable quell_exr)
set_target_properties(quell_loaded_frame quell_exr_code PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)

foreach(kind SHARED STATIC)
    string(TOLOWER quell_library_exr_${kind} target)
    add_library(${target} ${kind} $<TARGET_OBJECTS:quell_exr_code> $<TARGET_OBJECTS:quell_loaded_frame>)
    target_link_libraries(${target} PRIVATE OpenEXR::OpenEXR)
    target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME quell-exr LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LINK_DEPENDS
        ${CMAKE_CURRENT_SOURCE_DIR}/exr_names.map)
endforeach()
target_link_options(quell_library_exr_shared PRIVATE -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/exr_names.map)

set_target_properties(quell_library_exr_shared PROPERTIES EXPORT_NAME library_exr)
set_target_properties(quell_library_exr_static PROPERTIES EXPORT_NAME library_exr_static)
add_library(quell::library_exr ALIAS quell_library_exr_shared)
add_library(quell::library_exr_static ALIAS quell_library_exr_static)

if(QUELL_INSTALL)
    install(TARGETS quell_library_exr_shared quell_library_exr_static EXPORT quellLibraryExrTargets
        LIBRARY COMPONENT library_exr NAMELINK_COMPONENT library_development ARCHIVE COMPONENT library_development)
    install(FILES quell_exr.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library_development)
    install(EXPORT quellLibraryExrTargets NAMESPACE quell:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quell COMPONENT library_development)
    configure_file(quell-library-exr.pc.in quell-library-exr.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/quell-library-exr.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library_development)
endif()
