// Springs and Gears as they are resolved: defaults, Parts and their mirror images, and what cannot be coupled.
#include <QTest>

#include "model/gear_line.h"
#include "model/resolve/resolve_steps.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

std::string robot(const std::string& blocks, const std::string& before = "") {
    const auto body = [](const char* name, const char* pos) {
        return std::string("  Body ") + name + " { Pos=" + pos + " Box box { Size=0.1,0.1,0.1 Material=g Surface=s Mass=1 } }\n";
    };
    return "Material g { } Surface s { }\n" + before + "RobotConfig Kit {\n" + body("base", "0,0,1") + body("one", "0.1,0.2,1") +
           body("two", "0.3,0.2,1") + blocks + "}\nRobot r { Config=Kit }\n";
}

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

/// That the force of a gear acts along the second line `share` times as it does along the first, as the lever says.
void checkLine(const JointLine& first, const JointLine& second, double share) {
    const auto line = gearLine(first, second, share);
    QVERIFY(line);
    QVERIFY(std::abs(line->direction.norm() - 1) < 1e-12);
    const auto along = [&](const JointLine& j) {
        if (j.slides || line->isTorque) return j.axis.dot(line->direction);
        return j.axis.dot((line->point - j.point).cross(line->direction));
    };
    QVERIFY2(std::abs(along(first) - line->lever) < 1e-9 * std::abs(line->lever), qPrintable(QString::number(along(first))));
    QVERIFY2(std::abs(along(second) - share * line->lever) < 1e-9 * std::max(1.0, std::abs(share * line->lever)),
             qPrintable(QString::number(along(second) / line->lever)));
}

} // namespace

class CouplingsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void springHasDefaults() {
        const Resolved r = resolved(robot("  Spring a { Parent=base Child=two }\n"
                                          "  Spring b { Parent=world Child=one Anchor=0.1,0.2,2 Anchor2=0.1,0.2,1.5 Length=10cm "
                                          "Stiffness=200 Damping=3 }\n"));
        QCOMPARE(messagesOf(r), QString());
        const auto& springs = r.config().springs;
        QCOMPARE(springs.size(), std::size_t(2));
        QVERIFY(springs[0].parent == 0 && springs[0].child == 2 && springs[0].stiffness == 0);
        QVERIFY(springs[0].anchor == Vec3(0, 0, 1) && springs[0].anchor2 == Vec3(0.3, 0.2, 1));
        QVERIFY(springs[0].length == Vec3(0.3, 0.2, 0).norm());
        QVERIFY(springs[1].parent == kWorldBody && springs[1].anchor == Vec3(0.1, 0.2, 2));
        QVERIFY(springs[1].length == 0.1 && springs[1].stiffness == 200 && springs[1].damping == 3);
        QCOMPARE(r.config().joints.size(), std::size_t(0));
    }

    void gearNamesItsJoints() {
        const Resolved r = resolved(robot("  Gear g { Joint=b Other=a Ratio=-2.5 }\n" // joints may come later
                                          "  Hinge a { Parent=base Child=one }\n  Hinge b { Parent=base Child=two }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().gears.size(), std::size_t(1));
        const GearSpec& g = r.config().gears[0];
        QVERIFY(g.joint == 1 && g.other == 0 && g.ratio == -2.5);
    }

    void mirrorsSpringsAndRest() {
        const std::string part = "PartConfig Leg {\n  Body foot { Pos=0.1,0.2,0 Box box { Size=0.1,0.1,0.1 Material=g Surface=s "
                                 "Mass=1 } }\n  Hinge knee { Parent=$carrier Child=foot Axis=0,0,1 RestAngle=30 Stiffness=5 }\n"
                                 "  Spring coil { Parent=$carrier Child=foot Anchor=0,0.05,0.3 Stiffness=100 } }\n";
        const Resolved r = resolved(robot("  Part left { Config=Leg carrier=base }\n"
                                          "  Part right { Config=Leg carrier=base Mirror=y Pos=0,0,0.1 }\n",
                                          part));
        QCOMPARE(messagesOf(r), QString());
        const auto& springs = r.config().springs;
        QCOMPARE(springs.size(), std::size_t(2));
        QCOMPARE(springs[1].name, std::string("right.coil"));
        QVERIFY(springs[0].anchor == Vec3(0, 0.05, 0.3) && springs[1].anchor == Vec3(0, -0.05, 0.3 + 0.1));
        QVERIFY(springs[0].anchor2 == Vec3(0.1, 0.2, 0) && springs[1].anchor2 == Vec3(0.1, -0.2, 0.1));
        QVERIFY(springs[1].parent == 0 && springs[1].child == 4);
        QCOMPARE(r.config().joints[0].rest, -r.config().joints[1].rest); // its sense is reversed
    }

    void mirrorsGears_data() {
        QTest::addColumn<QString>("axis");
        QTest::addColumn<QString>("axis2");
        QTest::addColumn<QString>("kind2");
        QTest::addColumn<QString>("mirror");
        QTest::addColumn<double>("sign");
        QTest::newRow("wheels on upright axles") << "0,0,1"
                                                 << "0,0,1"
                                                 << "Hinge"
                                                 << "y" << 1.0;
        QTest::newRow("wheels on axles across") << "0,1,0"
                                                << "0,1,0"
                                                << "Hinge"
                                                << "y" << 1.0;
        QTest::newRow("bevel gear") << "0,0,1"
                                    << "0,1,0"
                                    << "Hinge"
                                    << "y" << -1.0;
        QTest::newRow("bevel gear along the mirror") << "0,0,1"
                                                     << "1,0,0"
                                                     << "Hinge"
                                                     << "y" << 1.0;
        QTest::newRow("rack forwards") << "0,1,0"
                                       << "1,0,0"
                                       << "Slider"
                                       << "y" << 1.0;
        QTest::newRow("rack forwards, upright axle") << "0,0,1"
                                                     << "1,0,0"
                                                     << "Slider"
                                                     << "y" << -1.0;
        QTest::newRow("rack forwards, mirrored to the back") << "0,1,0"
                                                             << "1,0,0"
                                                             << "Slider"
                                                             << "x" << -1.0;
    }
    /// The mirror image of a train turns as the train does, seen in the mirror.
    void mirrorsGears() {
        QFETCH(QString, axis);
        QFETCH(QString, axis2);
        QFETCH(QString, kind2);
        QFETCH(QString, mirror);
        QFETCH(double, sign);
        const std::string box = " Box box { Size=0.1,0.1,0.1 Material=g Surface=s Mass=1 } }\n";
        const std::string part = "PartConfig Train {\n  Body a { Pos=0.1,0.2,0" + box + "  Body b { Pos=0.1,0.3,0.1" + box +
                                 "  Hinge j { Parent=$carrier Child=a Axis=" + axis.toStdString() + " }\n  " +
                                 kind2.toStdString() + " k { Parent=$carrier Child=b Axis=" + axis2.toStdString() +
                                 " }\n  Gear g { Joint=j Other=k Ratio=3 } }\n";
        const Resolved r = resolved(robot("  Part left { Config=Train carrier=base }\n  Part right { Config=Train carrier=base "
                                          "HPR=40,10,5 Mirror=" +
                                              mirror.toStdString() + " }\n",
                                          part));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().gears.size(), std::size_t(2));
        QCOMPARE(r.config().gears[0].ratio, 3.0);
        QCOMPARE(r.config().gears[1].ratio, 3 * sign);
    }

    void repeats() {
        const Resolved r =
            resolved(robot("  Repeat leg { Count=3 Pos=$(0.5*index),0,0\n"
                           "    Body foot { Pos=0,0,0.1 Box box { Size=0.1,0.1,0.1 Material=g Surface=s Mass=1 } }\n"
                           "    Spring coil { Parent=base Child=foot Anchor=0,0,1 Stiffness=$(100*(index+1)) } }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().springs.size(), std::size_t(3));
        QCOMPARE(r.config().springs[2].name, std::string("leg_2.coil"));
        QVERIFY(r.config().springs[2].stiffness == 300 && r.config().springs[2].anchor == Vec3(1, 0, 1));
    }

    void refusesWhatCannotBe_data() {
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* blocks, const char* expected) { QTest::newRow(expected) << blocks << expected; };
        const char* const hinges = "Hinge a { Parent=base Child=one Axis=0,0,1 } Hinge b { Parent=base Child=two Axis=0,0,1 } ";
        const auto geared = [&](const char* gear) { return QByteArray(hinges) + gear; };
        row(geared("Gear g { Joint=a Other=a Ratio=1 }"), "Gear g couples a with itself");
        row(geared("Gear g { Joint=a Other=b Ratio=0 }"), "the Ratio of Gear g is zero");
        row(geared("Gear g { Joint=a Other=c Ratio=1 }"), "c");
        row("Hinge a { Parent=base Child=one } Hinge b { Parent=world Child=two } Gear g { Joint=a Other=b Ratio=1 }",
            "a and b need one body in common");
        row("Hinge a { Parent=base Child=one Anchor=0,0,0 } Hinge b { Parent=base Child=two Anchor=0,0,3 } "
            "Gear g { Joint=a Other=b Ratio=-1 }",
            "a and b turn about the same line");
        row("Slider a { Parent=base Child=one } Slider b { Parent=base Child=two } Gear g { Joint=a Other=b Ratio=-1 }",
            "a and b slide in parallel");
        row("Ball a { Parent=base Child=one } Hinge b { Parent=base Child=two } Gear g { Joint=a Other=b Ratio=1 }",
            "Joint names a, a Ball; it takes a Hinge or Slider");
        row("Spring s { Parent=one Child=one }", "the child of Spring s is its parent as well");
        row("Universal u { Parent=base Child=one LowStop2=3 HighStop2=2 }", "the LowStop2 of Universal u is above its HighStop2");
    }
    void refusesWhatCannotBe() {
        QFETCH(QString, blocks);
        QFETCH(QString, expected);
        const Resolved r = resolved(robot(blocks.toStdString() + "\n"));
        QVERIFY2(messagesOf(r).contains(expected), qPrintable(messagesOf(r)));
    }

    void linesActOnBothJoints() {
        const JointLine up{false, {0, 0, 1}, Vec3::UnitZ()}, tilted{false, {0.2, 0.1, 0.4}, Vec3(0, 0.6, 0.8)};
        const JointLine beside{false, {0.3, 0.4, -2}, Vec3::UnitZ()}, against{false, {0.3, 0.4, -2}, -Vec3::UnitZ()};
        const JointLine rack{true, {0.3, 0, 0}, Vec3(0.6, 0.8, 0)}, screw{true, {1, 1, 1}, Vec3::UnitZ()},
            aslant{true, {1, 1, 1}, Vec3(0.6, 0, 0.8)};
        for (const double share : {-3.0, -1.0, -0.02, 0.5, 1.0, 7.0})
            for (const JointLine& other : {tilted, beside, against, rack, screw, aslant}) {
                checkLine(up, other, share);
                checkLine(other, up, share);
                checkLine(tilted, other.point == tilted.point ? up : other, share);
            }
        checkLine(rack, aslant, -2);
        QVERIFY(!gearLine(up, {false, {0, 0, 5}, Vec3::UnitZ()}, -1));
        QVERIFY(gearLine(up, {false, {0, 0, 5}, Vec3::UnitZ()}, 1));
        QVERIFY(!gearLine(rack, rack, 2));
    }

    /// The wheels are where the joints are: a mirror image, whose axes have either sense, is the image of it.
    void theGearOfAMirrorImageIsItsImage() {
        const JointLine first{false, {0.3, -0.1, 0.4}, Vec3(1, 2, -0.5).normalized()};
        const JointLine second{false, {0.5, 0.2, 0.1}, Vec3(-0.4, 1, 1.2).normalized()};
        const auto image = [](const Vec3& v) { return Vec3(v.x(), -v.y(), v.z()); };
        for (const double share : {-2.7, -0.4, 0.8, 3.}) {
            const auto whole = gearLine(first, second, share);
            QVERIFY(whole);
            for (const double sense : {1., -1.}) {
                const JointLine a{false, image(first.point), sense * image(first.axis)},
                    b{false, image(second.point), sense * image(second.axis)};
                const auto mirrored = gearLine(a, b, share);
                QVERIFY(mirrored);
                QVERIFY((mirrored->point - image(whole->point)).norm() < 1e-12);
                checkLine(a, b, share);
            }
        }
    }
};

QTEST_APPLESS_MAIN(CouplingsTest)
#include "couplings_test.moc"
