#pragma once
#include <QObject>
#include <QSet>

class QAction;
class QWidget;
class QKeyEvent;

namespace trundle {

class Actions;
class RunSession;
class Selection;

/// While sim.drive is checked, the arrow keys drive the selected robot, unless a field for typing has the focus. The robot's
/// controller is not called while a key is pressed. Shift doubles the speed. In a test drive W, A, S and D drive too.
class KeyboardDrive final : public QObject {
    Q_OBJECT
public:
    KeyboardDrive(RunSession& session, Selection& selection, Actions& actions, QWidget& window);

    [[nodiscard]] bool isOn() const { return m_on; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setOn(bool on);
    void release();
    void steer();
    [[nodiscard]] bool press(QKeyEvent& key, bool down);

    RunSession& m_session;
    Selection& m_selection;
    const QAction& m_letters; // checked: W A S D drive too
    QWidget& m_window;
    bool m_on = false, m_fast = false;
    QSet<int> m_down;
};

} // namespace trundle
