# libquell-shaders: presets as compute shaders for libquell's hosts, in a library of its own, so that nobody else pays for them.
set(recorded quell_recorded_code)
set(link quell_develop)
if(QUELL_LIBRARY_INSTRUCTION_SETS) # for machines other than this one
    set(recorded quell_recorded_code_portable)
    set(link quell_develop_portable)
    quell_recorded_code(${recorded} ${link})
endif()
add_library(quell_shaders_code OBJECT shaders_library.cpp)
target_link_libraries(quell_shaders_code PRIVATE ${link})
target_compile_options(quell_shaders_code PRIVATE -O0)
set_target_properties(quell_shaders_code PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)

quell_c_library(library_shaders quell-shaders HEADERS quell_shaders.h NAMES shaders_names.map EXPORT quellLibraryShadersTargets
    SOURCES $<TARGET_OBJECTS:quell_shaders_code> $<TARGET_OBJECTS:${recorded}>)
