# libepoxy 1.5 or newer: GL and EGL functions, loaded at first use.
find_package(PkgConfig REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy>=1.5)
add_library(third_party_epoxy INTERFACE)
target_link_libraries(third_party_epoxy INTERFACE PkgConfig::epoxy)
