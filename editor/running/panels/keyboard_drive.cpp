#include "editor/running/panels/keyboard_drive.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/widgets/actions.h"
#include "model/robot_path.h"

namespace trundle {
namespace {

constexpr double kSpeed = 0.3, kTurnRate = 1.2; // m/s, rad/s

bool isArrow(int key) { return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Left || key == Qt::Key_Right; }

/// The arrow key for W, A, S or D; other keys as they are.
int arrowFor(int key) {
    return key == Qt::Key_W   ? Qt::Key_Up
           : key == Qt::Key_S ? Qt::Key_Down
           : key == Qt::Key_A ? Qt::Key_Left
           : key == Qt::Key_D ? Qt::Key_Right
                              : key;
}

/// Whether the widget uses arrow keys, to move a cursor or change a value.
bool isTypedInto(const QWidget* widget) {
    if (!widget) return false;
    for (const char* kind : {"QLineEdit", "QAbstractSpinBox", "QTextEdit", "QPlainTextEdit", "QComboBox", "QAbstractSlider",
                             "QMenu", "QsciScintillaBase"})
        if (widget->inherits(kind)) return true;
    return false;
}

/// Whether it is the main window itself or one of its floating docks, not a dialog.
bool isOf(const QWidget& main, const QWidget& window) {
    const bool panel = window.inherits("QDockWidget") || window.inherits("QDockWidgetGroupWindow");
    return &window == &main || (panel && window.parentWidget() == &main);
}

} // namespace

KeyboardDrive::KeyboardDrive(RunSession& session, Selection& selection, Actions& actions, QWidget& window)
    : QObject(&window), m_session(session), m_selection(selection), m_letters(actions.at("model.drive")), m_window(window) {
    QAction& action = actions.at("sim.drive");
    connect(&action, &QAction::toggled, this, &KeyboardDrive::setOn);
    connect(&session, &RunSession::stateChanged, this, [this] {
        if (m_session.state() == RunState::Start) m_down.clear();
    });
    connect(&selection, &Selection::changed, this, &KeyboardDrive::release);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (!now || isTypedInto(now)) release(); // the focus is elsewhere: key releases will be missed
    });
    setOn(action.isChecked());
}

void KeyboardDrive::setOn(bool on) {
    if (on == m_on) return;
    m_on = on;
    if (on) qApp->installEventFilter(this);
    else qApp->removeEventFilter(this);
    release();
}

void KeyboardDrive::release() {
    m_down.clear();
    m_session.robots().stopDriving();
}

void KeyboardDrive::steer() {
    if (m_down.isEmpty()) return m_session.robots().stopDriving();
    const auto along = [this](int forward, int back) { return int(m_down.contains(forward)) - int(m_down.contains(back)); };
    const double scale = m_fast ? 2 : 1;
    const std::string selected = m_selection.current();
    const auto experiment = m_session.results().experiment;
    const bool onlyOne = experiment && experiment->robots.size() == 1; // the only robot is driven whatever is selected
    const std::string robot = onlyOne ? experiment->robots.front().name : experiment ? robotNameIn(*experiment, selected) : std::string();
    if (!m_session.robots().drive(robot, scale * kSpeed * along(Qt::Key_Up, Qt::Key_Down),
                                  scale * kTurnRate * along(Qt::Key_Left, Qt::Key_Right)))
        m_down.clear();
}

bool KeyboardDrive::press(QKeyEvent& key, bool down) {
    if (key.isAutoRepeat()) return true;
    const int arrow = arrowFor(key.key());
    if (!down && !m_down.contains(arrow)) return false; // not pressed here
    if (down) m_down.insert(arrow);
    else m_down.remove(arrow);
    m_fast = key.modifiers().testFlag(Qt::ShiftModifier);
    steer();
    return true;
}

bool KeyboardDrive::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride) return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || !isOf(m_window, *widget->window()) || isTypedInto(widget)) return false;
    auto& key = *static_cast<QKeyEvent*>(event);
    const bool flies = QApplication::mouseButtons() != Qt::NoButton; // with a button held, letters move the camera
    const int arrow = m_letters.isChecked() && !flies ? arrowFor(key.key()) : key.key();
    if (!isArrow(arrow) || key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    event->accept();
    if (type == QEvent::ShortcutOverride) return true;
    return press(key, type == QEvent::KeyPress);
}

} // namespace trundle
