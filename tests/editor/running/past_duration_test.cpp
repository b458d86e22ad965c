// A run that goes on past its Duration, and where its logs are.
#include <QDir>
#include <QStandardPaths>
#include <QtTest>

#include "editor/running/opened_session.h"
#include "eventually.h"

using namespace trundle;

class PastDurationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void goesOnPastItsDuration() {
        OpenedSession o;
        QVERIFY(o.open(kStandingRobot + "Duration = 0.05\nPoseLog path { Robot=robot0 Interval=0.01 }\n"));
        QStringList said;
        connect(&o.session, &RunSession::consoleLines, &o.session, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) said.append(QString::fromStdString(line.text));
        });
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY(o.session.canGoOn());
        QCOMPARE(o.tick(), 5u);
        QCOMPARE(o.session.logsAt(), o.folder.filePath(QStringLiteral("logs/trial")));
        o.session.step();
        EVENTUALLY(o.session.state() == RunState::Paused && o.tick() == 6);
        QVERIFY(!o.session.end() && !o.session.canGoOn());
        QVERIFY2(said.join(u'\n').contains(QStringLiteral("goes on past its end at t = 0.05 s, and so do its logs")),
                 qPrintable(said.join(u'\n')));
        o.session.run();
        EVENTUALLY(o.tick() > 20);
        o.session.pause();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        const auto ticks = int(o.tick());
        QVERIFY(o.session.endRuns()); // the logs are closed
        QFile log(o.session.logsAt() + QStringLiteral("/path.csv"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QVERIFY(log.readAll().count('\n') >= ticks + 2);
        o.session.run(); // from the start again
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QCOMPARE(o.tick(), 5u);
    }

    void logsOfWhatIsNotSavedGoIntoTheUsersFolder() {
        QStandardPaths::setTestModeEnabled(true);
        const auto normal = qScopeGuard([] { QStandardPaths::setTestModeEnabled(false); });
        OpenedSession o;
        QVERIFY(o.document
                    .openNew("untitled.sim", (kStandingRobot + "Duration = 0.05\nPoseLog path { Robot=robot0 Interval=0.01 }\n")
                                                 .toStdString())
                    .ok());
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        const QString folder = o.session.logsAt();
        QVERIFY2(folder.startsWith(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)), qPrintable(folder));
        QVERIFY(QFile::exists(folder + QStringLiteral("/path.csv")));
        QVERIFY(o.session.endRuns());
        QVERIFY(QDir(folder).removeRecursively());
    }
};

QTEST_MAIN(PastDurationTest)
#include "past_duration_test.moc"
