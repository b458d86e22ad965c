#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/experiment_spec.h"

namespace trundle {

/// Robots that joints and springs at the top level join are placed together, without what moves in Statics.
class JoinedRobots {
public:
    explicit JoinedRobots(const ExperimentSpec& experiment);

    /// Ascending, with the robot itself.
    [[nodiscard]] std::vector<std::size_t> with(std::size_t robot) const;
    /// Why none of them can be placed, "hinge holds train_0 to the world"; empty: they can.
    [[nodiscard]] const std::string& hold(std::size_t robot) const { return m_holds[m_groups[robot]]; }

private:
    template <class Spec> void add(const ExperimentSpec& experiment, const Link<Spec>& link);

    std::vector<std::size_t> m_groups; ///< by robot: the lowest one that it is joined to
    std::vector<std::string> m_holds;  ///< by group
};

} // namespace trundle
