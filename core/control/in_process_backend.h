#pragma once
#include <memory>
#include <string>

#include <trundle/abi.h>

#include "control/backend.h"
#include "control/module_store.h"

namespace trundle {

/// The backend of a robot's controller, by its index, called in this process. Used as the runner's BackendFactory. `store` must outlive it and
/// have loaded its module; otherwise fails with E413.
[[nodiscard]] Result<std::unique_ptr<ControllerBackend>> makeInProcessBackend(const RobotSpec& robot, std::size_t controller,
                                                                              const SettingsSpec& settings,
                                                                              const ModuleStore& store);
/// The same for a function table without a module (tests, built-in controllers).
[[nodiscard]] std::unique_ptr<ControllerBackend> makeInProcessBackend(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
                                                                      const TrundleKind& code, std::string library);

} // namespace trundle
