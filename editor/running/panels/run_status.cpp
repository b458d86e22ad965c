#include "editor/running/panels/run_status.h"

#include <QStringList>

#include "editor/running/session.h"
#include "model/passive_objects.h"

namespace trundle {
namespace {

constexpr int kRefreshMs = 250;
constexpr int kMaxFinish = 80; // characters; the console shows the full text

QString counted(qulonglong count, const QString& one, const QString& many) { return count == 1 ? one : many.arg(count); }

/// "5 of 6 robots" if one has ended by a fault.
QString leftOf(qulonglong all, qulonglong ended, const QString& one, const QString& many) {
    const QString total = counted(all, one, many);
    return ended == 0 ? total : RunStatus::tr("%1 of %2").arg(QString::number(all - ended), total);
}

} // namespace

RunStatus::RunStatus(RunSession& session, QObject* parent) : QObject(parent), m_session(session) {
    m_timer.setInterval(kRefreshMs);
    connect(&m_timer, &QTimer::timeout, this, &RunStatus::refresh);
    connect(&session, &RunSession::stateChanged, this, [this] {
        const RunState state = m_session.state();
        if (state == RunState::Running || state == RunState::Building) m_timer.start();
        else m_timer.stop();
        refresh();
    });
    connect(&session, &RunSession::advanced, this, [this] {
        if (!m_timer.isActive()) refresh();
    });
    connect(&session.edits(), &RunEdits::changed, this, &RunStatus::refresh);
    connect(&session.responses(), &ResponseWatch::changed, this, &RunStatus::refresh);
}

void RunStatus::refresh() {
    QStringList parts;
    const auto experiment = m_session.results().experiment;
    if (experiment) {
        const RobotCounts counts = countRobots(*experiment);
        const EndedRobots& ended = m_session.robots().ended();
        QString text = leftOf(counts.robots, ended.robots(), tr("1 robot"), tr("%1 robots"));
        if (counts.objects > 0) text += tr(", ") + leftOf(counts.objects, ended.objects(), tr("1 object"), tr("%1 objects"));
        parts << text;
    }
    if (const auto shot = m_session.results().snapshot) {
        parts << counted(shot->contactCount, tr("1 contact"), tr("%1 contacts"));
        parts << tr("step %1 ms").arg(shot->stepMs, 0, 'f', shot->stepMs < 10 ? 2 : 0);
    }
    if (const QString finish = m_session.results().finishText(); !finish.isEmpty())
        parts << (finish.size() > kMaxFinish ? finish.left(kMaxFinish) + QChar(0x2026) : finish);
    if (const QString wasNotResponding = m_session.responses().text(); !wasNotResponding.isEmpty()) parts << wasNotResponding;
    if (m_session.edits().needsReset())
        parts << (m_session.results().canResume() ? tr("edits wait: F5 begins again with them") : tr("edits wait for Reset"));
    const QString text = parts.join(QStringLiteral("  •  ")), tip = m_session.robots().ended().summary();
    if (text == m_text && tip == m_tip) return;
    m_text = text;
    m_tip = tip;
    Q_EMIT changed(m_text, m_tip);
}

} // namespace trundle
