# Dear ImGui 1.86 or newer before 1.87 (its input functions changed): widgets, with the FreeType font builder and the
# GLFW and OpenGL 3 backends, all in Debian's static library.
find_path(IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(IMGUI_LIBRARY NAMES libimgui.a REQUIRED)
find_library(STB_LIBRARY NAMES libstb.a stb REQUIRED)  # what Dear ImGui packs its atlas with
find_package(Freetype REQUIRED)
file(STRINGS ${IMGUI_INCLUDE}/imgui.h IMGUI_VERSION_LINE REGEX "#define IMGUI_VERSION_NUM +186[0-9][0-9]")
if(NOT IMGUI_VERSION_LINE)
    message(FATAL_ERROR "Dear ImGui 1.86 is needed; ${IMGUI_INCLUDE}/imgui.h is another version.")
endif()
add_library(third_party_imgui INTERFACE)
target_include_directories(third_party_imgui SYSTEM INTERFACE ${IMGUI_INCLUDE})
target_link_libraries(third_party_imgui INTERFACE ${IMGUI_LIBRARY} ${STB_LIBRARY} Freetype::Freetype ${CMAKE_DL_LIBS})
