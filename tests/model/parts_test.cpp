// Parts: what a Part uses is as if its PartConfig were written in its place; mirrored, it has the numbers of a copy by hand.
#include <QTest>

#include "model/mass_properties.h"
#include "model/resolve/part_expansion.h"
#include "model/resolve/resolve_steps.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n"
                          "Surface rollers { Friction=0.1 Friction2=0.9 FrictionHeading=45 }\n";

/// A wheel with everything that has a side: a tilted axle, a geom off the centre, a given centre and inertia.
const std::string kWheel =
    "PartConfig Wheel {\n"
    "  Param r = 0.05\n"
    "  Body wheel { Pos=0.01,0.02,0.03 HPR=10,20,30\n"
    "    Cylinder tyre { Radius=$r Length=0.02 Pos=0.001,0.002,0.003 HPR=5,6,90 Material=g Surface=rollers }\n"
    "    Mass=0.5 CenterOfMass=0.004,0.005,0.006 Inertia=1,1.1,1.2,0.01,0.02,0.03 }\n"
    "  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0.1 LowStop=-10 HighStop=20 }\n"
    "  RotaryMotor motor { Joint=axle TorqueConstant=1 SpeedConstant=1 Resistance=2 }\n"
    "}\n";

std::string kit(const std::string& parts) {
    return kHead + kWheel + "RobotConfig Kit {\n  Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n" +
           parts + "}\nRobot r { Config=Kit }\n";
}

/// The same by hand, with other names for the wheel's blocks.
std::string twin(const std::string& blocks) {
    return kHead + "RobotConfig Kit {\n  Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n" + blocks +
           "}\nRobot r { Config=Kit }\n";
}

QString messagesOf(const Resolved& r) { return QString::fromStdString(r.messages()); }

template <class T> bool sameBits(const T& a, const T& b) { return a.size() == b.size() && (a.array() == b.array()).all(); }
bool sameBits(const Pose& a, const Pose& b) {
    return sameBits(a.position, b.position) && sameBits(a.rotation.coeffs(), b.rotation.coeffs());
}

/// What differs between two robots, apart from names: empty if they are the same to the last bit.
std::string difference(const RobotConfigSpec& a, const RobotConfigSpec& b) {
    if (a.bodies.size() != b.bodies.size() || a.joints.size() != b.joints.size() || a.devices.size() != b.devices.size())
        return "counts";
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const BodySpec &x = a.bodies[i], &y = b.bodies[i];
        if (!sameBits(x.pose, y.pose)) return "pose of " + x.name;
        if (x.mass.mass != y.mass.mass || !sameBits(x.mass.centre, y.mass.centre)) return "mass of " + x.name;
        if (!sameBits(Mat3(x.mass.inertia), Mat3(y.mass.inertia))) return "inertia of " + x.name;
        for (std::size_t g = 0; g < x.geoms.size(); ++g)
            if (!sameBits(x.geoms[g].pose, y.geoms[g].pose) || x.geoms[g].radius != y.geoms[g].radius) return "geom of " + x.name;
    }
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
        const JointSpec &x = a.joints[i], &y = b.joints[i];
        if (!sameBits(x.anchor, y.anchor) || !sameBits(x.axis, y.axis) || !sameBits(x.axis2, y.axis2)) return "axes of " + x.name;
        if (x.parent != y.parent || x.child != y.child || x.lowStop != y.lowStop || x.highStop != y.highStop)
            return "ends or stops of " + x.name;
    }
    for (std::size_t i = 0; i < a.devices.size(); ++i)
        for (const char* key : {"Resistance", "Pos", "HPR"}) {
            const ResolvedValue *x = a.devices[i].find(key), *y = b.devices[i].find(key);
            if ((x == nullptr) != (y == nullptr) || (x && x->value.numbers != y->value.numbers))
                return std::string(key) + " of " + a.devices[i].name;
        }
    return {};
}

} // namespace

class PartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A Part is its PartConfig, moved, with its name in front.
    void isWhatItsConfigSays() {
        const Resolved r = resolved(kit("  Part left { Config=Wheel Pos=1,2,3 carrier=chassis r=0.07 motor.Resistance=5 }\n"));
        QCOMPARE(messagesOf(r), QString());
        const RobotConfigSpec& c = r.config();
        QCOMPARE(c.bodies[1].name, std::string("left.wheel"));
        QCOMPARE(c.joints[0].name, std::string("left.axle"));
        QCOMPARE(c.joints[0].parent, 0);
        QCOMPARE(c.joints[0].child, 1);
        QCOMPARE(c.devices[0].name, std::string("left.motor"));
        QCOMPARE(c.devices[0].text("Joint"), std::string("left.axle"));
        const Resolved by = resolved(
            twin("  Body w { Pos=$(1+0.01),$(2+0.02),$(3+0.03) HPR=10,20,30\n"
                 "    Cylinder tyre { Radius=0.07 Length=0.02 Pos=0.001,0.002,0.003 HPR=5,6,90 Material=g Surface=rollers }\n"
                 "    Mass=0.5 CenterOfMass=0.004,0.005,0.006 Inertia=1,1.1,1.2,0.01,0.02,0.03 }\n"
                 "  Hinge a { Parent=chassis Child=w Axis=0,1,0.1 LowStop=-10 HighStop=20 }\n"
                 "  RotaryMotor m { Joint=a TorqueConstant=1 SpeedConstant=1 Resistance=5 }\n"));
        QCOMPARE(messagesOf(by), QString());
        QCOMPARE(difference(c, by.config()), std::string());
    }

    /// Each mirror image has the bits of a copy by hand: position, orientation, axes, centre of mass, inertia.
    void isMirroredLikeAHandmadeCopy_data() {
        QTest::addColumn<QString>("mirror");
        QTest::addColumn<QString>("hand");
        QTest::newRow("y") << "y"
                           << "Body w { Pos=0.01,-0.02,0.03 HPR=-10,20,-30 Cylinder tyre { Radius=0.05 Length=0.02 "
                              "Pos=0.001,-0.002,0.003 HPR=-5,6,-90 Material=g Surface=s } Mass=0.5 "
                              "CenterOfMass=0.004,-0.005,0.006 Inertia=1,1.1,1.2,-0.01,0.02,-0.03 }\n"
                              "Hinge a { Parent=chassis Child=w Axis=0,1,-0.1 LowStop=-10 HighStop=20 }\n";
        QTest::newRow("x") << "x"
                           << "Body w { Pos=-0.01,0.02,0.03 HPR=-10,-20,30 Cylinder tyre { Radius=0.05 Length=0.02 "
                              "Pos=-0.001,0.002,0.003 HPR=-5,-6,90 Material=g Surface=s } Mass=0.5 "
                              "CenterOfMass=-0.004,0.005,0.006 Inertia=1,1.1,1.2,-0.01,-0.02,0.03 }\n"
                              "Hinge a { Parent=chassis Child=w Axis=0,1,0.1 LowStop=-20 HighStop=10 }\n";
        QTest::newRow("z") << "z"
                           << "Body w { Pos=0.01,0.02,-0.03 HPR=10,-20,-30 Cylinder tyre { Radius=0.05 Length=0.02 "
                              "Pos=0.001,0.002,-0.003 HPR=5,-6,-90 Material=g Surface=s } Mass=0.5 "
                              "CenterOfMass=0.004,0.005,-0.006 Inertia=1,1.1,1.2,0.01,-0.02,-0.03 }\n"
                              "Hinge a { Parent=chassis Child=w Axis=0,1,-0.1 LowStop=-20 HighStop=10 }\n";
    }
    void isMirroredLikeAHandmadeCopy() {
        QFETCH(QString, mirror);
        QFETCH(QString, hand);
        const Resolved r = resolved(kit("  Part w { Config=Wheel Mirror=" + mirror.toStdString() + " carrier=chassis }\n"));
        const Resolved by =
            resolved(twin(hand.toStdString() + "  RotaryMotor m { Joint=a TorqueConstant=1 SpeedConstant=1 Resistance=2 }\n"));
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(messagesOf(by), QString());
        QCOMPARE(difference(r.config(), by.config()), std::string());
    }

    /// The friction of a mecanum roller points to the other side; a mirror image of a mirror image is the original.
    /// Whatever the order in the text.
    void refusesDeepNesting() {
        for (const bool innerFirst : {true, false}) {
            std::vector<std::string> texts{"PartConfig P0 { Body b { Sphere s { Radius=0.1 Material=g Surface=s Mass=1 } } }\n"};
            for (int i = 1; i < 20'000; ++i)
                texts.push_back("PartConfig P" + std::to_string(i) + " { Part p { Config=P" + std::to_string(i - 1) + " } }\n");
            if (!innerFirst) std::ranges::reverse(texts);
            std::string text = kHead;
            for (const std::string& part : texts) text += part;
            const Resolved r = resolved(
                text +
                "RobotConfig Kit { Body b { Mass=1 Box x { Size=1,1,1 Material=g Surface=s } } }\nRobot r { Config=Kit }\n");
            QVERIFY(r.diagnostics.hasErrors());
            for (const Diagnostic& d : r.diagnostics.all())
                QVERIFY2(d.severity != Severity::Error || d.message == "PartConfigs are nested more than 99 deep",
                         d.message.c_str());
        }
    }
    void mirrorsDirectedFriction() {
        const Resolved r = resolved(kHead + kWheel +
                                    "PartConfig Both { Part a { Config=Wheel Mirror=y carrier=$base }\n"
                                    "  Part b { Config=Wheel carrier=$base } }\n"
                                    "RobotConfig Kit { Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n"
                                    "  Part both { Config=Both base=chassis }\n"
                                    "  Part image { Config=Both base=chassis Mirror=y Pos=0,-1,0 } }\nRobot r { Config=Kit }\n");
        QCOMPARE(messagesOf(r), QString());
        const auto heading = [&](std::size_t body) {
            return r.experiment->surfaces[r.config().bodies[body].geoms[0].surface].frictionHeading;
        };
        QCOMPARE(heading(1), -heading(2));
        QCOMPARE(heading(3), heading(2)); // twice mirrored
        QCOMPARE(heading(4), heading(1));
        QCOMPARE(r.config().bodies[3].name, std::string("image.a.wheel"));
        QVERIFY(sameBits(r.config().bodies[3].pose.rotation.coeffs(), r.config().bodies[2].pose.rotation.coeffs()));
        QCOMPARE(r.experiment->surfaces.size(), std::size_t(4)); // default, s, rollers and its mirror image
    }

    /// A mesh is mirrored with its triangles the right way round; a height map cannot be.
    void mirrorsMeshes() {
        const Resolved r = resolved(
            kHead +
            "PartConfig Block { Body b { Mesh m { File=cube.obj Shape=hull Density=1 Material=g Surface=s } } }\n"
            "RobotConfig Kit { Part right { Config=Block } Part left { Config=Block Mirror=y } }\nRobot r { Config=Kit }\n");
        QCOMPARE(messagesOf(r), QString());
        const GeomSpec &right = r.config().bodies[0].geoms[0], &left = r.config().bodies[1].geoms[0];
        QCOMPARE(left.mesh->points[7], (std::array<double, 3>{1, -1, 1}));
        const double volume = solidOf(*right.mesh).value().mass;
        QVERIFY(volume > 0);
        QCOMPARE(solidOf(*left.mesh).value().mass, volume); // inside out it would be negative
        QCOMPARE(solidOf(*left.hull).value().mass, volume);
        QCOMPARE(r.config().bodies[1].mass.centre.y(), -0.5);
        QVERIFY(resolved(kHead + "PartConfig Hill { Heightfield h { File=hill.png Size=1,1,1 Material=g Surface=s } }\n"
                                 "StaticConfig A { Part p { Config=Hill Mirror=x } }\nStatic a { Config=A }\n")
                    .messages()
                    .find("the Heightfield h has no mirror image") != std::string::npos);
    }

    /// Overrides at three levels: the outermost holds.
    void takesTheOutermostOverride() {
        const std::string pair =
            "PartConfig Pair { Param r = 0.05\n  Part left { Config=Wheel r=$r carrier=$base motor.Resistance=3 }\n"
            "  Part right { Config=Wheel Mirror=y r=$r carrier=$base } }\n";
        const std::string robot = "RobotConfig Kit { Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n"
                                  "  Part front { Config=Pair base=chassis right.motor.Resistance=4 right.r=0.06 } }\n";
        const auto resistances = [](const Resolved& r) {
            return std::array{r.config().devices[0].number("Resistance"), r.config().devices[1].number("Resistance")};
        };
        const Resolved plain = resolved(kHead + kWheel + pair + robot + "Robot r { Config=Kit }\n");
        QCOMPARE(messagesOf(plain), QString());
        QCOMPARE(resistances(plain), (std::array{3.0, 4.0}));
        QCOMPARE(plain.config().bodies[1].geoms[0].radius, 0.05);
        QCOMPARE(plain.config().bodies[2].geoms[0].radius, 0.06);
        const Resolved over =
            resolved(kHead + kWheel + pair + robot +
                     "Robot r { Config=Kit front.left.motor.Resistance=7 front.r=0.08 front.right.Mirror=none }\n");
        QCOMPARE(messagesOf(over), QString());
        QCOMPARE(resistances(over), (std::array{7.0, 4.0}));
        QCOMPARE(over.config().bodies[1].geoms[0].radius, 0.08);
        QCOMPARE(over.config().bodies[2].geoms[0].radius, 0.06);
        QCOMPARE(over.config().bodies[2].pose.position.y(), 0.02);
        const Resolved set = resolved(kHead + kWheel + pair + robot + "Robot r { Config=Kit }\n",
                                      {"r.front.left.motor.Resistance=9", "RobotConfig.Kit.front.right.motor.Resistance=8"});
        QCOMPARE(messagesOf(set), QString());
        QCOMPARE(resistances(set), (std::array{9.0, 8.0}));
    }

    /// Where a value comes from: the override nearest to the robot, else the part's own text.
    void tracesValues() {
        const Resolved r = resolved(kit("  Part left { Config=Wheel carrier=chassis motor.Resistance=5 }\n"
                                        "  Part right { Config=Wheel carrier=chassis }\n"));
        const auto text = [&](const char* path) {
            const auto found = provenanceOf(*r.outline, path);
            return found ? r.slice(found->value) : std::string("nothing");
        };
        QCOMPARE(text("r.left.motor.Resistance"), std::string("5"));
        QCOMPARE(text("r.right.motor.Resistance"), std::string("2"));
        QCOMPARE(text("RobotConfig.Kit.left.motor.Resistance"), std::string("5"));
        QCOMPARE(text("PartConfig.Wheel.motor.Resistance"), std::string("2"));
        QCOMPARE(text("r.left.Config"), std::string("Wheel"));
        QCOMPARE(text("r.left.nothing.Resistance"), std::string("nothing"));
    }

    /// Geoms directly in a PartConfig are scenery.
    void isSceneryInAStaticConfig() {
        const Resolved r =
            resolved(kHead + "PartConfig Post { Box foot { Size=1,1,1 Pos=0,1,0 Material=g Surface=s } }\n"
                             "StaticConfig Arena { Part a { Config=Post Pos=0,5,0 } Part b { Config=Post Mirror=y } }\n"
                             "Static arena { Config=Arena }\n");
        QCOMPARE(messagesOf(r), QString());
        const std::vector<GeomSpec>& geoms = *r.experiment->statics.at(0).geoms;
        QCOMPARE(geoms[0].name, std::string("a.foot"));
        QCOMPARE(geoms[0].pose.position.y(), 6.0);
        QCOMPARE(geoms[1].pose.position.y(), -1.0);
    }

    /// What is wrong with a part is reported with its place, and with the use that it is wrong for.
    void namesPlaceAndUse_data() {
        QTest::addColumn<QString>("parts");
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("note");
        QTest::newRow("unknown outside") << "Part left { Config=Wheel carrier=chasis }"
                                         << "E208 Parent names chasis, but there is no such Body\n"
                                         << "chasis"
                                         << "it is used here: $carrier";
        QTest::newRow("nothing given") << "Part left { Config=Wheel }"
                                       << "E209 Part left needs carrier: what PartConfig Wheel is joined to\n"
                                       << "left"
                                       << "it is used here: carrier";
        QTest::newRow("bad Param") << "Part left { Config=Wheel carrier=chassis r=-1 }"
                                   << "E203 Radius is -1, it must be above 0\n"
                                   << "-1"
                                   << "it is used here: $r";
        QTest::newRow("bad override") << "Part left { Config=Wheel carrier=chassis motor.Resistance=0 }"
                                      << "E203 Resistance is 0, it must be above 0\n"
                                      << "0"
                                      << "";
        QTest::newRow("misspelt Param") << "Part left { Config=Wheel carier=chassis }"
                                        << "E201 Part left has no property carier\n"
                                        << "carier"
                                        << "";
        QTest::newRow("wrong kind") << "Hinge h { Parent=world Child=chassis } Part left { Config=Wheel carrier=h }"
                                    << "E208 Parent names h, a Hinge; it takes a Body: chassis or world\n"
                                    << "h"
                                    << "it is used here: $carrier";
        QTest::newRow("no such path") << "Part left { Config=Wheel carrier=chassis moter.Resistance=1 }"
                                      << "E314 PartConfig Wheel has no moter; it has wheel, axle and motor\n"
                                      << "moter"
                                      << "";
        QTest::newRow("unknown config: what is in it is not reported")
            << "Part left { Config=Wheal carrier=chassis }\nEncoder e { Joint=left.axle }"
            << "E208 Config names Wheal, but there is no such PartConfig\n"
            << "Wheal"
            << "";
        QTest::newRow("itself") << "Part left { Config=Wheel carrier=left.wheel }"
                                << "E307 the child of Hinge axle is its parent as well\n"
                                << "left.wheel"
                                << "it is used here: $carrier";
        QTest::newRow("config of another kind") << "Part left { Config=Kit }"
                                                << "E208 Config names Kit, a RobotConfig; a Part takes a PartConfig\n"
                                                << "Kit"
                                                << "";
    }
    void namesPlaceAndUse() {
        QFETCH(QString, parts);
        QFETCH(QString, message);
        QFETCH(QString, place);
        QFETCH(QString, note);
        const Resolved r = resolved(kit(parts.toStdString() + "\n"));
        QCOMPARE(QString::fromStdString(r.messages()), message);
        const Diagnostic& d = r.diagnostics.all().at(0);
        QCOMPARE(QString::fromStdString(r.slice(d.range)), place);
        QString notes;
        for (const auto& [text, range] : d.notes)
            notes += QString::fromStdString(text) + ": " + QString::fromStdString(r.slice(range));
        QCOMPARE(notes, note);
    }

    /// An error in the text of a part names its first use.
    void namesTheUseOfABrokenPart() {
        const Resolved r =
            resolved(kHead + "PartConfig Wheel { Body wheel { Sphere tyre { Radius=-1 Material=g Surface=s } Mass=1 } }\n"
                             "RobotConfig Kit { Part left { Config=Wheel } Part right { Config=Wheel } }\n"
                             "Robot r { Config=Kit }\n");
        QCOMPARE(r.diagnostics.all().size(), std::size_t(1));
        const Diagnostic& d = r.diagnostics.all()[0];
        QCOMPARE(r.slice(d.range), std::string("-1"));
        QCOMPARE(d.notes.at(0).first, std::string("used here by Part left"));
        QCOMPARE(r.slice(d.notes[0].second), std::string("left"));
    }

    /// A name of something outside is no name of a PartConfig.
    void saysHowToReachOutside() {
        const Resolved r =
            resolved(kHead + "PartConfig Wheel { Body wheel { Sphere tyre { Radius=1 Material=g Surface=s } Mass=1 }\n"
                             "  Hinge axle { Parent=chassis Child=wheel } }\n");
        QCOMPARE(messagesOf(r), QString("E208 Parent names chassis, but there is no such Body; there is world; "
                                        "what is outside of a PartConfig comes in by a Param, Parent=$chassis\n"));
    }

    /// The default of a Param may name something of what uses the part; misspelt Params are not taken for new ones.
    void takesDefaultsOfReferences() {
        const std::string wheel =
            "PartConfig Wheel { Param carrier = chassis  Body wheel { Sphere tyre { Radius=1 Material=g Surface=s } "
            "Mass=1 }\n  Hinge axle { Parent=$carrier Child=wheel } }\n";
        const std::string robot = "RobotConfig Kit { Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n"
                                  "  Part left { Config=Wheel } }\nRobot r { Config=Kit }\n";
        const Resolved r = resolved(kHead + wheel + robot);
        QCOMPARE(messagesOf(r), QString());
        QCOMPARE(r.config().joints[0].parent, 0);
        std::string misspelt = wheel;
        misspelt.replace(misspelt.find("$carrier"), 8, "$carier");
        const Resolved wrong = resolved(kHead + misspelt + robot);
        QCOMPARE(messagesOf(wrong), QString("E211 there is no Param carier\n"));
        QCOMPARE(wrong.diagnostics.all()[0].suggestions.at(0), std::string("carrier"));
    }

    /// Circles are reported as a chain; they end.
    void refusesCircles() {
        const Resolved r = resolved("PartConfig A { Part b { Config=B } }\nPartConfig B { Part a { Config=A } }\n"
                                    "RobotConfig Kit { Part a { Config=A } }\nRobot r { Config=Kit }\n");
        QCOMPARE(messagesOf(r),
                 QString("E302 PartConfigs contain each other in a circle: A > B > A\n" // no hint about the order
                         "E209 RobotConfig Kit needs a Body: the first one carries the robot's pose\n"));
        QCOMPARE(resolved("PartConfig Self { Part s { Config=Self } }\n").messages(),
                 std::string("E302 PartConfigs contain each other in a circle: Self > Self\n"));
    }

    /// Parts of parts of parts count: too many are refused before they are built.
    void refusesTooManyObjects() {
        std::string text = kHead + "PartConfig P0 { Body b { Sphere s { Radius=1 Material=g Surface=s } Mass=1 } }\n";
        for (int i = 1; i < 30; ++i) {
            const std::string inner = "P" + std::to_string(i - 1);
            text += "PartConfig P" + std::to_string(i) + " { Part a { Config=" + inner + " } Part b { Config=" + inner + " } }\n";
        }
        const Resolved r = resolved(text + "RobotConfig Kit { Part p { Config=P29 } }\nRobot r { Config=Kit }\n");
        QVERIFY(r.messages().starts_with("E312 with RobotConfig Kit there would be configs of more than 200000 objects"));
        QVERIFY(r.experiment->robots.empty());
    }

    /// The work for many Parts grows with their number alone: each block of each Part is read once.
    void readsEachPartOnce() {
        const auto readsOf = [](int count) {
            std::string text =
                kHead + kWheel + "RobotConfig Kit { Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n";
            for (int i = 0; i < count; ++i)
                text += "  Part p" + std::to_string(i) + " { Config=Wheel Pos=0," + std::to_string(i) + ",0 carrier=chassis }\n";
            Resolved r = resolved(text + "}\nRobot r { Config=Kit }\n");
            ExperimentSpec out;
            Diagnostics reported;
            ResolveContext context(*r.outline, sample::assets(), reported, out);
            resolveMaterials(context);
            resolveSurfaces(context);
            PartExpansion world(context);
            resolveInstances(context, world);
            return reported.hasErrors() || out.robots.at(0).config->bodies.size() != std::size_t(count) + 1 ? 0 : context.reads;
        };
        const std::size_t one = readsOf(1), many = readsOf(1001);
        QVERIFY(one > 0);
        QCOMPARE(many - one, std::size_t(5 * 1000)); // the Part, its Body, geom, Hinge and motor
    }

    /// A name in an override is that of what is there where it is written, or of what is in the Part.
    void overridesNameWhatIsAroundThem() {
        const std::string second = "  Body second { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n";
        const auto ends = [&](const std::string& values, const std::string& robot = {}) {
            const Resolved r = resolved(
                kHead + kWheel + "RobotConfig Kit {\n  Body chassis { Box hull { Size=1,1,1 Material=g Surface=s } Mass=1 }\n" +
                second + "  Part left { Config=Wheel carrier=chassis " + values + " }\n}\nRobot r { Config=Kit " + robot +
                " }\n");
            if (r.diagnostics.hasErrors() || r.experiment->robots.empty()) return r.messages();
            const RobotConfigSpec& c = r.config();
            return c.bodies[std::size_t(c.joints[0].parent)].name + " " + c.bodies[std::size_t(c.joints[0].child)].name + " " +
                   c.devices[0].text("Joint");
        };
        QCOMPARE(ends("axle.Parent=second"), std::string("second left.wheel left.axle"));
        QCOMPARE(ends("", "left.axle.Parent=second"), std::string("second left.wheel left.axle"));
        QCOMPARE(ends("motor.Joint=axle"), std::string("chassis left.wheel left.axle"));
        QCOMPARE(ends("", "left.motor.Joint=left.axle"), std::string("chassis left.wheel left.axle"));
        const std::string wrong = ends("axle.Parent=secnd");
        QVERIFY2(wrong.find("Parent names secnd") != std::string::npos && wrong.find("Param") == std::string::npos,
                 wrong.c_str());
    }

    /// What a Part gives does not depend on which Params there happen to be at the top level.
    void globalParamsCaptureNothing() {
        for (const char* global : {"Param carrier = 5\n", "Param carrier = chassis\n", "Param carrier = elsewhere\n", ""}) {
            const Resolved r = resolved(global + kit("  Part left { Config=Wheel carrier=chassis }\n"));
            QCOMPARE(messagesOf(r), QString());
            QCOMPARE(r.config().joints[0].parent, 0);
        }
        const Resolved given = resolved("Param carrier = chassis\n" + kit("  Part left { Config=Wheel }\n"));
        QCOMPARE(messagesOf(given), QString());
        QCOMPARE(given.config().joints[0].parent, 0);
        const Resolved number = resolved("Param carrier = 5\n" + kit("  Part left { Config=Wheel }\n"));
        QVERIFY2(messagesOf(number).contains("Part left needs carrier"), number.messages().c_str());
    }

    void refusesParamsWithNamesOfInstances() {
        const auto reported = [&](const char* config, const char* name) {
            return messagesOf(resolved(kHead + config + " X { Param " + name +
                                       " = 1\n Body b { Box x { Size=1,1,1 Mass=1 Material=g Surface=s } } }\n"));
        };
        for (const char* name : {"Config", "Pos", "HPR", "Mirror"})
            QVERIFY2(reported("PartConfig", name)
                         .contains(QStringLiteral("a Param cannot be named %1: every Part has that property itself").arg(name)),
                     name);
        QVERIFY(reported("RobotConfig", "Pos").contains("every Robot has that property itself"));
        QCOMPARE(reported("RobotConfig", "Mirror"), QString());
    }
};

QTEST_APPLESS_MAIN(PartsTest)
#include "parts_test.moc"
