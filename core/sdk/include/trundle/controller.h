// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Everything a controller needs: derive from Controller, describe its fields, bind ports in setup, act in update, and name it in
// TRUNDLE_MODULE. README.md of the SDK shows a whole one.

#include <sstream>
#include <string>
#include <string_view>

#include <trundle/describe.h>
#include <trundle/module.h>
#include <trundle/ports.h>

namespace trundle {
inline namespace sdk1 {

/// A file in the run's log folder.
class Log {
public:
    Log() = default;
    [[nodiscard]] bool open() const { return m_number >= 0; }
    void write(std::string_view bytes) {
        if (open()) m_robot->writeLog(m_robot->context, m_number, bytes.data(), bytes.size());
    }

private:
    friend class Controller;
    Log(const TrundleRobot* robot, std::int32_t number) : m_robot(robot), m_number(number) {}
    const TrundleRobot* m_robot = nullptr;
    std::int32_t m_number = -1;
};

/// The mind of one robot. Made before the run, given its fields, then setup once and update in each of its turns, all on one
/// thread. An exception that leaves either stops the run with its text.
class Controller {
public:
    virtual ~Controller() = default;
    /// Binds the ports.
    virtual void setup(RobotPorts& robot) = 0;
    /// One turn, before the world's tick. `sinceLast`: simulated s since the last turn, 0 in the first.
    virtual void update(Seconds sinceLast) = 0;

    /// Called by the module's border before setup.
    void attach(const TrundleRobot* robot) { m_robot = robot; }

protected:
    /// Simulated s; 0 in the first turn.
    [[nodiscard]] Seconds time() const { return {m_robot ? m_robot->time(m_robot->context) : 0.0}; }

    /// One line on the console, with the robot's name and the time in front: print("drove ", x, " m").
    template <class... Parts> void print(const Parts&... parts) const { say(TRUNDLE_INFO, parts...); }
    template <class... Parts> void warn(const Parts&... parts) const { say(TRUNDLE_WARNING, parts...); }

    /// The controller cannot go on: the run ends with this text after this turn.
    void fail(const std::string& text) const {
        if (m_robot) m_robot->fail(m_robot->context, text.c_str());
    }

    /// The experiment is over: the run ends after this tick, logs complete, exit code 0, and its summary says the reason.
    /// The first call of a run counts, whichever robot makes it.
    void finish(const std::string& reason) const {
        if (m_robot) m_robot->finish(m_robot->context, reason.c_str());
    }

    /// Numbers that depend on the experiment's seed, the robot and the tick alone: the same in every run.
    [[nodiscard]] std::uint64_t randomBits() const { return m_robot ? m_robot->random(m_robot->context) : 0; }
    [[nodiscard]] double random() const { return static_cast<double>(randomBits() >> 11) * 0x1p-53; } ///< [0, 1)
    [[nodiscard]] double random(double low, double high) const { return low + (high - low) * random(); }

    /// A file of one's own in the run's log folder. The name may hold folders. Not open() where that is
    /// refused: a name that leads out of the log folder, one that is written already, a run without logs.
    [[nodiscard]] Log openLog(const std::string& fileName) const {
        return m_robot ? Log(m_robot, m_robot->openLog(m_robot->context, fileName.c_str())) : Log();
    }

private:
    template <class... Parts> void say(std::int32_t severity, const Parts&... parts) const {
        if (!m_robot) return;
        std::ostringstream text;
        (text << ... << parts);
        m_robot->print(m_robot->context, severity, text.str().c_str());
    }
    const TrundleRobot* m_robot = nullptr;
};

} // namespace sdk1
} // namespace trundle
