#pragma once

namespace trundle {

/// From here on this process cannot start other processes or programs, trace or signal other ones, or gain rights: those calls fail
/// with EAGAIN or EPERM. Threads are allowed. False: the system has no such filter.
bool confineProcess() noexcept;

} // namespace trundle
