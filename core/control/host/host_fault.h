#pragma once
#include <string>

#include "control/backend.h"
#include "control/host/host_connection.h"

namespace trundle {

/// "update", "setup", "destructor".
[[nodiscard]] const char* phaseName(HostPhase phase);

/// What the end of a host process means: `controller` is the title of that which it called, empty if it is unknown. The backtrace has
/// functions and lines if the module has debug information and addr2line is installed.
[[nodiscard]] ControllerFault faultOf(const HostEnd& end, const std::string& controller, const std::string& library);
/// Of a call that ended with an exception: `reason`: its message, in Python with its place; `report`: of Python, the calls that led there,
/// see framesOfPython(); `thrown`: of C++ the return addresses in the library where it was thrown.
[[nodiscard]] ControllerFault faultOfException(std::string reason, const std::string& report,
                                               const std::vector<std::uint64_t>& thrown, const std::string& library);
/// Of a controller that shared the process with that of `faultyRobot`.
[[nodiscard]] ControllerFault sharedFault(const ControllerFault& own, const std::string& controller, const std::string& faultyRobot);
/// Why a module could not be loaded.
[[nodiscard]] Error errorOfLoading(Code code, const HostEnd& end, const std::string& library);

} // namespace trundle
