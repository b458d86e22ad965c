// Repeat and Ring: each member is what its blocks say for its number. index in Grid and Scatter.
#include <QTest>

#include <cmath>

#include "model/resolve/resolve_steps.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n";
const std::string kChassis = "  Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n";
const std::string kRoller = "    Body b { Pos=0.01,0,0 Sphere t { Radius=$(0.01*(index+1)) Material=g Surface=s Mass=0.1 } }\n"
                            "    Hinge h { Parent=chassis Child=b Axis=0,1,0 }\n"
                            "    RotaryMotor m { Joint=h TorqueConstant=1 SpeedConstant=1 Resistance=$(1+index) }\n";

std::string robot(const std::string& blocks, const std::string& values = {}) {
    return "RobotConfig Kit {\n" + kChassis + blocks + "}\nRobot r { Config=Kit " + values + " }\n";
}

std::string kit(const std::string& blocks, const std::string& values = {}) { return kHead + robot(blocks, values); }

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

double resistance(const RobotConfigSpec& config, std::size_t device) {
    return config.devices.at(device).number("Resistance", -1);
}

} // namespace

class RepeatTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isThereSeveralTimes() {
        const Resolved r = resolved(kit("  Repeat roller { Count=3 Pos=$(index*0.1),0,0.2\n" + kRoller + "  }\n"));
        QCOMPARE(messagesOf(r), QString());
        const RobotConfigSpec& c = r.config();
        QCOMPARE(c.bodies.size(), std::size_t(4));
        QCOMPARE(c.bodies[3].name, std::string("roller_2.b"));
        QCOMPARE(c.bodies[3].pose.position, Vec3(0.2 + 0.01, 0, 0.2));
        QCOMPARE(c.bodies[3].geoms[0].radius, 0.03);
        QCOMPARE(c.joints[1].name, std::string("roller_1.h"));
        QCOMPARE(c.joints[1].parent, 0); // what the member does not have is looked up around it
        QCOMPARE(c.joints[1].child, 2);
        QCOMPARE(c.devices[2].text("Joint"), std::string("roller_2.h"));
        QCOMPARE(resistance(c, 2), 3.0);
    }

    /// The first count is the faster one.
    void countsInTwoDirections() {
        const Resolved r =
            resolved(kit("  Repeat dot { Count=3,2 Pos=$(index),$(10*index2),0 Body b { Sphere t { Radius=1 Material=g "
                         "Surface=s Mass=1 } } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies.size(), std::size_t(7));
        QCOMPARE(r.config().bodies[6].name, std::string("dot_5.b"));
        QCOMPARE(r.config().bodies[6].pose.position, Vec3(2, 10, 0));
        QCOMPARE(r.config().bodies[3].pose.position, Vec3(2, 0, 0));
    }

    void nests() {
        const Resolved r = resolved(kit("  Repeat row { Count=2 Param k=$index\n    Repeat col { Count=2 Pos=$(index),$(k*10),0\n"
                                        "      Body b { Sphere t { Radius=1 Material=g Surface=s Mass=1 } } } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies[3].name, std::string("row_1.col_0.b"));
        QCOMPARE(r.config().bodies[4].pose.position, Vec3(1, 10, 0));
    }

    /// A Part in a Repeat takes values that depend on the number, and names what is around the Repeat.
    void holdsParts() {
        const Resolved r =
            resolved(kHead +
                     "PartConfig Wheel { Param r = 1 Body w { Sphere t { Radius=$r Material=g Surface=s Mass=1 } }\n"
                     "  Hinge h { Parent=$carrier Child=w } }\n" +
                     robot("  Repeat wheel { Count=2 Part p { Config=Wheel carrier=chassis r=$(index+2) Pos=$(index),0,0 } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies[2].name, std::string("wheel_1.p.w"));
        QCOMPARE(r.config().bodies[2].geoms[0].radius, 3.0);
        QCOMPARE(r.config().joints[1].parent, 0);
    }

    /// A Part with a Repeat in it, mirrored: the members too; `$carrier` in a Repeat is a Param of the PartConfig.
    void isInParts() {
        const Resolved r =
            resolved(kHead +
                     "PartConfig Side { Param n = 2 Repeat wheel { Count=$n Pos=$(index),1,0\n"
                     "  Body w { Sphere t { Radius=1 Material=g Surface=s Mass=1 } } Hinge h { Parent=$carrier Child=w } } }\n" +
                     robot("  Part left { Config=Side carrier=chassis }\n"
                           "  Part right { Config=Side carrier=chassis Mirror=y n=3 }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies.size(), std::size_t(6));
        QCOMPARE(r.config().bodies[5].name, std::string("right.wheel_2.w"));
        QCOMPARE(r.config().bodies[5].pose.position, Vec3(2, -1, 0));
        QCOMPARE(r.config().joints[4].parent, 0);
    }

    /// Overrides of one member hold before those of all.
    void takesOverrides() {
        const Resolved r = resolved(kit("  Repeat roller { Count=3\n" + kRoller + "  }\n",
                                        "roller.m.Resistance=7 roller_1.m.Resistance=9 roller.Count=4"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().devices.size(), std::size_t(4));
        QCOMPARE(resistance(r.config(), 0), 7.0);
        QCOMPARE(resistance(r.config(), 1), 9.0);
        QCOMPARE(resistance(r.config(), 3), 7.0);
    }

    void ringTurnsItsMembers_data() {
        QTest::addColumn<QString>("axis");
        QTest::addColumn<QVector<double>>("first");
        QTest::addColumn<QVector<double>>("second");
        QTest::newRow("z") << "0,0,1" << QVector<double>{3, 0, 0} << QVector<double>{1, 2, 0};
        QTest::newRow("y") << "0,2,0" << QVector<double>{3, 0, 0} << QVector<double>{1, 0, -2};
        QTest::newRow("x") << "1,0,0" << QVector<double>{1, 2, 0} << QVector<double>{1, 0, 2};
        // Inclined: the first is where x points to, across the axis, by the whole Radius.
        QTest::newRow("between x and z") << "3,0,4" << QVector<double>{2.6, 0, -1.2} << QVector<double>{1, 2, 0};
        const double third = 2 / (3 * std::sqrt(5.)); // across 2,1,2: along 5,-2,-4, then along 0,2,-1
        QTest::newRow("all") << "2,1,2" << QVector<double>{1 + 5 * third, -2 * third, -4 * third}
                             << QVector<double>{1, 6 * third, -3 * third};
    }
    void ringTurnsItsMembers() {
        QFETCH(QString, axis);
        QFETCH(QVector<double>, first);
        QFETCH(QVector<double>, second);
        const Resolved r = resolved(kit("  Ring spoke { Count=4 Radius=2 Pos=1,0,0 Axis=" + axis.toStdString() +
                                        " Body b { Sphere t { Radius=1 Material=g Surface=s Mass=$(1+index) } } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies.size(), std::size_t(5));
        QVERIFY((r.config().bodies[1].pose.position - Vec3(first.data())).norm() < 1e-12);
        QVERIFY((r.config().bodies[2].pose.position - Vec3(second.data())).norm() < 1e-12);
        const Quat turn = r.config().bodies[2].pose.rotation; // each is turned with the ring
        QVERIFY((turn * (Vec3(first.data()) - Vec3(1, 0, 0)) - (Vec3(second.data()) - Vec3(1, 0, 0))).norm() < 1e-12);
        QCOMPARE(r.config().bodies[4].mass.mass, 4.0);
    }

    void repeatsScenery() {
        const Resolved r =
            resolved(kHead + "StaticConfig Fence { Repeat post { Count=5 Pos=$(index),0,0.5 Box b { "
                             "Size=0.1,0.1,$(1+0.1*index) Material=g Surface=s } } }\nStatic f { Config=Fence }\n");
        QCOMPARE(messagesOf(r), QString());
        const std::vector<GeomSpec>& geoms = *r.experiment->statics.at(0).geoms;
        QCOMPARE(geoms.size(), std::size_t(5));
        QCOMPARE(geoms[4].name, std::string("post_4.b"));
        QCOMPARE(geoms[4].pose.position, Vec3(4, 0, 0.5));
        QCOMPARE(geoms[4].size.z(), 1.4);
    }

    /// Each member of a Grid has values of its own, of its config and of its controller.
    void numbersMembersOfLayouts() {
        const Resolved r =
            resolved(kHead + "RobotConfig Kit { Param side = 1 Body b { Box hull { Size=$side,$side,$side Material=g "
                             "Surface=s Mass=1 } } }\n"
                             "Grid g { Config=Kit Count=3,2 Spacing=5 side=$(1+0.1*index+index2) b.hull.Mass=$(1+index) }\n"
                             "Scatter s { Config=Kit Count=3 Area=20,20,40,40 side=$(1+index) }\n");
        QCOMPARE(messagesOf(r), QString());
        const auto size = [&](std::size_t robot) { return r.experiment->robots.at(robot).config->bodies[0].geoms[0].size.x(); };
        QCOMPARE(size(0), 1.0);
        QCOMPARE(size(2), 1.2);
        QCOMPARE(size(5), 2.2);
        QCOMPARE(size(8), 3.0);
        QCOMPARE(r.experiment->robots[4].config->bodies[0].mass.mass, 2.0);
    }

    void reportsWhatIsWrong_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << message;
        };
        const std::string body = "Body b { Sphere t { Radius=1 Material=g Surface=s Mass=1 } }";
        row("outside",
            kit("  Repeat a { Count=2 " + body +
                " }\n  Body c { Pos=$(index),0,0 Sphere t { Radius=1 Material=g Surface=s "
                "Mass=1 } }\n"),
            "there is no Param index");
        row("second", kit("  Repeat a { Count=2 Pos=$index2,0,0 " + body + " }\n"), "there is no Param index2");
        row("count", kit("  Repeat a { Count=$(index+2) " + body + " }\n"), "there is no Param index");
        row("none", kit("  Repeat a { Count=0 " + body + " }\n"), "Count is 0, it must be from 1 to 200000");
        row("many", kit("  Repeat a { Count=1000,1000 " + body + " }\n"), "would be configs of more than 200000 objects");
        row("many by a value", kit("  Param n=1\n  Repeat a { Count=$n,200 " + body + " }\n", "n=100000"),
            "would hold more than 200000 objects");
        row("member", kit("  Repeat a { Count=2 " + body + " }\n", "a_2.b.Mass=1"),
            "Repeat a has no member a_2; the last one is a_1");
        row("taken",
            kit("  Repeat a { Count=2 " + body + " }\n  Body a_1 { Mass=1 Sphere t { Radius=1 Material=g Surface=s } }\n"),
            "the name a_1 belongs to a member of Repeat a");
        row("name", kit("  Repeat a { Count=2 " + body + " Hinge h { Parent=chasis Child=b } }\n"), "Parent names chasis");
        row("member of it", kit("  Repeat a { Count=2 " + body + " }\n  Hinge h { Parent=chassis Child=a.b }\n"),
            "Child names a.b");
        row("last member", kit("  Repeat a { Count=2 " + body + " }\n  Hinge h { Parent=chassis Child=a_2.b }\n"),
            "Child names a_2.b");
        row("axis", kit("  Ring a { Count=2 Radius=1 Axis=0,0,0 " + body + " }\n"), "the Axis of Ring a is zero");
        row("geom", kit("  Repeat a { Count=2 Box x { Size=1,1,1 } }\n"), "not in a Repeat of a RobotConfig");
        row("robot", kHead + "Robot r { Repeat x { Count=2 } }\n", "Repeat is allowed in a RobotConfig");
    }
    void reportsWhatIsWrong() {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const Resolved r = resolved(text.toStdString());
        QVERIFY2(messagesOf(r).contains(message), r.messages().c_str());
    }

    /// What is wrong in the blocks of a Repeat is reported once, not for every member.
    void reportsOnce() {
        const Resolved r =
            resolved(kit("  Repeat a { Count=50 Body b { Sphere t { Radius=$(0-1-index) Material=g Surface=s Mass=1 } } }\n"));
        QCOMPARE(r.diagnostics.errorCount(), std::size_t(1));
    }

    void fifteenThousandMembersAreResolved() {
        const Resolved r =
            resolved(kit("  Repeat a { Count=100,150 Body b { Sphere t { Radius=1 Material=g Surface=s Mass=1 } } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().bodies.size(), std::size_t(15001));
    }
};

QTEST_APPLESS_MAIN(RepeatTest)
#include "repeat_test.moc"
