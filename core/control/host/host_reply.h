#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "control/backend.h"
#include "control/host/control_page.h"
#include "control/host/wire.h"

namespace trundle {

/// Passes a record of a host process on to the outputs of the robot whose controller made it. Returns the reply, for a record that
/// needs one. `radios`: those that the controller has found, extended by FindRadio; it can use no others.
[[nodiscard]] std::string answerHost(HostRecord record, const std::string& robot, const ControllerOutputs& outputs,
                                     std::vector<std::uint32_t>& radios, WireReader& in);

} // namespace trundle
