#pragma once
#include <string>

#include "control/backend.h"
#include "control/host/host_connection.h"

namespace trundle {

/// "update", "setup", "destructor".
[[nodiscard]] const char* phaseName(HostPhase phase);

/// What the end of a host process means: `robot` is that whose controller it called, nullptr if it is unknown. The backtrace has
/// functions and lines if the module has debug information and addr2line is installed.
[[nodiscard]] ControllerFault faultOf(const HostEnd& end, const RobotSpec* robot, const std::string& library);
/// Of a controller that shared the process of `faulty`.
[[nodiscard]] ControllerFault sharedFault(const ControllerFault& own, const RobotSpec& robot, const RobotSpec& faulty);
/// Why a module could not be loaded.
[[nodiscard]] std::string faultOfLoading(const HostEnd& end, const std::string& library);

} // namespace trundle
