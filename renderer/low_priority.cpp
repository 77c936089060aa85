// Priorities on Linux, where each thread has its own.
#include "renderer/low_priority.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

namespace fieldwright::renderer {

void lower_priority(const char* thread_name, Priority priority)
{
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), priority == Priority::compile ? 19 : 10);
    pthread_setname_np(pthread_self(), thread_name);
}

}  // namespace fieldwright::renderer
