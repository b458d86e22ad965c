#pragma once

namespace trundle {

/// Call first in main(): opens closed standard descriptors on /dev/null. Otherwise the next file or socket gets such a number and
/// receives whatever is printed. Returns whether standard output was open.
bool openStandardDescriptors();

/// The same for one descriptor; false if it was closed. Async-signal-safe.
bool openIfClosed(int descriptor);

} // namespace trundle
