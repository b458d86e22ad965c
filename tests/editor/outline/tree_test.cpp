// The Scene tree: its rows, what stays after edits, and selection in both directions.

#include <QAbstractButton>

#include <QHelpEvent>
#include <QToolTip>

#include "editor/running/session.h"
#include "eventually.h"
#include "outline_fixture.h"

using namespace trundle;

class TreeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void showsTheExperimentByOwner();
    void showsFilesWithTheirBlocks();
    void createsChildrenOnDemand();
    void oneValueOfManyComputesOneRow();
    void aClickSelectsTheObject();
    void selectionElsewhereIsShownHere();
    void membersOfAGridAreReached();
    void everyPathInsideAMemberLeadsToARow_data();
    void everyPathInsideAMemberLeadsToARow();
    void tenThousandMembersMakeFewRows();
    void passiveRobotIsAnObject();
    void editsKeepExpandedRows();
    void selectsFilterMatchFromKeyboard();
    void undoneDeletionIsUnfolded();
    void notifiesOnlyChangedRows();
    void aBrokenTextStillHasATree();
    void aRobotInItsOwnConfigHasAnEnd();
    void countsProblemsUpToTheGroups();
    void hidesAndLocksByTheIconsOfARow();
    void marksAreOfWholeNames();
    void narrowRowsKeepTheName();
};

void TreeTest::showsTheExperimentByOwner() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QCOMPARE(
        o.rows(),
        QStringLiteral("trial.sim\nRobots\n robot0\n robot1\nScenery\n arena\nLogs\n path\nRobot configs\nScenery configs\n"));
    o.tree().expand(o.at("robot0"));
    o.tree().expand(o.at("robot0.chassis"));
    QVERIFY(o.rows().contains(QStringLiteral(
        "\n robot0\n  chassis\n   hull\n   bumper\n  leftWheel\n  rightWheel\n  leftAxle\n  rightAxle\n  count\n robot1\n")));
    QCOMPARE(o.at("RobotConfig.Rover.chassis.hull").data().toString(), QStringLiteral("hull"));
    QCOMPARE(o.at("robot0").data(OutlineModel::DetailRole).toString(), QStringLiteral("Rover"));
    QVERIFY(!o.at("robot7").isValid());
    QVERIFY(!o.at("robot0.chassis.nothing").isValid());
    QVERIFY(!o.at("").data().toString().isEmpty());
}

void TreeTest::showsFilesWithTheirBlocks() {
    OutlineFixture o;
    QVERIFY(o.openSample("linear_motion.sim"));
    auto* byFile = o.panel->findChild<QAbstractButton*>(QStringLiteral("outlineByFile"));
    QTest::mouseClick(byFile, Qt::LeftButton);
    QCOMPARE(o.model().rowCount(), int(o.document.texts().files().size()));
    const QModelIndex main = o.model().index(0, 0);
    QCOMPARE(main.data().toString(), QStringLiteral("linear_motion.sim"));
    o.tree().expand(main);
    QCOMPARE(o.rows(main), QStringLiteral("linear_motion\narena\nrobot0\npath\n"));
    QVERIFY(o.at("RobotConfig.SimpleRobot.leftAxle").isValid());
    const QModelIndex imported = o.at("RobotConfig.SimpleRobot").parent();
    QCOMPARE(imported.data().toString(), QStringLiteral("simple_robot.sim"));
    QCOMPARE(imported.data(OutlineModel::DetailRole).toString(), QStringLiteral("robots"));
    o.selection.select("robot0.chassis.hull"); // a part of an instance: the row of its config is selected
    QCOMPARE(o.marked(), QStringLiteral("RobotConfig.SimpleRobot.chassis.hull"));
    QCOMPARE(o.selected(), QStringLiteral("robot0.chassis.hull"));
    // In a user's project too, a file shipped with the program is named as the import names it.
    QVERIFY(o.open("#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot }\n"));
    QCOMPARE(o.at("RobotConfig.SimpleRobot").parent().data(OutlineModel::DetailRole).toString(), QStringLiteral("robots"));
}

void TreeTest::createsChildrenOnDemand() {
    OutlineFixture o;
    QByteArray text = kRovers;
    for (int i = 2; i < 500; ++i)
        text += "Robot robot" + QByteArray::number(i) + " { Config=Rover Pos=" + QByteArray::number(i) + ",0,0 }\n";
    QVERIFY(o.open(text));
    const std::size_t before = o.model().work().made;
    QVERIFY(before < 600);
    o.tree().expand(o.at("robot300"));
    QCOMPARE(o.model().work().made, before + 6);
}

/// One value of 2,000 blocks: one row is computed again, and the others point into the new text.
void TreeTest::oneValueOfManyComputesOneRow() {
    OutlineFixture o;
    QByteArray text = "Material red { ColorRGB=1,0,0 }\nStaticConfig Yard { Box north { Size=1,1,1 Material=red } }\n";
    for (int i = 0; i < 2000; ++i)
        text += "Static s" + QByteArray::number(i) + " { Config=Yard Pos=" + QByteArray::number(i) + ",0,0 }\n";
    QVERIFY(o.open(text));
    o.tree().expand(o.at("s7"));
    QVERIFY(o.at("s7.north").isValid() && o.at("Material.red").isValid());
    std::vector<ChangeSet> edits;
    connect(&o.document, &Document::changed, this, [&](const ChangeSet& changes) { edits.push_back(changes); });
    QSignalSpy drawn(&o.model(), &QAbstractItemModel::dataChanged), resets(&o.model(), &QAbstractItemModel::modelReset);
    std::size_t computed = o.model().work().computed;
    const auto computedNow = [&] { return o.model().work().computed - std::exchange(computed, o.model().work().computed); };
    QVERIFY(o.document.structure().setValues(QStringLiteral("Move"), {{"s3.Pos", "1000.5,0,0"}}).ok());
    QCOMPARE(computedNow(), 1u);
    QVERIFY(o.document.structure().setValues(QStringLiteral("Colour"), {{"Material.red.ColorRGB", "0,1,0"}}).ok());
    QCOMPARE(computedNow(), 1u);
    QCOMPARE(drawn.count(), 1);
    QVERIFY(o.document.structure().setValues(QStringLiteral("Size"), {{"StaticConfig.Yard.north.Size", "1,1,20"}}).ok());
    QCOMPARE(computedNow(), 1u); // below s7, the only instance whose parts are shown
    QCOMPARE(resets.count(), 0);
    QCOMPARE(edits.size(), 3u); // one comparison an edit
    for (std::size_t i = 1; i < edits.size(); ++i) QVERIFY(edits[i].before() == edits[i - 1].after());
    for (const ChangeSet& changes : edits) QVERIFY(changes.isLocal() && changes.parts().size() == 1 && changes.compared() <= 2);
    const LoadedProject& now = *o.document.loaded();
    for (const char* path : {"s0", "s3", "s7", "s1999", "s7.north", "Material.red", "StaticConfig.Yard"}) {
        const OutlineRow* row = o.model().rowAt(o.at(path));
        const auto place = placeOf(now, path);
        QVERIFY2(row && place && row->part == place->part && row->range == place->part->range, path);
    }
    o.document.edits().undo();
    QElapsedTimer clock;
    clock.start();
    o.model().follow(ChangeSet(o.document.loaded(), o.document.loaded()));
    const double followed = double(clock.nsecsElapsed()) / 1e6;
    o.model().follow(ChangeSet::ofEverything(o.document.loaded(), o.document.loaded()));
    qInfo("2000 rows: %.2f ms, all computed again %.2f ms", followed, double(clock.nsecsElapsed()) / 1e6 - followed);
}

void TreeTest::aClickSelectsTheObject() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.click(o.at("robot1"));
    QCOMPARE(o.selected(), QStringLiteral("robot1"));
    o.click(o.at("arena"), Qt::ControlModifier);
    QCOMPARE(o.selected(), QStringLiteral("robot1 arena"));
    o.click(o.at("robot0"));
    o.click(o.at("path"), Qt::ShiftModifier); // group rows between them are not objects
    QCOMPARE(o.selected(), QStringLiteral("robot0 robot1 arena path"));
    o.click(o.at("robot1"), Qt::ControlModifier); // deselected again
    QCOMPARE(o.selected(), QStringLiteral("robot0 arena path"));
    o.click(o.at(""));
    QCOMPARE(o.selection.paths(), std::vector<std::string>{""});
    QTest::keyClick(&o.tree(), Qt::Key_Down);
    QVERIFY(o.selection.empty());
    QTest::keyClick(&o.tree(), Qt::Key_Down);
    QCOMPARE(o.selected(), QStringLiteral("robot0"));
}

void TreeTest::selectionElsewhereIsShownHere() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.selection.set({"robot1.chassis.hull", "arena"});
    QCOMPARE(o.marked(), QStringLiteral("arena robot1.chassis.hull"));
    QVERIFY(o.tree().isExpanded(o.at("robot1")));
    QVERIFY(o.tree().visualRect(o.at("robot1.chassis.hull")).isValid());
    o.selection.select("RobotConfig.Rover.count");
    QCOMPARE(o.marked(), QStringLiteral("RobotConfig.Rover.count"));
    o.selection.clear();
    QCOMPARE(o.marked(), QString());
    o.selection.select("nobody");
    QCOMPARE(o.marked(), QString());
    QCOMPARE(o.selected(), QStringLiteral("nobody")); // the tree does not change a selection it cannot show
}

void TreeTest::membersOfAGridAreReached() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers + "Grid swarm { Config=Rover Pos=5,5,0 Count=2,2 Spacing=1 }\n"));
    o.selection.select("swarm_3");
    QCOMPARE(o.marked(), QStringLiteral("swarm_3"));
    QCOMPARE(o.selected(), QStringLiteral("swarm_3"));
    o.selection.select("swarm_3.chassis");
    QCOMPARE(o.marked(), QStringLiteral("swarm_3.chassis"));
    QCOMPARE(o.at("swarm").data(OutlineModel::DetailRole).toString(), QStringLiteral("2×2 Rover"));
    const QModelIndex members = o.at("swarm_3").parent();
    QCOMPARE(members.data().toString(), QStringLiteral("Members"));
    QCOMPARE(members.data(OutlineModel::DetailRole).toString(), QStringLiteral("4"));
    QCOMPARE(members.model()->rowCount(members), 4);
    QVERIFY(!(members.flags() & Qt::ItemIsSelectable)); // not an object
    // A Grid's member has no text of its own: it can be neither renamed nor dragged.
    QVERIFY(!(o.at("swarm_3").flags() & (Qt::ItemIsEditable | Qt::ItemIsDragEnabled)));
    o.click(o.at("swarm_1"));
    QCOMPARE(o.selected(), QStringLiteral("swarm_1"));
    // The rows follow a changed Count.
    QVERIFY(o.document.structure().setValues(QStringLiteral("Set Count"), {{"swarm.Count", "1,2"}}).ok());
    QCOMPARE(members.model()->rowCount(o.at("swarm_1").parent()), 2);
}

void TreeTest::everyPathInsideAMemberLeadsToARow_data() {
    QTest::addColumn<bool>("byFile");
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("row");
    for (const char* inside : {".chassis", ".chassis.hull", ".brain"}) {
        const QString path = QStringLiteral("swarm_3") + QLatin1String(inside);
        QTest::addRow("by owner, %s", qPrintable(path)) << false << path << path;
        const QString inFile = inside == std::string_view(".brain") ? QStringLiteral("swarm.brain")
                                                                    : QStringLiteral("RobotConfig.Rover") + QLatin1String(inside);
        QTest::addRow("by file, %s", qPrintable(path)) << true << path << inFile;
    }
}

/// A path into a member that has no row by file was searched for without end.
void TreeTest::everyPathInsideAMemberLeadsToARow() {
    QFETCH(bool, byFile);
    QFETCH(QString, path);
    OutlineFixture o;
    QVERIFY(o.open("#loadModule controllers/linear_motion\n" + kRovers +
                   "Grid swarm { Config=Rover Pos=5,5,0 Count=2,2 Spacing=1 LinearMotion brain { Distance=1 } }\n"));
    o.model().setMode(byFile ? OutlineMode::ByFile : OutlineMode::ByOwner);
    o.selection.select(path.toStdString());
    QTEST(o.marked(), "row");
}

void TreeTest::tenThousandMembersMakeFewRows() {
    OutlineFixture o;
    QVERIFY(o.open("RobotConfig Pea { Body b { Sphere s { Radius=0.01 Mass=0.01 } } }\n"
                   "Grid peas { Config=Pea Count=100,100 Spacing=0.1 }\n"));
    const std::size_t before = o.model().work().made;
    o.selection.select("peas_4711");
    QCOMPARE(o.marked(), QStringLiteral("peas_4711"));
    QVERIFY2(o.model().work().made - before < 250, qPrintable(QString::number(o.model().work().made - before)));
    QCOMPARE(o.at("peas_4711").parent().data().toString(), QStringLiteral("peas_4700 … peas_4799"));
    o.model().setFilter("peas_9998");
    QVERIFY(o.at("peas_9998").isValid());
    QVERIFY2(o.model().work().made < 20, qPrintable(QString::number(o.model().work().made)));
}

void TreeTest::passiveRobotIsAnObject() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers +
                   "RobotConfig Ball { Body b { Sphere s { Radius=0.1 Mass=0.1 } } }\nRobot ball { Config=Ball Pos=3,3,0 }\n"
                   "Grid balls { Config=Ball Pos=5,5,0 Count=2,2 Spacing=1 }\n"));
    const auto groupOf = [&](const char* path) { return o.at(path).parent().data().toString(); };
    QCOMPARE(groupOf("ball"), QStringLiteral("Objects"));
    QCOMPARE(groupOf("balls"), QStringLiteral("Objects"));
    QCOMPARE(o.at("ball").parent().data(OutlineModel::DetailRole).toString(), QStringLiteral("2"));
    QCOMPARE(o.at("ball").data(OutlineModel::IconRole).toString(), QStringLiteral("kind-object"));
    QCOMPARE(o.at("balls_2").data(OutlineModel::IconRole).toString(), QStringLiteral("kind-object"));
    // A body with a sensor is a robot.
    QByteArray text = o.text();
    text.replace("Mass=0.1 } } }\nRobot ball", "Mass=0.1 } } Camera eye { Body=b } }\nRobot ball");
    QVERIFY(o.document.edits().replaceText(QStringLiteral("camera"), o.document.path(), text.toStdString()).ok());
    QCOMPARE(groupOf("ball"), QStringLiteral("Robots"));
}

void TreeTest::editsKeepExpandedRows() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.tree().expand(o.at("robot0"));
    o.tree().expand(o.at("robot0.chassis"));
    o.selection.select("robot0.chassis.bumper");
    const std::string file = o.document.path();
    std::string text =
        "// above\nMaterial blue { ColorRGB=0,0,1 }\n" + kRovers.toStdString() + "Robot robot2 { Config=Rover Pos=2,0,0 }\n";
    QVERIFY(o.document.edits().replaceText(QStringLiteral("Type"), file, text).ok());
    QVERIFY(o.tree().isExpanded(o.at("robot0.chassis")));
    QCOMPARE(o.marked(), QStringLiteral("robot0.chassis.bumper"));
    QVERIFY(o.edits.rename("robot0", "scout").ok());
    QVERIFY(o.tree().isExpanded(o.at("scout")));
    QVERIFY(o.tree().isExpanded(o.at("scout.chassis")));
    o.document.edits().undo();
    QVERIFY(o.tree().isExpanded(o.at("robot0.chassis")));
    o.filter().setText(QStringLiteral("arena"));
    QVERIFY(!o.rows().contains(QStringLiteral("hull")));
    o.filter().clear();
    QVERIFY(o.tree().isExpanded(o.at("robot0.chassis")));
}

void TreeTest::selectsFilterMatchFromKeyboard() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.filter().setText(QStringLiteral("bumper"));
    QTest::keyClick(&o.filter(), Qt::Key_Down);
    QCOMPARE(o.selection.current(), std::string("robot0.chassis.bumper"));
}

void TreeTest::undoneDeletionIsUnfolded() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.tree().expand(o.at("robot1"));
    o.tree().expand(o.at("robot1.chassis"));
    QVERIFY(o.edits.remove({"robot1"}).ok());
    QVERIFY(!o.at("robot1").isValid());
    o.document.edits().undo();
    QVERIFY(o.tree().isExpanded(o.at("robot1")));
    QVERIFY(o.tree().isExpanded(o.at("robot1.chassis")));
}

void TreeTest::notifiesOnlyChangedRows() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.tree().expand(o.at("robot0"));
    QSignalSpy data(&o.model(), &QAbstractItemModel::dataChanged), in(&o.model(), &QAbstractItemModel::rowsInserted),
        out(&o.model(), &QAbstractItemModel::rowsRemoved), moved(&o.model(), &QAbstractItemModel::rowsMoved),
        reset(&o.model(), &QAbstractItemModel::modelReset);
    const auto reported = [&] { return data.count() + in.count() + out.count() + moved.count() + reset.count(); };
    QVERIFY(o.document.structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "3,0,0"}}).ok());
    QCOMPARE(reported(), 0);
    QVERIFY(o.edits.rename("robot0", "scout").ok());
    QCOMPARE(in.count() + out.count() + moved.count() + reset.count(), 0);
    const std::string swapped = QByteArray(kRovers)
                                    .replace("Robot robot1", "Robot robotX")
                                    .replace("Robot robot0", "Robot robot1")
                                    .replace("Robot robotX", "Robot robot0")
                                    .toStdString();
    o.document.edits().undo();
    data.clear();
    QVERIFY(o.document.edits().replaceText(QStringLiteral("Swap"), o.document.path(), swapped).ok());
    QCOMPARE(moved.count(), 1);
    QCOMPARE(in.count() + out.count() + reset.count(), 0);
    QVERIFY(o.tree().isExpanded(o.at("robot0")));
    QCOMPARE(o.at("robot0").row(), 1);
}

void TreeTest::aBrokenTextStillHasATree() {
    OutlineFixture o;
    QVERIFY(o.open(
        "Robot a { Config=Nothing }\nRobot a { }\nRobott b { }\nBody loose { }\nMaterial { }\nRobot { Config=X }\n}} ((\n"));
    QVERIFY(o.rows().startsWith(QStringLiteral("trial.sim\nRobots\n a\n")));
    QVERIFY(o.rows().contains(QStringLiteral("Misplaced\n")));
    for (const QByteArray& text : {QByteArray(), QByteArray("{{{{{{"), QByteArray("\xff\xfe\x00", 3),
                                   QByteArray("RobotConfig R { Body b { Body b { Box { } Box { } } } }"), kRovers}) {
        QVERIFY(o.document.edits().replaceText(QStringLiteral("Type"), o.document.path(), text.toStdString()).ok());
        o.tree().expandAll();
        QVERIFY(o.model().rowCount() >= 1);
    }
    o.document.opening().close();
    QCOMPARE(o.model().rowCount(), 0);
}

void TreeTest::aRobotInItsOwnConfigHasAnEnd() {
    OutlineFixture w; // as after a misplaced brace
    QVERIFY(w.open("RobotConfig Rover { Body chassis { Box hull { Size=1,1,1 } }\nRobot robot0 { Config=Rover }\n}\n"
                   "Robot robot1 { Config=Rover }\n"));
    w.filter().setText(QStringLiteral("robot")); // expands all rows that lead to a match
    std::size_t rows = 0;
    const std::function<void(const QModelIndex&)> count = [&](const QModelIndex& parent) {
        if (w.model().canFetchMore(parent)) w.model().fetchMore(parent);
        for (int i = 0; i < w.model().rowCount(parent) && rows < 100; ++i, ++rows) count(w.model().index(i, 0, parent));
    };
    count({});
    QVERIFY2(rows > 4 && rows < 20, qPrintable(QString::number(rows)));
}

void TreeTest::countsProblemsUpToTheGroups() {
    OutlineFixture o;
    QVERIFY(o.open(QByteArray(kRovers).replace("Mass=0.05", "Mass=-1").replace("Config=Rover Pos=1", "Config=Rovr Pos=1")));
    const auto errors = [&](const QModelIndex& index) { return index.data(OutlineModel::ErrorsRole).toInt(); };
    QCOMPARE(errors(o.at("RobotConfig.Rover.chassis.bumper")), 1);
    QCOMPARE(errors(o.at("RobotConfig.Rover.chassis.hull")), 0);
    QCOMPARE(errors(o.at("RobotConfig.Rover.chassis")), 1);
    QCOMPARE(errors(o.at("RobotConfig.Rover")), 1);
    QCOMPARE(errors(o.at("RobotConfig.Rover").parent()), 1);
    QCOMPARE(errors(o.at("robot1")), 1);
    QCOMPARE(errors(o.at("robot0")), 0);
    QCOMPARE(errors(o.at("robot1").parent()), 1);
    QVERIFY(o.at("robot1").data(Qt::ToolTipRole).toString().contains(QStringLiteral("1 error")));
    QVERIFY(o.document.edits().replaceText(QStringLiteral("Fix"), o.document.path(), kRovers.toStdString()).ok());
    QCOMPARE(errors(o.at("robot1").parent()), 0);
    QCOMPARE(errors(o.at("RobotConfig.Rover")), 0);
}

void TreeTest::hidesAndLocksByTheIconsOfARow() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.selection.select("robot0.chassis");
    o.click(o.at("robot0"), {}, OutlineModel::VisibleColumn);
    QVERIFY(o.marks.isHidden("robot0"));
    QVERIFY(o.marks.isHidden("robot0.chassis.hull"));
    QVERIFY(!o.marks.isHidden("robot01"));
    QCOMPARE(o.selected(), QStringLiteral("robot0.chassis")); // the visibility icon does not select
    QCOMPARE(o.at("robot0.chassis").siblingAtColumn(OutlineModel::VisibleColumn).data(OutlineModel::MarkRole).toInt(),
             int(OutlineModel::MarkedAbove));
    o.click(o.at("robot0"), {}, OutlineModel::VisibleColumn);
    QVERIFY(!o.marks.isHidden("robot0"));

    o.selection.set({"robot0", "robot1"});
    o.click(o.at("robot1"), {}, OutlineModel::LockedColumn); // one of several selected rows: applies to all of them
    QVERIFY(o.marks.isLocked("robot0") && o.marks.isLocked("robot1"));
    const QByteArray before = o.text();
    QTest::keyClick(&o.tree(), Qt::Key_Delete);
    QCOMPARE(o.text(), before);
    QVERIFY2(o.refusals.join(QLatin1Char(' ')).contains(QStringLiteral("locked")), qPrintable(o.refusals.join(QLatin1Char(' '))));
    o.marks.setLocked({"robot1"}, false);
    QVERIFY(o.edits.rename("robot1", "scout").ok());
    o.marks.setHidden({"scout"}, true);
    QVERIFY(o.edits.rename("scout", "rover9").ok());
    QVERIFY(o.marks.isHidden("rover9")); // the mark is renamed with the object
    QVERIFY(!o.marks.isHidden("scout"));
}

/// `robot1` is no part of `robot10`, when a mark is asked for and when it is renamed.
void TreeTest::marksAreOfWholeNames() {
    ObjectMarks marks;
    marks.setHidden({"robot1", "robot10.chassis"}, true);
    marks.setLocked({"robot10", "swarm_1.base"}, true);
    for (const char* path : {"robot1", "robot1.chassis", "robot1.chassis.hull", "robot10.chassis", "robot10.chassis.hull"})
        QVERIFY2(marks.isHidden(path), path);
    for (const char* path : {"robot", "robot10", "robot10.chassis2", "robot11", "robot1x.chassis", "", "obot1", "x.robot1"})
        QVERIFY2(!marks.isHidden(path), path);
    marks.rename("robot1", "robot2");
    QVERIFY(marks.isHidden("robot2.chassis") && !marks.isHidden("robot1") && marks.isHidden("robot10.chassis"));
    QVERIFY(marks.isLocked("robot10.chassis") && !marks.isLocked("robot20"));
    marks.rename("swarm_1", "swarm_10");
    QVERIFY(marks.isLocked("swarm_10.base") && !marks.isLocked("swarm_1.base"));
    marks.rename("robot10.chas", "robot10.x"); // a part of no name
    QVERIFY(marks.isHidden("robot10.chassis") && !marks.isHidden("robot10.xsis"));
}

/// A kind that does not fit is elided or left out, the name is drawn as without it, and the tooltip has both whole.
void TreeTest::narrowRowsKeepTheName() {
    const auto leftOf = [](OutlineFixture& o, const char* path, int width) { // the row's picture up to the end of its name
        const QRect row = o.tree().visualRect(o.at(path));
        const int name = o.tree().fontMetrics().horizontalAdvance(o.at(path).data().toString());
        return o.tree()
            .viewport()
            ->grab(QRect(row.left(), row.top(), width < 0 ? row.width() : name + 24, row.height()))
            .toImage();
    };
    const QByteArray text = QByteArray(kRovers).replace("Rover", "AVeryLongNameOfAConfigThatFitsNowhere");
    QList<QImage> wide, narrow;
    for (const int width : {700, 200}) {
        OutlineFixture o;
        o.panel->resize(width, 700);
        QVERIFY(o.open(text));
        const QModelIndex robot = o.at("robot0");
        const QString name = robot.data().toString(), detail = robot.data(OutlineModel::DetailRole).toString();
        QVERIFY2(detail.contains(QStringLiteral("AVeryLongName")), qPrintable(detail));
        const QString tip = robot.data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(name) && tip.contains(detail), qPrintable(tip));
        EVENTUALLY(o.tree().visualRect(robot).isValid());
        (width > 400 ? wide : narrow) << leftOf(o, "robot0", 0) << leftOf(o, "robot0", -1);
    }
    QCOMPARE(narrow[0], wide[0]);
    const auto inked = [](const QImage& picture, int from) { // columns with anything drawn
        int count = 0;
        for (int x = from; x < picture.width(); ++x)
            for (int y = 0; y < picture.height(); ++y)
                if (picture.pixel(x, y) != picture.pixel(picture.width() - 1, 0)) {
                    ++count;
                    break;
                }
        return count;
    };
    QVERIFY(inked(narrow[1], narrow[0].width()) > 0); // the beginning of the kind
}

QTEST_MAIN(TreeTest)
#include "tree_test.moc"
