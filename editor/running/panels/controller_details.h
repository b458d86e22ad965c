#pragma once
#include <deque>
#include <map>
#include <string>

#include <QPlainTextEdit>
#include <QTimer>

#include "editor/running/session.h"
#include "project/edits/controllers.h"

namespace trundle {

/// What the controllers of a robot, or of all members of a Grid or Scatter, have cost and done in the run in progress.
struct ControllerNumbers {
    std::uint64_t calls = 0;
    double meanS = 0, worstS = 0;  ///< wall time of one update, s
    double lastCall = 0;           ///< s, simulated
    std::size_t restarts = 0;
    std::int64_t process = 0;      ///< of the first of them; 0: inside the program
    bool isKnown = false;          ///< there is such a controller in the run
};
[[nodiscard]] ControllerNumbers controllerNumbers(const RunSession& session, const ControlledRobot& robot);

/// The time of a call, with a fitting unit: "85 µs", "1.2 ms".
[[nodiscard]] QString callTimeText(double seconds);

/// One controller in words: state, cost, process, why it stopped, the last lines that it printed.
class ControllerDetails final : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit ControllerDetails(RunSession& session, QWidget* parent = nullptr);

    /// Shows this robot; one without a path: none.
    void show(const ControlledRobot& robot);

private:
    void addLines(const std::vector<LiveLine>& lines);
    void refresh();
    [[nodiscard]] QString text() const;

    RunSession& m_session;
    ControlledRobot m_robot;
    std::map<std::string, std::deque<std::string>> m_lines; ///< by robot, the newest last
};

} // namespace trundle
