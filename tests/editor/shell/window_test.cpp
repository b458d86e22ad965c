// The whole window, with its real parts: open, move, undo, type, run, reset, save.

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/shell/main_window.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/viewport_panel.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"

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
    void initTestCase() {
        applyTheme(*qApp, ThemeKind::Light);
        m_parts = makeParts();
        auto render = RenderService::start();
        QVERIFY2(render.ok(), render.ok() ? "" : render.error().message.c_str());
        m_render = std::move(render).value();
    }
    void init() {
        QSettings().clear();
        QVERIFY(m_folder.isValid());
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(kExperiment);
        file.close();
        m_window = std::make_unique<MainWindow>(*m_parts, m_render.get(), findLocations());
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }

    void aNewWindowShowsTheWelcomePage() {
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("sample.linear_motion"))->isVisible());
    }

    void onTheWelcomePageEveryCommandDoesNoHarm() {
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

    void theGuideIsReadOnTheWelcomePageAndGoesAlong() {
        auto* guide = m_window->findChild<QDockWidget*>(QStringLiteral("dock.guide"));
        m_window->actions().at("help.guide").trigger();
        QVERIFY(guide->isVisible());
        QVERIFY(!m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
        openMine();
        QTRY_VERIFY(guide->isVisible());
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
        m_window->actions().at("file.openSample").trigger();
        QVERIFY(!m_window->document().isOpen());
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
    }

    void aMessageInTheStatusBarStandsAlone() {
        openMine();
        Q_EMIT m_window->document().refused(QStringLiteral("no"));
        const auto* file = m_window->findChild<QLabel*>(QStringLiteral("status.file"));
        QVERIFY(!file->isVisible());
        QVERIFY(m_window->document().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(!file->isVisible());
        m_window->statusBar()->clearMessage();
        QVERIFY(file->isVisible());
    }

    void theWindowComesBackAsLargeAsItWas() {
        m_window->resize(1111, 777);
        QVERIFY(m_window->close());
        m_window = std::make_unique<MainWindow>(*m_parts, m_render.get(), findLocations());
        QCOMPARE(m_window->size(), QSize(1111, 777));
    }

    void aSmallScreenHoldsTheWindow() {
        openMine();
        QVERIFY2(
            m_window->minimumSizeHint().width() <= 1024 && m_window->minimumSizeHint().height() <= 700,
            qPrintable(
                QStringLiteral("%1 x %2").arg(m_window->minimumSizeHint().width()).arg(m_window->minimumSizeHint().height())));
    }

    void aSampleOpensWithAClick() {
        QTest::mouseClick(m_window->findChild<QWidget*>(QStringLiteral("sample.linear_motion")), Qt::LeftButton);
        QTRY_VERIFY(m_window->document().isOpen());
        QTRY_VERIFY(m_window->isSettled());
        QVERIFY(!m_window->findChild<QWidget*>(QStringLiteral("welcome"))->isVisible());
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("dock.scene"))->isVisible());
    }

    void aNewExperimentRunsBeforeItIsSaved() {
        m_window->actions().at("file.newExperiment").trigger();
        QTRY_VERIFY(m_window->document().isOpen());
        QVERIFY(m_window->document().isNew());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
        m_window->session().runFor(0.1);
        QTRY_VERIFY(m_window->session().time() > 0.0999);
        m_window->actions().at("sim.reset").trigger();
        QCOMPARE(m_window->session().state(), RunState::Start);
    }

    void movedUndoneRedone() {
        openMine();
        QVERIFY(m_window->document().setValues(QStringLiteral("Move robot0"), {{"robot0.Pos", "-1.5,0,0"}}).ok());
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

    void aRunLeavesTheTextsAlone() {
        openMine();
        m_window->actions().at("sim.run").trigger();
        QTRY_VERIFY(m_window->session().time() > 0.05);
        m_window->actions().at("sim.pause").trigger();
        QTRY_COMPARE(m_window->session().state(), RunState::Paused);
        QCOMPARE(text(), kExperiment);
        QVERIFY(!m_window->document().history().canUndo());
        m_window->actions().at("sim.reset").trigger();
        QTRY_COMPARE(m_window->session().state(), RunState::Start);
    }

    void aTextWithErrorsOpensAndIsNotRun() {
        openMine();
        QVERIFY(m_window->document()
                    .replaceText(QStringLiteral("Typing"), path().toStdString(),
                                 QByteArray(kExperiment).replace("Config=SimpleRobot", "Config=SimpelRobot").toStdString())
                    .ok());
        QVERIFY(m_window->document().loaded()->diagnostics.hasErrors());
        m_window->actions().at("sim.run").trigger();
        QCOMPARE(m_window->session().state(), RunState::Start);
        QVERIFY(m_window->document().lastGood() != nullptr);
        m_window->actions().at("edit.undo").trigger();
        QCOMPARE(text(), kExperiment);
        m_window->actions().at("sim.step").trigger();
        QTRY_VERIFY(m_window->session().time() > 0);
    }

    void bothThemesAndBothLayouts() {
        openMine();
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
    QString path() const { return m_folder.filePath(QStringLiteral("mine.sim")); }
    QByteArray text() const {
        m_window->text().flush();
        return QByteArray::fromStdString(*m_window->document().text(m_window->document().path()));
    }
    void openMine() {
        QVERIFY(m_window->open(path()));
        QTRY_VERIFY(m_window->document().isOpen());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Parts> m_parts;
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(WindowTest)
#include "window_test.moc"
