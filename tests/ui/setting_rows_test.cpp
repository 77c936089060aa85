// The words of settings.
#include "ui/setting_rows.h"

#include <gtest/gtest.h>

namespace fieldwright::ui {
namespace {

// What a setting's help explains of 0, its field shows in a word: "0.000 m" would look like an amount.
template <typename Settings>
void expect_words_at_zero(std::string_view group, const graph::SettingTable<Settings>& table)
{
    for (const auto& number : table.numbers) {
        const SettingWords& words = setting_words(group, number.name);
        bool explained = words.help.find(" 0 ") != words.help.npos || words.help.find(" 0:") != words.help.npos;
        EXPECT_EQ(explained, !words.at_zero.empty()) << group << "." << number.name;
        if (!explained) continue;
        EXPECT_EQ(shown_number(0, {.at_zero = std::string(words.at_zero)}, 100), words.at_zero);
    }
}

TEST(SettingRows, say_in_a_word_what_zero_means_where_it_is_no_amount)
{
    expect_words_at_zero("march", graph::march_table);
    expect_words_at_zero("occlusion", graph::occlusion_table);
    expect_words_at_zero("fog", graph::fog_table);
    expect_words_at_zero("picture", graph::picture_table);
    expect_words_at_zero("animation", graph::animation_table);
}

}  // namespace
}  // namespace fieldwright::ui
