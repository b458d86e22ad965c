// The Scene tree during a run.
#include <QHelpEvent>
#include <QToolTip>

#include "editor/outline/outline_fixture.h"
#include "editor/running/session.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kCrate = "RobotConfig Crate { Body box { Box hull { Size=0.2,0.2,0.2 Mass=1 } } }\n";

} // namespace

class RunningTreeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tooltipShowsMeasuredValues() {
        OutlineFixture o;
        RunSession session(o.document, *o.application);
        o.panel->showValuesOf(session);
        QVERIFY(o.open("RobotConfig Crate { Body box { Box hull { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                       "Robot crate { Config=Crate Pos=0,0,20 }\n"));
        const auto ask = [&o] {
            const QPoint at = o.tree().visualRect(o.at("crate")).center();
            QHelpEvent help(QEvent::ToolTip, at, o.tree().viewport()->mapToGlobal(at));
            QApplication::sendEvent(o.tree().viewport(), &help);
            return QToolTip::text();
        };
        const QString before = ask();
        QVERIFY(!before.contains(QStringLiteral("speed")));
        session.step();
        EVENTUALLY_EQUAL(session.state(), RunState::Paused);
        const QString now = ask();
        QVERIFY2(now.contains(QStringLiteral("speed")) && now.contains(QStringLiteral("0.098")), qPrintable(now));
        QVERIFY(before.isEmpty() || now.contains(before.section(u'\n', 0, 0).toHtmlEscaped())); // the same text as before
        session.step();                                                                         // updated while it is shown
        EVENTUALLY(QToolTip::text().contains(QStringLiteral("0.196")));
        session.reset();
        EVENTUALLY(!ask().contains(QStringLiteral("speed")));
        QToolTip::hideText();
    }

    void marksRobotsThatEnded() {
        OutlineFixture o;
        RunSession session(o.document, *o.application);
        o.panel->showValuesOf(session);
        QVERIFY(o.open(kCrate + "Robot one { Config=Crate Pos=0,0,20 }\nRobot two { Config=Crate Pos=3,0,20 }\n"
                                "Grid row { Config=Crate Pos=0,5,20 Count=3,1 Spacing=1 }\n"));
        const auto label = [&o](const char* path) { return o.at(path).data(OutlineModel::EndedRole).toString(); };
        const auto faint = [&o](const char* path) { return o.at(path).data(OutlineModel::FaintRole).toBool(); };
        session.step();
        EVENTUALLY_EQUAL(session.state(), RunState::Paused);
        QCOMPARE(label("one") + label("row"), QString());
        for (const char* body : {"one/box", "row_1/box"}) {
            QVERIFY(session.robots().push(body, {0, 0, 1e9}, {0, 0, 20}));
            session.step();
            EVENTUALLY(session.robots().ended().countOf(QByteArray(body).split('/')[0].toStdString()) == 1);
            session.robots().endPush();
        }
        QCOMPARE(label("one"), QStringLiteral("ended"));
        QCOMPARE(label("row"), QStringLiteral("1 ended"));
        QCOMPARE(label("row_1"), QStringLiteral("ended"));
        QVERIFY(faint("one") && faint("one.box.hull") && faint("row_1"));
        QVERIFY(!faint("two") && !faint("row") && !faint("row_0") && label("two").isEmpty());
        QVERIFY(o.at("one").data(Qt::ToolTipRole).toString().contains(QStringLiteral("one/box stopped: ")));
        QVERIFY(o.at("row").data(Qt::ToolTipRole).toString().contains(QStringLiteral("row_1")));
        QVERIFY(!o.at("two").data(Qt::ToolTipRole).toString().contains(QStringLiteral("fault")));
        QVERIFY(!session.robots().place("one", Pose()) && !session.robots().push("one/box", {0, 0, 1}, {0, 0, 20}));
        session.reset();
        QVERIFY(label("one").isEmpty() && label("row").isEmpty() && !faint("one"));
    }
};

QTEST_MAIN(RunningTreeTest)
#include "running_tree_test.moc"
