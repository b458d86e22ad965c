// What the Insert menu offers in Repeats, Rings and PartConfigs: what they may hold where they are. Where copies of them are put.

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

#include "editor/outline/insert_menu.h"
#include "outline_fixture.h"
#include "project/edits/insert_positions.h"

using namespace trundle;

namespace {

const QByteArray kKit = R"(Tick = 0.01
PartConfig Wheel {
  Body wheel { Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
}
PartConfig Kerb { Box stone { Size=0.1,0.1,0.1 } }
RobotConfig Kit {
  Body chassis { Pos=0,0,0.1
    Box hull { Size=0.3,0.2,0.1 Mass=2 }
    Ring bolt { Count=6 Radius=0.05 Pos=0,0,0.055 Sphere head { Radius=0.008 Mass=0.01 } }
  }
  Part left { Config=Wheel Pos=0,0.125,0.05 carrier=chassis }
  Repeat mast {
    Count=3 Pos=$(0.05*index - 0.1),0,0.2
    Body pole { Box stick { Size=0.01,0.01,0.1 Pos=0,0,0.05 Mass=0.02 } }
    Fixed foot { Parent=chassis Child=pole }
  }
}
StaticConfig Floor { Plane ground { } Repeat post { Count=2 Pos=$index,2,0 Box wood { Size=0.1,0.1,1 } } }
Static arena { Config=Floor }
Robot rover { Config=Kit }
Repeat row { Count=2 Pos=$index,3,0.5 Robot one { Config=Kit } }
)";

QAction* entry(QMenu& menu, const char* kind) {
    return menu.findChild<QAction*>(QStringLiteral("insert.") + QLatin1String(kind));
}

} // namespace

class InsertPlacesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void offersOnlyWhatWorks_data() {
        QTest::addColumn<QByteArray>("selected");
        for (const char* path : {"rover.chassis.bolt.head", "rover.left.wheel", "rover.mast.pole.stick", "RobotConfig.Kit.mast",
                                 "PartConfig.Wheel", "arena.post.wood", "arena.post", "row.one"})
            QTest::newRow(path) << QByteArray(path);
    }

    /// Each of these entries adds a block of its kind in the place that it is listed under, and the text has no error then.
    void offersOnlyWhatWorks() {
        QFETCH(QByteArray, selected);
        OutlineFixture o;
        QVERIFY(o.open(kKit));
        QCOMPARE(o.errors(), QString());
        InsertMenu insert(o.document, o.selection, o.edits);
        const auto listed = [&] {
            std::vector<std::pair<QString, QString>> all; // kind and place
            o.selection.select(selected.toStdString());
            QMenu menu;
            insert.fill(menu);
            QString place;
            const std::function<void(const QMenu&)> read = [&](const QMenu& of) {
                for (QAction* action : of.actions()) {
                    if (action->objectName().startsWith(u"insertPlace."_qs)) place = action->objectName().mid(12);
                    if (action->objectName().startsWith(u"insert."_qs)) all.emplace_back(action->objectName().mid(7), place);
                    if (action->menu()) read(*action->menu());
                }
            };
            read(menu);
            return all;
        };
        const auto offered = listed();
        QVERIFY(!offered.empty());
        const QStringList tried{u"Box"_qs, u"Plane"_qs, u"Body"_qs, u"Encoder"_qs, u"Repeat"_qs, u"Robot"_qs, u"PoseLog"_qs};
        for (const auto& [kind, place] : offered) {
            if (!tried.contains(kind)) continue; // each takes a while
            o.selection.select(selected.toStdString());
            QMenu menu;
            insert.fill(menu);
            const QByteArray what = kind.toUtf8() + " in " + place.toUtf8();
            entry(menu, kind.toUtf8())->trigger();
            QVERIFY2(o.refusals.isEmpty(), what + ": " + o.refusals.join(u' ').toUtf8());
            const std::string made = definedAt(*o.document.loaded(), o.selection.current());
            const std::string into = parentOf(*o.document.loaded(), made);
            QVERIFY2(into == place.toStdString(), what + ": made " + QByteArray::fromStdString(made));
            QCOMPARE(what + o.errors().toUtf8(), what);
            o.document.edits().undo();
            QCOMPARE(o.text(), kKit);
        }
    }

    /// What its config or, at the top level, the experiment may hold.
    void aRepeatIsOfferedWhatItMayHold() {
        OutlineFixture o;
        QVERIFY(o.open(kKit));
        InsertMenu insert(o.document, o.selection, o.edits);
        const auto offered = [&](const char* path, const char* place) {
            o.selection.select(path);
            QMenu menu;
            insert.fill(menu);
            QStringList kinds;
            bool isHere = false;
            const std::function<void(const QMenu&)> read = [&](const QMenu& of) {
                for (QAction* action : of.actions()) {
                    if (action->objectName().startsWith(u"insertPlace."_qs))
                        isHere = action->objectName().mid(12) == QLatin1String(place);
                    if (isHere && action->objectName().startsWith(u"insert."_qs)) kinds << action->objectName().mid(7);
                    if (action->menu()) read(*action->menu());
                }
            };
            read(menu);
            return kinds;
        };
        const QStringList mast = offered("rover.mast.pole.stick", "RobotConfig.Kit.mast");
        for (const char* kind : {"Body", "Hinge", "Encoder"}) QVERIFY2(mast.contains(QLatin1String(kind)), kind);
        for (const char* kind : {"Box", "Plane", "Robot", "Static", "Grid", "Light", "View", "Region", "PoseLog"})
            QVERIFY2(!mast.contains(QLatin1String(kind)), kind);
        const QStringList row = offered("row.one", "row");
        for (const char* kind : {"Robot", "Static", "Light", "Region", "PoseLog"})
            QVERIFY2(row.contains(QLatin1String(kind)), kind);
        for (const char* kind : {"Box", "Body", "Encoder", "Part"}) QVERIFY2(!row.contains(QLatin1String(kind)), kind);
        QVERIFY(offered("arena.post.wood", "StaticConfig.Floor.post").contains(u"Box"_qs));
        const QStringList wheel = offered("PartConfig.Wheel.wheel", "PartConfig.Wheel");
        QVERIFY(wheel.contains(u"Body"_qs) && !wheel.contains(u"Plane"_qs) && !wheel.contains(u"Heightfield"_qs));
        QVERIFY(offered("PartConfig.Kerb.stone", "PartConfig.Kerb").contains(u"Plane"_qs));
    }

    /// Those that the place may hold, and a new one.
    void partsOfferTheirConfigs() {
        OutlineFixture o;
        QVERIFY(o.open(kKit));
        InsertMenu insert(o.document, o.selection, o.edits);
        const auto choose = [&](const char* path, const char* name) {
            o.selection.select(path);
            QMenu menu;
            insert.fill(menu);
            auto* action = menu.findChild<QAction*>(QLatin1String(name));
            if (action) action->trigger();
            return action != nullptr;
        };
        QVERIFY(choose("rover", "insertPart.Wheel"));
        QVERIFY2(o.text().contains("  Part wheel { Config=Wheel carrier=chassis }\n"), o.text());
        QCOMPARE(o.selection.current(), std::string("rover.wheel"));
        QCOMPARE(o.errors(), QString());
        o.document.edits().undo();
        QVERIFY(!choose("rover", "insertPart.Kerb"));             // scenery
        QVERIFY(!choose("rover.left.wheel", "insertPart.Wheel")); // in itself
        QVERIFY(choose("StaticConfig.Floor", "insertPart.Kerb"));
        QVERIFY2(o.text().contains("Part kerb { Config=Kerb }"), o.text());
        QCOMPARE(o.errors(), QString());
        o.document.edits().undo();
        QVERIFY(choose("rover", "insert.Part"));
        QVERIFY2(o.text().contains("PartConfig MyPart {") && o.text().contains("  Part part { Config=MyPart }\n"), o.text());
        QCOMPARE(o.selection.current(), std::string("rover.part"));
        QCOMPARE(o.errors(), QString());
        o.document.edits().undo();
        QVERIFY(choose("StaticConfig.Floor", "insert.Part"));
        QVERIFY2(o.text().contains("PartConfig MyPart {\n  Box box {"), o.text());
        QCOMPARE(o.errors(), QString());
        o.document.edits().undo();
        QCOMPARE(o.text(), kKit);
    }

    /// Beside the selected one and clear of it, as those of other objects. What is of another kind is put into it.
    void copiesOfARepeatAreBesideIt() {
        OutlineFixture o;
        QVERIFY(o.open(kKit));
        o.selection.select("row");
        o.edits.copySelected();
        for (const char* copy : {"row2", "row3"}) {
            o.edits.pasteAtSelected();
            QCOMPARE(o.selected(), QLatin1String(copy));
        }
        const auto& robots = o.document.loaded()->experiment->robots;
        QCOMPARE(robots.size(), std::size_t(7)); // with the rover
        for (std::size_t a = 0; a < robots.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY2((robots[a].pose.position - robots[b].pose.position).norm() > 0.2, o.text().constData());
        QCOMPARE(o.document.edits().history().entries().size(), std::size_t(2));
        o.document.edits().undo(), o.document.edits().undo();
        QCOMPARE(o.text(), kKit);

        o.selection.select("rover.chassis.bolt");
        o.edits.copySelected();
        o.edits.pasteAtSelected();
        QCOMPARE(o.selected(), QStringLiteral("rover.chassis.bolt2"));
        QGuiApplication::clipboard()->setText(QStringLiteral("Sphere knob { Radius=0.001 Mass=0.001 }"));
        o.edits.pasteAtSelected();
        QCOMPARE(o.selected(), QStringLiteral("rover.chassis.bolt2.knob"));
        QCOMPARE(o.errors(), QString());
    }
};

QTEST_MAIN(InsertPlacesTest)
#include "insert_places_test.moc"
