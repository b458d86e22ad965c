#pragma once

namespace trundle {

/// From now on the first Ctrl+C (SIGINT, SIGTERM) is noted and the second ends the program at once with exit code 130. A file that
/// grows past the system's limit becomes a failed write instead of a signal.
void watchInterrupts();
[[nodiscard]] bool interrupted();

} // namespace trundle
