#pragma once
// Checks of what must hold whatever the input: a violation is a fault of the program. On in every build.

namespace trundle {

/// Writes "internal error: ..." to standard error and aborts; the crash guard then closes the logs.
[[noreturn]] void assertionFailed(const char* condition, const char* file, int line);

} // namespace trundle

#define TRUNDLE_ASSERT(condition)                                                                                                \
    (static_cast<bool>(condition) ? static_cast<void>(0) : ::trundle::assertionFailed(#condition, __FILE__, __LINE__))
