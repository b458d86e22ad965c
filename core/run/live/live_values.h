#pragma once
// Current values of the objects of a run, formatted for property rows, tooltips and read-outs.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/experiment_spec.h"
#include "run/live/live_run.h"
#include "run/number_scale.h"
#include "schema/registry.h"

namespace trundle {

/// One displayed line: "current  0.213 A".
struct LiveValue {
    std::string name;                 ///< "current", "position"
    std::string signal;               ///< path of the signal that it is read from, "robot0/leftMotor/current"; empty: none
    std::string help;                 ///< a sentence, or empty
    std::vector<std::string> numbers; ///< formatted, in `unit`; or one word
    std::string unit;                 ///< "mA", "°"; or empty
    bool commanded = false;           ///< set by a controller, not measured

    /// "0.120, -0.400, 0.050"
    [[nodiscard]] std::string text() const;
};

/// The values of one object of a run. Its signals are looked up once, in the constructor.
class LiveObject {
public:
    /// `path`: "robot0", "swarm_3.chassis.hull", "robot0.leftMotor", "robot0.brain"; "" is the run itself. Has no values if the
    /// path is not a robot of the run or part of one, or has no signals.
    LiveObject(const ExperimentSpec& experiment, const SignalLayout& layout, const Registry& registry, std::string_view path);

    /// Lengths in m, angles in degrees, rates in rad/s, other values in SI units with a suitable prefix. Decimals and prefixes
    /// follow the largest value read so far, so that the digits keep their positions.
    [[nodiscard]] const std::vector<LiveValue>& read(const LiveSnapshot& snapshot);

private:
    using Numbers = std::vector<double>;
    struct Line {
        std::size_t value = 0; ///< index in m_values
        NumberScale scale;
        std::function<void(const LiveSnapshot&, Numbers&)> read;
        SignalType type = SignalType::Real;
    };
    void bind(const ExperimentSpec& experiment, const SignalLayout& layout, const Registry& registry, std::string_view path);
    void addRun();
    void addMotion(const SignalLayout& layout, const std::string& prefix, const Pose& inFrame);
    void addRobot(const RobotSpec& robot, const SignalLayout& layout, const Registry& registry);
    /// Those below `prefix`, with `owner` before each name.
    void addSignals(const SignalLayout& layout, const std::string& prefix, const Kind* kind, const std::string& owner = {});
    void addSignal(const SignalEntry& entry, LiveValue value);
    void addPose(const SignalEntry& entry, const std::string& prefix, const Pose& inFrame);
    void addVector(const SignalEntry& entry, LiveValue value, const char* unit, std::uint32_t from, std::uint32_t count);
    void addExtremes(const SignalEntry& entry, LiveValue value);
    void add(LiveValue value, NumberScale scale, std::function<void(const LiveSnapshot&, Numbers&)> read);

    std::vector<LiveValue> m_values;
    std::vector<Line> m_lines;
    Numbers m_numbers; // scratch buffer for one line
    std::shared_ptr<const SignalBlock> m_read;
};

/// The observed objects of one run; each is bound at its first read().
class LiveObjects {
public:
    LiveObjects(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const SignalLayout> layout,
                std::shared_ptr<const Registry> registry);
    /// The result is valid until the next call.
    [[nodiscard]] const std::vector<LiveValue>& read(const std::string& path, const LiveSnapshot& snapshot);

private:
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<const SignalLayout> m_layout;
    std::shared_ptr<const Registry> m_registry;
    std::map<std::string, LiveObject, std::less<>> m_objects;
};

} // namespace trundle
