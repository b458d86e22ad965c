#pragma once
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace trundle {

class Actions;
class RunSession;

/// Reset, run or pause, single tick, speed, time and real-time factor in a row for the tool bar. Implements sim.run, sim.pause,
/// sim.step, sim.reset, sim.faster, sim.slower and sim.keepPoses, and enables those that apply.
class TransportBar final : public QWidget {
    Q_OBJECT
public:
    TransportBar(RunSession& session, Actions& actions, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void connectActions();
    void showState();
    void showRefusal();
    void showFigures();
    void showSpeed();
    void changeSpeed(int by);

    RunSession& m_session;
    Actions& m_actions;
    QToolButton* m_reset = nullptr;
    QToolButton* m_run = nullptr;
    QToolButton* m_step = nullptr;
    QComboBox* m_speed = nullptr;
    QLabel* m_state = nullptr;
    QLabel* m_time = nullptr;
    QLabel* m_factor = nullptr;
};

} // namespace trundle
