// RandomUser's actions in the 3D view, in the text and with runs.

#include <QApplication>
#include <QClipboard>
#include <QMouseEvent>
#include <QTest>

#include "editor/outline/outline_panel.h"
#include "editor/outline/outline_view.h"
#include "editor/shell/main_window.h"
#include "editor/shell/random_user.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

// ---- in the 3D view ----

void RandomUser::mouse(QWidget& on, int type, const QPointF& at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(QEvent::Type(type), at, on.mapToGlobal(at), button, buttons, modifiers);
    QApplication::sendEvent(&on, &event);
}

bool RandomUser::dragHandle(const char* tool, GizmoHandle handle) {
    trigger(tool);
    const auto spot = view().tools().gizmo().spot(handle);
    if (!spot || !view().rect().contains(spot->toPoint())) return false;
    const QByteArray before = QByteArray::fromStdString(*m_window.document().texts().text(m_window.document().path()));
    view().setFocus();
    mouse(view(), QEvent::MouseButtonPress, *spot, Qt::LeftButton);
    QPointF to = *spot;
    const Qt::KeyboardModifiers modifiers = below(3) ? Qt::NoModifier : Qt::ControlModifier;
    for (std::size_t i = below(6) + 1; i > 0; --i) {
        to += QPointF(double(below(80)) - 40, double(below(80)) - 40);
        mouse(view(), QEvent::MouseMove, to, Qt::LeftButton, modifiers);
        if (below(3) == 0) QTest::qWait(20); // ends the burst, so that the next one is an edit of its own
    }
    if (below(6) == 0) QTest::keyClicks(&view(), QStringLiteral("0.25"));
    if (below(4) == 0) {
        QTest::keyClick(&view(), Qt::Key_Escape);
        if (before != QByteArray::fromStdString(*m_window.document().texts().text(m_window.document().path())))
            m_trouble = QStringLiteral("Esc in a drag left another text");
    }
    mouse(view(), QEvent::MouseButtonRelease, to, Qt::NoButton);
    return true;
}

void RandomUser::moveByGizmo() {
    const bool any = below(3) == 0;
    if (any ? !selectObject() : !selectRobot()) return;
    if (below(4)) dragHandle("tool.move", {GizmoHandle::Kind::Axis, int(below(3))});
    else dragHandle("tool.move", {GizmoHandle::Kind::Plane, int(below(3))});
}

void RandomUser::rotateByGizmo() {
    if (selectRobot()) dragHandle("tool.rotate", {GizmoHandle::Kind::Ring, int(below(3))});
}

void RandomUser::sizeByGizmo() {
    for (int tries = 0; tries < 4 && selectObject(); ++tries)
        if (dragHandle("tool.scale", {GizmoHandle::Kind::Size, int(below(3))})) return;
}

void RandomUser::nudge() {
    if (!selectRobot()) return;
    view().setFocus();
    static const std::vector<Qt::Key> keys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp};
    for (std::size_t i = below(3) + 1; i > 0; --i) QTest::keyClick(&view(), oneOf(keys));
    if (below(2)) m_window.document().edits().endMerge(); // as any other user action does
}

void RandomUser::dropToFloor() {
    if (selectRobot()) trigger("tool.drop");
}

// ---- in the text ----

void RandomUser::caretSomewhere() {
    TextPanel& panel = m_window.text();
    if (below(4) == 0) panel.openFile(oneOf(m_window.document().texts().files()));
    CodeEdit& edit = panel.page()->edit();
    const auto at = static_cast<std::uint32_t>(below(edit.bytes().size() + 1));
    edit.setFocus();
    edit.select({at, at});
}

/// Errors in the text prevent other edits, so most are fixed at once.
void RandomUser::fixText() {
    m_window.text().flush();
    for (int i = 0; i < 12 && m_window.document().loaded()->diagnostics.hasErrors() && below(5) != 0; ++i) trigger("edit.undo");
    outline().tree().setFocus();
}

void RandomUser::typeText() {
    caretSomewhere();
    static const std::vector<QString> words{QStringLiteral(" "),   QStringLiteral("// word\n"),
                                            QStringLiteral("x"),   QStringLiteral("\nRobot r { Config=SimpleRobot }\n"),
                                            QStringLiteral("}"),   QStringLiteral("\nTick = 0.02\n"),
                                            QStringLiteral("\n\n")};
    CodeEdit& edit = m_window.text().page()->edit();
    for (const QChar c : oneOf(words)) {
        if (c == QLatin1Char('\n')) QTest::keyClick(&edit, Qt::Key_Return);
        else QTest::keyClick(&edit, c.toLatin1());
    }
    if (below(4) == 0) QTest::qWait(50); // long enough for the document to receive the unfinished text
    if (below(3) == 0) QTest::keyClick(&edit, Qt::Key_Backspace);
    fixText();
}

void RandomUser::pasteText() {
    caretSomewhere();
    static const std::vector<QString> texts{
        QStringLiteral("// pasted\n"), QStringLiteral("\nRobot other { Config=SimpleRobot Pos=2,2,0 }\n"), QStringLiteral("\r\n"),
        QString::fromUtf8("\xC3\xA4\xE2\x86\x92"), QStringLiteral("0.5")};
    QGuiApplication::clipboard()->setText(oneOf(texts));
    trigger("edit.paste");
    fixText();
}

void RandomUser::deleteText() {
    caretSomewhere();
    CodeEdit& edit = m_window.text().page()->edit();
    const std::size_t size = edit.bytes().size();
    if (size > 0 && below(2)) {
        const auto from = static_cast<std::uint32_t>(below(size));
        edit.select({from, std::min(static_cast<std::uint32_t>(size), from + static_cast<std::uint32_t>(below(30)))});
    }
    QTest::keyClick(&edit, below(2) ? Qt::Key_Delete : Qt::Key_Backspace);
    fixText();
}

void RandomUser::commandText() {
    caretSomewhere();
    static const std::vector<const char*> commands{"text.comment", "text.lineUp",    "text.lineDown", "text.format",
                                                   "edit.undo",    "edit.duplicate", "edit.cut"};
    trigger(oneOf(commands));
    fixText();
}

// ---- runs ----

void RandomUser::waitFor(const std::function<bool()>& done, const char* what) {
    if (!QTest::qWaitFor(done, 30000)) m_trouble = QStringLiteral("waited in vain for ") + QLatin1String(what);
}

void RandomUser::waitForRun() {
    const RunSession& session = m_window.session();
    waitFor([&] { return session.state() != RunState::Building && session.state() != RunState::Running; }, "a run to stand");
}

void RandomUser::runAWhile() {
    if (!m_window.session().source().refusal().isEmpty() && m_window.session().state() == RunState::Start) return;
    m_window.session().runFor(0.02 * double(below(15) + 1));
    waitForRun();
}

void RandomUser::stepOnce() {
    const std::uint64_t before = m_window.session().results().snapshot ? m_window.session().results().snapshot->tick : 0;
    trigger("sim.step");
    const RunSession& session = m_window.session();
    const auto done = [&] {
        return session.state() == RunState::Start || session.state() == RunState::Ended ||
               (session.results().snapshot && session.results().snapshot->tick > before);
    };
    waitFor(done, "a tick");
}

/// How far the run gets depends on the machine, so its state is not recorded.
void RandomUser::runAndPause() {
    if (m_window.session().state() == RunState::Ended) return;
    m_window.session().setSpeed(0);
    trigger("sim.run");
    const double from = m_window.session().results().time();
    const RunSession& session = m_window.session();
    waitFor(
        [&] {
            const RunState state = session.state(); // a fast run may have reached its end, or a fault, before `from` was read
            return session.results().time() > from || (state != RunState::Building && state != RunState::Running);
        },
        "a run to go on");
    if (below(2) && session.state() == RunState::Running) { // an edit during the run
        if (selectRobot()) dragHandle("tool.move", {GizmoHandle::Kind::Axis, 0});
    }
    trigger("sim.pause");
    waitForRun();
    trigger("sim.reset");
}

void RandomUser::pushRobot() {
    runAWhile();
    const RunSession& session = m_window.session();
    if (session.state() != RunState::Paused || session.results().experiment->robots.empty()) return;
    trigger("tool.select");
    const auto where =
        session.robots().pose(session.results().experiment->robots[below(session.results().experiment->robots.size())].name);
    const auto at = where ? view().camera().pixelOf(where->position + Vec3(0, 0, 0.08)) : std::nullopt;
    if (!at || !view().rect().contains(at->toPoint())) return;
    mouse(view(), QEvent::MouseButtonPress, *at, Qt::LeftButton, Qt::ControlModifier);
    mouse(view(), QEvent::MouseMove, *at + QPointF(40, -10), Qt::LeftButton, Qt::ControlModifier);
    stepOnce();
    mouse(view(), QEvent::MouseButtonRelease, *at + QPointF(40, -10), Qt::NoButton, Qt::ControlModifier);
}

void RandomUser::keepPoses() {
    if (m_window.session().state() != RunState::Paused) runAWhile();
    trigger("sim.keepPoses");
}

void RandomUser::resetRun() { trigger("sim.reset"); }

// ---- history ----

void RandomUser::undo() {
    for (std::size_t i = below(3) + 1; i > 0; --i) trigger("edit.undo");
}

void RandomUser::redo() {
    for (std::size_t i = below(4) + 1; i > 0; --i) trigger("edit.redo");
}

/// Undoes or redoes a few entries: most edits are undone at the end.
void RandomUser::leap() {
    const std::size_t at = m_window.document().edits().history().position() + below(9);
    m_window.document().edits().moveTo(at < 4 ? 0 : at - 4);
}

void RandomUser::save() { trigger("file.save"); }

} // namespace trundle
