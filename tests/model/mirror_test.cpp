// Mirror images that rounding or frames could get wrong: axes at 45 degrees, antennas, and what counts from a body by In.
#include <numbers>

#include <QTest>

#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kGeom = "Box g { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s }";

/// `@` in the texts is a geom.
Resolved kit(const std::string& before, const std::string& blocks) {
    std::string all = "Material m { } Surface s { }\n" + before + "RobotConfig Kit {\n" + blocks + "}\nRobot r { Config=Kit }\n";
    for (std::size_t at = 0; (at = all.find('@', at)) != std::string::npos; at += kGeom.size()) all.replace(at, 1, kGeom);
    return resolved(all);
}
QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

} // namespace

class MirrorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// As far from its mirror image as from the reverse of that, an axis takes the image, whatever the rotation around it rounds to.
    void anAxisAt45DegreesTakesTheImage() {
        for (int heading = -135; heading <= 315; heading += 90) {
            const std::string text = std::to_string(heading);
            const Resolved r =
                kit("PartConfig A { Body w { @ } Hinge h { Parent=$on Child=w Axis=1,0,0 LowStop=-10 HighStop=20 } }\n"
                    "PartConfig B { Part a { Config=A HPR=" +
                        text + ",0,0 on=$on } }\n",
                    "Body base { @ } Part p { Config=B on=base } Part v { Config=B Mirror=x on=base }\n");
            QCOMPARE(messagesOf(r), QString());
            const JointSpec &described = r.config().joints[0], &image = r.config().joints[1];
            QVERIFY((image.axis - Vec3(described.axis.x(), -described.axis.y(), 0)).norm() < 1e-12);
            QCOMPARE(image.lowStop, described.lowStop);
        }
    }

    /// Turning one way about an axis is turning the other way in the mirror, or about the reverse of its image.
    void stopsOfAUniversalAreMirrored() {
        for (const char* mirror : {"x", "y", "z"})
            for (const auto& [first, second] :
                 {std::pair("0,1,0", "1,0,0"), std::pair("1,0,0", "0,1,0"), std::pair("0,0,1", "1,0,0")}) {
                const Resolved m = kit(std::string("PartConfig A { Body w { @ } Universal u { Parent=$on Child=w Axis=") + first +
                                           " Axis2=" + second + " LowStop=-10 HighStop=20 LowStop2=-30 HighStop2=40 } }\n",
                                       std::string("Body base { @ } Part p { Config=A on=base } Part v { Config=A Mirror=") +
                                           mirror + " on=base }\n");
                QCOMPARE(messagesOf(m), QString());
                const JointSpec &u = m.config().joints.at(0), &image = m.config().joints.at(1);
                const int normal = mirror[0] - 'x';
                const auto check = [&](const Vec3& axis, const Vec3& other, double low, double high, double otherLow,
                                       double otherHigh) {
                    Vec3 turned = -axis; // an axis of rotation is reversed but for what is along the mirror's normal
                    turned[normal] = axis[normal];
                    const bool isSame = (other - turned).norm() < 1e-12;
                    QVERIFY(isSame || (other + turned).norm() < 1e-12);
                    QCOMPARE(otherLow, isSame ? low : -high);
                    QCOMPARE(otherHigh, isSame ? high : -low);
                };
                check(u.axis, image.axis, *u.lowStop, *u.highStop, *image.lowStop, *image.highStop);
                check(u.axis2, image.axis2, *u.lowStop2, *u.highStop2, *image.lowStop2, *image.highStop2);
            }
    }

    /// A gear sees the same image, seen from any side.
    void aGearOfSuchAnAxisRunsTheSameWay() {
        for (const char* heading : {"0", "5", "12", "37", "77", "90", "143", "-23"}) {
            const Resolved r =
                kit("PartConfig A { Body p { @ } Body q { Pos=0,0,0.3 @ } Hinge hp { Parent=$on Child=p Axis=1,1,0 }\n"
                    "  Hinge hq { Parent=$on Child=q Axis=0,0,1 } Gear g { Joint=hp Other=hq Ratio=-0.5 } }\n",
                    std::string("Body base { @ } Part a { Config=A Mirror=y HPR=") + heading + ",0,0 on=base }\n");
            QCOMPARE(messagesOf(r), QString());
            QCOMPARE(r.config().gears.at(0).ratio, 0.5); // the mirror reverses the hinge about z alone
        }
    }

    /// What an antenna sends to the left it sends to the right; one that is symmetric, or mirrored twice, is what it was.
    void antennasAreMirrored() {
        const Resolved r =
            kit("AntennaPattern side { Azimuth=-170,-20, -90,-12, 0,0, 60,2, 180,-20 Elevation=-30,-9, 0,0, 60,-12 }\n"
                "PartConfig A { Body b { @ } Transceiver t { Antenna=side } Transceiver d { Antenna=dipole } }\n"
                "PartConfig B { Part a { Config=A Mirror=z } }\n",
                "Part l { Config=A } Part u { Config=A Mirror=y } Part v { Config=A Mirror=x } Part w { Config=B "
                "Mirror=y }\nFixed a { Parent=l.b Child=u.b } Fixed b { Parent=l.b Child=v.b } Fixed c { Parent=l.b "
                "Child=w.a.b }\n");
        QCOMPARE(messagesOf(r), QString());
        const auto pattern = [&](std::size_t device) {
            return antennaNamed(*r.experiment, r.config().devices[device].text("Antenna"));
        };
        for (const std::size_t mirrored : {2u, 4u})
            for (double azimuth = -3.1; azimuth < 3.1; azimuth += 0.1)
                QVERIFY(std::abs(pattern(mirrored)->gain(azimuth, 0.2) - pattern(0)->gain(-azimuth, 0.2)) < 1e-9);
        QVERIFY(std::abs(pattern(2)->gain(1, 0.2) - pattern(0)->gain(1, 0.2)) > 1);
        QCOMPARE(pattern(6), pattern(0)); // twice
        QCOMPARE(r.config().devices[3].text("Antenna"), std::string("dipole"));
        QCOMPARE(r.experiment->antennas.size(), std::size_t(2));
    }

    /// HPR of a mirrored sensor has the bits of the copy by hand: 180 - 35 degrees, not pi - 0.61.
    void anglesAreThoseOfACopyByHand() {
        const Resolved r = kit("PartConfig A { Body b { @ } Camera c { HPR=35,10.3,-0.7 } }\n",
                               "Part p { Config=A Mirror=x } Body d { @ } Fixed f { Parent=d Child=p.b }\n"
                               "Camera c { HPR=145,10.3,0.7 } Part q { Config=A Mirror=z } Fixed e { Parent=d Child=q.b }\n"
                               "Camera z { HPR=35,-10.3,180.7 }\n");
        QCOMPARE(messagesOf(r), QString());
        const auto angles = [&](std::size_t device) { return r.config().devices[device].find("HPR")->value.numbers; };
        QCOMPARE(angles(0), angles(1));
        QCOMPARE(angles(2), angles(3));
    }

    /// In places joints, couplings and scenery of a Part too, whether the Part has a body or not.
    void jointsCountFromABodyToo_data() {
        QTest::addColumn<QString>("more");
        QTest::newRow("no body") << "";
        QTest::newRow("a body") << "Body m { @ } Fixed f { Parent=$a Child=m }";
    }
    void jointsCountFromABodyToo() {
        QFETCH(QString, more);
        const Resolved r = kit("PartConfig Ax { Hinge h { Parent=$a Child=$b Anchor=0.5,0,0 Axis=0,1,0 }\n"
                               "  Spring s { Parent=$a Child=$b Anchor=1,0,0 Anchor2=0,0,0 } " +
                                   more.toStdString() + " }\n",
                               "Body base { @ } Body arm { Pos=0,2,3 HPR=90,0,0 @ }\nPart s { Config=Ax In=arm a=base b=arm }\n");
        QCOMPARE(messagesOf(r), QString());
        QVERIFY((r.config().joints[0].anchor - Vec3(0, 2.5, 3)).norm() < 1e-12);
        QVERIFY((r.config().joints[0].axis - Vec3(-1, 0, 0)).norm() < 1e-12);
        QVERIFY((r.config().springs[0].anchor - Vec3(0, 3, 3)).norm() < 1e-12);
        const Resolved yard = resolved("Material m { } Surface s { }\nPartConfig Post { " + kGeom +
                                       " }\nStaticConfig Yard { Part p { Config=Post "
                                       "In=door Pos=1,0,0 } Body door { Pos=0,2,0 HPR=90,0,0 " +
                                       kGeom +
                                       " } Hinge h { Parent=world Child=door } }\n"
                                       "Static yard { Config=Yard }\n");
        QCOMPARE(messagesOf(yard), QString());
        QVERIFY((yard.experiment->statics.at(0).geoms->at(0).pose.position - Vec3(0, 3, 0)).norm() < 1e-12);
    }

    /// A device on a body from outside is placed in that body by Pos and HPR of the Part, whatever the Part counts from.
    void devicesOutsideDoNotCountFromIt() {
        for (const char* more : {"", "Body m { @ } Fixed f { Parent=$on Child=m }"}) {
            const Resolved r =
                kit(std::string("PartConfig Eye { Camera c { Body=$on Pos=0.1,0,0 HPR=10,0,0 } ") + more + " }\n",
                    "Body base { Pos=0,0,1 HPR=90,0,0 @ }\nPart e { Config=Eye In=base Pos=0.25,0,0 HPR=20,0,0 on=base }\n");
            QCOMPARE(messagesOf(r), QString());
            const std::vector<double>& pos = r.config().devices[0].find("Pos")->value.numbers;
            const std::vector<double>& hpr = r.config().devices[0].find("HPR")->value.numbers;
            const double turn = 20 * std::numbers::pi / 180;
            QVERIFY((Vec3(pos.data()) - Vec3(0.25 + 0.1 * std::cos(turn), 0.1 * std::sin(turn), 0)).norm() < 1e-12);
            QVERIFY(std::abs(hpr[0] - 1.5 * turn) < 1e-12);
        }
    }
};

QTEST_APPLESS_MAIN(MirrorTest)
#include "mirror_test.moc"
