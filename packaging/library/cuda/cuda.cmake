# Presets for a GPU, by nvcc. It is called as it is: what g++ and clang++ are told, such as -march=native, it does not understand.
option(QUELL_CUDA "Compile presets for NVIDIA GPUs into libquell and the programs: wants nvcc 12 or newer, and minutes" OFF)
set(QUELL_CUDA_PRESETS "general;final-frame;surface-clamp;svgf" CACHE STRING
    "With QUELL_CUDA: presets that are compiled for a GPU; none of them may be of a part of the frame's size")
set(QUELL_CUDA_ARCHITECTURES "arch=compute_80,code=[compute_80,sm_90]" CACHE STRING
    "With QUELL_CUDA: what nvcc is told after -gencode, one for each kind of GPU; compute_80 runs on all since Ampere")

# quell_link_cuda(target): gives it the presets for a GPU, where there are some.
function(quell_link_cuda target)
    if(NOT QUELL_CUDA)
        return()
    endif()
    get_property(objects GLOBAL PROPERTY quell_cuda_objects)
    get_property(runtime GLOBAL PROPERTY quell_cuda_runtime)
    get_property(codes GLOBAL PROPERTY quell_cuda_codes)
    target_sources(${target} PRIVATE ${objects} ${codes})
    add_dependencies(${target} quell_cuda_presets)
    target_compile_definitions(${target} PRIVATE QUELL_CUDA_CODE)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/packaging/library/cuda)
    target_link_libraries(${target} PRIVATE ${runtime} ${CMAKE_DL_LIBS} rt pthread)
endfunction()
if(NOT QUELL_CUDA)
    return()
endif()

find_program(QUELL_NVCC nvcc HINTS ENV CUDA_PATH PATHS /usr/local/cuda PATH_SUFFIXES bin)
if(NOT QUELL_NVCC)
    message(FATAL_ERROR "QUELL_CUDA is ON, and there is no nvcc: install CUDA 12 or newer, set CUDA_PATH, or leave QUELL_CUDA OFF")
endif()
get_filename_component(toolkit ${QUELL_NVCC} REALPATH)
get_filename_component(toolkit ${toolkit} DIRECTORY)
get_filename_component(toolkit ${toolkit} DIRECTORY)
find_library(QUELL_CUDART cudart_static HINTS ${toolkit} PATH_SUFFIXES lib64 lib targets/x86_64-linux/lib targets/sbsa-linux/lib)
if(NOT QUELL_CUDART)
    message(FATAL_ERROR "QUELL_CUDA is ON, and ${toolkit} has no cudart_static: set QUELL_CUDART to the library's path")
endif()
set_property(GLOBAL PROPERTY quell_cuda_runtime ${QUELL_CUDART})

set(architectures)
foreach(architecture IN LISTS QUELL_CUDA_ARCHITECTURES)
    list(APPEND architectures -gencode ${architecture})
endforeach()
set(objects)
set(declarations "")
set(calls "")
foreach(preset IN LISTS QUELL_CUDA_PRESETS)
    string(MAKE_C_IDENTIFIER ${preset} name)
    configure_file(cuda/cuda_unit.cu.in cuda_${name}.cu @ONLY)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/cuda_${name}.o)
    # 20012: GLM marks defaulted functions for the device, which nvcc remarks on and ignores.
    add_custom_command(OUTPUT ${object}
        COMMAND ${QUELL_NVCC} -std=c++20 --expt-relaxed-constexpr -ftz=true -prec-div=false -prec-sqrt=false -diag-suppress 20012 -O2
            ${architectures} -ccbin ${CMAKE_CXX_COMPILER} -Xcompiler -fPIC,-fvisibility=hidden -I${PROJECT_SOURCE_DIR}/include
            -I${PROJECT_SOURCE_DIR}/packaging/library/cuda -MD -MF ${object}.d -c -o ${object} ${CMAKE_CURRENT_BINARY_DIR}/cuda_${name}.cu
        DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/cuda_${name}.cu DEPFILE ${object}.d COMMENT "Compiling ${preset} for a GPU" VERBATIM)
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
    list(APPEND objects ${object})
    string(APPEND declarations "PresetCode cuda_code_${name}();\n")
    string(APPEND calls "cuda_code_${name}(), ")
endforeach()
configure_file(cuda/cuda_codes.cpp.in cuda_codes.cpp @ONLY)
set_property(GLOBAL PROPERTY quell_cuda_codes ${CMAKE_CURRENT_BINARY_DIR}/cuda_codes.cpp)
# Several targets have the objects, which are made once.
add_custom_target(quell_cuda_presets DEPENDS ${objects})
set_property(GLOBAL PROPERTY quell_cuda_objects ${objects})
