# oneTBB 2021.8 or newer: work on all cores.
find_package(TBB 2021.8 REQUIRED COMPONENTS tbb)
add_library(third_party_tbb INTERFACE)
target_link_libraries(third_party_tbb INTERFACE TBB::tbb)
