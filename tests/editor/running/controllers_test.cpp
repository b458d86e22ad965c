// The Controllers panel: assigning controllers, loading and rebuilding modules, trust.
#include <QAction>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/trust.h"
#include "editor/running/session_fixture.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"
#include "project/edits/module_lines.h"

using namespace trundle;

namespace {

constexpr ActionRow kRows[] = {
    {"controllers.load", "", "Load Module…", "module", "", "Load."},
    {"controllers.assign", "", "Assign…", "", "", "Assign."},
    {"controllers.remove", "", "Remove", "", "", "Remove."},
    {"controllers.restart", "", "Restart", "reset", "", "Restart."},
    {"controllers.stop", "", "Stop", "pause", "", "Stop."}, {"controllers.isolate", "", "Isolate", "", "", "Isolate.", true}, {"controllers.debug", "", "Debugger", "", "", "Debugger."},
    {"controllers.reload", "", "Reload", "", "", "Reload."},
    {"controllers.follow", "", "Follow", "", "", "Follow.", true},
};

/// Three robots: one with a controller, one without, and a Grid.
const QByteArray kTeam = R"(// a team
#import robots/simple_robot.sim
#import arenas/medium_arena.sim
#loadModule controllers/linear_motion
Static arena { Config=MediumArena Pos=0,0,0 }
Robot leader {
  Config=SimpleRobot  Pos=1,0,0
  LinearMotion brain { UpdatePeriod=0.05 Speed=0.2 }
}
Robot idle { Config=SimpleRobot Pos=0,1,0 }
Grid swarm { Config=SimpleRobot Pos=-1,0,0 Count=2 Spacing=0.6 }
)";

} // namespace

class ControllersTest : public QObject {
    Q_OBJECT

    static ControllerChoice choice(const ControllerCommands& commands, const char* name) {
        for (const ControllerChoice& c : commands.choices())
            if (c.kind.name == name) return c;
        return {};
    }
    static std::string textOf(const SessionFixture& o) { return *o.document.texts().text(o.document.path()); }
    /// Copies a module of the program to a folder that is not trusted.
    static QString copiedModule(const SessionFixture& o, const char* name, const char* as) {
        return copied(o, QStringLiteral("lib/trundle/controllers/lib") + QLatin1String(name), as);
    }
    /// Copies the test's module, built before or after a change, over the one in the project.
    static QString builtModule(const SessionFixture& o, const char* version) {
        return copied(o, QStringLiteral("tests/modules/rebuilt/lib") + QLatin1String(version), "mind");
    }
    static QString copied(const SessionFixture& o, const QString& from, const char* as) {
        QDir(o.folder.path()).mkpath(QStringLiteral("mine"));
        const QString to = o.path("mine/lib") + QLatin1String(as) + QStringLiteral(".so");
        for (const char* ending : {".so", ".so.kinds.json"}) {
            QFile source(QStringLiteral(TRUNDLE_BINARY_DIR "/") + from + QLatin1String(ending));
            QFile target(to.chopped(3) + QLatin1String(ending)); // overwrites the same file, as cp does
            if (!source.open(QIODevice::ReadOnly) || !target.open(QIODevice::WriteOnly)) return {};
            target.write(source.readAll());
        }
        return to;
    }
    static QByteArray minded(const QByteArray& values) {
        return QByteArray(kTeam)
            .replace("controllers/linear_motion", "mine/mind")
            .replace("LinearMotion brain { UpdatePeriod=0.05 Speed=0.2 }", "Rebuilt brain { " + values + " }");
    }

private Q_SLOTS:
    void init() {
        QCoreApplication::setOrganizationName(QStringLiteral("trundle-test"));
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
    }
    void cleanup() { QSettings().clear(); }

    void listsModulesAndRobots() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        ControllerCommands commands(o.document, o.session);
        const auto modules = commands.modules();
        QCOMPARE(modules.size(), 1u);
        QCOMPARE(modules[0].written, std::string("controllers/linear_motion"));
        QCOMPARE(modules[0].kinds, std::vector<std::string>{"LinearMotion"});
        QVERIFY(!modules[0].version.isEmpty());
        QVERIFY(modules[0].trouble.isEmpty());
        QCOMPARE(modules[0].usedBy, std::string("leader"));
        const auto robots = controlledRobots(*o.document.loaded());
        QCOMPARE(robots.size(), 3u);
        QCOMPARE(robots[0].kind, std::string("LinearMotion"));
        QVERIFY(robots[1].kind.empty());
        QCOMPARE(robots[2].members, 2u);
        QCOMPARE(robotsAmong(*o.document.loaded(), {"leader.chassis", "swarm_1", "arena", "leader", "Material.red"}),
                 (std::vector<std::string>{"leader", "swarm"}));
    }

    /// No text of a column but the last is cut or touches the next one, whatever the font.
    void columnsFollowTheFont() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kTeam).replace("#loadModule", "#loadModule controllers/random_drive\n#loadModule")));
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.resize(900, 300);
        panel.show();
        for (const int font : {13, 17}) {
            applyTheme(*qApp, ThemeKind::Light, {font, font});
            QCoreApplication::processEvents();
            for (const char* name : {"moduleList", "robotControllers"}) {
                auto* list = panel.findChild<QTreeWidget*>(QLatin1String(name));
                QVERIFY(list && list->topLevelItemCount() >= 2);
                const QFontMetrics metrics = list->fontMetrics();
                for (int column = 0; column + 1 < list->columnCount(); ++column) {
                    int longest = metrics.horizontalAdvance(list->headerItem()->text(column));
                    for (int row = 0; row < list->topLevelItemCount(); ++row)
                        longest = std::max(longest, metrics.horizontalAdvance(list->topLevelItem(row)->text(column)));
                    QVERIFY2(list->columnWidth(column) >= longest + 8,
                             qPrintable(QStringLiteral("%1 %2 at %3").arg(QLatin1String(name)).arg(column).arg(font)));
                }
            }
        }
        applyTheme(*qApp, ThemeKind::Light);
    }

    void assignsToOneAndReplaces() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        ControllerCommands commands(o.document, o.session);
        QVERIFY(commands.assign({"leader", "idle", "swarm"}, choice(commands, "RandomDrive")));
        const std::string text = textOf(o);
        QVERIFY2(text.find("#loadModule controllers/random_drive") != std::string::npos, text.c_str());
        QVERIFY2(text.find("RandomDrive brain { UpdatePeriod=0.05 Speed=0.2 }") != std::string::npos,
                 text.c_str()); // the properties that both controllers have
        QVERIFY2(text.starts_with("// a team\n"), text.c_str());
        QVERIFY(!o.document.loaded()->diagnostics.hasErrors());
        for (const RobotSpec& robot : o.document.loaded()->experiment->robots) {
            QVERIFY2(robot.controllers.size() == 1, robot.name.c_str());
            QCOMPARE(robot.controllers[0].kind, std::string("RandomDrive"));
        }
        QCOMPARE(o.document.edits().history().entries().size(), 1u);
        o.document.edits().undo();
        QCOMPARE(textOf(o), kTeam.toStdString());

        QVERIFY(commands.assign({"leader"}, choice(commands, "BumpAndTurn")));
        QSignalSpy refused(&o.document, &Document::refused);
        QVERIFY(!commands.assign({"leader"}, choice(commands, "BumpAndTurn"))); // it has it already
        QCOMPARE(refused.size(), 1);
    }

    void removesAndUnloads() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        ControllerCommands commands(o.document, o.session);
        QVERIFY(!commands.unload(commands.modules()[0])); // leader needs it
        QVERIFY(commands.unassign({"leader", "idle"}));
        QVERIFY(textOf(o).find("LinearMotion") == std::string::npos && !commands.unassign({"leader"}));
        QVERIFY(commands.unload(commands.modules()[0]));
        QVERIFY(textOf(o).find("#loadModule") == std::string::npos);
        QVERIFY(commands.modules().empty());
        o.document.edits().undo();
        o.document.edits().undo();
        QCOMPARE(textOf(o), kTeam.toStdString());
    }

    void asksBeforeTrustingModule() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        const QString library = copiedModule(o, "random_drive", "wander");
        QVERIFY(!library.isEmpty());
        ControllerCommands commands(o.document, o.session);
        QStringList asked;
        bool answer = false;
        commands.setAsk([&](const QString&, const QString& folder) {
            asked.append(folder);
            return answer;
        });
        QVERIFY(!commands.load(library));
        QCOMPARE(asked, QStringList{QFileInfo(library).absolutePath()});
        QVERIFY(!o.document.texts().isModified());
        QVERIFY(ControllerCommands::recent().isEmpty());
        answer = true;
        QVERIFY(commands.load(library));
        QVERIFY2(textOf(o).find("#loadModule mine/wander") != std::string::npos, textOf(o).c_str());
        QVERIFY(TrustedFolders::covers(QFileInfo(library).absolutePath()));
        QCOMPARE(commands.modules().size(), 2u);
        QVERIFY2(commands.modules()[1].trusted, qPrintable(commands.modules()[1].trouble));
        QCOMPARE(ControllerCommands::recent(), QStringList{library});
        QVERIFY(!commands.load(library)); // it is loaded already
        QCOMPARE(asked.size(), 2);
        QVERIFY(commands.assign({"idle"}, choice(commands, "RandomDrive")));
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
    }

    void aModuleOfAnotherFolderOfTheProjectIsWrittenRelative() {
        SessionFixture o;
        QVERIFY(QDir(o.folder.path()).mkpath(QStringLiteral(".trundle")) &&
                QDir(o.folder.path()).mkpath(QStringLiteral("trials/one")));
        QVERIFY(o.open(kTeam, "trials/one/trial.sim"));
        const QString library = copiedModule(o, "random_drive", "wander");
        ControllerCommands commands(o.document, o.session);
        commands.setAsk([](const QString&, const QString&) { return true; });
        QVERIFY(commands.load(library));
        QVERIFY2(textOf(o).find("#loadModule ../../mine/wander\n") != std::string::npos, textOf(o).c_str());
        QVERIFY(textOf(o).find(o.folder.path().toStdString()) == std::string::npos);
        QCOMPARE(commands.modules()[1].library, QFileInfo(library).canonicalFilePath().toStdString());
        QVERIFY2(commands.modules()[1].trusted, qPrintable(commands.modules()[1].trouble));
        QVERIFY(commands.assign({"idle"}, choice(commands, "RandomDrive")));
        QVERIFY(!o.document.loaded()->diagnostics.hasErrors());
    }

    void aModuleBelowAFolderOfTheCommandLineIsWrittenFromThere() {
        SessionFixture o;
        QTemporaryDir libraries;
        QVERIFY(o.open(kTeam));
        const std::string library = libraries.filePath(QStringLiteral("drives/libwander.so")).toStdString();
        const std::string& shipped = o.session.source().application().locations().modules;
        QCOMPARE(writtenFor(library, *o.document.loaded(), shipped, {libraries.path().toStdString()}),
                 std::string("drives/wander"));
        QCOMPARE(writtenFor(library, *o.document.loaded(), shipped),
                 libraries.filePath(QStringLiteral("drives/wander")).toStdString());
        // The project was opened through a link to the folder.
        QVERIFY(QFile::link(o.folder.path(), libraries.filePath(QStringLiteral("link"))));
        QCOMPARE(
            writtenFor(libraries.filePath(QStringLiteral("link/mine/libwander.so")).toStdString(), *o.document.loaded(), shipped),
            std::string("mine/wander"));
    }

    void anOpenedExperimentWithAnUntrustedModuleDoesNotRunUntilItIsTrusted() {
        SessionFixture o;
        const QString library = copiedModule(o, "random_drive", "wander");
        QVERIFY(o.open(QByteArray(kTeam)
                           .replace("controllers/linear_motion", "mine/wander")
                           .replace("LinearMotion brain { UpdatePeriod=0.05 Speed=0.2 }", "RandomDrive brain { Speed=0.2 }")));
        Actions actions(kRows);
        Selection selection;
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.show();
        QVERIFY(panel.findChild<QLabel*>(QStringLiteral("controllersNotice"))->isVisible());
        QVERIFY(o.session.source().refusal().contains(QStringLiteral("trust")));
        QVERIFY(!o.session.source().refusal().contains(QStringLiteral("--trust"))); // the hint of the command line
        const auto modules = panel.commands().modules();
        QCOMPARE(modules.size(), 1u);
        QVERIFY(!modules[0].trusted);
        QCOMPARE(modules[0].library, library.toStdString());
        panel.commands().setAsk([](const QString&, const QString&) { return true; });
        QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("moduleTrust")), Qt::LeftButton);
        QVERIFY(!panel.findChild<QLabel*>(QStringLiteral("controllersNotice"))->isVisible());
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        QVERIFY(!o.document.texts().isModified());
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY(o.session.results().time() > 0.1);
        // Removed trust takes effect at the next load.
        TrustedFolders::remove(QFileInfo(library).absolutePath());
        panel.commands().applyTrust();
        QVERIFY(!o.session.source().refusal().isEmpty());
    }

    void filesThatAreNoModulesAreRefused_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("text") << QByteArray("#!/bin/sh\necho hello\n");
        QTest::newRow("cut off") << QByteArray("\177ELF\2\1\1", 7);
    }
    void filesThatAreNoModulesAreRefused() {
        QFETCH(QByteArray, bytes);
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        QFile file(o.path("libbad.so"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        ControllerCommands commands(o.document, o.session);
        commands.setAsk([](const QString&, const QString&) { return true; });
        QSignalSpy refused(&commands, &ControllerCommands::refused);
        QVERIFY(!commands.load(file.fileName()));
        QCOMPARE(refused.size(), 1);
        QVERIFY(!commands.load(o.path("nowhere.so")));
        QVERIFY(!TrustedFolders::covers(o.folder.path())); // the user was not asked for it
        QVERIFY(!o.document.texts().isModified());
    }

    void reloadUsesCurrentLibrary() {
        SessionFixture o;
        const QString library = copiedModule(o, "random_drive", "mind");
        TrustedFolders::add(QFileInfo(library).absolutePath());
        QVERIFY(o.open(QByteArray(kTeam)
                           .replace("controllers/linear_motion", "mine/mind")
                           .replace("LinearMotion brain { UpdatePeriod=0.05 Speed=0.2 }", "RandomDrive brain { }")));
        ControllerCommands commands(o.document, o.session);
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY(o.session.results().time() > 0.1);
        QVERIFY(!copiedModule(o, "bump_and_turn", "mind").isEmpty()); // rebuilt, with another controller
        commands.reload();
        QCOMPARE(o.session.state(), RunState::Start);
        QVERIFY(!o.session.source().refusal().isEmpty()); // RandomDrive is no longer in the module
        QCOMPARE(commands.modules()[0].kinds, std::vector<std::string>{"BumpAndTurn"});
        const std::string text = textOf(o);
        QVERIFY(o.document.edits()
                    .replaceText(QStringLiteral("Follow"), o.document.path(),
                                 QByteArray::fromStdString(text).replace("RandomDrive", "BumpAndTurn").toStdString())
                    .ok());
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        o.session.run();
        EVENTUALLY(o.session.results().time() > 0.1);
        QVERIFY(!o.session.results().end);
    }

    void runUsesRebuiltModuleWithoutReload() {
        SessionFixture o;
        TrustedFolders::add(QFileInfo(builtModule(o, "before")).absolutePath());
        QVERIFY(o.open(minded("Pace=1")));
        ControllerCommands commands(o.document, o.session);
        QStringList reportOf;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) reportOf.append(QString::fromStdString(line.text));
        });
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY(o.session.results().time() > 0.1);
        QVERIFY(!builtModule(o, "after").isEmpty()); // while the old one runs
        const double then = o.session.results().time();
        EVENTUALLY(o.session.results().time() > then + 1);
        o.session.reset();
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        o.session.run(); // 1 is not a valid pace any more
        QCOMPARE(refused.size(), 1);
        QVERIFY2(refused[0][0].toString().contains(QStringLiteral("Pace")), qPrintable(refused[0][0].toString()));
        QCOMPARE(o.session.state(), RunState::Start);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Pace"), {{"leader.brain.Pace", "0.25"}}).ok());
        o.session.run();
        EVENTUALLY(reportOf.contains(QStringLiteral("after life 1 pace 0.25")));
        QVERIFY(reportOf.contains(QStringLiteral("before life 1 pace 1")));
    }

    /// The old module's thread and code stay in memory, under the same name.
    void rebuiltModuleRunsBesideUnresponsiveOne() {
        SessionFixture o;
        TrustedFolders::add(QFileInfo(builtModule(o, "before")).absolutePath());
        QFile hold(o.path("hold"));
        QVERIFY(hold.open(QIODevice::WriteOnly));
        QVERIFY(o.open(minded("Hold=\"" + hold.fileName().toUtf8() + "\"")));
        ControllerCommands commands(o.document, o.session);
        o.session.run();
        EVENTUALLY(!o.session.responses().unresponsiveController().isEmpty());
        o.session.reset();
        QVERIFY(!builtModule(o, "after").isEmpty());
        QVERIFY(o.document.edits().replaceText(QStringLiteral("Hold"), o.document.path(), minded("").toStdString()).ok());
        QStringList reportOf;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) reportOf.append(QString::fromStdString(line.text));
        });
        o.session.run();
        EVENTUALLY(reportOf.contains(QStringLiteral("after life 1 pace 0.2")));
        QVERIFY(hold.remove());
        QVERIFY(o.session.endRuns());
    }

    void loadingModuleKeepsSelection() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        const QString library = copiedModule(o, "random_drive", "wander");
        ControllerCommands commands(o.document, o.session);
        commands.setAsk([](const QString&, const QString&) { return true; });
        Selection selection;
        connect(&o.document, &Document::selectionRequested, &selection, [&](const auto& paths) { selection.set(paths); });
        selection.select("idle");
        QVERIFY(commands.load(library));
        QCOMPARE(selection.current(), std::string("idle"));
        QVERIFY(commands.unload(commands.modules()[1]));
        QCOMPARE(selection.current(), std::string("idle"));
        selection.select("leader");
        QVERIFY(commands.unassign({"leader"}));
        QCOMPARE(selection.current(), std::string("leader"));
    }

    void thePanelFollowsSelectionAndRun() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        Actions actions(kRows);
        Selection selection;
        ControllersPanel panel(o.document, selection, o.session, actions);
        auto* robots = panel.findChild<QTreeWidget*>(QStringLiteral("robotControllers"));
        QCOMPARE(robots->topLevelItemCount(), 0); // no rows without a robot
        panel.show();
        QCOMPARE(robots->topLevelItemCount(), 3);
        for (int column : {0, 1}) // "swarm (9 robots)" is not clipped
            EVENTUALLY(robots->columnWidth(column) >=
                       robots->fontMetrics().horizontalAdvance(robots->topLevelItem(2)->text(column)));
        QVERIFY(!actions.at("controllers.assign").isEnabled());
        selection.select("idle.chassis");
        QVERIFY(robots->topLevelItem(1)->isSelected());
        QVERIFY(actions.at("controllers.assign").isEnabled());
        QVERIFY(!actions.at("controllers.remove").isEnabled()); // there is nothing to remove
        robots->clearSelection();
        robots->topLevelItem(0)->setSelected(true);
        QCOMPARE(selection.current(), std::string("leader"));
        QVERIFY(actions.at("controllers.remove").isEnabled());
        QCOMPARE(robots->topLevelItem(0)->text(2), QStringLiteral("waits for a run"));
        o.session.run();
        EVENTUALLY_EQUAL(robots->topLevelItem(0)->text(2), QStringLiteral("runs"));
        o.session.pause();
        EVENTUALLY_EQUAL(robots->topLevelItem(0)->text(2), QStringLiteral("paused"));
        actions.at("controllers.remove").trigger();
        QCOMPARE(robots->topLevelItem(0)->text(1), QStringLiteral("–"));
        QVERIFY(!o.session.edits().waitsForReset("leader.brain")); // it leaves at once
        QCOMPARE(robots->topLevelItem(0)->text(2), QStringLiteral("no controller"));
    }

    void createsOnlyVisibleRows() {
        SessionFixture o;
        QVERIFY(o.open(kTeam));
        Actions actions(kRows);
        Selection selection;
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.show();
        auto* robots = panel.findChild<QTreeWidget*>(QStringLiteral("robotControllers"));
        panel.hide();
        QSignalSpy made(robots->model(), &QAbstractItemModel::rowsInserted);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Move"), {{"idle.Pos", "3,0,0"}}).ok());
        selection.select("leader");
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Running);
        QCOMPARE(made.size(), 0);
        QVERIFY(actions.at("controllers.remove").isEnabled()); // enabled without opening the menu
        panel.show();
        QCOMPARE(robots->topLevelItemCount(), 3);
        QCOMPARE(robots->topLevelItem(0)->text(2), QStringLiteral("runs"));
        QVERIFY(robots->topLevelItem(0)->isSelected());
    }
};

QTEST_MAIN(ControllersTest)
#include "controllers_test.moc"
