# SPDX-License-Identifier: MIT
# rivage_room(NAME sph_numerics LINK rivage::coupler_foundation ...): the library of the folder it is called in.
# A room without .cpp files becomes an INTERFACE library. Alias: rivage::NAME.
function(rivage_room)
    cmake_parse_arguments(ROOM "" "NAME" "LINK" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    if(sources)
        add_library(${ROOM_NAME} STATIC ${sources})
        target_link_libraries(${ROOM_NAME} PUBLIC rivage::options ${ROOM_LINK})
        if(ROOM_NAME MATCHES "^coupler_") # part of librivage.so
            set_target_properties(${ROOM_NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON)
            rivage_precompiled(${ROOM_NAME} LIBRARY)
        else()
            rivage_precompiled(${ROOM_NAME})
        endif()
    else()
        add_library(${ROOM_NAME} INTERFACE)
        target_link_libraries(${ROOM_NAME} INTERFACE rivage::options ${ROOM_LINK})
    endif()
    add_library(rivage::${ROOM_NAME} ALIAS ${ROOM_NAME})
endfunction()

# rivage_rooms(coupler_lib foundation base ...): adds the rooms that exist, in floor order.
function(rivage_rooms)
    foreach(room ${ARGN})
        if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${room}/CMakeLists.txt")
            add_subdirectory(${room})
        endif()
    endforeach()
endfunction()
