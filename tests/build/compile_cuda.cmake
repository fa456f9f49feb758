# Compiles SOURCE with NVCC into OBJECT. CTest reads "skipped: " as its sign.
if(NOT NVCC)
    message(STATUS "skipped: no nvcc found, so the device kernels are not compiled")
    return()
endif()
execute_process(COMMAND ${NVCC} --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "release ([0-9]+)" OR CMAKE_MATCH_1 LESS 12)
    message(STATUS "skipped: ${NVCC} is older than CUDA 12, the first with C++20")
    return()
endif()
# 20012: GLM marks defaulted functions for the device, which nvcc remarks on and ignores.
execute_process(COMMAND ${NVCC} -std=c++20 --expt-relaxed-constexpr -diag-suppress 20012 -Werror all-warnings -I${INCLUDE}
    -c ${SOURCE} -o ${OBJECT} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(failed)
    message(FATAL_ERROR "${output}")
endif()
