#include "base/platform/memory.h"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace trundle {

std::uint64_t peakMemoryKb() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        std::uint64_t kb = 0;
        if (word == "VmHWM:" && status >> kb) return kb;
    }
    return 0;
}

/// Method: the heap grows at once, and is not touched before the system knows.
void useLargePages(std::size_t bytes) {
    constexpr std::size_t kPage = 2u << 20, kMost = 1u << 30;
    rlimit limit{};
    const bool isLimited = getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY; // others may need what is left
    if (bytes < kPage || isLimited || gettid() != getpid()) return;
    mallopt(M_MMAP_THRESHOLD, 32 << 20); // the most: long arrays lie there too
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
    mallopt(M_TOP_PAD, static_cast<int>(std::min(bytes, kMost) / kPage * kPage + kPage));
    const auto before = reinterpret_cast<std::uintptr_t>(sbrk(0));
    void* const more = std::malloc(mallinfo2().keepcost + kPage / 2); // more than the heap has at its end
    asm volatile("" : : "r"(more) : "memory");                        // else the compiler leaves it out
    const auto after = reinterpret_cast<std::uintptr_t>(sbrk(0));
    const std::uintptr_t first = (before + kPage - 1) / kPage * kPage;
    if (after > first) (void)madvise(reinterpret_cast<void*>(first), after - first, MADV_HUGEPAGE);
    std::free(more);
    mallopt(M_TOP_PAD, static_cast<int>(kPage));
}

std::string reasonOf(const std::exception& exception) {
    if (!dynamic_cast<const std::bad_alloc*>(&exception)) return exception.what();
    return "there is not enough memory: the system gives no more to this program, which has had " + std::to_string(peakMemoryKb() / 1024) + " MB";
}

} // namespace trundle
