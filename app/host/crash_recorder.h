#pragma once
#include <cstdint>
#include <optional>

#include "base/call_monitor.h"
#include "base/platform/dynamic_library.h"
#include "control/host/control_page.h"

namespace trundle {

/// From here on a crash or an exit() of this process is written to the page, with the return addresses in the module. Call once,
/// on the main thread; both arguments must live as long as the process.
void recordCrashes(ControlPage& page, const CallMonitor& calls);
/// The module whose addresses are recorded.
void setModuleCode(const DynamicLibrary& library);
/// Where a return address is in the module; nothing: elsewhere.
[[nodiscard]] std::optional<std::uint64_t> offsetInModule(std::uintptr_t address);
/// The memory that only the run writes.
void setSensorImage(const void* data, std::size_t bytes);

} // namespace trundle
