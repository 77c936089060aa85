# GLFW 3.3 or newer: the window, its GL context and its input.
find_package(glfw3 3.3 REQUIRED)
add_library(third_party_glfw INTERFACE)
target_link_libraries(third_party_glfw INTERFACE glfw)
