#include "editor/running/response_watch.h"

#include <trundle/abi.h>

#include "editor/running/run_messages.h"

namespace trundle {
namespace {

constexpr int kIntervalMs = 250;
constexpr double kRemarkablyLongS = 1;

} // namespace

ResponseWatch::ResponseWatch(const ActiveRun& run, RunMessages& messages, QObject* parent)
    : QObject(parent), m_run(run), m_messages(messages) {
    m_timer.setInterval(kIntervalMs);
    connect(&m_timer, &QTimer::timeout, this, &ResponseWatch::look);
}

double ResponseWatch::seconds() const {
    const double busy = m_run.live ? m_run.live->busyS() : 0;
    return busy >= kRemarkablyLongS ? busy : 0;
}

QString ResponseWatch::unresponsiveController() const {
    const CallTarget* called = m_run.live ? m_run.live->controllerInCall() : nullptr;
    if (!called) return {};
    return tr("%1's %2").arg(QString::fromStdString(called->robot), QString::fromStdString(called->kind));
}

QString ResponseWatch::text() const {
    const double held = seconds();
    if (held <= 0) return {};
    const QString shown = QString::number(held, 'f', 0), who = unresponsiveController();
    if (!who.isEmpty()) return tr("%1 has not responded for %2 s").arg(who, shown);
    return m_run.state == RunState::Building ? tr("building for %1 s").arg(shown) : tr("one tick takes %1 s so far").arg(shown);
}

void ResponseWatch::look() {
    const QString now = text();
    if (now == m_text) return;
    m_text = now;
    if (!unresponsiveController().isEmpty() && seconds() > 0 && !std::exchange(m_reported, true))
        m_messages.add(
            m_run.end ? m_run.end->time : m_run.time(), TRUNDLE_WARNING,
            tr("%1 is not responding. Reset abandons it; you can continue editing and save").arg(unresponsiveController()));
    if (now.isEmpty()) m_reported = false;
    Q_EMIT changed();
}

void ResponseWatch::setEnabled(bool enabled) {
    if (!enabled) m_timer.stop();
    else if (!m_timer.isActive()) m_timer.start();
}

void ResponseWatch::leaveRun() {
    m_timer.stop();
    m_reported = false;
}

bool ResponseWatch::clear() { return !std::exchange(m_text, {}).isEmpty(); }

} // namespace trundle
