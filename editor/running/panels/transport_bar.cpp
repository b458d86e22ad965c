#include "editor/running/panels/transport_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "editor/running/panels/speeds.h"
#include "editor/running/session.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

struct StateAppearance {
    QString text;
    Ink ink;
};

StateAppearance appearanceOf(const RunSession& session, bool open) {
    if (!session.responses().unresponsiveController().isEmpty() && session.responses().seconds() > 0)
        return {TransportBar::tr("Not responding"), Ink::Warning};
    switch (session.state()) {
    case RunState::Start:
        if (open && session.source().describesOnly()) return {TransportBar::tr("Nothing to run"), Ink::Faint};
        if (open && !session.source().refusal().isEmpty()) return {TransportBar::tr("Cannot run"), Ink::Error};
        return {TransportBar::tr("At start"), Ink::Faint};
    case RunState::Building: return {TransportBar::tr("Building"), Ink::Accent};
    case RunState::Running: return {TransportBar::tr("Running"), Ink::Good};
    case RunState::Paused: return {TransportBar::tr("Paused"), Ink::Warning};
    case RunState::Ended: break;
    }
    const bool failed = session.results().end && session.results().end->failure;
    return failed ? StateAppearance{TransportBar::tr("Stopped"), Ink::Error}
                  : StateAppearance{TransportBar::tr("Finished"), Ink::Accent};
}

/// As wide as the widest of the texts, so that neighbouring widgets do not move.
void fixWidth(QLabel* label, const QStringList& texts) {
    int width = 0;
    for (const QString& text : texts) width = std::max(width, label->fontMetrics().horizontalAdvance(text));
    const QMargins margins = label->contentsMargins();
    label->setMinimumWidth(width + margins.left() + margins.right() + 2);
}

QToolButton* button(QAction& action, const char* name, QWidget* parent) {
    auto* made = new QToolButton(parent);
    made->setObjectName(QLatin1String(name));
    made->setDefaultAction(&action);
    made->setAutoRaise(true);
    made->setIconSize({20, 20});
    made->setFocusPolicy(Qt::TabFocus);
    return made;
}

} // namespace

TransportBar::TransportBar(RunSession& session, Actions& actions, QWidget* parent)
    : QWidget(parent), m_session(session), m_actions(actions) {
    setObjectName(QStringLiteral("TransportBar"));
    build();
    connectActions();
    connect(&session, &RunSession::stateChanged, this, &TransportBar::showState);
    connect(&session.source(), &RunSource::changed, this, &TransportBar::showState);
    connect(&session.responses(), &ResponseWatch::changed, this, &TransportBar::showRefusal);
    connect(&session.edits(), &RunEdits::changed, this, &TransportBar::showRefusal);
    connect(&session, &RunSession::advanced, this, &TransportBar::showFigures);
    connect(&session, &RunSession::speedChanged, this, &TransportBar::showSpeed);
    showState();
    showSpeed();
}

void TransportBar::build() {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(m_reset = button(m_actions.at("sim.reset"), "transportReset", this));
    row->addWidget(m_run = button(m_actions.at("sim.run"), "transportRun", this));
    row->addWidget(m_step = button(m_actions.at("sim.step"), "transportStep", this));
    row->addSpacing(6);

    m_speed = new QComboBox(this);
    m_speed->setObjectName(QStringLiteral("transportSpeed"));
    m_speed->setToolTip(tr("Speed of the simulation against real time"));
    m_speed->setAccessibleName(tr("Speed"));
    for (const double speed : kSpeeds) m_speed->addItem(speedText(speed), speed);
    connect(m_speed, &QComboBox::activated, this, [this](int index) { m_session.setSpeed(m_speed->itemData(index).toDouble()); });
    row->addWidget(m_speed);
    row->addSpacing(8);

    m_state = new QLabel(this);
    m_state->setObjectName(QStringLiteral("transportState"));
    m_state->setAlignment(Qt::AlignCenter);
    m_state->setContentsMargins(8, 0, 8, 0);
    m_state->setMinimumHeight(22);
    row->addWidget(m_state, 0, Qt::AlignVCenter);
    row->addSpacing(6);

    m_time = new QLabel(this);
    m_time->setObjectName(QStringLiteral("transportTime"));
    useMonospaceFont(*m_time);
    m_time->setToolTip(tr("Simulated time"));
    row->addWidget(m_time);
    m_factor = new QLabel(this);
    m_factor->setObjectName(QStringLiteral("transportFactor"));
    useMonospaceFont(*m_factor);
    m_factor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_factor);
}

void TransportBar::connectActions() {
    connect(&m_actions.at("sim.run"), &QAction::triggered, &m_session, &RunSession::run);
    connect(&m_actions.at("sim.pause"), &QAction::triggered, &m_session, &RunSession::pause);
    connect(&m_actions.at("sim.step"), &QAction::triggered, &m_session, &RunSession::step);
    connect(&m_actions.at("sim.reset"), &QAction::triggered, &m_session, &RunSession::reset);
    connect(&m_actions.at("sim.keepPoses"), &QAction::triggered, &m_session.robots(), &RobotCommands::keepPoses);
    connect(&m_actions.at("sim.faster"), &QAction::triggered, this, [this] { changeSpeed(1); });
    connect(&m_actions.at("sim.slower"), &QAction::triggered, this, [this] { changeSpeed(-1); });
}

void TransportBar::changeSpeed(int by) {
    const int index = std::clamp(speedIndex(m_session.speed()) + by, 0, static_cast<int>(kSpeeds.size()) - 1);
    m_session.setSpeed(kSpeeds[static_cast<std::size_t>(index)]);
}

void TransportBar::showSpeed() {
    m_speed->setCurrentIndex(speedIndex(m_session.speed()));
    m_actions.at("sim.slower").setEnabled(m_speed->currentIndex() > 0);
    m_actions.at("sim.faster").setEnabled(m_speed->currentIndex() + 1 < m_speed->count());
}

void TransportBar::showState() {
    const RunState state = m_session.state();
    const bool open = m_session.source().isOpen(), goes = state == RunState::Running || state == RunState::Building;
    QAction &run = m_actions.at("sim.run"), &pause = m_actions.at("sim.pause");
    run.setEnabled(open && !goes);
    pause.setEnabled(goes);
    m_actions.at("sim.step").setEnabled(open && (state != RunState::Ended || m_session.results().canResume()) && !goes);
    m_actions.at("sim.reset").setEnabled(state != RunState::Start);
    m_actions.at("sim.keepPoses").setEnabled(state == RunState::Paused || state == RunState::Ended);
    QAction& shown = goes ? pause : run;
    if (m_run->defaultAction() != &shown) {
        m_run->removeAction(m_run->defaultAction());
        m_run->setDefaultAction(&shown);
    }
    showRefusal();
    showFigures();
}

void TransportBar::showRefusal() {
    const bool open = m_session.source().isOpen();
    const StateAppearance look = appearanceOf(m_session, open);
    const QColor colour = ink(look.ink);
    m_state->setText(look.text);
    m_state->setStyleSheet(
        QStringLiteral("QLabel { color: %1; border: 1px solid %1; border-radius: 8px; font-weight: 600; }").arg(colour.name()));
    fixWidth(m_state, {tr("At start"), tr("Building"), tr("Running"), tr("Paused"), tr("Finished"), tr("Stopped"),
                       tr("Cannot run"), tr("Nothing to run"), tr("Not responding")});
    QString why = m_session.responses().text();
    if (m_session.state() == RunState::Start && open) why = m_session.source().refusal();
    else if (m_session.results().end && m_session.results().end->failure)
        why = QString::fromStdString(m_session.results().end->failure->message);
    else if (m_session.results().canResume() && m_session.edits().needsReset())
        why = tr("At its Duration, and the edits of %1 wait for a reset. F5 begins again with them; F10 runs one tick without "
                 "them.")
                  .arg(m_session.edits().waitingText());
    else if (m_session.results().canResume())
        why = tr("At its Duration. F5 resumes past it, F10 runs one tick; Shift+F5 resets to the start.");
    m_state->setToolTip(why);
    m_run->setToolTip(why.isEmpty() || m_session.state() != RunState::Start ? m_run->defaultAction()->toolTip() : why);
}

void TransportBar::showFigures() {
    m_time->setText(timeText(m_session.results().time()));
    m_time->setEnabled(m_session.state() != RunState::Start);
    const bool runs = m_session.state() == RunState::Running;
    m_factor->setText(runs ? factorText(m_session.results().realTimeFactor()) : QString());
    const QString meaning = tr("Real-time factor: simulated seconds per second");
    const EngineChoice engine = m_session.results().engine();
    m_factor->setToolTip(
        engine == EngineChoice::General ? meaning : tr("%1. The engine is %2.").arg(meaning, QLatin1String(nameOf(engine))));
    fixWidth(m_time, {timeText(0), timeText(8888.88), m_time->text()});
    fixWidth(m_factor, {factorText(888), factorText(0.88), m_factor->text()});
}

void TransportBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // The theme changed: the state's colour is set explicitly.
    if (event->type() == QEvent::PaletteChange && m_state) showRefusal();
}

} // namespace trundle
