# For cpack, between installing and packing: each package gets the licence, and everybody may enter its folders, whatever the umask of who
# makes it.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
    set(documents ${root}/usr/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    file(MAKE_DIRECTORY ${documents})
    file(COPY_FILE ${CPACK_QUELL_LICENSE} ${documents}/copyright)
    file(CHMOD ${documents}/copyright PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    file(GLOB_RECURSE folders LIST_DIRECTORIES TRUE ${root}/*)
    foreach(folder IN LISTS folders)
        if(IS_DIRECTORY ${folder})
            file(CHMOD ${folder}
                PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
        endif()
    endforeach()
endforeach()
