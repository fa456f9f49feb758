# Runs the shaders of presets, as far as they are compiled in: of General and Effects all but trmv, whose passes are those of shadow, glossy
# and dual-cone, and which takes as long as all three; blur, and the stages behind presets. With QUELL_SHADERS_OF naming presets, of these. Without glslangValidator or
# a Vulkan driver it is skipped.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/../../examples/vulkan_host/run_on_device.cmake)
if(NOT GLSLANG)
    message("skipped: there is no glslangValidator (apt install glslang-tools)")
    return()
endif()
set(presets none surface surface-clamp atrous svgf general final-frame accumulated shadow glossy dual-cone blur light colours resolve)
if(NOT "$ENV{QUELL_SHADERS_OF}" STREQUAL "")
    set(presets $ENV{QUELL_SHADERS_OF})
endif()
execute_process(COMMAND ${SHADERS} --list OUTPUT_VARIABLE compiled COMMAND_ERROR_IS_FATAL ANY)
set(folders)
foreach(preset IN LISTS presets)
    if(compiled MATCHES "(^|\n)${preset}\n")
        # Of views of the buffers lavapipe loads several times as fast, and compiles faster. How shaders load of buffers is tested by
        # examples/vulkan_host, and in browsers.
        write_spirv(${preset} ${FOLDER}/${preset} --texel-loads)
        list(APPEND folders ${FOLDER}/${preset})
    endif()
endforeach()
if(general IN_LIST presets AND compiled MATCHES "(^|\n)general\n")
    write_spirv(general ${FOLDER}/general-half --texel-loads --half-precision)
    list(APPEND folders ${FOLDER}/general-half)
endif()
if(NOT folders)
    message("skipped: quell-shaders is compiled without these presets (QUELL_PRESETS)")
    return()
endif()
# lavapipe compiles a quarter faster without LLVM's optimisations, and these pictures are small.
set(ENV{GALLIVM_PERF} nopt)
run_on_device(${PROGRAM} ${folders})
