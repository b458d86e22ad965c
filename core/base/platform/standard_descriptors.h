#pragma once

namespace trundle {

/// First of all in main(): a standard descriptor that is closed leads nowhere from now on. Otherwise the next file or socket gets its
/// number, and whatever prints to it writes there. Returns whether standard output was open.
bool openStandardDescriptors();

/// The same for one of them; false where it was closed. Async-signal-safe.
bool openIfClosed(int descriptor);

} // namespace trundle
