#include "base/platform/memory.h"

#include <fstream>
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

} // namespace trundle
