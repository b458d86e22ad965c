// The whole window with the real application: open, move, undo, type, run, reset, save.

#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <QtWidgets>

#include "editor/document/structure_edits.h"
#include "editor/shell/recent_files.h"
#include "editor/shell/window_fixture.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kExperiment = "// mine\n"
                               "#import robots/simple_robot.sim\n"
                               "#import arenas/medium_arena.sim\n"
                               "#loadModule controllers/linear_motion\n"
                               "Static arena { Config=MediumArena }\n"
                               "Robot robot0 {\n"
                               "  Config=SimpleRobot  Pos=-1,0,0   // where it starts\n"
                               "  LinearMotion brain { Distance=1.0 Speed=0.2 }\n"
                               "}\n";

} // namespace

class WindowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        QVERIFY(m_folder.isValid());
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(kExperiment);
        file.close();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kTimeoutMs));
    }
    void cleanup() { m_window.reset(); }

    void aNewWindowShowsTheWelcomePage() {
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("sample.linear_motion"))->isVisible());
        const QString configs = QString::fromStdString(findLocations().configs);
        for (const Sample& sample : sampleExperiments(configs) + sampleParts(configs))
            QVERIFY2(!QImage(sample.picture).isNull(), qPrintable(sample.picture));
        for (const char* subject : {"sample.blob_follow", "sample.camera_swarm", "sample.sensor_network_amr",
                                    "sample.directional_antenna", "sample.turn_angle", "sample.network_navigation"})
            QVERIFY2(m_window->findChild<QWidget*>(QLatin1String(subject)), subject);
    }

    void commandsAreHarmlessOnWelcomePage() {
        const QStringList asking{QStringLiteral("file.open"),        QStringLiteral("file.quit"),  QStringLiteral("edit.palette"),
                                 QStringLiteral("edit.preferences"), QStringLiteral("help.about"), QStringLiteral("view.theme")};
        for (const ActionRow& row : m_window->actions().table()) {
            const QString id = QLatin1String(row.id);
            if (asking.contains(id) || id.startsWith(QStringLiteral("file.new"))) continue;
            m_window->actions().at(row.id).trigger();
            QVERIFY2(!m_window->document().isOpen(), row.id);
            QVERIFY2(!QApplication::activeModalWidget() && !QApplication::activePopupWidget(), row.id);
        }
    }

    void guideStaysOpenAcrossPages() {
        auto* guide = m_window->findChild<QDockWidget*>(QStringLiteral("dock.guide"));
        m_window->actions().at("help.guide").trigger();
        QVERIFY(guide->isVisible());
        QVERIFY(!m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
        openExperiment();
        EVENTUALLY(guide->isVisible());
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
        m_window->actions().at("file.openSample").trigger();
        QVERIFY(!m_window->document().isOpen());
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
    }

    void statusMessageHidesOthers() {
        openExperiment();
        m_window->statusBar()->showMessage(QStringLiteral("a hint"));
        const auto* file = m_window->findChild<QLabel*>(QStringLiteral("status.file"));
        QVERIFY(!file->isVisible());
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(!file->isVisible());
        m_window->statusBar()->clearMessage();
        QVERIFY(file->isVisible());
    }

    void nextEditClearsRejection() {
        openExperiment();
        Q_EMIT m_window->document().refused(QStringLiteral("no"));
        QCOMPARE(m_window->statusBar()->currentMessage(), QStringLiteral("No"));
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(m_window->statusBar()->currentMessage().isEmpty());
    }

    void restoresWindowSize() {
        m_window->resize(701, 633); // smaller than the screen of the test
        QVERIFY(m_window->close());
        m_window = m_fixture.window();
        QCOMPARE(m_window->size(), QSize(701, 633));
    }

    void windowFitsSmallScreen() {
        openExperiment();
        QVERIFY2(
            m_window->minimumSizeHint().width() <= 1024 && m_window->minimumSizeHint().height() <= 700,
            qPrintable(
                QStringLiteral("%1 x %2").arg(m_window->minimumSizeHint().width()).arg(m_window->minimumSizeHint().height())));
    }

    void aSmallScreenMayHaveItAll() {
        m_window->resize(1024, 700);
        openExperiment();
        EVENTUALLY(m_window->isSettled());
        QCOMPARE(m_window->size(), QSize(1024, 700));
    }

    void aSmallScreenIsEnough_data() {
        QTest::addColumn<QString>("layout");
        QTest::newRow("to edit") << QStringLiteral("view.layoutEdit");
        QTest::newRow("to run") << QStringLiteral("view.layoutRun");
    }
    void aSmallScreenIsEnough() {
        QFETCH(QString, layout);
        m_window->resize(1100, 700);
        openExperiment();
        m_window->actions().at(qPrintable(layout)).trigger();
        m_window->selection().select("robot0");
        EVENTUALLY(m_window->isSettled());
        QCOMPARE(m_window->size(), QSize(1100, 700));
        const QStringList cut = cutOff(*m_window);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QLatin1Char('\n'))));
    }

    void tabbedDockHasNoTitle() {
        openExperiment();
        const auto dock = [this](const char* name) {
            return m_window->findChild<QDockWidget*>(QStringLiteral("dock.") + QLatin1String(name));
        };
        QDockWidget *problems = dock("problems"), *console = dock("console"), *controllers = dock("controllers");
        const auto titled = [](const QDockWidget* which) { return which->titleBarWidget() == nullptr; };
        EVENTUALLY(!titled(problems) && !titled(console) && !titled(controllers)); // their tabs show the titles
        QVERIFY(titled(dock("scene")));
        console->setFloating(true);
        EVENTUALLY(titled(console));
        QVERIFY(!titled(problems));
        controllers->setFloating(true); // the first one is alone now, though the others were tabbed with it before
        EVENTUALLY(titled(controllers) && titled(problems));
        console->setFloating(false);
        EVENTUALLY(!titled(console) && !titled(problems));
    }

    void aSampleOpensWithAClick() {
        QTest::mouseClick(m_window->findChild<QWidget*>(QStringLiteral("sample.linear_motion")), Qt::LeftButton);
        EVENTUALLY(m_window->document().isOpen());
        EVENTUALLY(m_window->isSettled());
        QVERIFY(!m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
    }

    void aNewExperimentRunsBeforeItIsSaved() {
        m_window->actions().at("file.newExperiment").trigger();
        EVENTUALLY(m_window->document().isOpen());
        QVERIFY(m_window->document().isNew());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
        m_window->session().runFor(0.1);
        EVENTUALLY(m_window->session().results().time() > 0.0999);
        m_window->actions().at("sim.reset").trigger();
        QCOMPARE(m_window->session().state(), RunState::Start);
    }

    void movedUndoneRedone() {
        openExperiment();
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move robot0"), {{"robot0.Pos", "-1.5,0,0"}}).ok());
        const QByteArray moved = QByteArray(kExperiment).replace("Pos=-1,0,0", "Pos=-1.5,0,0");
        QCOMPARE(text(), moved);
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(m_window->actions().at("edit.undo").text(), QStringLiteral("&Undo Move robot0"));
        m_window->actions().at("edit.undo").trigger();
        QCOMPARE(text(), kExperiment);
        QVERIFY(!m_window->isWindowModified());
        m_window->actions().at("edit.redo").trigger();
        QCOMPARE(text(), moved);
        m_window->actions().at("file.save").trigger();
        QFile file(path());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), moved);
        QVERIFY(!m_window->isWindowModified());
    }

    void runKeepsTexts() {
        openExperiment();
        m_window->actions().at("sim.run").trigger();
        EVENTUALLY(m_window->session().results().time() > 0.05);
        m_window->actions().at("sim.pause").trigger();
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Paused);
        QCOMPARE(text(), kExperiment);
        QVERIFY(!m_window->document().edits().history().canUndo());
        m_window->actions().at("sim.reset").trigger();
        EVENTUALLY_EQUAL(m_window->session().state(), RunState::Start);
    }

    /// After a value was typed into a field, the arrow keys would change that value.
    void viewHasKeyboardWhileDriving() {
        openExperiment();
        m_window->actions().at("sim.drive").trigger();
        m_window->selection().select("robot0");
        auto* row = m_window->findChild<QDockWidget*>(QStringLiteral("dock.properties"))->findChild<QLineEdit*>();
        QVERIFY(row);
        row->setFocus();
        m_window->actions().at("sim.run").trigger();
        QVERIFY(m_window->viewport().views().current().hasFocus());
        m_window->actions().at("sim.reset").trigger();
    }

    void aTextWithErrorsOpensAndIsNotRun() {
        openExperiment();
        QVERIFY(m_window->document()
                    .edits()
                    .replaceText(QStringLiteral("Typing"), path().toStdString(),
                                 QByteArray(kExperiment).replace("Config=SimpleRobot", "Config=SimpelRobot").toStdString())
                    .ok());
        QVERIFY(m_window->document().loaded()->diagnostics.hasErrors());
        m_window->actions().at("sim.run").trigger();
        QCOMPARE(m_window->session().state(), RunState::Start);
        QVERIFY(m_window->document().lastValid() != nullptr);
        m_window->actions().at("edit.undo").trigger();
        QCOMPARE(text(), kExperiment);
        m_window->actions().at("sim.step").trigger();
        EVENTUALLY(m_window->session().results().time() > 0);
    }

    void deleteRemovesObjectsInScene() {
        openExperiment();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        const auto pressIn = [this](QWidget* place) {
            m_window->selection().select("robot0");
            place->setFocus();
            QTest::keyClick(place, Qt::Key_Delete);
            QTest::keyClick(place, Qt::Key_X, Qt::ControlModifier);
        };
        for (const auto& [dock, name] : {std::pair{"console", "consoleLines"}, {"history", "historyList"}}) {
            m_window->findChild<QDockWidget*>(QStringLiteral("dock.") + QLatin1String(dock))->raise();
            auto* list = m_window->findChild<QAbstractItemView*>(QLatin1String(name));
            QTRY_VERIFY2(list && list->isVisible(), name);
            pressIn(list);
            QVERIFY2(text() == kExperiment, name);
        }
        for (QWidget* place : {static_cast<QWidget*>(m_window->findChild<QTreeView*>(QStringLiteral("outlineTree"))),
                               static_cast<QWidget*>(&m_window->viewport().views().current())}) {
            pressIn(place);
            QVERIFY(!text().contains("robot0 {"));
            m_window->actions().at("edit.undo").trigger();
            QCOMPARE(text(), kExperiment);
        }
    }

    void scaleFactorTwoIsEnough() {
        m_window->resize(792, 460); // 1600 x 1000 at scale factor 2, less the window frame
        openExperiment();
        EVENTUALLY(m_window->text().isVisible() && m_window->viewport().isVisible());
        const QSize least = m_window->minimumSizeHint();
        QVERIFY2(least.width() <= 792 && least.height() <= 460,
                 qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
        QCOMPARE(m_window->size(), QSize(792, 460));
        m_window->actions().at("view.four").trigger();
        QVERIFY2(m_window->minimumSizeHint().width() <= 792, qPrintable(QString::number(m_window->minimumSizeHint().width())));
        m_window->actions().at("view.layoutRun").trigger();
        QVERIFY(m_window->minimumSizeHint().width() <= 792);
    }

    void showsExternalChangeBeforeChoice() {
        openExperiment();
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(kExperiment).replace("Pos=-1,0,0", "Pos=7,0,0"));
        file.close();
        m_window->document().disk().check();
        auto* question = m_window->findChild<QMessageBox*>(QStringLiteral("diskQuestion"));
        QVERIFY(question && question->isVisible());
        for (const char* line : {"- ", "Pos=1,0,0", "+ ", "Pos=7,0,0"})
            QVERIFY2(question->informativeText().contains(QLatin1String(line)), line);
        QCOMPARE(question->buttonRole(question->defaultButton()), QMessageBox::RejectRole); // Enter is not destructive
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole) button->click();
        QVERIFY(text().contains("Pos=7,0,0"));
        m_window->actions().at("edit.undo").trigger();
        QVERIFY(text().contains("Pos=1,0,0"));
    }

    void aTextDroppedAnywhereIsOpened() {
        QMimeData carried;
        carried.setUrls({QUrl::fromLocalFile(path())});
        const auto drop = [this, &carried](const QPointF& at) {
            QDragEnterEvent enter(at.toPoint(), Qt::CopyAction | Qt::MoveAction, &carried, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(m_window->windowHandle(), &enter);
            QDropEvent there(at, Qt::CopyAction | Qt::MoveAction, &carried, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(m_window->windowHandle(), &there);
            return enter.isAccepted() && there.isAccepted();
        };
        const auto middleOf = [this](QWidget& panel) { return QPointF(panel.mapTo(m_window.get(), panel.rect().center())); };
        QVERIFY(drop(QPointF(300, 300))); // on the Welcome page
        EVENTUALLY(m_window->document().isOpen());
        QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        m_window->actions().at("file.save").trigger();
        for (QWidget* panel : {static_cast<QWidget*>(&m_window->text()), static_cast<QWidget*>(&m_window->viewport())}) {
            QSignalSpy opened(&m_window->document(), &Document::opened);
            QVERIFY(drop(middleOf(*panel)));
            EVENTUALLY_EQUAL(opened.size(), 1);
            QVERIFY(text().contains("Pos=1,0,0")); // the text is opened, not inserted into another
        }
        QVERIFY(!m_window->isWindowModified());
        carried.setUrls({QUrl::fromLocalFile(m_folder.path())});
        QVERIFY(!drop(middleOf(m_window->viewport())));
        m_window->document().opening().close();
    }

    void canPauseWhilePushing() {
        openExperiment();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        EVENTUALLY(m_window->isSettled());
        RunSession& session = m_window->session();
        View& view = m_window->viewport().views().current();
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_F5);
        EVENTUALLY(session.results().poses && session.results().time() > 0.02);
        const QPoint at = view.camera().pixelOf(session.robots().pose("robot0")->position + Vec3(0, 0, 0.1)).value().toPoint();
        QTest::mousePress(&view, Qt::LeftButton, Qt::ControlModifier, at);
        QMouseEvent move(QEvent::MouseMove, at + QPointF(30, 0), view.mapToGlobal(at + QPointF(30, 0)), Qt::NoButton,
                         Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&view, &move);
        QVERIFY(view.isMouseBusy());
        QTest::keyClick(&view, Qt::Key_F6);
        EVENTUALLY_EQUAL(session.state(), RunState::Paused);
        QVERIFY(view.isMouseBusy());
        QTest::keyClick(&view, Qt::Key_F5);
        EVENTUALLY_EQUAL(session.state(), RunState::Running);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::ControlModifier, at + QPoint(30, 0));
        QVERIFY(!view.isMouseBusy());
    }

    void theFindBarMovesNothing() {
        openExperiment();
        m_window->resize(1100, 700);
        EVENTUALLY(m_window->isSettled());
        auto* work = m_window->findChild<QSplitter*>(QStringLiteral("work"));
        work->setSizes({10000, 1}); // makes the text as narrow as possible
        const QList<int> before = work->sizes();
        m_window->actions().at("edit.replace").trigger();
        EVENTUALLY(m_window->findChild<QWidget*>(QStringLiteral("findBar"))->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(work->sizes(), before);
        QCOMPARE(cutOff(*m_window->findChild<QWidget*>(QStringLiteral("findBar"))), QStringList());
    }

    void dialogButtonsHaveNoIcons() {
        QDialogButtonBox box(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::Discard);
        box.show();
        for (const QAbstractButton* button : box.buttons()) QVERIFY2(button->icon().isNull(), qPrintable(button->text()));
        QMessageBox question(QMessageBox::Question, {}, QStringLiteral("?"), QMessageBox::Save | QMessageBox::Discard);
        question.show();
        for (const QAbstractButton* button : question.buttons()) QVERIFY2(button->icon().isNull(), qPrintable(button->text()));
    }

    void bothThemesAndBothLayouts() {
        openExperiment();
        m_window->actions().at("view.theme").trigger();
        QCOMPARE(currentTheme(), ThemeKind::Dark);
        m_window->actions().at("view.layoutRun").trigger();
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.console"))->isVisible());
        m_window->actions().at("view.layoutEdit").trigger();
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.library"))->isVisible());
        m_window->actions().at("view.theme").trigger();
        QCOMPARE(currentTheme(), ThemeKind::Light);
    }

private:
    /// Clipped widgets: those that extend beyond their parent, texts without enough room, and hidden buttons of the window's own
    /// toolbars. Widgets in background tabs are not checked.
    static QStringList cutOff(QWidget& window) {
        QStringList found;
        for (const QWidget* w : window.findChildren<QWidget*>()) {
            const QWidget* parent = w->parentWidget();
            if (!w->isVisible() || w->isWindow() || w->visibleRegion().isEmpty() || qobject_cast<const QLineEdit*>(parent))
                continue;
            const bool scrolls = parent->parentWidget() && qobject_cast<const QAbstractScrollArea*>(parent->parentWidget());
            const auto* label = qobject_cast<const QLabel*>(w);
            const auto* tool = qobject_cast<const QToolButton*>(w);
            const auto* button = qobject_cast<const QAbstractButton*>(w);
            const bool words = label ? !label->text().isEmpty()
                                     : button && !button->text().isEmpty() &&
                                           !(tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull());
            QString why;
            if (w->objectName() == QStringLiteral("qt_toolbar_ext_button")) {
                if (parent->parentWidget() == &window) why = QStringLiteral("hides what did not fit");
            } else if (!w->objectName().startsWith(QStringLiteral("qt_")) && !scrolls &&
                       !parent->rect().adjusted(-2, -2, 2, 2).contains(w->geometry())) {
                why = QStringLiteral("reaches out of its place");
            } else if (words && w->width() < w->minimumSizeHint().width()) {
                why = QStringLiteral("is narrower than its words");
            }
            if (why.isEmpty()) continue;
            QString path;
            for (const QWidget* at = w; at && at != &window; at = at->parentWidget())
                path.prepend(QLatin1Char('/') +
                             (at->objectName().isEmpty() ? QLatin1String(at->metaObject()->className()) : at->objectName()));
            const QRect box = w->geometry();
            found += QStringLiteral("%1 %2: %3,%4 %5 x %6")
                         .arg(path, why)
                         .arg(box.x())
                         .arg(box.y())
                         .arg(box.width())
                         .arg(box.height());
        }
        return found;
    }
    QString path() const { return m_folder.filePath(QStringLiteral("mine.sim")); }
    QByteArray text() const {
        m_window->text().flush();
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().path()));
    }
    void openExperiment() {
        QVERIFY(m_window->open(path()));
        EVENTUALLY(m_window->document().isOpen());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
    }

    QTemporaryDir m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(WindowTest)
#include "window_test.moc"
