// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Everything a controller needs: derive from Controller, describe its fields, bind ports in setup, act in update, and register it
// in TRUNDLE_MODULE. The README.md of the SDK has a complete example.

#include <sstream>
#include <string>
#include <string_view>

#include <trundle/describe.h>
#include <trundle/module.h>
#include <trundle/needs.h>
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

/// Controls one robot. Created before the run, then its fields are set, setup is called once and update periodically, all on one
/// thread unless its kind is independent(). An exception thrown by setup or update ends the run with its message.
class Controller {
public:
    virtual ~Controller() = default;
    /// Binds the ports. Called once before the run.
    virtual void setup(RobotPorts& robot) = 0;
    /// Called before a tick of the world. `sinceLast`: simulated seconds since the last call, 0 in the first.
    virtual void update(Seconds sinceLast) = 0;
    /// What a new version of its code continues from: called when that is loaded during a run. Any bytes; none: it starts as in a new run.
    /// An exception is reported, and no state is handed over. Since 1.11.
    [[nodiscard]] virtual std::string saveState() const { return {}; }
    /// Called after setup with what the old code saved, which may be an older version of it. After an exception it is created and set up again.
    virtual void loadState(std::string_view) {}

    /// Called by the SDK before setup.
    void attach(const TrundleRobot* robot) { m_robot = robot; }

protected:
    /// Simulated time, s; 0 in the first update.
    [[nodiscard]] Seconds time() const { return {m_robot ? m_robot->time(m_robot->context) : 0.0}; }

    /// Prints one line on the console, prefixed with the robot's name and the time: print("drove ", x, " m").
    template <class... Parts> void print(const Parts&... parts) const { say(TRUNDLE_INFO, parts...); }
    template <class... Parts> void warn(const Parts&... parts) const { say(TRUNDLE_WARNING, parts...); }

    /// Reports an error from which the controller cannot continue: the run ends with this text after this update.
    void fail(const std::string& text) const {
        if (m_robot) m_robot->fail(m_robot->context, text.c_str());
    }

    /// Ends the experiment: the run ends after this tick with complete logs and exit code 0, and its summary contains the reason.
    /// The first call in a run counts, whichever robot makes it.
    void finish(const std::string& reason) const {
        if (m_robot) m_robot->finish(m_robot->context, reason.c_str());
    }

    /// Random numbers that depend only on the experiment's seed, the robot, the tick and the number of calls in this tick: the
    /// same in every run.
    [[nodiscard]] std::uint64_t randomBits() const { return m_robot ? m_robot->random(m_robot->context) : 0; }
    [[nodiscard]] double random() const { return static_cast<double>(randomBits() >> 11) * 0x1p-53; } ///< [0, 1)
    [[nodiscard]] double random(double low, double high) const { return low + (high - low) * random(); }

    /// Opens a log file of this controller in the run's log folder. The name may contain subfolders. The returned Log is not
    /// open() if the path is outside the log folder, the file is already in use, or the run has no logs.
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
