// The header of Properties: where an object comes from, and where a change of it goes.
#include "properties_fixture.h"

using namespace trundle;

class ObjectHeaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// What is inside a Part comes from its PartConfig, and the Part takes the override.
    void namesTheConfigOfAPart() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("PartConfig Wheel { Body disc { Pos=0,0.1,0.05 Sphere ball { Radius=0.05 Mass=1 Material=grey Surface=rubber } }\n"
                             "  Fixed weld { Parent=$carrier Child=disc } }\n"
                             "RobotConfig Cart { Body hull { Pos=0,0,0.05 Box box { Size=0.1,0.1,0.05 Mass=1 Material=grey Surface=rubber } }\n"
                             "  Part left { Config=Wheel carrier=hull }\n  Part right { Config=Wheel carrier=hull Mirror=y } }\n"
                             "Robot cart { Config=Cart }\n"));
        const auto header = [&] { return fixture.panel.findChild<QLabel*>(QStringLiteral("objectConfig"))->text(); };
        fixture.selection.select("cart.hull.box");
        QVERIFY2(header().contains(u">Cart</a>"_qs) && header().contains(u"go into Cart in main.sim: only cart is created"_qs),
                 qPrintable(header()));
        fixture.selection.select("cart.right.disc.ball");
        QVERIFY2(header().contains(u"select:PartConfig.Wheel"_qs) && header().contains(u"main.sim:2<"_qs) &&
                     header().contains(u"Values of Wheel that are changed here become overrides of right in main.sim."_qs),
                 qPrintable(header()));
        fixture.type("Mass", QStringLiteral("2"));
        QVERIFY2(fixture.text().find("Mirror=y disc.ball.Mass=2 }") != std::string::npos, fixture.text().c_str());
    }

    /// In the model of a robot that came with Trundle: the config that has the Part is copied.
    void saysThatAPartOfAShippedRobotIsCopied() {
        PropertiesFixture fixture;
        QVERIFY(fixture.open("#import robots/car.sim\nRobot car { Config=Car }\n"));
        const auto header = [&] { return fixture.panel.findChild<QLabel*>(QStringLiteral("objectConfig"))->text(); };
        for (const auto& [path, config] : {std::pair{"RobotConfig.Car.frontRight.wheel.wheel.tyre", u"Car"_qs},
                                           std::pair{"RobotConfig.Car.frontRight", u"Car"_qs},
                                           std::pair{"PartConfig.CarFront.wheel.wheel.tyre", u"CarFront"_qs}}) {
            fixture.selection.select(path);
            QVERIFY2(
                header().contains(config + u" came with Trundle and is read-only: a change makes a copy of it in main.sim."_qs),
                qPrintable(header()));
        }
        fixture.document.edits().restoreSelection(fixture.selection);
        fixture.selection.select("RobotConfig.Car.frontRight.knuckle.block");
        QVERIFY(fixture.choose("Mass", "rowPull")); // writes what is there into the Part
        QVERIFY2(fixture.text().find("body=chassis knuckle.block.Mass=0.04 }") != std::string::npos, fixture.text().c_str());
        QCOMPARE(fixture.selection.current(), std::string("RobotConfig.Car2.frontRight.knuckle.block"));
        QVERIFY(fixture.choose("Mass", "rowReset"));
        QVERIFY2(fixture.text().find("knuckle.block.Mass") == std::string::npos, fixture.text().c_str());
        fixture.selection.select("car.frontRight.knuckle.block");
        QVERIFY2(header().contains(u"become overrides of car in main.sim"_qs), qPrintable(header()));
    }
};

QTEST_MAIN(ObjectHeaderTest)
#include "object_header_test.moc"
