// A run continues past its Duration; and the folders of its logs.
#include <QDir>
#include <QStandardPaths>
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/running/panels/robot_states.h"
#include "editor/running/panels/run_status.h"
#include "editor/running/session_fixture.h"
#include "eventually.h"
#include "project/edits/controllers.h"

using namespace trundle;

class PastDurationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void resumesPastDuration() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot + "Duration = 0.05\nPoseLog path { Robot=robot0 Interval=0.01 }\n"));
        QStringList reportOf;
        connect(&o.session.messages(), &RunMessages::consoleLines, &o.session, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) reportOf.append(QString::fromStdString(line.text));
        });
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY(o.session.results().canResume());
        QCOMPARE(o.tick(), 5u);
        QCOMPARE(o.session.logs().folder(), o.folder.filePath(QStringLiteral("logs/trial")));
        o.session.step();
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 6);
        QVERIFY(!o.session.results().end && !o.session.results().canResume());
        QVERIFY2(reportOf.join(u'\n').contains(QStringLiteral("continues past its end at t = 0.05 s, and so do its logs")),
                 qPrintable(reportOf.join(u'\n')));
        o.session.run();
        EVENTUALLY(o.tick() > 20);
        o.session.pause();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        const auto ticks = int(o.tick());
        QVERIFY(o.session.endRuns()); // closes the logs
        QFile log(o.session.logs().folder() + QStringLiteral("/path.csv"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QVERIFY(log.readAll().count('\n') >= ticks + 2);
        o.session.run(); // a new run from the start
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QCOMPARE(o.tick(), 5u);
    }

    void withEditsThatWaitItBeginsAgain() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot + "Duration = 0.05\n"));
        QStringList notices;
        connect(&o.document, &Document::notice, &o.session, [&](const QString& text) { notices.append(text); });
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Set"), {{"Duration", "0.08"}}).ok());
        QVERIFY(o.session.results().canResume() && o.session.edits().needsReset());
        o.session.step(); // continues with the old world, and reports it
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 6);
        QCOMPARE(notices.size(), 1);
        QVERIFY2(notices[0].contains(QStringLiteral("without the edits of Duration")), qPrintable(notices[0]));
        QVERIFY(o.session.edits().needsReset());
        o.session.reset();
        QVERIFY(!o.session.edits().needsReset());
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QCOMPARE(o.tick(), 8u);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Set"), {{"Duration", "0.03"}}).ok());
        o.session.run(); // At its Duration: restarts, with the edits.
        QVERIFY(!o.session.edits().needsReset());
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QCOMPARE(o.tick(), 3u);
        QCOMPARE(notices.size(), 2);
        QVERIFY2(notices[1].contains(QStringLiteral("with the edits of Duration")), qPrintable(notices[1]));
        o.session.run(); // continues if there are no edits
        EVENTUALLY(o.tick() > 5);
    }

    /// As a run that is resumed without an end.
    void runForReportsEditsThatWait() {
        SessionFixture o;
        QVERIFY(o.open(kStandingRobot));
        QStringList notices;
        connect(&o.document, &Document::notice, &o.session, [&](const QString& text) { notices.append(text); });
        o.session.runFor(0.05);
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 5);
        o.session.runFor(0.05);
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 10);
        QVERIFY(notices.empty());
        QVERIFY(o.document.structure().setValues(QStringLiteral("Set"), {{"robot0.Pos", "1,0,0"}}).ok());
        QVERIFY(o.session.edits().needsReset());
        o.session.runFor(0.05);
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 15);
        QCOMPARE(notices.size(), 1);
        QVERIFY2(notices[0].contains(QStringLiteral("without the edits of robot0.Pos")), qPrintable(notices[0]));
    }

    void twoExperimentsThatAreInNoFileHaveTwoLogFolders() {
        QStandardPaths::setTestModeEnabled(true);
        const auto normal = qScopeGuard([] { QStandardPaths::setTestModeEnabled(false); });
        const std::string text =
            (kStandingRobot + "Duration = 0.05\nPoseLog path { Robot=robot0 Interval=0.01 }\n").toStdString();
        SessionFixture one, other;
        QStringList folders;
        for (SessionFixture* o : {&one, &other, &one}) {
            if (o->document.path().empty() || !o->document.isNew())
                QVERIFY(o->document.opening().openNew("untitled.sim", text).ok());
            if (o->session.state() != RunState::Start) o->session.reset();
            o->session.run();
            EVENTUALLY_EQUAL(o->session.state(), RunState::Ended);
            folders += o->session.logs().folder();
            QVERIFY(QFile::exists(folders.back() + QStringLiteral("/path.csv")));
        }
        QVERIFY2(folders[0] != folders[1], qPrintable(folders[0]));
        QCOMPARE(folders[2], folders[0]);                                   // the same experiment has the same log folder again
        QVERIFY(one.document.opening().openNew("untitled.sim", text).ok()); // another experiment
        one.session.run();
        EVENTUALLY_EQUAL(one.session.state(), RunState::Ended);
        QVERIFY(!folders.contains(one.session.logs().folder()));
        folders += one.session.logs().folder();
        for (SessionFixture* o : {&one, &other}) QVERIFY(o->session.endRuns());
        for (const QString& folder : folders) QDir(folder).removeRecursively();
    }

    /// A robot that falls for 20 s is faster than anything may be.
    void aRobotThatEndedIsShown() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("Tick = 0.01", "Tick = 0.02\n#loadModule controllers/linear_motion") +
                       "Robot flyer { Config=SimpleRobot Pos=3,0,30000 LinearMotion brain { Speed=0.2 } }\n"));
        o.session.setSpeed(0);
        QStringList lines;
        LiveLine ended;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& more) {
            for (const LiveLine& line : more) {
                lines << QString::fromStdString(line.text);
                if (lines.back().contains(QStringLiteral("flyer has ended"))) ended = line;
            }
        });
        const RunStatus status(o.session);
        const auto robots = controlledRobots(*o.document.loaded());
        const auto flyer = std::ranges::find(robots, std::string("flyer"), &ControlledRobot::path);
        QVERIFY(flyer != robots.end());
        o.session.runFor(19);
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        QVERIFY(controllerState(o.session, *flyer).active || controllerState(o.session, *flyer).text == u"paused"_qs);
        o.session.runFor(2);
        EVENTUALLY(o.session.state() == RunState::Paused && o.session.results().time() > 20.5);
        QVERIFY(controllerState(o.session, *flyer).failed);
        QVERIFY2(controllerState(o.session, *flyer).detail.contains(QStringLiteral("stopped: ")),
                 qPrintable(controllerState(o.session, *flyer).detail));
        EVENTUALLY_EQUAL(status.text().section(QStringLiteral("  •"), 0, 0), QStringLiteral("1 of 2 robots"));
        QCOMPARE(status.tip(), QStringLiteral("Ended by a fault: flyer"));
        QVERIFY(o.session.robots().driveRefusal("flyer").contains(QStringLiteral("has ended by a fault")));
        QVERIFY(o.session.robots().driveRefusal("robot0").isEmpty());
        QCOMPARE(lines.filter(QStringLiteral("flyer has ended, all others continue")).size(), 1);
        QCOMPARE(ended.who, std::string("flyer"));
        QVERIFY2(ended.time > 19.5 && ended.time < 20.8, qPrintable(QString::number(ended.time)));
        QCOMPARE(o.session.messages().problems().size(), std::size_t(1));
    }

    void logsOfWhatIsNotSavedGoIntoTheUsersFolder() {
        QStandardPaths::setTestModeEnabled(true);
        const auto normal = qScopeGuard([] { QStandardPaths::setTestModeEnabled(false); });
        SessionFixture o;
        QVERIFY(o.document.opening()
                    .openNew("untitled.sim",
                             (kStandingRobot + "Duration = 0.05\nPoseLog path { Robot=robot0 Interval=0.01 }\n").toStdString())
                    .ok());
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        const QString folder = o.session.logs().folder();
        QVERIFY2(folder.startsWith(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)), qPrintable(folder));
        QVERIFY(QFile::exists(folder + QStringLiteral("/path.csv")));
        QVERIFY(o.session.endRuns());
        QVERIFY(QDir(folder).removeRecursively());
    }
};

QTEST_MAIN(PastDurationTest)
#include "past_duration_test.moc"
