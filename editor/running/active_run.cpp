#include "editor/running/active_run.h"

#include <QCoreApplication>

namespace trundle {

QString RunResults::finishText() const {
    if (!end || !end->finish) return {};
    const RunFinish& finish = *end->finish;
    const QString who = QString::fromStdString(finish.robot + "/" + finish.controller);
    const QString reason = QString::fromStdString(finish.reason).simplified();
    const QString when = QString::number(finish.time);
    const auto tr = [](const char* text) { return QCoreApplication::translate("trundle::RunSession", text); };
    return reason.isEmpty() ? tr("finished by %1 at t = %2 s").arg(who, when)
                            : tr("finished by %1 at t = %2 s: %3").arg(who, when, reason);
}

const RobotSpec* RunResults::robot(const std::string& name) const {
    if (!experiment) return nullptr;
    for (const RobotSpec& robot : experiment->robots)
        if (robot.name == name) return &robot;
    return nullptr;
}

} // namespace trundle
