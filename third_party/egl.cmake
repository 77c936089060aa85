# EGL 1.5: a GL context without a window.
find_package(PkgConfig REQUIRED)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl>=1.5)
add_library(third_party_egl INTERFACE)
target_link_libraries(third_party_egl INTERFACE PkgConfig::egl)
