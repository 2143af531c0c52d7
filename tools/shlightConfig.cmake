# find_package(shlight) -> shlight::shlight; found relative to this file, so the installed tree can be moved.
if(NOT TARGET shlight::shlight)
    get_filename_component(_shlight_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
    add_library(shlight::shlight INTERFACE IMPORTED)
    set_target_properties(shlight::shlight PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${_shlight_prefix}/include/shlight")
    if(UNIX)
        set_target_properties(shlight::shlight PROPERTIES INTERFACE_LINK_LIBRARIES m)
    endif()
    unset(_shlight_prefix)
endif()
