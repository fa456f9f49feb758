# quell_embed_page(SOURCE FUNCTION HTML file IMAGES sources STYLES files... SCRIPTS files...): writes a C++ file in which the function of
# that name, in quell::examples, returns the page as PageParts. So a page travels inside a program, which needs no files beside it. All
# pages begin alike; IMAGES says where this one may take pictures from (a Content-Security-Policy's sources). One literal per file:
# compilers promise no more than 64 KiB for one.
set(QUELL_PAGE_HEAD ${CMAKE_CURRENT_LIST_DIR}/page/head.html)
set(QUELL_PAGE_TEMPLATE ${CMAKE_CURRENT_LIST_DIR}/page_parts.cpp.in)
function(quell_embed_page source function)
    cmake_parse_arguments(PARSE_ARGV 2 page "" "HTML;IMAGES" "STYLES;SCRIPTS")
    file(READ ${QUELL_PAGE_HEAD} head)
    file(READ ${page_HTML} body)
    string(REPLACE "{{images}}" "${page_IMAGES}" head "${head}")
    set(quell_page_html "${head}${body}")
    foreach(kind STYLES SCRIPTS)
        set(quell_page_${kind} "")
        foreach(file IN LISTS page_${kind})
            file(READ ${file} text)
            string(APPEND quell_page_${kind} "    R\"quell_page(${text})quell_page\",\n")
        endforeach()
    endforeach()
    set(quell_page_function ${function})
    configure_file(${QUELL_PAGE_TEMPLATE} ${source} @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${QUELL_PAGE_HEAD} ${page_HTML} ${page_STYLES} ${page_SCRIPTS})
endfunction()
