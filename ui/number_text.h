// Numbers as people read and type them, with their unit.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::ui {

// What follows a number: " m", "°", " 1/m"; empty for no unit.
std::string unit_suffix(std::string_view unit);
// At least `decimals` places, and more while the number (a float) has them; without a unit.
std::string number_text(double value, int decimals);
// The shortest text that reads back as the same float.
std::string exact_text(double value);
// "0.25", "0,25", "25 cm" (in metres), "30°", "1/3"; nothing when it is no number or of another unit.
std::optional<double> parse_number(std::string_view text, std::string_view unit);

}  // namespace fieldwright::ui
