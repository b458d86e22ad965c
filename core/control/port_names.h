#pragma once
#include <cstdint>
#include <string>

#include "base/result.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// Finds what a controller's port names among its robot's signals.
class PortNames {
public:
    PortNames(const RobotSpec& robot, const SignalLayout& layout) : m_robot(robot), m_layout(layout) {}

    /// The entry of a signal of a device of this kind ("": any). Ground truth is the kind GroundTruth named groundTruth, and nothing
    /// else gives it. Fails with E411, naming what there is.
    [[nodiscard]] Result<const SignalEntry*> bind(const std::string& kind, const std::string& device,
                                                  const std::string& signal) const;
    /// The entry of a signal that the controller's kind describes. Fails with E411, naming those that there are.
    [[nodiscard]] Result<const SignalEntry*> published(const std::string& signal) const;
    /// Without a failure to tell: nullptr where there is none. Empty `signal`: any of the device's.
    [[nodiscard]] const SignalEntry* look(const std::string& device, const std::string& signal) const;

private:
    [[nodiscard]] Result<const SignalEntry*> truth(const std::string& name, const std::string& signal) const;
    [[nodiscard]] std::string devices(const std::string& kind) const;
    [[nodiscard]] std::string signalsBelow(const std::string& prefix, bool truth) const;
    const RobotSpec& m_robot;
    const SignalLayout& m_layout;
};

} // namespace trundle
