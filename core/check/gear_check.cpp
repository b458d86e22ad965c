// Gears that contradict each other. Method: joints that Gears couple turn in fixed ratios; a Gear between two joints whose ratio follows
// from other Gears must agree with it, or all of them stand still.
#include <cmath>
#include <numeric>
#include <set>

#include "check/checks.h"

namespace trundle {

namespace {

/// The joints of a config in sets, each with its rate per that of the set's first joint.
class CoupledJoints {
public:
    explicit CoupledJoints(std::size_t joints) : m_above(joints), m_rate(joints, 1) {
        std::iota(m_above.begin(), m_above.end(), 0);
    }
    struct Rate {
        int first;
        double rate;
    };
    [[nodiscard]] Rate of(int joint) {
        Rate found{joint, 1};
        while (m_above[index(found.first)] != found.first) {
            int& above = m_above[index(found.first)];
            double& rate = m_rate[index(found.first)];
            if (m_above[index(above)] != above) { // from now on the way is half as long
                rate *= m_rate[index(above)];
                above = m_above[index(above)];
            }
            found.rate *= rate;
            found.first = above;
        }
        return found;
    }
    /// From now on the rate of `joint` is `ratio` times that of `other`, which is in another set.
    void couple(int joint, int other, double ratio) {
        const Rate a = of(joint), b = of(other);
        m_above[index(a.first)] = b.first;
        m_rate[index(a.first)] = ratio * b.rate / a.rate;
    }

private:
    static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }

    std::vector<int> m_above;
    std::vector<double> m_rate; ///< per that of the joint above; 1 without one
};

void check(const RobotConfigSpec& config, Diagnostics& diagnostics) {
    constexpr double kEqual = 1e-6; // relative
    CoupledJoints coupled(config.joints.size());
    for (const GearSpec& gear : config.gears) {
        const auto joint = coupled.of(gear.joint), other = coupled.of(gear.other);
        if (joint.first != other.first) {
            coupled.couple(gear.joint, gear.other, gear.ratio);
            continue;
        }
        const double ratio = joint.rate / other.rate;
        if (std::abs(ratio - gear.ratio) <= kEqual * std::max(std::abs(ratio), std::abs(gear.ratio))) continue;
        const std::string &one = config.joints[static_cast<std::size_t>(gear.joint)].name,
                          &two = config.joints[static_cast<std::size_t>(gear.other)].name;
        diagnostics.warning(Code::ClosedLoop, gear.nameRange,
                            "the Gear " + gear.name + " of " + config.name + " holds " + one + " and " + two +
                                " still: by its Ratio, " + one + " turns at " + figureText(gear.ratio) + " times the rate of " +
                                two + ", by other Gears at " + figureText(ratio) + " times");
    }
}

} // namespace

void checkGears(const ExperimentSpec& experiment, Diagnostics& diagnostics) {
    std::set<const RobotConfigSpec*> seen; // membership test only: its order, by address, must not affect the output
    for (const RobotSpec& robot : experiment.robots)
        if (robot.config && seen.insert(robot.config.get()).second) check(*robot.config, diagnostics);
}

} // namespace trundle
