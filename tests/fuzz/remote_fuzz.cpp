#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    (void)trundle::fuzz::tryRemote({data, size});
    return 0;
}
