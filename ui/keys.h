// Keys as the window system's library numbers them (GLFW 3: printable keys by their US letter), without including it.
#pragma once

namespace fieldwright::ui::key {

inline constexpr int space = 32, apostrophe = 39, comma = 44, minus = 45, period = 46, slash = 47;
inline constexpr int zero = 48, nine = 57, equal = 61;
inline constexpr int a = 65, z = 90;  // letters are their capitals: 'A' .. 'Z'
inline constexpr int left_bracket = 91, right_bracket = 93, backquote = 96;
inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261;
inline constexpr int right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267, home = 268,
                     end = 269;
inline constexpr int f1 = 290, f2 = 291, f3 = 292, f5 = 294, f11 = 300, f12 = 301;
inline constexpr int keypad_0 = 320, keypad_1 = 321, keypad_2 = 322, keypad_3 = 323, keypad_4 = 324, keypad_5 = 325;
inline constexpr int keypad_6 = 326, keypad_7 = 327, keypad_8 = 328, keypad_9 = 329, keypad_decimal = 330;
inline constexpr int keypad_enter = 335;
inline constexpr int left_shift = 340, left_control = 341, left_alt = 342, left_super = 343;
inline constexpr int right_shift = 344, right_control = 345, right_alt = 346, right_super = 347;
inline constexpr int count = 512;

}  // namespace fieldwright::ui::key
