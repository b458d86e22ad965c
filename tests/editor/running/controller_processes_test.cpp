// The Controllers panel with controllers in processes of their own: restart after a fault, new code in a running experiment.
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include "editor/document/selection.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/robot_states.h"
#include "editor/running/panels/trust.h"
#include "editor/running/session_fixture.h"
#include "editor/widgets/actions.h"
#include "eventually.h"
#include "project/edits/controllers.h"

using namespace trundle;

namespace {

constexpr ActionRow kRows[] = {
    {"controllers.load", "", "Load Module…", "module", "", "Load."},
    {"controllers.assign", "", "Assign…", "", "", "Assign."},
    {"controllers.remove", "", "Remove", "delete", "", "Remove."},
    {"controllers.restart", "", "Restart", "restart", "", "Restart."},
    {"controllers.stop", "", "Stop", "pause", "", "Stop."},
    {"controllers.isolate", "", "Isolate", "", "", "Isolate.", true},
    {"controllers.debug", "", "Debugger", "", "", "Debugger."},
    {"controllers.reload", "", "Reload", "", "", "Reload."},
    {"controllers.follow", "", "Follow", "", "", "Follow.", true},
};

} // namespace

class ControllerProcessesTest : public QObject {
    Q_OBJECT

    QStringList m_console;

    /// Copies a module of the tests into the project, with one word in it replaced by another, as if it was built again.
    static bool build(const SessionFixture& o, const QString& from, const QByteArray& word = {}, const QByteArray& by = {}) {
        QDir(o.folder.path()).mkpath(QStringLiteral("mine"));
        for (const char* ending : {".so", ".so.kinds.json"}) {
            QFile source(QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/") + from + QLatin1String(ending));
            QFile target(o.path("mine/libmind") + QLatin1String(ending));
            target.remove(); // as a linker does
            if (!source.open(QIODevice::ReadOnly) || !target.open(QIODevice::WriteOnly)) return false;
            QByteArray bytes = source.readAll();
            if (!word.isEmpty()) bytes.replace(word + '\0', by + '\0');
            if (target.write(bytes) != bytes.size()) return false;
        }
        TrustedFolders::add(QFileInfo(o.path("mine")).absoluteFilePath());
        return true;
    }
    static QByteArray text(const QByteArray& controller) {
        return "Isolation = module\n#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\n#loadModule mine/mind\n"
               "Static arena { Config=MediumArena }\nRobot leader { Config=SimpleRobot " +
               controller + " }\n";
    }
    void listen(SessionFixture& o) {
        m_console.clear();
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) m_console.append(QString::fromStdString(line.text));
        });
    }
    [[nodiscard]] bool reported(const char* part) const { return !m_console.filter(QLatin1String(part)).isEmpty(); }

private Q_SLOTS:
    void init() {
        QCoreApplication::setOrganizationName(QStringLiteral("trundle-test"));
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
    }
    void cleanup() { QSettings().clear(); }

    /// A robot of a running experiment gets another controller where it is, and loses it.
    void swapsDuringARun() {
        SessionFixture o;
        QVERIFY(o.open("#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\n#loadModule controllers/linear_motion\n"
                       "Static arena { Config=MediumArena }\n"
                       "Robot leader { Config=SimpleRobot  Pos=1,0,0  LinearMotion brain { Speed=0.2 } }\n"
                       "Robot idle { Config=SimpleRobot Pos=0,1,0 }\n"));
        ControllerCommands commands(o.document, o.session);
        o.session.run();
        const auto snapshot = [&] { return o.session.results().snapshot; };
        EVENTUALLY(snapshot() && snapshot()->tick > 20);
        const auto choices = commands.choices();
        const auto random = std::ranges::find(choices, std::string("RandomDrive"), [](const auto& c) { return c.kind.name; });
        QVERIFY(random != choices.end());
        const auto kindOf = [&](std::size_t robot) {
            const auto& controllers = o.session.results().experiment->robots.at(robot).controllers;
            return controllers.empty() ? std::string() : controllers.front().kind;
        };
        const auto costOf = [&](std::size_t robot) -> const ControllerCost* {
            for (const ControllerCost& cost : snapshot()->costs)
                if (cost.robot == robot) return &cost;
            return nullptr;
        };
        QVERIFY(commands.assign({"leader", "idle"}, *random));
        QCOMPARE(kindOf(0), std::string("RandomDrive"));
        QCOMPARE(kindOf(1), std::string("RandomDrive"));
        QVERIFY(!o.session.edits().needsReset());
        const std::uint64_t tick = snapshot()->tick;
        EVENTUALLY(snapshot()->tick > tick + 20 && costOf(1) && costOf(1)->calls > 0);
        QVERIFY(snapshot()->stopped.empty());
        QVERIFY(commands.unassign({"leader", "idle"}));
        EVENTUALLY(snapshot()->costs.empty());
        QCOMPARE(o.session.state(), RunState::Running);
    }

    void theRestartButtonStartsAStoppedController() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("zoo/libzoo")));
        QVERIFY(o.open(text("Zoo brain { Action=segv At=20 }")));
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.resize(900, 300);
        panel.show();
        QVERIFY2(o.session.source().refusal().isEmpty(), qPrintable(o.session.source().refusal()));
        listen(o);
        const auto stopped = [&] {
            const auto& snapshot = o.session.results().snapshot;
            return snapshot && snapshot->stopped.size() == 1 ? snapshot->stopped[0].time : -1;
        };
        o.session.run();
        EVENTUALLY(stopped() > 0);
        const double first = stopped();
        auto* robots = panel.findChild<QTreeWidget*>(QStringLiteral("robotControllers"));
        EVENTUALLY_EQUAL(robots->topLevelItem(0)->text(2), QStringLiteral("stopped by a fault, see Problems"));
        const auto message = m_console.filter(QStringLiteral("crashed in update: Segmentation fault"));
        QVERIFY(!message.isEmpty());
        QVERIFY(m_console.indexOf(message[0]) + 1 < m_console.size());
        QVERIFY(
            m_console[m_console.indexOf(message[0]) + 1].startsWith(QStringLiteral("  "))); // the backtrace follows its message
        selection.select("leader");
        QToolButton* button = nullptr;
        for (QToolButton* each : panel.findChildren<QToolButton*>())
            if (each->defaultAction() == &actions.at("controllers.restart")) button = each;
        QVERIFY(button && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
        EVENTUALLY(stopped() > first); // it has run again, for as many turns, and time went on
        QVERIFY(reported("was started again"));
        o.session.reset();
        QVERIFY(o.session.endRuns());
    }

    void aFaultInTheLastTickIsShown() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("zoo/libzoo")));
        QVERIFY(o.open("Duration = 0.2\nTick = 0.01\n" + text("Zoo brain { Action=segv At=20 }")));
        const ControllerCommands commands(o.document, o.session); // which knows the trusted folders
        listen(o);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY2(reported("crashed in update: Segmentation fault"), qPrintable(m_console.join(u'\n')));
        QCOMPARE(o.session.messages().problems().size(), std::size_t(1));
        QVERIFY(o.session.endRuns());
    }

    /// Their controllers have one block.
    void eachMemberOfAGridHasItsOwnFault() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("zoo/libzoo")));
        QVERIFY(o.open(text("Zoo brain { Action=segv At=$(20 + 10 * index) }")
                           .replace("Isolation = module", "Isolation = robot")
                           .replace("Robot leader { Config=SimpleRobot", "Grid row { Config=SimpleRobot Count=2 Spacing=0.5")));
        const ControllerCommands commands(o.document, o.session);
        std::vector<LiveLine> faults;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& lines) {
            std::ranges::copy_if(lines, std::back_inserter(faults),
                                 [](const LiveLine& line) { return line.text.find("crashed in update") != std::string::npos; });
        });
        o.session.run();
        const auto stopped = [&] {
            const auto& snapshot = o.session.results().snapshot;
            return snapshot ? snapshot->stopped : std::vector<StoppedController>();
        };
        EVENTUALLY_EQUAL(stopped().size(), std::size_t(2));
        EVENTUALLY_EQUAL(faults.size(), std::size_t(2));
        QCOMPARE(faults[0].who + " " + faults[1].who, std::string("row_0 row_1"));
        QCOMPARE(faults[0].time, stopped()[0].time);
        QCOMPARE(faults[1].time, stopped()[1].time);
        QVERIFY(faults[0].time < faults[1].time);
        QVERIFY(o.session.endRuns());
    }

    /// The fault of a controller is at its line of code in Problems, where that is in the project; a note leads to its block.
    void aFaultIsShownInTheSource() {
        SessionFixture o;
        QVERIFY(QDir(o.folder.path()).mkpath(u"mine"_qs));
        OpenOptions options = o.document.options();
        options.trust = true;
        o.document.setOptions(options);
        QFile source(o.path("mine/sick.py"));
        QVERIFY(source.open(QIODevice::WriteOnly));
        QVERIFY(source.write("import trundle\n\n\nclass Sick(trundle.Controller):\n    def update(self, dt):\n        self.act()\n\n"
                             "    def act(self):\n        raise ValueError(\"no\")\n") > 0);
        source.close();
        QByteArray experiment = text("Sick brain { }");
        experiment.replace("mine/mind", "mine/sick.py");
        QVERIFY(o.open(experiment));
        o.session.run();
        const RunMessages& messages = o.session.messages();
        EVENTUALLY(!messages.problems().empty());
        QCOMPARE(messages.problems().size(), std::size_t(1));
        const auto sliceOf = [](const LoadedProject& texts, const SourceRange& range) {
            const auto bytes = texts.sources[range.file].text->bytes();
            return QString::fromStdString(std::string(bytes.substr(range.range.begin, range.range.end - range.range.begin)));
        };
        const ProblemsInCode shown = messages.problemsInCode(o.session.results().built);
        const Diagnostic& fault = shown.problems.at(0);
        QVERIFY2(fault.message.find("ValueError: no, in act at sick.py:9") != std::string::npos, fault.message.c_str());
        QCOMPARE(shown.texts->paths.at(fault.range.file), o.path("mine/sick.py").toStdString());
        QCOMPARE(sliceOf(*shown.texts, fault.range), u"raise ValueError(\"no\")"_qs);
        QCOMPARE(fault.notes.size(), std::size_t(1));
        QCOMPARE(fault.notes[0].second, messages.problems()[0].range);
        QCOMPARE(sliceOf(*shown.texts, fault.notes[0].second), u"brain"_qs);
        o.session.reset();
        QVERIFY(messages.problemsInCode(o.session.results().built).problems.empty());
        QVERIFY(o.session.endRuns());
    }

    /// One member of a Grid fails, another one is stopped by hand: that is no stop by hand alone.
    void aFaultAmongStoppedMembersIsShown() {
        SessionFixture o;
        QVERIFY(QDir(o.folder.path()).mkpath(u"mine"_qs));
        OpenOptions options = o.document.options();
        options.trust = true;
        o.document.setOptions(options);
        QFile source(o.path("mine/pair.py"));
        QVERIFY(source.open(QIODevice::WriteOnly));
        QVERIFY(source.write("import trundle\n\n\nclass Pair(trundle.Controller):\n    def setup(self, robot):\n"
                             "        self.sick = robot.name.endswith(\"1\")\n\n    def update(self, dt):\n"
                             "        if self.sick:\n            raise ValueError(\"no\")\n") > 0);
        source.close();
        QVERIFY(o.open("#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\n#loadModule mine/pair.py\n"
                       "Static arena { Config=MediumArena }\n"
                       "Grid pair { Config=SimpleRobot Count=2,1 Spacing=1 Pair brain { } }\n"));
        const auto stateNow = [&] {
            const auto all = controlledRobots(*o.document.loaded());
            return controllerState(o.session, *std::ranges::find(all, std::string("pair"), &ControlledRobot::path));
        };
        o.session.run();
        EVENTUALLY_EQUAL(stateNow().text, QStringLiteral("1 of 2 stopped by a fault, see Problems"));
        QVERIFY(stateNow().failed && !stateNow().active);
        const std::string other = o.session.results().experiment->robots.front().name;
        QVERIFY(o.session.robots().stopControllers({other}));
        EVENTUALLY_EQUAL(stateNow().text, QStringLiteral("2 of 2 stopped by a fault, see Problems"));
        QVERIFY(stateNow().failed);
        QVERIFY(o.session.endRuns());
    }

    /// Cost, process, stop, restart and isolation of a controller that works.
    void aControllerIsMeasuredStoppedAndIsolated() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("zoo/libzoo")));
        QVERIFY(o.open(text("Zoo brain { At=1000000 }")));
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.resize(900, 300);
        panel.show();
        listen(o);
        selection.select("leader");
        o.session.run();
        auto* robots = panel.findChild<QTreeWidget*>(QStringLiteral("robotControllers"));
        EVENTUALLY(!robots->topLevelItem(0)->text(3).isEmpty() && robots->topLevelItem(0)->text(6) == QLatin1String("0"));
        auto* details = panel.findChild<QPlainTextEdit*>(QStringLiteral("controllerDetails"));
        EVENTUALLY(details->toPlainText().contains(QStringLiteral("calls, mean ")));
        const auto costs = [&] { return o.session.results().snapshot->costs.at(0); };
        QVERIFY(costs().process > 0 && costs().worstS > 0 && costs().totalS >= costs().worstS);
        QGuiApplication::clipboard()->clear();
        actions.at("controllers.debug").trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("gdb -p %1").arg(costs().process));

        actions.at("controllers.stop").trigger();
        EVENTUALLY_EQUAL(robots->topLevelItem(0)->text(2), QStringLiteral("stopped"));
        const std::uint64_t calls = costs().calls;
        const std::uint64_t tick = o.tick();
        EVENTUALLY(o.tick() > tick + 10); // the run continues
        QCOMPARE(costs().calls, calls);
        actions.at("controllers.restart").trigger();
        EVENTUALLY(costs().calls > calls && costs().restarts == 1);
        EVENTUALLY_EQUAL(robots->topLevelItem(0)->text(2), QStringLiteral("runs"));

        const std::string before = *o.document.texts().text(o.document.path());
        actions.at("controllers.isolate").trigger();
        const std::string alone = *o.document.texts().text(o.document.path());
        QVERIFY2(alone.find("Isolation") != std::string::npos && alone.find("robot") != std::string::npos, alone.c_str());
        QVERIFY(actions.at("controllers.isolate").isChecked());
        o.document.edits().undo();
        QCOMPARE(*o.document.texts().text(o.document.path()), before);
        o.session.reset();
        QVERIFY(o.session.endRuns());
    }

    void isolationIsSwitchedOnAndOff_data() {
        QTest::addColumn<QByteArray>("robots");
        QTest::addColumn<QString>("path");
        QTest::newRow("a robot") << QByteArray("Robot one { Config=SimpleRobot LinearMotion brain { } }")
                                 << QStringLiteral("one");
        QTest::newRow("a Grid") << QByteArray("Grid swarm { Config=SimpleRobot Count=2 Spacing=1 LinearMotion brain { } }")
                                << QStringLiteral("swarm");
        QTest::newRow("in a Repeat") << QByteArray("Repeat row { Count=2 Pos=$index,0,0 Robot cart { Config=SimpleRobot "
                                                   "LinearMotion brain { } } }")
                                     << QStringLiteral("row.cart");
    }
    void isolationIsSwitchedOnAndOff() {
        QFETCH(QByteArray, robots);
        QFETCH(QString, path);
        SessionFixture o;
        QVERIFY(o.open("#import robots/simple_robot.sim\n#loadModule controllers/linear_motion\n" + robots + '\n'));
        QVERIFY(!o.document.loaded()->diagnostics.hasErrors());
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        selection.select(path.toStdString());
        QAction& isolate = actions.at("controllers.isolate");
        const auto isAlone = [&] {
            const auto text = QString::fromStdString(*o.document.texts().text(o.document.path()));
            return text.contains(QRegularExpression(QStringLiteral("Isolation *= *robot")));
        };
        for (const bool alone : {true, false, true}) {
            isolate.trigger();
            QCOMPARE(isolate.isChecked(), alone);
            QCOMPARE(isAlone(), alone);
        }
    }

    /// In the program's own process.
    void theSecondControllerOfARobotIsNotResponding() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore")));
        QFile hold(o.path("hold"));
        QVERIFY(hold.open(QIODevice::WriteOnly));
        QVERIFY(o.open(text("LinearMotion drive { } Rebuilt brain { Hold=\"" + hold.fileName().toUtf8() + "\" }")
                           .replace("Isolation = module", "#loadModule controllers/linear_motion")));
        const ControllerCommands commands(o.document, o.session); // which knows the trusted folders
        o.session.run();
        EVENTUALLY_EQUAL(o.session.responses().unresponsiveController(), QStringLiteral("leader's Rebuilt"));
        QVERIFY(hold.remove());
        QVERIFY(o.session.endRuns());
    }

    void rebuiltModulesAreUsedAtOnce() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore")));
        QVERIFY(o.open(text("Rebuilt brain { }")));
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        listen(o);
        o.session.run();
        EVENTUALLY(reported("before life 1") && o.session.state() == RunState::Running);
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore"), "before", "behind"));
        EVENTUALLY(reported("behind life 1"));
        QVERIFY(reported("has the new code of"));
        QVERIFY(o.tick() > 0);
        QCOMPARE(o.session.state(), RunState::Running);

        actions.at("controllers.follow").setChecked(false); // from here on only by the action
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore"), "before", "beyond"));
        actions.at("controllers.reload").trigger();
        EVENTUALLY(reported("beyond life 1"));
        QCOMPARE(o.session.state(), RunState::Running);
        o.session.reset();
        QVERIFY(o.session.endRuns());
    }

    /// A run that goes on past its end takes what was rebuilt since then.
    void whatIsRebuiltAfterTheEndIsUsedOnGoingOn() {
        SessionFixture o;
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore")));
        QVERIFY(o.open("Duration=0.1\n" + text("Rebuilt brain { }")));
        Selection selection;
        Actions actions(kRows);
        ControllersPanel panel(o.document, selection, o.session, actions);
        listen(o);
        o.session.run();
        EVENTUALLY(o.session.state() == RunState::Ended);
        QVERIFY(build(o, QStringLiteral("rebuilt/libbefore"), "before", "behind"));
        o.session.run();
        EVENTUALLY(reported("behind life 1"));
        QVERIFY(o.tick() > 10);
        QCOMPARE(o.session.state(), RunState::Running);
        o.session.reset();
        QVERIFY(o.session.endRuns());
    }

    void numbersOfManyRobotsMeasureTheColumnsOnce() {
        constexpr int kRobots = 30;
        QByteArray many = "#import robots/simple_robot.sim\n#import arenas/medium_arena.sim\n#loadModule controllers/linear_motion\n"
                          "Static arena { Config=MediumArena }\n";
        for (int i = 0; i < kRobots; ++i) {
            const QByteArray n = QByteArray::number(i);
            many += "Robot r" + n + " { Config=SimpleRobot Pos=" + n + ",0,0 LinearMotion brain { UpdatePeriod=0.05 Speed=0.2 } }\n";
        }
        SessionFixture o;
        QVERIFY(o.open(many));
        Actions actions(kRows);
        Selection selection;
        ControllersPanel panel(o.document, selection, o.session, actions);
        panel.show();
        auto* robots = panel.findChild<QTreeWidget*>(QStringLiteral("robotControllers"));
        QCOMPARE(robots->topLevelItemCount(), kRobots);
        QSignalSpy changes(robots->model(), &QAbstractItemModel::dataChanged);
        o.session.run();
        EVENTUALLY(!robots->topLevelItem(kRobots - 1)->text(3).isEmpty()); // the mean time of a call
        QVERIFY(!changes.isEmpty());
        for (const QList<QVariant>& change : changes) { // each one measures the columns
            QCOMPARE(change[0].toModelIndex().row(), 0);
            QCOMPARE(change[1].toModelIndex().row(), kRobots - 1);
        }
    }
};

QTEST_MAIN(ControllerProcessesTest)
#include "controller_processes_test.moc"
