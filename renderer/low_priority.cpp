// Priorities on Linux, where each thread has its own.
#include "renderer/low_priority.h"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

namespace fieldwright::renderer {

// Niceness alone shares a core by the millisecond: whoever wakes waits for the end of a slice of the nicest thread. Of
// the idle policy it does not.
void lower_priority(const char* thread_name, Priority priority)
{
    bool compiles = priority == Priority::compile;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), compiles ? 19 : 10);
    sched_param none{};
    if (compiles) sched_setscheduler(gettid(), SCHED_IDLE, &none);
    pthread_setname_np(pthread_self(), thread_name);
}

}  // namespace fieldwright::renderer
