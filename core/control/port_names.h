#pragma once
#include <cstdint>
#include <string>

#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// Resolves the names of the ports of a robot's controller among its robot's signals.
class PortNames {
public:
    PortNames(const RobotSpec& robot, const ControllerSpec* controller, const SignalLayout& layout)
        : m_robot(robot), m_controller(controller), m_layout(layout) {}

    /// The entry of a signal of a device of this kind ("": any). Ground truth is available only through kind GroundTruth with the
    /// name groundTruth. Fails with E411 and lists the available names.
    [[nodiscard]] Result<SignalEntry> bind(const std::string& kind, const std::string& device, const std::string& signal) const;
    /// The entry of a signal described by the controller's kind. Fails with E411 and lists the available ones.
    [[nodiscard]] Result<SignalEntry> published(const std::string& signal) const;
    /// The same without an error: nullptr if there is none. Empty `signal`: any signal of the device.
    [[nodiscard]] std::optional<SignalEntry> look(const std::string& device, const std::string& signal) const;

private:
    [[nodiscard]] Result<SignalEntry> truth(const std::string& name, const std::string& signal) const;
    [[nodiscard]] std::string devices(const std::string& kind) const;
    [[nodiscard]] std::string signalsBelow(const std::string& prefix, bool truth) const;
    const RobotSpec& m_robot;
    const ControllerSpec* m_controller; ///< whose names are meant; null: that of no text
    const SignalLayout& m_layout;
};

} // namespace trundle
