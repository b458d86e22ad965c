// Robots made of parts in the Scene tree.

#include "outline_fixture.h"

using namespace trundle;

class PartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A Part is one row that opens: what its PartConfig has is below it, with paths through the robot.
    void partOpens() {
        OutlineFixture w;
        QVERIFY(w.open("PartConfig Wheel { Body wheel { Sphere tyre { Radius=0.05 Mass=1 } }\n"
                       "  Hinge axle { Parent=$carrier Child=wheel } }\n"
                       "RobotConfig Kit { Body chassis { Box hull { Size=1,1,1 Mass=1 } }\n"
                       "  Part left { Config=Wheel carrier=chassis } Part right { Config=Wheel Mirror=y carrier=chassis } }\n"
                       "Robot robot0 { Config=Kit }\n"));
        QCOMPARE(w.errors(), QString());
        const QModelIndex tyre = w.at("robot0.left.wheel.tyre");
        QVERIFY(tyre.isValid());
        QCOMPARE(w.model().rowAt(tyre.parent().parent())->path, std::string("robot0.left"));
        QCOMPARE(w.model().rowAt(tyre.parent().parent())->detail, std::string("Wheel"));
        QVERIFY(w.at("robot0.right.axle").isValid());
        QCOMPARE(w.model().rowCount(w.at("robot0.right")), 2);
        QVERIFY(w.at("RobotConfig.Kit.right.axle").isValid());
        QVERIFY(w.at("PartConfig.Wheel.wheel").isValid());
        w.filter().setText(QStringLiteral("tyre"));
        QVERIFY(w.at("robot0.right.wheel.tyre").isValid());
    }

    /// A Repeat is one row with its count; the path of a member leads to the row of the block.
    void repeatIsOneRow() {
        OutlineFixture w;
        QVERIFY(w.open("RobotConfig Kit { Body hub { Box hull { Size=1,1,1 Mass=1 } }\n"
                       "  Repeat roller { Count=3,2 Pos=$index,$index2,1 Body rim { Sphere t { Radius=0.05 Mass=1 } } } }\n"
                       "Robot robot0 { Config=Kit }\n"));
        QCOMPARE(w.errors(), QString());
        const QModelIndex rim = w.at("robot0.roller.rim");
        QVERIFY(rim.isValid());
        QCOMPARE(w.model().rowAt(rim.parent())->detail, std::string("3×2 "));
        QCOMPARE(w.at("robot0.roller_4.rim"), rim);
        QCOMPARE(w.at("robot0.roller_4"), rim.parent());
        QVERIFY(w.at("RobotConfig.Kit.roller.rim.t").isValid());
        w.filter().setText(QStringLiteral("rim"));
        QVERIFY(w.at("robot0.roller.rim").isValid());
    }

    /// A Grid in a Repeat of the world is one row there; the path of each of its members leads to it.
    void gridInARepeatIsOneRow() {
        OutlineFixture w;
        QVERIFY(w.open("RobotConfig Kit { Body hub { Box hull { Size=0.1,0.1,0.1 Mass=1 } } }\n"
                       "StaticConfig Post { Box b { Size=0.1,0.1,1 } }\n"
                       "Repeat row { Count=2 Pos=$(9*index),0,0 Grid herd { Config=Kit Count=3 Spacing=1 } }\n"
                       "Repeat fence { Count=2 Pos=$(9*index),5,0 Grid posts { Config=Post Count=3 Spacing=1 } }\n"));
        QCOMPARE(w.errors(), QString());
        const QModelIndex herd = w.at("row.herd");
        QVERIFY(herd.isValid());
        QCOMPARE(w.model().rowAt(herd)->detail, std::string("3 Kit"));
        for (const char* path : {"row_1.herd_2", "row.herd_0", "row_0.herd"}) QCOMPARE(w.at(path), herd);
        QCOMPARE(w.at("row_1.herd_2.hub.hull"), w.at("row.herd.hub.hull"));
        QVERIFY(w.at("row.herd.hub.hull").isValid());
        QVERIFY(w.at("fence").parent() != w.at("row").parent()); // among the scenery
    }

    /// What a variant has from another config is below it, too, and below its robots.
    void variantHasAll() {
        OutlineFixture w;
        QVERIFY(w.open("RobotConfig Kit { Body hub { Box hull { Size=1,1,1 Mass=1 } } }\n"
                       "RobotConfig Big { Config=Kit hub.hull.Mass=2 Body mast { Box b { Size=1,1,1 Mass=1 } } }\n"
                       "Robot robot0 { Config=Big }\n"));
        QCOMPARE(w.errors(), QString());
        for (const char* path :
             {"robot0.hub.hull", "robot0.mast.b", "RobotConfig.Big.hub", "RobotConfig.Big.mast", "RobotConfig.Kit.hub"})
            QVERIFY2(w.at(path).isValid(), path);
        w.filter().setText(QStringLiteral("hull"));
        QVERIFY(w.at("RobotConfig.Big.hub.hull").isValid());
    }
};

QTEST_MAIN(PartsTest)
#include "parts_test.moc"
