# CLI11 2.1 or newer: the command line's grammar.
find_package(CLI11 2.1 REQUIRED)
add_library(third_party_cli11 INTERFACE)
target_link_libraries(third_party_cli11 INTERFACE CLI11::CLI11)
