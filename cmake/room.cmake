# A room: one static library `fieldwright_<room>` of all its .cpp files, which sees only the rooms it links.
#
# The include folder of a room holds nothing but a link named like the room, so `#include "field/evaluator.h"` compiles
# only where fieldwright_field is linked, directly or through another room.

function(fieldwright_include_folder target visibility room)
    set(folder ${CMAKE_BINARY_DIR}/rooms/${room})
    file(MAKE_DIRECTORY ${folder})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${room} ${folder}/${room} SYMBOLIC)
    target_include_directories(${target} ${visibility} ${folder})
endfunction()

# What everything written here is compiled with; the generated kernels add to it (field/CMakeLists.txt).
function(fieldwright_compile_options target)
    # A member that designated initialisers leave out has its default: that is what they are for.
    target_compile_options(
        ${target} PRIVATE -Wall -Wextra -Wshadow -Werror -Wno-missing-field-initializers -ffp-contract=off)
    if(FIELDWRIGHT_SANITIZE)
        # The sanitizers' own code makes g++ 12 see uninitialised reads that are not there.
        target_compile_options(${target} PRIVATE -fno-omit-frame-pointer -Wno-maybe-uninitialized)
        target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all)
        target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    endif()
endfunction()

# fieldwright_room(<room> [EXCLUDE <file>...]): files with a program's `main` are not the library's.
function(fieldwright_room room)
    cmake_parse_arguments(PARSE_ARGV 1 argument "" "" "EXCLUDE")
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp)
    foreach(name ${argument_EXCLUDE})
        list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/${room}/${name})
    endforeach()
    add_library(fieldwright_${room} STATIC ${sources})
    fieldwright_include_folder(fieldwright_${room} PUBLIC ${room})
    fieldwright_compile_options(fieldwright_${room})
endfunction()
