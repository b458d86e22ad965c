// The window on a real X server with a window manager, driven by synthetic hardware events: keyboard focus, drag and drop,
// closing, and the clipboard as another program sees it. xdotool sends the events, openbox is the window manager.

#include <cstdio>

#include <QApplication>
#include <QClipboard>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QSocketNotifier>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/library_view.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_panel.h"
#include "editor/outline/outline_view.h"
#include "editor/properties/editors/value_field.h"
#include "editor/shell/window_fixture.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kExperiment = R"(Tick = 0.01
RobotConfig Rover {
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 }
    Box bumper { Size=0.02,0.2,0.04 Pos=0.16,0,0.07 Mass=0.05 }
  }
  Body wheel { Pos=0,0.1,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge axle { Parent=chassis Child=wheel Axis=0,1,0 }
}
StaticConfig Floor { Plane floor { } }
Static arena { Config=Floor }
Robot robot0 { Config=Rover Pos=0,0,0 }   // the first
)";

constexpr int kLookMs = 20; // polling interval of conditions without a signal, in ms

/// Calls xdotool: "mousemove 10 20 click 1".
bool act(const QString& words) {
    QProcess tool;
    tool.setStandardOutputFile(QProcess::nullDevice());
    tool.setStandardErrorFile(QProcess::nullDevice()); // it also reports that the window manager has not started yet
    tool.start(QStringLiteral("xdotool"), words.split(QLatin1Char(' ')));
    return tool.waitForFinished() && tool.exitStatus() == QProcess::NormalExit && tool.exitCode() == 0;
}

bool keys(const QString& names) { return act(QStringLiteral("key ") + names); }

bool pointTo(const QPoint& place) { return act(QStringLiteral("mousemove %1 %2").arg(place.x()).arg(place.y())); }

/// Answers the next dialog with keys as soon as it has the focus. Polls with a timer, because a dialog runs its own event loop.
class Answer final : public QObject {
public:
    explicit Answer(QMessageBox::StandardButton button) : m_button(button) {
        connect(&m_timer, &QTimer::timeout, this, &Answer::look);
        m_timer.start(kLookMs);
    }
    [[nodiscard]] const QString& seen() const { return m_seen; }

private:
    void look() {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        auto* focus = qobject_cast<QPushButton*>(QApplication::focusWidget());
        if (!box || !box->isActiveWindow() || !focus || focus->window() != box) return;
        m_seen = box->objectName();
        const bool there = box->standardButton(focus) == m_button;
        if (there || m_button == QMessageBox::Cancel) m_timer.stop();
        (void)keys(m_button == QMessageBox::Cancel ? QStringLiteral("Escape")
                   : there                         ? QStringLiteral("Return")
                                                   : QStringLiteral("Tab"));
    }
    const QMessageBox::StandardButton m_button;
    QTimer m_timer;
    QString m_seen;
};

/// Drags with the mouse button pressed: moves towards the point until the target has seen the drag exactly there, then releases.
/// Polls with a timer, because a drag runs its own event loop.
class Carrier final : public QObject {
public:
    Carrier(QWidget& target, const QPoint& place) : m_place(place), m_screen(target.mapToGlobal(place)) {
        target.installEventFilter(this);
        connect(&m_timer, &QTimer::timeout, this, &Carrier::go);
        m_timer.start(kLookMs);
    }
    [[nodiscard]] bool done() const { return m_done; }

private:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::DragMove) m_there |= static_cast<QDropEvent*>(event)->position().toPoint() == m_place;
        if (event->type() == QEvent::Drop) m_done = true;
        return false;
    }
    void go() {
        if (m_there) {
            m_timer.stop();
            (void)act(QStringLiteral("mouseup 1"));
            return;
        }
        m_far = !m_far;
        (void)pointTo(m_far ? m_screen + QPoint(7, 7) : m_screen);
    }
    const QPoint m_place, m_screen;
    QTimer m_timer;
    bool m_far = false, m_there = false, m_done = false;
};

/// A second process of this program, to share the clipboard with.
struct OtherProgram : QProcess {
    explicit OtherProgram(const char* task) {
        setProcessChannelMode(ForwardedErrorChannel);
        start(QCoreApplication::applicationFilePath(), {QLatin1String(task)});
    }
    ~OtherProgram() override {
        closeWriteChannel();
        if (!waitForFinished(5000)) kill(), waitForFinished();
    }
};

int readClipboard() {
    const QByteArray text = QGuiApplication::clipboard()->text().toUtf8();
    std::fwrite(text.constData(), 1, std::size_t(text.size()), stdout);
    return 0;
}

/// Owns the clipboard until standard input ends.
int ownClipboard() {
    QGuiApplication::clipboard()->setText(QStringLiteral("Robot fromElsewhere { Config=Rover Pos=1,1,0 }\n"));
    QSocketNotifier end(0, QSocketNotifier::Read);
    QObject::connect(&end, &QSocketNotifier::activated, qApp, &QCoreApplication::quit);
    return QGuiApplication::exec();
}

} // namespace

class DesktopTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QCOMPARE(QGuiApplication::platformName(), QStringLiteral("xcb"));
        QGuiApplication::setQuitOnLastWindowClosed(false);
        m_manager.start(QStringLiteral("openbox"), {QStringLiteral("--sm-disable")});
        QVERIFY(m_manager.waitForStarted());
        // Waits for the window manager. If another one runs already, ours cannot start and that one is used.
        EVENTUALLY(act(QStringLiteral("get_desktop")));
        m_fixture.start();
    }
    void cleanupTestCase() {
        m_manager.terminate();
        m_manager.waitForFinished();
    }
    void init() {
        QSettings().clear();
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(kExperiment);
        file.close();
        if (!m_window) m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        EVENTUALLY(m_window->frameGeometry().top() < m_window->geometry().top()); // it has its frame, so it will not move
        QVERIFY(m_window->open(path()));
        EVENTUALLY(m_window->document().isOpen());
        EVENTUALLY(m_window->viewport().views().isUpToDate());
    }
    void cleanup() {
        (void)act(QStringLiteral("mouseup 1")); // in case a test failed during a drag
        m_window->document().opening().close();
        if (!m_window->isVisible() || QTest::currentTestFailed()) m_window.reset();
    }

    void keysGoWhereOneClicked() {
        QAction &move = m_window->actions().at("tool.move"), &select = m_window->actions().at("tool.select");
        CodeEdit& edit = m_window->text().page()->edit();
        click(*edit.viewport(), edit.geometry().placeOf(0) + QPoint(1, -edit.geometry().lineHeight() / 2));
        EVENTUALLY(edit.hasFocus());
        QVERIFY(keys(QStringLiteral("w Delete Right Right Right BackSpace 1")));
        EVENTUALLY_EQUAL(text().left(5), QByteArray("wic1 ")); // in the text, W is not a tool and Delete removes no objects
        QVERIFY(select.isChecked());

        View& view = m_window->viewport().views().current();
        click(view, {20, 60}); // an empty part of the view
        EVENTUALLY(view.hasFocus());
        const QByteArray before = text();
        QVERIFY(keys(QStringLiteral("w 7")));
        EVENTUALLY(move.isChecked());
        EVENTUALLY_EQUAL(view.camera().free().kind(), ViewKind::Top);
        QCOMPARE(text(), before);

        click(*tree().viewport(), placeOf("robot0"));
        EVENTUALLY(tree().hasFocus());
        EVENTUALLY_EQUAL(m_window->selection().current(), std::string("robot0"));
        QWidget* row = m_window->findChild<QWidget*>(QStringLiteral("row.Pos"));
        QVERIFY(row);
        auto* field = row->findChild<ValueField*>(QStringLiteral("field0"));
        QVERIFY(field);
        click(*field, field->rect().center());
        EVENTUALLY(field->hasFocus());
        QVERIFY(keys(QStringLiteral("ctrl+a Delete 5"))); // selects all of the field, not all objects; 5 does not select a camera
        EVENTUALLY_EQUAL(field->text(), QStringLiteral("5"));
        QCOMPARE(m_window->selection().paths(), std::vector<std::string>{"robot0"});
        QCOMPARE(view.camera().free().kind(), ViewKind::Top);
        QVERIFY(keys(QStringLiteral("Escape")));
        EVENTUALLY_EQUAL(field->text(), QStringLiteral("0"));

        click(*tree().viewport(), placeOf("robot0"));
        EVENTUALLY(tree().hasFocus());
        QVERIFY(keys(QStringLiteral("Delete")));
        EVENTUALLY(!text().contains("Robot robot0"));
        QVERIFY(keys(QStringLiteral("ctrl+z")));
        EVENTUALLY_EQUAL(text(), before);
    }

    void libraryDropPlacesUnderCursor() {
        EVENTUALLY(!m_window->findChild<LibraryPanel*>()->isReading());
        auto* search = m_window->findChild<QLineEdit*>(QStringLiteral("librarySearch"));
        click(*search, search->rect().center());
        EVENTUALLY(search->hasFocus());
        QVERIFY(act(QStringLiteral("type pillar")));
        LibraryList* list = nullptr;
        EVENTUALLY(list = libraryListWith("Pillar"));
        const QRect item = list->visualRect(list->model()->index(0, 0));
        View& view = m_window->viewport().views().current();
        const QPoint at(view.width() / 3, view.height() * 3 / 4);
        const Vec3 point = view.camera().pointUnder(at);
        QVERIFY(std::abs(point.z()) < 1e-9); // on the floor
        carry(*list->viewport(), item.center(), view, at);
        if (QTest::currentTestFailed()) return;
        EVENTUALLY_EQUAL(m_window->document().loaded()->experiment->statics.size(), std::size_t(2));
        const StaticSpec& pillar = m_window->document().loaded()->experiment->statics.back();
        // There is no room on top of the robot: it is placed on the floor beside it, neither inside it nor over the floor's edge.
        QVERIFY2(std::abs(pillar.pose.position.z()) < 1e-5, qPrintable(QStringLiteral("%1 %2 %3 from %4 %5")
                                                                           .arg(pillar.pose.position.x())
                                                                           .arg(pillar.pose.position.y())
                                                                           .arg(pillar.pose.position.z())
                                                                           .arg(point.x())
                                                                           .arg(point.y())));
        const double away = (pillar.pose.position - point).head<2>().norm();
        QVERIFY2(away > 0 && away < 0.4, qPrintable(QString::number(away)));
        QCOMPARE(m_window->selection().paths(), std::vector<std::string>{pillar.name});
        m_window->document().edits().undo();
        QCOMPARE(text(), kExperiment);
    }

    void movesDraggedShapeToAnotherBody() {
        for (const char* above : {"RobotConfig.Rover", "RobotConfig.Rover.chassis"}) tree().expand(model().indexOf(above));
        const QPoint from = placeOf("RobotConfig.Rover.chassis.bumper"), to = placeOf("RobotConfig.Rover.wheel");
        carry(*tree().viewport(), from, *tree().viewport(), to);
        if (QTest::currentTestFailed()) return;
        EVENTUALLY_EQUAL(m_window->selection().paths(), std::vector<std::string>{"RobotConfig.Rover.wheel.bumper"});
        QVERIFY2(text().contains("bumper { Size=0.02,0.2,0.04 Pos=0.16,-0.1,0.02 "),
                 text().constData()); // the same pose in the world
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
        m_window->document().edits().undo();
        QCOMPARE(text(), kExperiment);
    }

    void closingQuestionAcceptsKeyboard() {
        const QByteArray moved = QByteArray(kExperiment).replace("Pos=0,0,0 }   //", "Pos=1,0,0 }   //");
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        close(QMessageBox::Cancel);
        QVERIFY(m_window->isVisible());
        QCOMPARE(onDisk(), kExperiment);
        QCOMPARE(text(), moved);
        EVENTUALLY(m_window->isActiveWindow());
        close(QMessageBox::Save);
        EVENTUALLY(!m_window->isVisible());
        QCOMPARE(onDisk(), moved);
    }

    void discardWritesNothing() {
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        close(QMessageBox::Discard);
        EVENTUALLY(!m_window->isVisible());
        QCOMPARE(onDisk(), kExperiment);
    }

    void unchangedWindowClosesWithoutQuestion() {
        QVERIFY(keys(QStringLiteral("alt+F4")));
        EVENTUALLY(!m_window->isVisible());
    }

    void aBlockTravelsByTheClipboard() {
        click(*tree().viewport(), placeOf("robot0"));
        EVENTUALLY(tree().hasFocus());
        QVERIFY(keys(QStringLiteral("ctrl+c")));
        EVENTUALLY(QApplication::clipboard()->ownsClipboard());
        {
            OtherProgram reader("--read-clipboard");
            EVENTUALLY_EQUAL(reader.state(), QProcess::NotRunning); // while this program answers
            QCOMPARE(reader.readAllStandardOutput().trimmed(),
                     QByteArray("Robot robot0 { Config=Rover Pos=0,0,0 }   // the first"));
        }
        OtherProgram owner("--own-clipboard");
        EVENTUALLY(!QApplication::clipboard()->ownsClipboard());
        QVERIFY(keys(QStringLiteral("ctrl+v")));
        EVENTUALLY_EQUAL(m_window->selection().paths(), std::vector<std::string>{"fromElsewhere"});
        QVERIFY(text().contains("Robot fromElsewhere { Config=Rover Pos=1,1,0 }"));
    }

private:
    QString path() const { return m_folder.filePath(QStringLiteral("mine.sim")); }
    QByteArray onDisk() const {
        QFile file(path());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QByteArray text() const {
        m_window->text().flush();
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().path()));
    }
    OutlineView& tree() const { return m_window->findChild<OutlinePanel*>()->tree(); }
    OutlineModel& model() const { return m_window->findChild<OutlinePanel*>()->model(); }
    QPoint placeOf(const char* path) const {
        const QModelIndex index = model().indexOf(path);
        tree().reveal(index);
        return tree().visualRect(index).center();
    }
    /// The list of the Library that contains only this item.
    LibraryList* libraryListWith(const char* title) const {
        for (auto* list : m_window->findChild<LibraryPanel*>()->findChildren<LibraryList*>())
            if (list->isVisible() && list->model()->rowCount() == 1 && list->model()->index(0, 0).data() == QLatin1String(title))
                return list;
        return nullptr;
    }

    void click(QWidget& widget, const QPoint& place) {
        EVENTUALLY(isOver(widget, place));
        QVERIFY(act(QStringLiteral("click 1")));
    }
    /// True if the widget has received the pointer position there: the events may be still on their way.
    static bool isOver(QWidget& widget, const QPoint& place) {
        return pointTo(widget.mapToGlobal(place)) && QTest::qWaitFor([&] { return widget.underMouse(); }, 5 * kLookMs);
    }
    void carry(QWidget& source, const QPoint& from, QWidget& target, const QPoint& to) {
        EVENTUALLY(isOver(source, from));
        QVERIFY(act(QStringLiteral("mousedown 1")));
        Carrier carrier(target, to);
        EVENTUALLY(carrier.done());
    }
    /// Closes the window by the window manager's shortcut, and answers the question with this button.
    void close(QMessageBox::StandardButton button) {
        Answer answer(button);
        QVERIFY(keys(QStringLiteral("alt+F4")));
        EVENTUALLY_EQUAL(answer.seen(), QStringLiteral("unsavedQuestion"));
    }

    QTemporaryDir m_folder;
    QProcess m_manager;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.contains(QStringLiteral("--read-clipboard"))) return readClipboard();
    if (arguments.contains(QStringLiteral("--own-clipboard"))) return ownClipboard();
    DesktopTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "desktop_test.moc"
