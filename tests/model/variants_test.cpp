// Variants: a config made from another one, with values for its Params and for what is in it, and blocks added.
#include <QTest>

#include "model/provenance.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kKit = "Material g { } Surface s { }\n"
                         "RobotConfig Kit { Param r = 0.05 Param d = $(2*r) SelfCollision=true\n"
                         "  Body chassis { Box hull { Size=1,1,$d Material=g Surface=s } Mass=1 }\n"
                         "  Body wheel { Sphere t { Radius=$r Material=g Surface=s Mass=1 } }\n"
                         "  Hinge axle { Parent=chassis Child=wheel }\n"
                         "  RotaryMotor motor { Joint=axle TorqueConstant=1 SpeedConstant=1 Resistance=2 }\n"
                         "  Repeat pin { Count=2 Body p { Sphere t { Radius=0.1 Material=g Surface=s Mass=1 } } } }\n";

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

} // namespace

class VariantsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void hasValuesAndBlocksOfItsOwn() {
        const Resolved r =
            resolved(kKit + "RobotConfig Big { Config=Kit r=0.07 motor.Resistance=5 chassis.Mass=3 Param x = $r\n"
                            "  Body mast { Sphere t { Radius=$(x+d) Material=g Surface=s Mass=1 } }\n"
                            "  Fixed hold { Parent=chassis Child=mast } }\n"
                            "Robot a { Config=Big } Robot b { Config=Kit } Robot c { Config=Big r=0.1 motor.Resistance=9 }\n");
        QCOMPARE(messagesOf(r), QString());
        const auto robot = [&](std::size_t i) -> const RobotConfigSpec& { return *r.experiment->robots.at(i).config; };
        QCOMPARE(robot(0).bodies.size(), std::size_t(5));
        QCOMPARE(robot(0).bodies[1].geoms[0].radius, 0.07);
        QCOMPARE(robot(0).bodies[0].geoms[0].size.z(), 0.14); // a Param that depends on another one
        QCOMPARE(robot(0).bodies[4].geoms[0].radius, 0.07 + 0.14);
        QCOMPARE(robot(0).devices[0].number("Resistance", 0), 5.0);
        QCOMPARE(robot(0).joints[1].parent, 0);
        QVERIFY(robot(0).selfCollision);
        QCOMPARE(robot(1).bodies[1].geoms[0].radius, 0.05);
        QCOMPARE(robot(1).devices[0].number("Resistance", 0), 2.0);
        QCOMPARE(robot(2).bodies[1].geoms[0].radius, 0.1);
        QCOMPARE(robot(2).devices[0].number("Resistance", 0), 9.0);
    }

    /// A variant of a variant: the last value holds; properties of the config itself too.
    void ofVariants() {
        const Resolved r =
            resolved(kKit + "RobotConfig B { Config=A motor.Resistance=4 SelfCollision=false }\n"
                            "RobotConfig A { Config=Kit r=0.2 motor.Resistance=3 motor.TorqueConstant=7 pin.Count=3 }\n"
                            "Robot b { Config=B pin_1.p.Pos=1,2,3 }\n");
        QVERIFY(!r.diagnostics.hasErrors());
        QCOMPARE(r.config().bodies.size(), std::size_t(5));
        QCOMPARE(r.config().bodies[3].pose.position, Vec3(1, 2, 3));
        QCOMPARE(r.config().devices[0].number("Resistance", 0), 4.0);
        QCOMPARE(r.config().devices[0].number("TorqueConstant", 0), 7.0);
        QCOMPARE(r.config().bodies[1].geoms[0].radius, 0.2);
        QVERIFY(!r.config().selfCollision);
    }

    void ofPartsAndScenery() {
        const Resolved r =
            resolved("Material g { } Surface s { }\n"
                     "PartConfig Wheel { Param r = 0.1 Body w { Sphere t { Radius=$r Material=g Surface=s Mass=1 } } Hinge h { "
                     "Parent=$carrier Child=w } }\n"
                     "PartConfig Large { Config=Wheel r=0.3 Body cap { Sphere t { Radius=0.1 Material=g Surface=s Mass=1 } }\n"
                     "  Fixed f { Parent=w Child=cap } Fixed again { Parent=$carrier Child=cap } }\n"
                     "RobotConfig Kit { Body hub { Box b { Size=1,1,1 Material=g Surface=s Mass=1 } } Part l { Config=Large "
                     "carrier=hub Pos=0,1,0 }\n"
                     "  Part k { Config=Large carrier=hub r=0.4 } }\n"
                     "StaticConfig Fence { Param h = 1 Box post { Size=1,1,$h Material=g Surface=s } }\n"
                     "StaticConfig High { Config=Fence h=2 Box more { Size=1,1,1 Material=g Surface=s } }\n"
                     "Static f { Config=High }\nRobot r { Config=Kit l.w.Pos=0,0,1 }\n");
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies[1].name, std::string("l.w"));
        QCOMPARE(r.config().bodies[1].pose.position, Vec3(0, 1, 1));
        QCOMPARE(r.config().bodies[1].geoms[0].radius, 0.3);
        QCOMPARE(r.config().bodies[3].geoms[0].radius, 0.4);
        QCOMPARE(r.config().joints[1].parent, 1);
        QCOMPARE(r.config().joints[2].parent, 0);
        QCOMPARE(r.experiment->statics[0].geoms->size(), std::size_t(2));
        QCOMPARE(r.experiment->statics[0].geoms->at(0).size.z(), 2.0);
    }

    void provenance() {
        const Resolved r = resolved(kKit + "RobotConfig Big { Config=Kit motor.Resistance=5 }\nRobot a { Config=Big }\n");
        const auto from = provenanceOf(*r.outline, "a.motor.Resistance");
        QVERIFY(from);
        QCOMPARE(r.outline->texts().slice(from->value), std::string_view("5"));
        QCOMPARE(r.outline->texts().slice(provenanceOf(*r.outline, "a.motor.SpeedConstant")->value), std::string_view("1"));
    }

    void reportsWhatIsWrong_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(kKit + text) << message;
        };
        row("circle", "RobotConfig A { Config=B }\nRobotConfig B { Config=A }\n",
            "E302 RobotConfigs are variants of each other in a circle: A > B > A\n");
        row("itself", "RobotConfig A { Config=A }\n", "E302 RobotConfigs are variants of each other in a circle: A > A\n");
        row("unknown", "RobotConfig A { Config=Kid r=3 motor.Resistance=4 }\n",
            "E208 Config names Kid, but there is no such RobotConfig\n");
        row("other kind", "StaticConfig F { Box b { Size=1,1,1 Material=g Surface=s } }\nRobotConfig A { Config=F }\n",
            "E208 Config names F, a StaticConfig; a RobotConfig takes a RobotConfig\n");
        row("name", "RobotConfig A { Config=Kit Body wheel { Mass=1 Sphere t { Radius=1 Material=g Surface=s } } }\n",
            "E303 RobotConfig Kit has Body wheel already; set its values by path, wheel. ...\n");
        row("Param", "RobotConfig A { Config=Kit Param r = 1 }\n",
            "E303 RobotConfig Kit has a Param r already; set its value: r=...\n");
        row("path", "RobotConfig A { Config=Kit moter.Resistance=4 }\n",
            "E314 RobotConfig Kit has no moter; it has chassis, wheel, axle, motor and pin\n");
        row("property", "RobotConfig A { Config=Kit rr=4 }\n", "E201 RobotConfig A has no property rr\n");
        row("controller", "RobotConfig A { Config=Kit }\nRobot a { Config=A Walker motor { } }\n",
            "E303 the name motor is taken by RotaryMotor motor of RobotConfig A\n");
        row("controller named like a member",
            "RobotConfig A { Config=Kit }\nGrid a { Config=A Count=2 Spacing=3 Walker pin_1 { } }\n",
            "E303 the name pin_1 is taken by Repeat pin of RobotConfig A\n");
        row("value", "RobotConfig A { Config=Kit r=-1 }\n", "E203 Radius is -1, it must be above 0\n");
    }
    void reportsWhatIsWrong() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const Resolved r = resolved(text.toStdString());
        QVERIFY2(messagesOf(r).contains(message), r.messages().c_str());
    }
};

QTEST_APPLESS_MAIN(VariantsTest)
#include "variants_test.moc"
