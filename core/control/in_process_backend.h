#pragma once
#include <memory>
#include <string>

#include <trundle/abi.h>

#include "control/backend.h"
#include "control/module_store.h"

namespace trundle {

/// The backend of a robot's controller, called in this process. `store` outlives it and has its module loaded; where it has not,
/// fails with E413. For the runner's BackendFactory.
[[nodiscard]] Result<std::unique_ptr<ControllerBackend>> makeInProcessBackend(const RobotSpec& robot,
                                                                              const SettingsSpec& settings,
                                                                              const ModuleStore& store);
/// The same for a table that no module brings (tests, built-in controllers).
[[nodiscard]] std::unique_ptr<ControllerBackend> makeInProcessBackend(const RobotSpec& robot, const SettingsSpec& settings,
                                                                      const TrundleKind& code, std::string library);

} // namespace trundle
