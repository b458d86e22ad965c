#include "control/isolation.h"

namespace trundle {

Isolation isolationOf(const ComponentSpec& controller, const SettingsSpec& settings, Isolation otherwise) {
    const std::string own = controller.find("Isolation") ? controller.text("Isolation") : std::string();
    const std::string& chosen = own.empty() ? settings.isolation : own;
    if (chosen.empty()) return otherwise;
    return chosen == "robot" ? Isolation::Robot : chosen == "module" ? Isolation::Module : Isolation::None;
}

} // namespace trundle
