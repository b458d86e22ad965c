#include "base/platform/limits.h"

#include <sys/resource.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define TRUNDLE_SHADOW_MEMORY 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRUNDLE_SHADOW_MEMORY 1
#endif

namespace trundle {
namespace {

// Never requests more than the current hard limit, which would be refused.
bool lower(decltype(RLIMIT_AS) what, std::uint64_t value) noexcept {
    rlimit now{};
    if (::getrlimit(what, &now) != 0) return false;
    rlim_t wanted = static_cast<rlim_t>(value);
    if (now.rlim_max != RLIM_INFINITY && wanted > now.rlim_max) wanted = now.rlim_max;
    const rlimit next{wanted, wanted};
    return ::setrlimit(what, &next) == 0;
}

} // namespace

bool memoryLimitsAreOff() noexcept {
#ifdef TRUNDLE_SHADOW_MEMORY
    return true;
#else
    return false;
#endif
}

bool applyLimits(const ResourceLimits& limits) noexcept {
    bool ok = true;
    if (limits.memoryBytes > 0 && !memoryLimitsAreOff()) ok = lower(RLIMIT_AS, limits.memoryBytes) && ok;
    if (limits.cpuSeconds > 0) ok = lower(RLIMIT_CPU, limits.cpuSeconds) && ok;
    if (limits.fileBytes > 0) ok = lower(RLIMIT_FSIZE, limits.fileBytes) && ok;
    if (limits.openFiles > 0) ok = lower(RLIMIT_NOFILE, limits.openFiles) && ok;
    if (!limits.coreDumps) ok = lower(RLIMIT_CORE, 0) && ok;
    return ok;
}

} // namespace trundle
