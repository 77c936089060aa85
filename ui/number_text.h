// Numbers as people read and type them, with their unit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::ui {

// What follows a number: " m", "°", " 1/m"; empty for no unit.
std::string unit_suffix(std::string_view unit);
// At least `decimals` places, and more while the number (a float) has them; without a unit.
std::string number_text(double value, int decimals);
// Three digits that count, never an exponent: "0.012", "17.4", "2,208".
std::string rounded_text(double value);
std::string duration_text(double ms);           // "0.412 ms", "24.2 ms", "2.21 s"
std::string percent_text(double share);         // of 0.125: "12.5 %"; "< 0.01 %" of what is not quite nothing
std::string grouped_text(std::int64_t number);  // "12,345"
// The shortest text that reads back as the same float.
std::string exact_text(double value);
// "0.25", "0,25", "25 cm" (in metres), "30°", "1/3"; nothing when it is no number or of another unit.
std::optional<double> parse_number(std::string_view text, std::string_view unit);

}  // namespace fieldwright::ui
