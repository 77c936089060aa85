// Threads that give way to the window's: nice 19, which threads that they make inherit.
#pragma once

namespace fieldwright::renderer {

// The calling thread's; there is no way back up without privileges.
void lower_priority(const char* thread_name);  // at most 15 characters

}  // namespace fieldwright::renderer
