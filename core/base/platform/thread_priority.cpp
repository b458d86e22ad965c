#include "base/platform/thread_priority.h"

#include <sys/resource.h>

namespace trundle {

void letOthersGoFirst() {
    constexpr int kStep = 5; // a third of the time that another thread gets where both want all of it
    // On Linux 0 means the calling thread, not the process.
    (void)setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kStep);
}

} // namespace trundle
