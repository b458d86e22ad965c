// Rows of the Scene tree that only differ in their config: variants, groups, members of large Grids, marks, filters.

#include "editor/outline/outline_rows.h"
#include "editor/outline/problem_counts.h"
#include "outline_fixture.h"
#include "project/objects/object_location.h"

using namespace trundle;

namespace {

/// Two variants of one config, without blocks of their own.
const QByteArray kVariants = R"(RobotConfig Kit {
  Body hub { Box hull { Size=1,1,1 Mass=1 } }
  Body arm { Pos=0,0,1 Box rod { Size=0.1,0.1,1 Mass=1 } }
  Hinge elbow { Parent=hub Child=arm Anchor=0,0,0.5 }
}
RobotConfig Big { Config=Kit hub.hull.Mass=2 }
RobotConfig Small { Config=Kit hub.hull.Mass=0.5 }
Robot first { Config=Big Pos=0,0,0.5 }
Robot second { Config=Small Pos=3,0,0.5 }
Grid herd { Config=Small Count=2 Spacing=3 Pos=9,0,0.5 }
)";

const QAbstractItemModel& asModel(OutlineFixture& w) { return w.model(); }

} // namespace

class OutlineRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// What they have from their base is below them and below their robots, each under its own config.
    void variantsWithoutBlocks() {
        OutlineFixture w;
        QVERIFY(w.open(kVariants));
        QCOMPARE(w.errors(), QString());
        for (const char* path : {"first", "second", "RobotConfig.Big", "RobotConfig.Small"}) {
            QVERIFY2(asModel(w).hasChildren(w.at(path)), path);
            QVERIFY2(w.at((std::string(path) + ".hub.hull").c_str()).isValid(), path);
            QCOMPARE(w.model().rowCount(w.at(path)), 3);
        }
        const auto nameOfConfig = [&](const char* path) {
            const OutlineRow* row = w.model().rowAt(w.at(path));
            return row && row->config ? row->config->name : std::string("-");
        };
        const auto isAsWritten = [&] {
            return nameOfConfig("first") == "Big" && nameOfConfig("second") == "Small" && nameOfConfig("herd") == "Small" &&
                   nameOfConfig("herd_1") == "Small";
        };
        QVERIFY(isAsWritten());
        QCOMPARE(w.at("first").data(OutlineModel::DetailRole).toString(), QStringLiteral("Big"));
        QCOMPARE(w.at("second").data(OutlineModel::DetailRole).toString(), QStringLiteral("Small"));
        QVERIFY(asModel(w).hasChildren(w.at("herd_1")) && w.at("herd_1.arm.rod").isValid());
        QVERIFY(w.document.structure().setValues(QStringLiteral("Set"), {{"RobotConfig.Small.hub.hull.Mass", "0.7"}}).ok());
        QVERIFY(isAsWritten());
        const OutlineRow* row = w.model().rowAt(w.at("second"));
        QCOMPARE(row->config,
                 configOf(*w.document.loaded(), *placeOf(*w.document.loaded(), "second")->part)); // of the present text
        QVERIFY(w.document.structure().setValues(QStringLiteral("Set"), {{"second.Config", "Big"}}).ok());
        QCOMPARE(nameOfConfig("second"), std::string("Big"));
        QCOMPARE(nameOfConfig("herd"), std::string("Small"));
    }

    void filteredVariants_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QStringList>("paths");
        QTest::addColumn<QStringList>("others");
        QTest::newRow("what both have")
            << QStringLiteral("rod")
            << QStringLiteral("first.arm.rod|second.arm.rod|RobotConfig.Big.arm.rod|RobotConfig.Small.arm.rod").split(u'|')
            << QStringLiteral("first.hub|RobotConfig.Big.elbow").split(u'|');
        QTest::newRow("one config") << QStringLiteral("big") << QStringLiteral("first|RobotConfig.Big|first.arm").split(u'|')
                                    << QStringLiteral("second|herd|RobotConfig.Kit").split(u'|');
        QTest::newRow("the other, in capitals")
            << QStringLiteral("SMALL") << QStringLiteral("second|herd|RobotConfig.Small").split(u'|')
            << QStringLiteral("first|RobotConfig.Big").split(u'|');
        QTest::newRow("name and kind") << QStringLiteral("arm body")
                                       << QStringLiteral("first.arm|RobotConfig.Kit.arm").split(u'|')
                                       << QStringLiteral("first.hub").split(u'|');
    }
    /// Rows that match, what is below them, and what leads to them.
    void filteredVariants() {
        QFETCH(QString, words);
        QFETCH(QStringList, paths);
        QFETCH(QStringList, others);
        OutlineFixture w;
        QVERIFY(w.open(kVariants));
        w.filter().setText(words);
        const auto isThere = [&](const QString& path) {
            const QModelIndex index = w.at(path.toLatin1().constData());
            return index.isValid() && w.model().rowAt(index)->path == path.toStdString();
        };
        for (const QString& path : paths) QVERIFY2(isThere(path), qPrintable(path));
        for (const QString& path : others) QVERIFY2(!isThere(path), qPrintable(path));
    }

    /// By what they are, or hold: scenery in a Grid or a Repeat, what has no joints, each kind of config.
    void groupsOfObjects() {
        OutlineFixture w;
        QVERIFY(w.open("PartConfig Leg { Body leg { Box b { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                       "RobotConfig Crate { Body c { Box b { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                       "StaticConfig Post { Box b { Size=0.1,0.1,1 } }\n"
                       "Robot crate { Config=Crate Pos=0,0,1 }\nGrid crates { Config=Crate Count=2 Spacing=1 Pos=5,0,1 }\n"
                       "Grid posts { Config=Post Count=2 Spacing=1 Pos=0,5,0 }\nStatic post { Config=Post Pos=0,-5,0 }\n"
                       "Repeat fence { Count=2 Pos=$(3*index),9,0 Static pole { Config=Post } }\n"
                       "Region goal { Size=1,1,1 Pos=0,0,9 }\nPoseLog way { Robots=crate }\n"));
        const auto groupOf = [&](const char* path) { return w.at(path).parent().data().toString(); };
        QCOMPARE(groupOf("crate"), QStringLiteral("Objects"));
        QCOMPARE(groupOf("crates"), QStringLiteral("Objects"));
        QCOMPARE(groupOf("posts"), QStringLiteral("Scenery"));
        QCOMPARE(groupOf("post"), QStringLiteral("Scenery"));
        QCOMPARE(groupOf("fence"), QStringLiteral("Scenery"));
        QCOMPARE(groupOf("goal"), QStringLiteral("Regions"));
        QCOMPARE(groupOf("PartConfig.Leg"), QStringLiteral("Part configs"));
        QCOMPARE(groupOf("StaticConfig.Post"), QStringLiteral("Scenery configs"));
        QCOMPARE(groupOf("RobotConfig.Crate"), QStringLiteral("Robot configs"));
        QCOMPARE(w.at("post").parent().data(OutlineModel::DetailRole).toString(), QStringLiteral("3"));
        const auto icon = [&](const char* path) { return w.at(path).data(OutlineModel::IconRole).toString(); };
        QCOMPARE(icon("crate"), QStringLiteral("kind-object"));
        QCOMPARE(icon("crates_1"), QStringLiteral("kind-object"));
        QCOMPARE(icon("RobotConfig.Crate"), QStringLiteral("kind-robotconfig"));
    }

    /// A hundred members are beside each other; of more there are ranges of a hundred, the last one shorter.
    void rangesOfMembers_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<QStringList>("rows");
        QTest::newRow("a hundred") << 100 << QStringList();
        QTest::newRow("one more") << 101 << QStringLiteral("herd_0 … herd_99|herd_100 … herd_100").split(u'|');
        QTest::newRow("several") << 230 << QStringLiteral("herd_0 … herd_99|herd_100 … herd_199|herd_200 … herd_229").split(u'|');
    }
    void rangesOfMembers() {
        QFETCH(int, count);
        QFETCH(QStringList, rows);
        OutlineFixture w;
        QVERIFY(w.open("StaticConfig Post { Box b { Size=0.1,0.1,1 } }\nStatic post { Config=Post Pos=0,-5,0 }\n"
                       "Grid fence { Config=Post Count=3 Spacing=1 Pos=0,9,0 }\n"
                       "Grid herd { Config=Post Count=" +
                       QByteArray::number(count) + " Spacing=1 }\n"));
        QCOMPARE(w.errors(), QString());
        const QModelIndex members = w.model().index(0, 0, w.at("herd_0").isValid() ? w.at("herd") : QModelIndex());
        QCOMPARE(members.data().toString(), QStringLiteral("Members"));
        QCOMPARE(members.data(OutlineModel::DetailRole).toString(), QString::number(count));
        QStringList found;
        for (int i = 0; i < w.model().rowCount(members); ++i)
            if (const QModelIndex row = w.model().index(i, 0, members); w.model().rowAt(row)->type == OutlineRow::Type::Members)
                found << row.data().toString();
        QCOMPARE(found, rows);
        for (const int member : {0, 99, count - 1}) {
            const QByteArray path = "herd_" + QByteArray::number(member);
            const QModelIndex index = w.at(path.constData());
            QCOMPARE(w.model().rowAt(index)->path, path.toStdString());
            if (!rows.isEmpty()) QCOMPARE(index.parent().data().toString(), rows[member / 100]);
        }
        QCOMPARE(w.model().rowAt(w.at("fence_2"))->path, std::string("fence_2"));
    }

    /// Bodies and geoms of what is placed can be hidden; the text of a row says how many problems are there.
    void marksOfRows() {
        OutlineFixture w;
        QVERIFY(w.open(kVariants + "Robot third { Config=Kit Pos=0,9,0.5 }\nRobot broken { Config=None }\n"));
        const auto isMarkable = [&](const char* path) { return w.model().rowAt(w.at(path))->markable; };
        for (const char* path : {"first", "first.hub", "first.hub.hull", "herd", "herd_1", "herd_1.arm", "third.arm.rod"})
            QVERIFY2(isMarkable(path), path);
        for (const char* path : {"first.elbow", "RobotConfig.Kit", "RobotConfig.Kit.hub", "RobotConfig.Big.hub.hull"})
            QVERIFY2(!isMarkable(path), path);
        QVERIFY(w.at("broken").data(Qt::ToolTipRole).toString().contains(QStringLiteral("1 error")));
        QVERIFY(!w.at("broken").data(Qt::ToolTipRole).toString().contains(QStringLiteral("1 errors")));
        QCOMPARE(w.at("broken").parent().data(OutlineModel::ErrorsRole).toInt(), 1);
        QCOMPARE(w.at("first").data(OutlineModel::ErrorsRole).toInt(), 0);
        w.marks.setLocked({"first"}, true);
        w.marks.setHidden({"second.hub"}, true);
        const auto mark = [&](const char* path, int column) {
            return w.at(path).siblingAtColumn(column).data(OutlineModel::MarkRole).toInt();
        };
        const int locked = OutlineModel::LockedColumn, visible = OutlineModel::VisibleColumn;
        QCOMPARE(mark("first", locked), int(OutlineModel::Marked));
        QCOMPARE(mark("first.hub.hull", locked), int(OutlineModel::MarkedAbove));
        QCOMPARE(mark("first", visible), int(OutlineModel::Unmarked));
        QCOMPARE(mark("second.hub", visible), int(OutlineModel::Marked));
        QCOMPARE(mark("second.hub.hull", visible), int(OutlineModel::MarkedAbove));
        QCOMPARE(mark("second", visible), int(OutlineModel::Unmarked));
        QCOMPARE(mark("RobotConfig.Kit", visible), int(OutlineModel::NoMark));
        w.marks.rename("first", "renamed");
        w.marks.rename("second.hub", "second.base");
        QVERIFY(w.marks.isLocked("renamed.hub") && !w.marks.isLocked("first"));
        QVERIFY(w.marks.isHidden("second.base.hull") && !w.marks.isHidden("second.hub") && !w.marks.isHidden("second.base2"));
        w.marks.clear();
        QVERIFY(!w.marks.isLocked("renamed") && !w.marks.isHidden("second.base"));
    }

    /// Of the innermost block around their place, and of all around that; hints do not count.
    void countsOfProblems() {
        OutlineFixture w;
        QVERIFY(
            w.open("Tikc = 0.01\nRobotConfig C {\n  Body b { Box x { Size=1,1,1 Mass=1 Masss=2 } }\n  Body d { Bxo y { } }\n}\n"
                   "Robot r { Config=C Pso=0,0,0 }\n#loadModule none/such\n"));
        const LoadedProject& loaded = *w.document.loaded();
        const ProblemCounts counts(loaded);
        const auto errors = [&](const char* path) {
            const auto place = placeOf(loaded, path);
            return place && place->part ? counts.of(*place->part).errors : -1;
        };
        QCOMPARE(errors("RobotConfig.C.b.x"), 1);
        QCOMPARE(errors("RobotConfig.C.b"), 1);
        QCOMPARE(errors("RobotConfig.C.d"), 1);
        QCOMPARE(errors("RobotConfig.C"), 2);
        QCOMPARE(errors("r"), 1);
        QCOMPARE(counts.ofFile(0).errors, int(loaded.diagnostics.errorCount()));
        QCOMPARE(counts.outside(loaded).errors, 1); // the misspelt setting; the module has a row of its own
        QCOMPARE(counts.at(loaded.experiment->modules.at(0).range).errors, int(loaded.diagnostics.errorCount()) - 4);
        QCOMPARE(counts.at({0, {0, 4}}).errors, 1);
    }
};

QTEST_MAIN(OutlineRowsTest)
#include "rows_test.moc"
