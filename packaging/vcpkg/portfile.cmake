# Before use, put the repository's address and the commit in.
set(VCPKG_BUILD_TYPE release) # headers, and a library with an interface of C

vcpkg_from_git(
    OUT_SOURCE_PATH SOURCE_PATH
    URL https://example.org/quell.git
    REF 0000000000000000000000000000000000000000
)
vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES library QUELL_LIBRARY)
if("library" IN_LIST FEATURES AND VCPKG_TARGET_ARCHITECTURE STREQUAL "x64")
    # Of these the best that a machine has is chosen at the start.
    list(APPEND features "-DQUELL_LIBRARY_INSTRUCTION_SETS=x86-64\;x86-64-v3\;x86-64-v4")
endif()
if(NOT "exr" IN_LIST FEATURES)
    list(APPEND features -DCMAKE_DISABLE_FIND_PACKAGE_OpenEXR=ON) # libquell-exr would be built wherever it happens to be
endif()
vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        -DQUELL_DEVELOP=OFF
        -DQUELL_NATIVE=OFF
        ${features}
        "-DQUELL_PKG_CONFIG_REQUIRES=xsimd >= 8"
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH share/cmake/quell)
if("library" IN_LIST FEATURES)
    vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/quell)
endif()

# The module of a part whose library is not there would not pass vcpkg's check.
foreach(part threads exr)
    if(NOT part IN_LIST FEATURES)
        file(REMOVE "${CURRENT_PACKAGES_DIR}/share/pkgconfig/quell-${part}.pc")
    endif()
endforeach()
vcpkg_fixup_pkgconfig()

vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
