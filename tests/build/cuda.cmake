# The kernels of presets::svgf for the device: success is compiling. nvcc is no part of quell's build, so it is called like any program.
find_program(QUELL_NVCC nvcc HINTS /usr/local/cuda/bin ENV CUDA_PATH PATH_SUFFIXES bin)
add_test(NAME cuda COMMAND ${CMAKE_COMMAND} -D NVCC=${QUELL_NVCC} -D SOURCE=${CMAKE_CURRENT_SOURCE_DIR}/cuda/svgf.cu
    -D INCLUDE=${PROJECT_SOURCE_DIR}/include -D OBJECT=${CMAKE_CURRENT_BINARY_DIR}/svgf.o
    -P ${CMAKE_CURRENT_SOURCE_DIR}/compile_cuda.cmake)
set_tests_properties(cuda PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
