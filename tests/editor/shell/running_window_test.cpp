// The window during a run: it raises problems, finds logs and maximises the 3D view. And layouts on small screens.

#include <QDesktopServices>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <QtWidgets>

#include "editor/document/structure_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/properties/editors/value_field.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/work_area.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kRobot = "#import robots/simple_robot.sim\n"
                          "#import arenas/medium_arena.sim\n"
                          "Static arena { Config=MediumArena }\n"
                          "Robot robot0 { Config=SimpleRobot Pos=-1,0,0 }\n";

} // namespace

/// Replaces the desktop's file manager.
class OpenedUrls : public QObject {
    Q_OBJECT
public:
    QList<QUrl> all;
public Q_SLOTS:
    void take(const QUrl& url) { all.append(url); }
};

class RunningWindowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
        open("mine.sim", kRobot);
    }
    void cleanup() { m_window.reset(); }

    /// What *Remote Control…* copies runs as it is, wherever the package is.
    void theCopiedLinesConnectAProgram() {
        m_window->actions().at("sim.remote").trigger();
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("remoteDialog"));
        QVERIFY(dialog);
        dialog->findChild<QCheckBox*>(QStringLiteral("remoteOn"))->click();
        EVENTUALLY(m_window->session().state() == RunState::Paused);
        dialog->findChild<QToolButton*>(QStringLiteral("remoteCopy"))->click();
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("PYTHONPATH"));
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::MergedChannels);
        program.start(QStringLiteral("python3"),
                      {QStringLiteral("-B"), QStringLiteral("-c"),
                       QGuiApplication::clipboard()->text() + QStringLiteral("run.step(3); print(run.tick)")});
        EVENTUALLY(program.state() == QProcess::NotRunning);
        QCOMPARE(program.readAll().trimmed(), QByteArray("3"));
        dialog->close();
    }

    /// Typed in Properties, without Enter.
    void theRunHasWhatIsTypedInARow() {
        EVENTUALLY(m_window->findChild<QWidget*>(QStringLiteral("row.Tick")));
        auto* field = m_window->findChild<QWidget*>(QStringLiteral("row.Tick"))->findChild<ValueField*>();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QStringLiteral("0.004"));
        QTest::keyClick(field, Qt::Key_F10);
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Paused);
        QCOMPARE(m_window->session().results().experiment->settings.tick, 0.004);
        QVERIFY(m_window->session().edits().waitingText().isEmpty());
    }

    /// Colours that are part of a text or a style sheet follow the theme too.
    void noTextKeepsTheColoursOfTheOtherTheme() {
        const auto inks = [] {
            QStringList names;
            for (const Ink which : {Ink::Faint, Ink::Accent, Ink::Error, Ink::Warning, Ink::Hint, Ink::Good})
                names << ink(which).name();
            return names;
        };
        applyTheme(*qApp, ThemeKind::Light);
        const QStringList light = inks();
        m_window->actions().at("sim.step").trigger(); // there is a link to its logs
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "0.5,0,0"}}).ok());
        EVENTUALLY(m_window->session().state() == RunState::Paused);
        m_window->selection().select("robot0");
        QApplication::processEvents();
        applyTheme(*qApp, ThemeKind::Dark);
        QApplication::processEvents();
        QStringList stale;
        for (const auto* widget : m_window->findChildren<QWidget*>()) {
            if (!widget->isVisible()) continue;
            const auto* label = qobject_cast<const QLabel*>(widget);
            for (const QString& text : {label ? label->text() : QString(), widget->styleSheet()})
                if (std::ranges::any_of(light, [&](const QString& name) { return text.contains(name); }))
                    stale << widget->objectName() + u' ' + text;
            if (label && light.contains(label->palette().color(QPalette::WindowText).name()))
                stale << label->objectName() + u' ' + label->text();
        }
        applyTheme(*qApp, ThemeKind::Light);
        QVERIFY2(stale.isEmpty(), qPrintable(stale.join(QStringLiteral("; "))));
    }

    void raisesProblemsForBrokenFile() {
        const auto* problems = m_window->findChild<QDockWidget*>(QStringLiteral("dock.problems"));
        auto* console = m_window->findChild<QDockWidget*>(QStringLiteral("dock.console"));
        console->raise();
        EVENTUALLY(problems->visibleRegion().isEmpty());
        open("broken.sim", QByteArray(kRobot).replace("Config=SimpleRobot", "Config=SimpelRobot"));
        QVERIFY(m_window->document().loaded()->diagnostics.hasErrors());
        EVENTUALLY(!problems->visibleRegion().isEmpty());
        console->raise(); // a dock that the user raises stays in front
        EVENTUALLY(problems->visibleRegion().isEmpty());
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Set Tick"), {{"Tick", "5 ms"}}).ok());
        QVERIFY(problems->visibleRegion().isEmpty());
    }

    void restoresPinnedValuesWithExperiment() {
        m_window->rememberViews();
        open("pinned.sim", kRobot);
        PinnedValues* pinned = &m_window->viewport().pinned();
        pinned->set({"robot0", "", "robot0.leftMotor"}, true);
        pinned->move("robot0", QPointF(0.5, 0.25));
        const std::vector<Pin> pins = pinned->pins();
        open("other.sim", kRobot); // robots of the same names, but in another document
        QVERIFY(pinned->pins().empty());
        open("pinned.sim", kRobot);
        QVERIFY(pinned->pins() == pins);
        QVERIFY(m_window->close());
        m_window = m_fixture.window();
        m_window->rememberViews();
        open("pinned.sim", kRobot);
        QVERIFY(m_window->viewport().pinned().pins() == pins);
    }

    /// Marks of objects that have been removed meanwhile are not restored: a new one of the same name is visible.
    void restoresMarksOfExistingObjects() {
        m_window->rememberViews();
        const QByteArray second = QByteArray(kRobot).replace("Robot robot0", "Robot robot10");
        open("marks.sim", kRobot + second.mid(second.indexOf("Robot robot10")));
        auto* marks = m_window->findChild<ObjectMarks*>();
        QVERIFY(marks);
        marks->setHidden({"robot0", "robot10"}, true);
        marks->setLocked({"robot10"}, true);
        open("other.sim", kRobot);
        QVERIFY(marks->hidden().empty() && marks->locked().empty());
        open("marks.sim", kRobot);
        QCOMPARE(marks->hidden(), ObjectMarks::Paths{"robot0"});
        QVERIFY(marks->locked().empty());
    }

    /// The next edit removes the message of a refusal, and no other.
    void editKeepsOtherMessages() {
        open("message.sim", kRobot);
        Q_EMIT m_window->document().refused(QStringLiteral("no"));
        m_window->statusBar()->showMessage(QStringLiteral("Saved a picture"));
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Set Tick"), {{"Tick", "5 ms"}}).ok());
        QCOMPARE(m_window->statusBar()->currentMessage(), QStringLiteral("Saved a picture"));
    }

    void windowShowsAndOpensLogFolder() {
        QAction& show = m_window->actions().at("sim.openLogs");
        auto* label = m_window->findChild<QLabel*>(QStringLiteral("status.logs"));
        QVERIFY(!show.isEnabled() && label->text().isEmpty());
        open("logged.sim", kRobot + "PoseLog path { Robot=robot0 }\n");
        m_window->actions().at("sim.step").trigger();
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Paused);
        QVERIFY(show.isEnabled());
        QVERIFY2(label->text().contains(QStringLiteral("logs/logged")), qPrintable(label->text()));
        OpenedUrls urls;
        QDesktopServices::setUrlHandler(QStringLiteral("file"), &urls, "take");
        const auto before = qScopeGuard([] { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); });
        show.trigger();
        QCOMPARE(urls.all, QList<QUrl>{QUrl::fromLocalFile(m_folder.filePath(QStringLiteral("logs/logged")))});
        QTest::mouseClick(label, Qt::LeftButton);
        QCOMPARE(urls.all.size(), 2);
        m_window->actions().at("sim.reset").trigger(); // the logs still exist
        QVERIFY(show.isEnabled());
    }

    /// In a window 800 wide the folder of the logs and the name of the file give way to the state of the run.
    void narrowStatusLineShowsTheRun() {
        open("an_experiment_with_so_long_a_name_that_no_narrow_window_shows_all_of_its_many_words_in_it.sim",
             kRobot + "PoseLog path { Robot=robot0 }\n");
        m_window->resize(800, 500);
        m_window->actions().at("sim.step").trigger();
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Paused);
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Set Tick"), {{"Tick", "5 ms"}}).ok());
        const auto* run = m_window->findChild<QLabel*>(QStringLiteral("status.run"));
        EVENTUALLY(run->text().contains(QStringLiteral("step")) && run->text().contains(QStringLiteral("edits wait")));
        const auto labels = m_window->statusBar()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
        const auto whole = [&] {
            return std::ranges::all_of(labels, [&](const QLabel* label) {
                return label->width() >= label->sizeHint().width() && m_window->statusBar()->rect().contains(label->geometry());
            });
        };
        EVENTUALLY(whole());
        const auto* file = m_window->findChild<QLabel*>(QStringLiteral("status.file"));
        QVERIFY2(file->text().contains(QChar(0x2026)) && file->toolTip().endsWith(QStringLiteral("in_it.sim")),
                 qPrintable(file->text()));
        m_window->resize(1700, 500);
        EVENTUALLY(file->text().endsWith(QStringLiteral("many_words_in_it.sim")) && whole());
    }

    /// What does not fit into the panel is scrolled to; the window keeps its size.
    void theDetailsOfAControllerAreReadableInANarrowWindow() {
        m_window->resize(1000, 700);
        m_window->actions().at("view.layoutRun").trigger();
        m_window->findChild<QDockWidget*>(QStringLiteral("dock.controllers"))->raise();
        m_window->selection().select("robot0");
        EVENTUALLY(m_window->isSettled());
        const auto* details = m_window->findChild<QPlainTextEdit*>(QStringLiteral("controllerDetails"));
        EVENTUALLY(details->isVisible());
        QVERIFY2(details->width() >= 200, qPrintable(QString::number(details->width())));
        QCOMPARE(m_window->size(), QSize(1000, 700));
    }

    void runLayoutCentresView() {
        QVERIFY(m_window->text().isVisible());
        m_window->text().page()->edit().setFocus();
        EVENTUALLY(m_window->text().hasKeyboard());
        m_window->actions().at("view.layoutRun").trigger();
        QVERIFY(m_window->viewport().isVisible() && !m_window->text().isVisible());
        QVERIFY(m_window->viewport().isAncestorOf(QApplication::focusWidget())); // keys do not go to Properties
        QVERIFY(!m_window->actions().at("view.text").isChecked());
        m_window->actions().at("view.layoutEdit").trigger();
        QVERIFY(m_window->text().isVisible());
        m_window->work().showText(false); // a user who hid the text does not get it back
        m_window->actions().at("view.layoutRun").trigger();
        m_window->actions().at("view.layoutEdit").trigger();
        QVERIFY(!m_window->text().isVisible());
    }

    /// A layout saved on a screen of 1600 x 1000 at scale factor 2.
    void aLayoutOfALargerScreenGivesWay() {
        m_window->resize(1500, 900);
        EVENTUALLY(m_window->isSettled());
        QVERIFY(m_window->close());
        m_window = m_fixture.window();
        m_window->resize(790, 460);
        m_window->show();
        open("mine.sim", kRobot);
        EVENTUALLY(m_window->isSettled());
        EVENTUALLY_EQUAL(m_window->width(), 790);
        QVERIFY(!m_window->tabifiedDockWidgets(m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties"))).isEmpty());
    }

    void selectingKeepsTheWindowsSize_data() {
        QTest::addColumn<int>("font");
        QTest::addColumn<int>("width");
        for (const int font : {11, 13, 17})
            for (const int width : {800, 1100}) QTest::addRow("%d px, %d wide", font, width) << font << width;
    }

    void selectingKeepsTheWindowsSize() {
        QFETCH(int, font);
        QFETCH(int, width);
        applyTheme(*qApp, ThemeKind::Light, {font, font});
        const auto after = qScopeGuard([] { applyTheme(*qApp, ThemeKind::Light); });
        m_window->resize(width, 500);
        EVENTUALLY(m_window->isSettled());
        m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties"))->raise();
        QCoreApplication::processEvents();
        const QSize before = m_window->size();
        m_window->actions().at("sim.step").trigger();
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Paused);
        auto* live = m_window->findChild<QTreeWidget*>(QStringLiteral("liveValues"));
        for (const char* path : {"robot0", "robot0.chassis", "robot0.leftMotor", "arena", "", "robot0"}) {
            m_window->selection().select(path);
            QCoreApplication::processEvents();
            QCoreApplication::processEvents();
            QCOMPARE(m_window->size(), before);
        }
        QVERIFY(live->isVisible() && live->height() > 0);
    }

private:
    void open(const char* name, const QByteArray& text) {
        QFile file(m_folder.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        QVERIFY(m_window->open(file.fileName()));
        EVENTUALLY(m_window->document().isOpen() && m_window->document().path() == file.fileName().toStdString());
    }

    QTemporaryDir m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(RunningWindowTest)
#include "running_window_test.moc"
