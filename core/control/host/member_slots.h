#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// The slots of one controller in the images of its host: it reads all of its robot, and writes what it publishes and the commands that it
/// claims.
class MemberSlots {
public:
    /// Places them behind `first` slots of the images. Returns the number of slots with them.
    std::size_t place(const RobotSpec& robot, const ControllerSpec& controller, const SignalLayout& layout, std::size_t first);
    [[nodiscard]] std::size_t inImage() const { return m_inImage; }
    /// The value that the command has now goes into the image, as if it had been there from the start.
    void claim(const SignalEntry& command, std::span<const double> block, std::span<double> commands);
    void forgetClaims() { m_written.resize(m_published); }

    void copyIn(std::span<const double> block, std::span<double> sensors, std::span<double> commands) const;
    void copyOut(std::span<const double> commands, std::span<double> block) const;

private:
    struct Written {
        std::size_t inBlock, inImage, count;
    };
    std::vector<Written> m_written; ///< first those that need no claim
    std::size_t m_published = 0, m_inBlock = 0, m_inImage = 0, m_count = 0;
};

} // namespace trundle
