#include "base/platform/thread_priority.h"

#include <sys/resource.h>

namespace trundle {

void lowerThreadPriority() {
    constexpr int kStep = 5; // nice levels: about a third of the processor time of a thread at the normal level
    // On Linux 0 is the calling thread, not the process.
    (void)setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kStep);
}

} // namespace trundle
