# Installs quell under WORK where WAY is `package`, then configures, builds and runs the consumer there.
function(step)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(failed)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed: ${command}\n${output}")
    endif()
endfunction()

# What an earlier run left must not stand in for what is missing now.
file(REMOVE_RECURSE ${WORK})
set(from -D QUELL_SOURCE=${SOURCE})
if(WAY STREQUAL package)
    step(${CMAKE_COMMAND} --install ${BUILT} --prefix ${WORK}/prefix)
    set(from -D CMAKE_PREFIX_PATH=${WORK}/prefix)
endif()
step(${CMAKE_COMMAND} -S ${SOURCE}/tests/build/consumer -B ${WORK}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_BUILD_TYPE=Release -D EXPECT_THREADS=${THREADS} -D EXPECT_EXR=${EXR} ${from})
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${WORK}/build/consumer)
