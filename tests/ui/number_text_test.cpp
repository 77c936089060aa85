// Numbers in words that are the same wherever they stand.
#include "ui/number_text.h"

#include <gtest/gtest.h>

namespace fieldwright::ui {
namespace {

TEST(RoundedText, has_three_digits_that_count)
{
    EXPECT_EQ(rounded_text(17.44), "17.4");
    EXPECT_EQ(rounded_text(1), "1.00");
    EXPECT_EQ(rounded_text(0.01234), "0.0123");
    EXPECT_EQ(rounded_text(-2.345), "-2.35");
    EXPECT_EQ(rounded_text(2208), "2,208");
    EXPECT_EQ(rounded_text(-1234567), "-1,234,567");
    EXPECT_EQ(rounded_text(0), "0");
    EXPECT_EQ(rounded_text(1e-12), "0");
}

TEST(RoundedText, a_number_that_rounds_up_to_the_next_power_of_ten_has_no_fourth_digit)
{
    EXPECT_EQ(rounded_text(9.996), "10.0");
    EXPECT_EQ(rounded_text(99.96), "100");
    EXPECT_EQ(rounded_text(999.4), "999");
    EXPECT_EQ(rounded_text(999.6), "1,000");
}

TEST(DurationText, changes_to_seconds_where_milliseconds_would_have_four_digits)
{
    EXPECT_EQ(duration_text(0.4123), "0.412 ms");
    EXPECT_EQ(duration_text(24.2), "24.2 ms");
    EXPECT_EQ(duration_text(999.4), "999 ms");
    EXPECT_EQ(duration_text(999.6), "1.00 s");
    EXPECT_EQ(duration_text(2208), "2.21 s");
}

TEST(PercentText, is_of_a_share)
{
    EXPECT_EQ(percent_text(0), "0 %");
    EXPECT_EQ(percent_text(0.125), "12.5 %");
    EXPECT_EQ(percent_text(1), "100 %");
    EXPECT_EQ(percent_text(0.000003), "< 0.01 %");
}

}  // namespace
}  // namespace fieldwright::ui
