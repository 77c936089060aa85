# GLM 0.9.9.8 or newer: vectors and matrices, and GLSL's functions in C++.
find_package(glm 0.9.9.8 REQUIRED)
add_library(third_party_glm INTERFACE)
target_link_libraries(third_party_glm INTERFACE glm::glm)
