// Names, angles and values of objects at rarer edges.
#include <QTest>

#include <numbers>

#include "plan_fixture.h"
#include "project/objects/moves_with.h"
#include "project/objects/object_location.h"
#include "project/objects/object_names.h"
#include "project/objects/unplaced_configs.h"
#include "project/objects/value_text.h"
#include "project/objects/written_hpr.h"

using namespace trundle;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

} // namespace

class ObjectEdgesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Angles stay as they are written: beyond half a turn, with a pitch beyond a quarter turn, and straight up and down.
    void anglesStayAsTheyAreWritten() {
        for (const double heading : {-350., -180., -100., 0., 35., 180., 270.})
            for (const double pitch : {-250., -120., -90., -30., 0., 80., 90., 100., 180.})
                for (const double roll : {-190., -45., 0., 20., 170.}) {
                    const Vec3 written = kDegree * Vec3(heading, pitch, roll), like = hprLike(written, rotationFromHpr(written));
                    const QByteArray what =
                        QByteArray::number(heading) + " " + QByteArray::number(pitch) + " " + QByteArray::number(roll);
                    QVERIFY2((like - written).cwiseAbs().maxCoeff() < 1e-4, what);
                    QVERIFY2(rotationFromHpr(like).angularDistance(rotationFromHpr(written)) < 1e-6, what);
                }
    }

    void angleOfAnObject() {
        sample::PlanFixture fixture;
        const auto loaded =
            fixture.open("RobotConfig K { Body a { Box x { Mass=1 Size=1,1,1 } HPR=270,0,350 } }\nRobot r { Config=K }\n");
        QVERIFY(loaded && !loaded->diagnostics.hasErrors());
        const auto place = placeOf(*loaded, "RobotConfig.K.a");
        QVERIFY(place);
        const Vec3 same = writtenHpr(*loaded, *place, rotationFromHpr(kDegree * Vec3(270, 0, 350)));
        QVERIFY((same - kDegree * Vec3(-90, 0, -10)).norm() < 1e-6);
        const Vec3 other = writtenHpr(*loaded, *place, rotationFromHpr(kDegree * Vec3(40, 5, 0)));
        QVERIFY((other - kDegree * Vec3(40, 5, 0)).norm() < 1e-6);
    }

    void whatMovesWithOthers_data() {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<QByteArray>("other");
        QTest::addColumn<bool>("moves");
        QTest::newRow("itself") << QByteArray("K.a") << QByteArray("K.a") << false;
        QTest::newRow("in it") << QByteArray("K.a.x") << QByteArray("K.a") << true;
        QTest::newRow("around it") << QByteArray("K.a") << QByteArray("K.a.x") << false;
        QTest::newRow("whose pose counts from it") << QByteArray("K.b") << QByteArray("K.a") << true;
        QTest::newRow("the other way") << QByteArray("K.a") << QByteArray("K.b") << false;
        QTest::newRow("from what counts from it") << QByteArray("K.c") << QByteArray("K.a") << true;
        QTest::newRow("of a name that begins alike") << QByteArray("K.b") << QByteArray("K.aa") << false;
        QTest::newRow("a geom of what counts from it") << QByteArray("K.c.x") << QByteArray("K.a") << true;
        QTest::newRow("beside it") << QByteArray("K.aa") << QByteArray("K.a") << false;
    }
    void whatMovesWithOthers() {
        QFETCH(QByteArray, path);
        QFETCH(QByteArray, other);
        QFETCH(bool, moves);
        sample::PlanFixture fixture;
        const auto loaded = fixture.open(
            "RobotConfig K {\n  Body a { Box x { Mass=1 Size=1,1,1 } }\n  Body aa { Box x { Mass=1 Size=1,1,1 } }\n"
            "  Body b { In=a Pos=1,0,0 Box x { Mass=1 Size=1,1,1 } }\n  Body c { In=b Pos=1,0,0 Box x { Mass=1 Size=1,1,1 } }\n"
            "}\nRobot r { Config=K }\n");
        QVERIFY2(loaded && !loaded->diagnostics.hasErrors(), sample::messages(*loaded).c_str());
        QCOMPARE(movesWith(*loaded, "RobotConfig." + path.toStdString(), {"RobotConfig." + other.toStdString()}), moves);
    }

    /// Those of the opened file, no parts.
    void configsThatAreShownAlone() {
        sample::PlanFixture fixture;
        const char* const body = " { Body a { Box x { Mass=1 Size=1,1,1 } } }\n";
        const auto loaded =
            fixture.open({{"main.sim", std::string("#import other.sim\nRobotConfig K") + body + "PartConfig P" + body},
                          {"other.sim", std::string("RobotConfig Other") + body}});
        QVERIFY(loaded);
        const auto shown = configsWithoutInstances(*loaded);
        QCOMPARE(shown.size(), std::size_t(1));
        QCOMPARE(shown[0]->name, std::string("K"));
        const auto placed = fixture.open(std::string("RobotConfig K") + body + "Robot r { Config=K }\n");
        QVERIFY(configsWithoutInstances(*placed).empty());
    }

    void namesAreLegal() {
        for (const auto& [given, made] :
             {std::pair("true", "true_"), {"world", "world_"}, {"3d", "_3d"}, {"", "_"}, {"a b", "a_b"}})
            QCOMPARE(legalised(given), std::string(made));
        QCOMPARE(legalised(std::string(80, 'a')).size(), std::size_t(60));
        for (const char* bad : {"", "3d", "a b", "world", "Param", "a.b"}) QVERIFY2(!legalName(bad), bad);
        QVERIFY(legalName("_3d") && legalName("worlds"));
        sample::PlanFixture fixture;
        const auto loaded = fixture.open("RobotConfig K { Param reach = 1 Body a { Box x { Mass=1 Size=1,1,1 } } }\n"
                                         "RobotConfig L { Body a { Box x { Mass=1 Size=1,1,1 } } }\nRobot r { Config=K }\nGrid "
                                         "swarm { Config=K Counts=2 Spacing=1 }\n");
        QVERIFY(loaded);
        UsedNames names(*loaded, nullptr, nullptr);
        QCOMPARE(names.take("r"), std::string("r2"));
        QCOMPARE(names.take("r"), std::string("r3"));
        QCOMPARE(names.take("r9"), std::string("r9"));
        QCOMPARE(names.take("r9"), std::string("r10"));
        const std::string digits = "x" + std::string(40, '9'); // too long for a number
        QCOMPARE(names.take(digits), digits);
        QVERIFY(names.take(digits) != digits);
        UsedNames inside(*loaded, loaded->outline->configs.find("K"), nullptr);
        QCOMPARE(inside.take("reach"), std::string("reach2"));
        QCOMPARE(inside.take("a"), std::string("a2"));
    }

    void textsOfValues() {
        QCOMPARE(wordOrQuoted("a\nb c", false).text(), std::string("\"a\\nb c\""));
        QCOMPARE(wordOrQuoted("word", true).text(), std::string("\"word\""));
        QCOMPARE(plainNumber(123456789012.5), std::string("123456789012.5"));
        Property degrees;
        degrees.unit = "deg";
        degrees.scale = kDegree;
        QCOMPARE(std::strtod(numberOf(degrees, 0.1234567891234 * kDegree).c_str(), nullptr), 0.1234567891234 * kDegree / kDegree);
        Property colour;
        colour.type = PropertyType::Number;
        colour.minCount = colour.maxCount = 3;
        colour.minimum = 0;
        colour.maximum = 1;
        QVERIFY(isColour(colour));
        colour.minimum = -1;
        QVERIFY(!isColour(colour));
    }
};

QTEST_APPLESS_MAIN(ObjectEdgesTest)
#include "object_edges_test.moc"
