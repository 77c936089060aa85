// TBB workers at a low priority, for the thread that owns the arena.
#pragma once

#include "renderer/low_priority.h"

#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

namespace fieldwright::renderer {

// Workers stay at that priority afterwards: who is in a hurry does not use TBB in this process.
class QuietArena {
public:
    QuietArena() : observer_(arena_) { observer_.observe(true); }

    template <typename Work>
    auto execute(const Work& work)
    {
        return arena_.execute(work);
    }

private:
    struct Observer : tbb::task_scheduler_observer {
        explicit Observer(tbb::task_arena& arena) : task_scheduler_observer(arena) {}
        ~Observer() override { observe(false); }
        void on_scheduler_entry(bool is_worker) override
        {
            if (is_worker) lower_priority("render worker", Priority::picture);
        }
    };

    tbb::task_arena arena_;
    Observer observer_;
};

}  // namespace fieldwright::renderer
