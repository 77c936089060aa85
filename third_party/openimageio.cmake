# OpenImageIO 2.4 or newer: picture files. Debian's CMake files for it also demand its command line tools, so pkg-config.
find_package(PkgConfig REQUIRED)
pkg_check_modules(openimageio REQUIRED IMPORTED_TARGET OpenImageIO>=2.4)
add_library(third_party_openimageio INTERFACE)
target_link_libraries(third_party_openimageio INTERFACE PkgConfig::openimageio)
