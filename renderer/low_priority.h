// Threads that give way to the window's; threads that they make inherit it. A picture that a hand waits for goes before a
// shader that compiles.
#pragma once

namespace fieldwright::renderer {

inline constexpr int picture_nice = 10, compile_nice = 19;

// The calling thread's; there is no way back up without privileges. The name has at most 15 characters.
void lower_priority(const char* thread_name, int nice);

}  // namespace fieldwright::renderer
