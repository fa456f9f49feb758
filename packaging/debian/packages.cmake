# `cpack -G DEB` makes a package of each component. What was not built is not packed: what_was_built.cmake.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME quell)
if(NOT CPACK_PACKAGE_CONTACT) # of whoever hands the packages to others: Name <address>
    set(CPACK_PACKAGE_CONTACT "The quell authors")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_QUELL_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_BINARY_DIR}/what_was_built.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish.cmake)

# quell_debian_package(component name section depends description target...): what is installed as the component. It is packed where the
# targets were built. A dependency list may be empty; shared libraries are found out.
set(built_files)
macro(quell_debian_package component name section depends description)
    string(TOUPPER ${component} upper)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON)
    string(APPEND built_files "set(quell_files_of_${component}")
    foreach(target ${ARGN})
        if(TARGET ${target})
            string(APPEND built_files " \"$<TARGET_FILE:${target}>\"")
        endif()
    endforeach()
    string(APPEND built_files ")\n")
endmacro()

set(library libquell${PROJECT_VERSION_MAJOR})
quell_debian_package(tools quell-tools graphics "" "Real-time denoising of ray-traced images, programs
quell-denoise removes the noise from EXR sequences of any renderer,
quell-shaders writes presets as compute shaders for engines.
quell-trace and quell-demo render sequences to try it on; quell-bench,
quell-chart and quell-stability measure methods, as far as they are here." ${quell_programs})
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "glslang-tools, spirv-cross")

quell_debian_package(library ${library} libs "" "Real-time denoising of ray-traced images, shared library
It has quell's presets, compiled, for C and all languages that call it." quell_library_shared)
# What packages of hosts depend on.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/shlibs CONTENT "libquell ${PROJECT_VERSION_MAJOR} ${library} (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/shlibs)

set(shaders_library)
if(TARGET quell_library_shaders_shared)
    set(shaders_library "libquell-shaders${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}), ")
    quell_debian_package(library_shaders libquell-shaders${PROJECT_VERSION_MAJOR} libs "" "Real-time denoising of ray-traced images, presets as shaders
It writes quell's presets as compute shaders for WebGPU and Vulkan." quell_library_shaders_shared)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/shaders/shlibs
        CONTENT "libquell-shaders ${PROJECT_VERSION_MAJOR} libquell-shaders${PROJECT_VERSION_MAJOR} (>= ${PROJECT_VERSION})\n")
    set(CPACK_DEBIAN_LIBRARY_SHADERS_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/shaders/shlibs)
endif()
set(exr_library)
if(TARGET quell_library_exr_shared)
    set(exr_library "libquell-exr${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}), ")
    quell_debian_package(library_exr libquell-exr${PROJECT_VERSION_MAJOR} libs "" "Real-time denoising of ray-traced images, EXR files
It reads and writes EXR files for hosts of libquell." quell_library_exr_shared)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/exr/shlibs
        CONTENT "libquell-exr ${PROJECT_VERSION_MAJOR} libquell-exr${PROJECT_VERSION_MAJOR} (>= ${PROJECT_VERSION})\n")
    set(CPACK_DEBIAN_LIBRARY_EXR_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/exr/shlibs)
endif()

# oneTBB: the static library is linked with it, and CMake's file of both libraries names it.
quell_debian_package(library_development libquell-dev libdevel
    "${library} (= ${PROJECT_VERSION}), ${exr_library}${shaders_library}libquell-headers (= ${PROJECT_VERSION}), libtbb-dev (>= 2021)"
    "Real-time denoising of ray-traced images, development files
Headers for C and C++, the static library, and what CMake and pkg-config
find libquell by." quell_library_shared quell_library_static)
set(CPACK_DEBIAN_LIBRARY_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)

quell_debian_package(headers libquell-headers libdevel "libglm-dev, libxsimd-dev (>= 8)" "Real-time denoising of ray-traced images, header-only library
It is a library of C++20 headers. libtbb-dev is for its executor of
many threads, libopenexr-dev for EXR files.")
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "libtbb-dev (>= 2021), libopenexr-dev (>= 3)")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SHLIBDEPS OFF)

# Its modules are for one version of Python.
set(depends "")
if(TARGET quell_python)
    get_target_property(python_version quell_python QUELL_INTERPRETER_VERSION)
    string(REPLACE "." ";" parts ${python_version})
    list(GET parts 0 major)
    list(GET parts 1 minor)
    math(EXPR next_minor "${minor} + 1")
    set(depends "python3 (>= ${major}.${minor}~), python3 (<< ${major}.${next_minor}), python3-numpy")
endif()
quell_debian_package(python python3-quell python "${depends}" "Real-time denoising of ray-traced images, for Python
quell.Denoiser and quell.denoise work on NumPy arrays; metrics and EXR
files beside them." quell_python_library quell_python_metrics quell_python_shaders quell_python_exr)

configure_file(${CMAKE_CURRENT_LIST_DIR}/what_was_built.cmake.in what_was_built.cmake @ONLY)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/built_files_$<CONFIG>.cmake CONTENT "${built_files}")
include(CPack)
