# What tests of shaders on a Vulkan device have in common. SHADERS is the program quell-shaders.
find_program(GLSLANG glslangValidator)
find_program(SPIRV_VAL spirv-val)

# write_spirv(preset folder options...): its shaders, which must be valid.
function(write_spirv preset folder)
    execute_process(COMMAND ${SHADERS} --preset ${preset} --language spirv --out ${folder} ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
    if(SPIRV_VAL)
        file(GLOB binaries ${folder}/*.spv)
        foreach(binary IN LISTS binaries)
            execute_process(COMMAND ${SPIRV_VAL} --target-env vulkan1.1 ${binary} COMMAND_ERROR_IS_FATAL ANY)
        endforeach()
    endif()
endfunction()

# run_on_device(command...): says what the program says, or that it is skipped for want of a device.
function(run_on_device)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE error)
    if(error MATCHES "there is no driver|no device has a queue")
        message("skipped: there is no Vulkan device (apt install mesa-vulkan-drivers)")
    elseif(NOT code EQUAL 0)
        message(FATAL_ERROR "${said}${error}")
    else()
        message("${said}")
    endif()
endfunction()
