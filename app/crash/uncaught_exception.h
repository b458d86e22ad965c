#pragma once

namespace trundle {

/// An exception that nothing catches, in any thread, prints one line and aborts. The C++ library would print its text unfiltered.
/// `program` must live as long as the process; `file` returns the descriptor to print to.
void reportUncaughtExceptions(const char* program, int (*file)());
/// Its text, cut to some hundred bytes; "" before there was one. Async-signal-safe.
[[nodiscard]] const char* uncaughtException() noexcept;

} // namespace trundle
