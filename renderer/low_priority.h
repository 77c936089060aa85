// Threads that give way to the window's; threads that they make inherit it. A picture that a hand waits for goes before a
// shader that compiles.
#pragma once

namespace fieldwright::renderer {

// Niceness, not the kernel's idle policy: among busy programs that one stops a compile, and a window that closes waits for it.
enum class Priority { picture, compile };

// The calling thread's; there is no way back up without privileges. The name has at most 15 characters.
void lower_priority(const char* thread_name, Priority priority);

}  // namespace fieldwright::renderer
