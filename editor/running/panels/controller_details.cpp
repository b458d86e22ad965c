#include "editor/running/panels/controller_details.h"

#include <algorithm>

#include "editor/running/panels/robot_states.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr std::size_t kTail = 8; ///< lines
constexpr int kLeastWidth = 200; ///< pixels; in less than that, names would be broken

} // namespace

ControllerNumbers controllerNumbers(const RunSession& session, const ControlledRobot& robot) {
    ControllerNumbers numbers;
    const RunResults& results = session.results();
    if (!results.snapshot || !results.experiment) return numbers;
    double total = 0;
    for (const ControllerCost& cost : results.snapshot->costs) {
        const RobotSpec& built = results.experiment->robots[cost.robot];
        const ControllerSpec* controller = isRobotOf(session, built.name, robot) ? controllerIn(built, robot) : nullptr;
        if (!controller || controller->name != cost.controller) continue;
        if (!numbers.isKnown) numbers.process = cost.process;
        numbers.isKnown = true;
        numbers.calls += cost.calls;
        numbers.restarts += cost.restarts;
        numbers.worstS = std::max(numbers.worstS, cost.worstS);
        if (cost.calls > 0) numbers.lastCall = std::max(numbers.lastCall, cost.lastCall);
        total += cost.totalS;
    }
    if (numbers.calls > 0) numbers.meanS = total / static_cast<double>(numbers.calls);
    return numbers;
}

QString callTimeText(double seconds) {
    if (seconds < 1e-3) return ControllerDetails::tr("%1 µs").arg(seconds * 1e6, 0, 'f', seconds < 1e-5 ? 1 : 0);
    if (seconds < 1) return ControllerDetails::tr("%1 ms").arg(seconds * 1e3, 0, 'f', seconds < 1e-2 ? 1 : 0);
    return ControllerDetails::tr("%1 s").arg(seconds, 0, 'f', 1);
}

ControllerDetails::ControllerDetails(RunSession& session, QWidget* parent) : QPlainTextEdit(parent), m_session(session) {
    setObjectName(QStringLiteral("controllerDetails"));
    setAccessibleName(tr("Details of the controller"));
    setReadOnly(true);
    setFrameStyle(QFrame::NoFrame);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setPlaceholderText(tr("Select a robot to see what its controller does."));
    setMinimumWidth(kLeastWidth);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    auto* timer = new QTimer(this);
    timer->setInterval(250);
    connect(timer, &QTimer::timeout, this, &ControllerDetails::refresh);
    timer->start();
    connect(&session.messages(), &RunMessages::consoleLines, this, &ControllerDetails::addLines);
    connect(&session, &RunSession::stateChanged, this, [this] {
        if (m_session.state() == RunState::Start) m_lines.clear();
        refresh();
    });
}

void ControllerDetails::show(const ControlledRobot& robot) {
    m_robot = robot;
    refresh();
}

void ControllerDetails::addLines(const std::vector<LiveLine>& lines) {
    for (const LiveLine& line : lines) {
        if (line.who.empty()) continue;
        std::deque<std::string>& tail = m_lines[line.who.substr(0, line.who.find('/'))];
        tail.push_back(line.text);
        if (tail.size() > kTail) tail.pop_front();
    }
}

void ControllerDetails::refresh() {
    if (!isVisible()) return;
    if (const QString now = text(); now != toPlainText()) setPlainText(now);
}

QString ControllerDetails::text() const {
    if (m_robot.path.empty()) return {};
    if (m_robot.kind.empty()) return tr("%1 has no controller.").arg(toQString(m_robot.path));
    const ControllerState state = controllerState(m_session, m_robot);
    const std::string name = m_robot.controllers > 1 ? m_robot.kind + " " + m_robot.controller : m_robot.kind;
    QStringList rows{tr("%1 of %2: %3").arg(toQString(name), toQString(m_robot.path), state.text)};
    if (const ControllerNumbers numbers = controllerNumbers(m_session, m_robot); numbers.isKnown) {
        rows += numbers.process > 0 ? tr("Process %1").arg(numbers.process)
                : state.active      ? tr("Inside the program")
                                    : tr("Its process has ended");
        if (numbers.calls > 0)
            rows += tr("%1 calls, mean %2, worst %3")
                        .arg(QString::number(numbers.calls), callTimeText(numbers.meanS), callTimeText(numbers.worstS));
    }
    if (!state.detail.isEmpty()) rows += state.detail;
    if (const auto lines = m_lines.find(m_robot.path); lines != m_lines.end() && !lines->second.empty()) {
        rows += QString();
        for (const std::string& line : lines->second) rows += toQString(line);
    }
    return rows.join(QLatin1Char('\n'));
}

} // namespace trundle
