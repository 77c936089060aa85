// Icons by what they mean: Font Awesome 4.7 code points as UTF-8.
#pragma once

namespace fieldwright::ui::icon {

inline constexpr const char *add = "\xef\x81\xa7", *search = "\xef\x80\x82", *close = "\xef\x80\x8d",
                            *check = "\xef\x80\x8c";
inline constexpr const char *undo = "\xef\x83\xa2", *redo = "\xef\x80\x9e", *copy = "\xef\x83\x85",
                            *trash = "\xef\x80\x94";
inline constexpr const char *folder = "\xef\x81\xbb", *file = "\xef\x80\x96", *save = "\xef\x83\x87",
                            *download = "\xef\x80\x99";
inline constexpr const char *warning = "\xef\x81\xb1", *error = "\xef\x81\xaa", *info = "\xef\x81\x9a",
                            *question = "\xef\x81\x99";
inline constexpr const char *eye = "\xef\x81\xae", *eye_off = "\xef\x81\xb0", *camera = "\xef\x80\xb0",
                            *sun = "\xef\x86\x85";
inline constexpr const char *bulb = "\xef\x83\xab", *cube = "\xef\x86\xb2", *cubes = "\xef\x86\xb3",
                            *image = "\xef\x80\xbe";
inline constexpr const char *play = "\xef\x81\x8b", *pause = "\xef\x81\x8c", *stop = "\xef\x81\x8d",
                            *rewind = "\xef\x81\x88", *backward = "\xef\x81\x8a", *forward = "\xef\x81\x8e",
                            *loop = "\xef\x81\xb9";
inline constexpr const char *code = "\xef\x84\xa1", *history = "\xef\x87\x9a", *fire = "\xef\x81\xad",
                            *glasses = "\xef\x87\xa5";
inline constexpr const char *palette = "\xef\x87\xbc", *sliders = "\xef\x87\x9e", *expand = "\xef\x81\xa5",
                            *crosshair = "\xef\x81\x9b";
inline constexpr const char *arrow_up = "\xef\x81\xa2", *arrow_down = "\xef\x81\xa3", *arrow_left = "\xef\x81\xa0",
                            *arrow_right = "\xef\x81\xa1";
inline constexpr const char *chevron_right = "\xef\x84\x85", *chevron_down = "\xef\x84\x87", *pencil = "\xef\x81\x80",
                            *move = "\xef\x81\x87";
inline constexpr const char *gauge = "\xef\x83\xa4", *cloud = "\xef\x83\x82", *reset = "\xef\x80\xa1",
                            *link = "\xef\x83\x81", *unlink = "\xef\x84\xa7", *dot_on = "\xef\x86\x92",
                            *dot_off = "\xef\x84\x8c", *home = "\xef\x80\x95", *number = "\xef\x8a\x92",
                            *mirror = "\xef\x81\xbe";

}  // namespace fieldwright::ui::icon
