# What letters are made of: FreeType reads their outlines, HarfBuzz sets them side by side with kerning and ligatures,
# Fontconfig finds the file of an installed family.
find_package(Freetype REQUIRED)
find_package(Fontconfig REQUIRED)
find_path(HARFBUZZ_INCLUDE hb.h PATH_SUFFIXES harfbuzz REQUIRED)
find_library(HARFBUZZ_LIBRARY harfbuzz REQUIRED)
add_library(third_party_letters INTERFACE)
target_include_directories(third_party_letters SYSTEM INTERFACE ${HARFBUZZ_INCLUDE})
target_link_libraries(third_party_letters INTERFACE Freetype::Freetype Fontconfig::Fontconfig ${HARFBUZZ_LIBRARY})
