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
add_library(quell_exr_code OBJECT exr_library.cpp take_rows.cpp)
target_link_libraries(quell_exr_code PRIVATE quell_develop_portable quell_exr)
set_target_properties(quell_loaded_frame quell_exr_code PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)

quell_c_library(library_exr quell-exr HEADERS quell_exr.h NAMES exr_names.map EXPORT quellLibraryExrTargets
    SOURCES $<TARGET_OBJECTS:quell_exr_code> $<TARGET_OBJECTS:quell_loaded_frame>)
foreach(target quell_library_exr_shared quell_library_exr_static)
    target_link_libraries(${target} PRIVATE OpenEXR::OpenEXR)
endforeach()
