#pragma once

namespace trundle {

// Code of modules writes to the standard descriptors directly, with printf() or std::cerr. A second process passes that text on to
// the original standard error, without control characters and as valid UTF-8 (cleanText()). As it is a process of its own, no text
// is lost when this one crashes or is killed, and no module can close its descriptors.

/// Starts that process. Call early in main(), before there are threads; it ends with the last process that can write to it. Does
/// nothing if the system refuses.
void startOutputCleaner();
/// Redirects standard output and standard error to it; without it, standard output to standard error.
void cleanStandardOutput();
/// Waits until text that has been written so far has been passed on, as long as that makes progress. Async-signal-safe.
void waitForOutputCleaner() noexcept;
/// Waits likewise, gives standard error back and ends the cleaner unless another process can still write to it. Call last before
/// this process ends. Async-signal-safe.
void finishOutputCleaner() noexcept;

} // namespace trundle
