# GoogleTest 1.12 or newer, with GoogleMock's matchers: tests only.
find_package(GTest 1.12 REQUIRED)
add_library(third_party_googletest INTERFACE)
target_link_libraries(third_party_googletest INTERFACE GTest::gmock GTest::gtest_main)
