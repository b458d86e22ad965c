// Needs: __cxa_throw of the C++ library calls nothing of ours, hence the variables of the thread below.
#include "host/throw_recorder.h"

#include <algorithm>
#include <array>
#include <typeinfo>

#include <dlfcn.h>
#include <execinfo.h>

#include "host/crash_recorder.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
extern "C" void __asan_handle_no_return();
#define TRUNDLE_UNWINDS() __asan_handle_no_return()
#endif
#endif
#ifndef TRUNDLE_UNWINDS
#define TRUNDLE_UNWINDS() (void)0
#endif

namespace trundle {
namespace {

constexpr std::size_t kMostAddresses = 64;

thread_local std::array<void*, kMostAddresses> t_addresses; // threads of the module have their own, which is not read
thread_local std::size_t t_count = 0;

} // namespace

std::vector<std::uint64_t> lastThrow() {
    std::vector<std::uint64_t> offsets;
    for (std::size_t i = 0; i < t_count; ++i)
        if (const auto offset = offsetInModule(reinterpret_cast<std::uintptr_t>(t_addresses[i]))) offsets.push_back(*offset);
    return offsets;
}

void forgetThrow() { t_count = 0; }

} // namespace trundle

extern "C" [[noreturn]] __attribute__((visibility("default"))) void __cxa_throw(void* thrown, std::type_info* type,
                                                                                void (*destroy)(void*)) {
    using Throw = void (*)(void*, std::type_info*, void (*)(void*));
    static const auto own = reinterpret_cast<Throw>(::dlsym(RTLD_NEXT, "__cxa_throw"));
    const int count = ::backtrace(trundle::t_addresses.data(), static_cast<int>(trundle::kMostAddresses));
    trundle::t_count = static_cast<std::size_t>(std::max(count, 0));
    TRUNDLE_UNWINDS();
    own(thrown, type, destroy);
    __builtin_unreachable();
}
