// The Console panel: messages of controllers, filters, copying, scrolling and the limit of stored lines.
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QtTest>

#include <trundle/abi.h>

#include "editor/running/panels/console_model.h"
#include "editor/running/panels/console_panel.h"
#include "editor/running/panels/run_status.h"
#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

/// A controller that publishes, and ends the run with a message that looks like markup.
const QByteArray kCountingRobot = "Tick = 0.01\n#import robots/simple_robot.sim\n#loadModule publishing/publishing\n"
                                  "Robot robot0 { Config=SimpleRobot Counter brain { End=3 Reason=\"<b>there\\nnow\" } }\n"
                                  "SignalLog counts { Signals=\"robot0/brain/*\" File=counts.csv }\n";

} // namespace

class ConsoleTest : public QObject {
    Q_OBJECT

    static std::vector<LiveLine> lines(const char* who, int count, int from = 0) {
        std::vector<LiveLine> made;
        for (int i = from; i < from + count; ++i) made.push_back({i * 0.01, who, TRUNDLE_INFO, "line " + std::to_string(i)});
        return made;
    }
    static QString textAt(const ConsoleModel& model, int row) {
        return model.data(model.index(row, ConsoleModel::Text), Qt::DisplayRole).toString();
    }

private Q_SLOTS:
    void keepsTheNewestHundredThousand() {
        ConsoleModel model;
        model.append(lines("robot0", 60'000), 0);
        model.append(lines("robot0", 60'000, 60'000), 0);
        QCOMPARE(model.rowCount(), 100'000);
        QCOMPARE(textAt(model, 0), QStringLiteral("line 20000"));
        QCOMPARE(textAt(model, 99'999), QStringLiteral("line 119999"));
        model.append(lines("robot0", 250'000, 120'000), 0); // more than the buffer holds, at once
        QCOMPARE(model.rowCount(), 100'000);
        QCOMPARE(textAt(model, 99'999), QStringLiteral("line 369999"));
    }

    /// A module's message is shown on one line, without markup.
    void showsWhoFinishedTheRun() {
        SessionFixture o;
        OpenOptions options = o.document.options();
        options.modules.push_back(TRUNDLE_BINARY_DIR "/tests/modules");
        o.document.setOptions(options);
        QVERIFY(o.open(kCountingRobot));

        QString console;
        connect(&o.session.messages(), &RunMessages::consoleLines, this, [&](const std::vector<LiveLine>& lines) {
            for (const LiveLine& line : lines) console += QString::fromStdString(line.text) + QLatin1Char('\n');
        });
        const RunStatus status(o.session);
        o.session.setSpeed(0);
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        const QString reportOf = QStringLiteral("finished by robot0/brain at t = 0.03 s: <b>there now");
        QCOMPARE(o.session.results().finishText(), reportOf);
        QVERIFY2(console.contains(reportOf), qPrintable(console));
        QVERIFY2(status.text().contains(reportOf), qPrintable(status.text()));
        QFile log(o.folder.filePath(QStringLiteral("logs/trial/counts.csv")));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QCOMPARE(log.readAll().split('\n')[4], QByteArray("0.03,3,0,5"));
        o.session.reset();
        QVERIFY(o.session.results().finishText().isEmpty());
    }

    void aBatchIsOneInsertion() {
        ConsoleModel model;
        QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
        model.append(lines("robot0", 5'000), 0);
        QCOMPARE(inserted.size(), 1);
    }

    void filtersByRobotAndText() {
        ConsoleModel model;
        model.append({{0, "robot0", TRUNDLE_INFO, "touched"},
                      {0, "robot0/leftMotor", TRUNDLE_WARNING, "Too fast"},
                      {0, "robot1", TRUNDLE_INFO, "touched"},
                      {0, "", TRUNDLE_ERROR, "E501: it blew up"}},
                     0);
        QCOMPARE(model.robots(), (QStringList{QStringLiteral("robot0"), QStringLiteral("robot1")}));
        model.setFilter(QStringLiteral("robot0"), {});
        QCOMPARE(model.rowCount(), 2); // the robot with its devices
        model.setFilter(QStringLiteral("robot0"), QStringLiteral("too FAST"));
        QCOMPARE(model.rowCount(), 1);
        model.setFilter({}, QStringLiteral("touch"));
        QCOMPARE(model.rowCount(), 2);
        model.append(lines("robot7", 10), 0); // none of the lines fits
        QCOMPARE(model.rowCount(), 2);
        model.setFilter(ConsoleModel::kRunItself, {});
        QCOMPARE(model.rowCount(), 1);
        model.setFilter({}, {});
        QCOMPARE(model.rowCount(), 14);
    }

    void dropsOldestFromFilteredList() {
        ConsoleModel model;
        model.append(lines("robot0", 10), 0);
        model.append(lines("robot1", 99'995), 0);
        QCOMPARE(model.lineCount(), 100'000u);
        model.setFilter(QStringLiteral("robot0"), {});
        QCOMPARE(model.rowCount(), 5);
        model.append(lines("robot1", 3), 0);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(textAt(model, 0), QStringLiteral("line 8"));
        model.append(lines("robot1", 10), 0);
        QCOMPARE(model.rowCount(), 0);
    }

    void severalLinesAndDroppedOnes() {
        ConsoleModel model;
        model.append({{1.5, "robot0", TRUNDLE_INFO, "one\ntwo\n"}}, 7);
        QCOMPARE(model.rowCount(), 3);
        QVERIFY(textAt(model, 0).contains(QStringLiteral("7 lines")));
        QCOMPARE(textAt(model, 2), QStringLiteral("two"));
        QCOMPARE(model.copyText({model.index(2, 0), model.index(1, 0)}), QStringLiteral("[1.50 robot0] one\n[1.50 robot0] two"));
        model.clear();
        QCOMPARE(model.rowCount(), 0);
    }

    void followsTheEndUntilOneScrollsUp() {
        SessionFixture o;
        ConsolePanel panel(o.session);
        panel.resize(600, 200);
        panel.show();
        auto* view = panel.findChild<QTableView*>(QStringLiteral("consoleLines"));
        QScrollBar* bar = view->verticalScrollBar();
        panel.model().append(lines("robot0", 200), 0);
        EVENTUALLY(bar->maximum() > 0);
        QCOMPARE(bar->value(), bar->maximum());
        panel.model().append(lines("robot0", 200, 200), 0);
        EVENTUALLY_EQUAL(bar->value(), bar->maximum());
        bar->setValue(17);
        panel.model().append(lines("robot0", 200, 400), 0);
        EVENTUALLY(bar->maximum() > 400);
        QCOMPARE(bar->value(), 17);
        bar->setValue(bar->maximum());
        panel.model().append(lines("robot0", 5, 600), 0);
        EVENTUALLY_EQUAL(bar->value(), bar->maximum());
        const int before = bar->maximum();
        panel.resize(600, 120); // another layout can make it smaller
        EVENTUALLY(bar->maximum() > before);
        QCOMPARE(bar->value(), bar->maximum());
    }

    void keepsScrollPositionWhenOldestAreDropped() {
        SessionFixture o;
        ConsolePanel panel(o.session);
        panel.resize(600, 200);
        panel.show();
        QScrollBar* bar = panel.findChild<QTableView*>(QStringLiteral("consoleLines"))->verticalScrollBar();
        panel.model().append(lines("robot0", 100'000), 0);
        EVENTUALLY(bar->maximum() > 0);
        bar->setValue(500);
        panel.model().append(lines("robot0", 100, 100'000), 0);
        QCOMPARE(bar->value(), 400);
        QCOMPARE(textAt(panel.model(), bar->value()), QStringLiteral("line 500"));
    }

    void copiesAndFiltersByItsWidgets() {
        SessionFixture o;
        ConsolePanel panel(o.session);
        panel.show();
        panel.model().append(lines("robot0", 3), 0);
        panel.model().append(lines("robot1", 3), 0);
        auto* robots = panel.findChild<QComboBox*>(QStringLiteral("consoleRobot"));
        robots->setCurrentIndex(robots->findText(QStringLiteral("robot1")));
        QCOMPARE(panel.model().rowCount(), 3);
        QTest::keyClicks(panel.findChild<QLineEdit*>(QStringLiteral("consoleSearch")), QStringLiteral("LINE 2"));
        QCOMPARE(panel.model().rowCount(), 1);
        auto* view = panel.findChild<QTableView*>(QStringLiteral("consoleLines"));
        view->selectRow(0);
        QTest::keySequence(view, QKeySequence::Copy);
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("[0.02 robot1] line 2"));
        QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("consoleClear")), Qt::LeftButton);
        QCOMPARE(panel.model().lineCount(), 0u);
        QCOMPARE(robots->currentText(), QStringLiteral("robot1")); // the choice is kept
    }

    void showsControllerOutput() {
        SessionFixture o;
        QVERIFY(o.openSample("linear_motion.sim"));
        ConsolePanel panel(o.session);
        o.session.setSpeed(0);
        o.session.run();
        QTRY_COMPARE_WITH_TIMEOUT(o.session.state(), RunState::Ended, 30000);
        QStringList texts;
        for (int row = 0; row < panel.model().rowCount(); ++row) texts.append(textAt(panel.model(), row));
        QVERIFY2(texts.join(u'\n').contains(QStringLiteral("done: drove")), qPrintable(texts.join(u'\n')));
        QVERIFY2(texts.join(u'\n').contains(QStringLiteral("logs/linear_motion/linear_motion.csv")),
                 qPrintable(texts.join(u'\n')));
    }
};

QTEST_MAIN(ConsoleTest)
#include "console_test.moc"
