#pragma once

namespace trundle {

/// "Segmentation fault"; nullptr for a signal that is no crash. Async-signal-safe.
[[nodiscard]] const char* crashName(int signal) noexcept;

} // namespace trundle
