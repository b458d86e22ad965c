#include "base/platform/memory.h"

#include <fstream>
#include <new>
#include <string>

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

std::string reasonOf(const std::exception& exception) {
    if (!dynamic_cast<const std::bad_alloc*>(&exception)) return exception.what();
    return "there is not enough memory: the system gives no more to this program, which has had " + std::to_string(peakMemoryKb() / 1024) + " MB";
}

} // namespace trundle
