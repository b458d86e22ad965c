#pragma once
#include <string>

namespace trundle {

/// The filter of confineProcess() as instructions (struct sock_filter), for a program that installs it itself once it runs in this
/// process. "": the system has no such filter.
[[nodiscard]] std::string confinementFilter();

/// From here on this process cannot start other processes or programs, trace or signal other ones, or gain rights: those calls fail
/// with EAGAIN or EPERM. Threads are allowed. False: the system has no such filter.
bool confineProcess() noexcept;

} // namespace trundle
