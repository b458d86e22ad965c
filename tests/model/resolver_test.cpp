// The typed model: each value of the text reaches its field, in SI units, with its sign and its axis.
#include <QTest>

#include <algorithm>
#include <numbers>

#include "model/mass_properties.h"
#include "model_fixture.h"

using namespace trundle;
using sample::boxMesh;
using sample::Resolved;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-12 * std::max(1.0, b.norm()); }
bool near(const Mat3& a, const Mat3& b) { return (a - b).norm() < 1e-12 * std::max(1.0, b.norm()); }

/// The mass of `Body b { <text> }` with mesh materials.
MassProperties massOf(const std::string& text, std::string* said = nullptr) {
    const Resolved r =
        sample::resolved("Material g { } Surface s { }\nRobotConfig C { Body b { " + text + " } }\nRobot r { Config=C }\n");
    if (said) *said = r.messages();
    return r.experiment->robots.empty() ? MassProperties{} : r.config().bodies.at(0).mass;
}

/// A text with two files that it imports at its top. Each has a folder of its own: the first one finds a mesh of 1 m there, the
/// second one of 2 m.
Resolved imported(const std::string& text, const std::string& first, const std::string& second) {
    Resolved r;
    addText(r, "main.sim", "#import first.sim\n#import second.sim\n" + text);
    for (const std::string& inner : {first, second}) {
        const FileId file = addText(r, "inner.sim", inner);
        r.texts->imports[r.texts->trees[0]->items().at(file - 1).as<ImportItem>()] = file;
    }
    r.texts->firstSet = 3;
    r.outline = Outline::build(r.texts, sample::kindsWithWalker(), r.diagnostics);
    AssetLookup lookup = sample::assets();
    lookup.mesh = [](const std::string& written, FileId file) -> Result<FoundAsset<TriangleMesh>> {
        const double side = file == 2 ? 2 : 1;
        return FoundAsset<TriangleMesh>{"/" + written, std::make_shared<const TriangleMesh>(boxMesh({side, side, side}, Pose{}))};
    };
    r.experiment = resolve(*r.outline, lookup, r.diagnostics);
    return r;
}

} // namespace

class ResolverTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Centre and six different moments, given or from turned geoms.
    void massOfABody() {
        const std::string box = "Box k { Size=1,2,3 Pos=4,5,6 HPR=30,40,50 Material=g Surface=s ";
        const Pose pose{Vec3(4, 5, 6), rotationFromHpr(Vec3(30, 40, 50) * kDegree)};
        const MassProperties solid = solidOf(boxMesh({1, 2, 3}, pose)).value();

        MassProperties m = massOf("Mass=2 CenterOfMass=0.1,-0.2,0.3 Inertia=1,2,2.5,0.01,0.02,0.03");
        Mat3 given;
        given << 1, 0.01, 0.02, 0.01, 2, 0.03, 0.02, 0.03, 2.5;
        QVERIFY(m.mass == 2 && near(m.centre, Vec3(0.1, -0.2, 0.3)) && near(m.inertia, given));

        m = massOf(box + "} Mass=12");
        QVERIFY(std::abs(m.mass - 12) < 1e-12 && (m.centre - pose.position).norm() < 1e-9);
        QVERIFY((m.inertia - 2 * solid.inertia).norm() < 1e-9);

        m = massOf(box + "Density=500 }");
        QVERIFY(std::abs(m.mass - 3000) < 1e-9 && (m.inertia - 500 * solid.inertia).norm() < 1e-6);

        m = massOf(box + "Mass=3 } CenterOfMass=1,2,3"); // the inertia stays that about the centre of mass
        QVERIFY(near(m.centre, Vec3(1, 2, 3)) && (m.inertia - solid.inertia / 2).norm() < 1e-9);

        const std::string ball = "Sphere b { Radius=0.5 Pos=-3,1,2 Material=g Surface=s ";
        m = massOf(box + "Mass=3 } " + ball + "Mass=5 }");
        const MassProperties lightBox = withMass(solid, 3), small{5, Vec3(-3, 1, 2), Mat3(0.4 * 5 * 0.25 * Mat3::Identity())};
        QVERIFY(std::abs(m.mass - 8) < 1e-12 && near(m.centre, Vec3((3 * lightBox.centre + 5 * small.centre) / 8)));
        QVERIFY((m.inertia - sum({lightBox, small}).inertia).norm() < 1e-9);

        m = massOf(box + "} " + ball + "} Mass=8"); // spread by volume
        const double volume = 6 + std::numbers::pi / 6;
        QVERIFY((m.centre - (6 * pose.position + std::numbers::pi / 6 * Vec3(-3, 1, 2)) / volume).norm() < 1e-9);

        m = massOf(box + "Mass=3 } " + ball + "}"); // a geom without a mass has none
        QVERIFY(std::abs(m.mass - 3) < 1e-12 && (m.centre - pose.position).norm() < 1e-9);
    }

    void massFaults_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* text, const char* said) { QTest::newRow(text) << text << said; };
        row("Mass=1", "E305 Body b has a Mass but no geoms to spread it over; give it Inertia or a geom\n");
        row("Box k { Size=1,1,1 Material=g Surface=s }", "E305 Body b has no mass; give one to it or to its geoms\n");
        row("Mass=1 Inertia=1,1", "E204 Inertia has 2 elements, it takes three to six numbers\n");
        row("Mass=1 Inertia=1,1,1,0", "E204 Inertia has 4 elements, it takes three or six numbers\n");
        row("Mass=1 Inertia=1,1,2.1",
            "E305 the mass of Body b cannot be: no body has this inertia: of the principal moments 1, 1 and 2.1 the "
            "largest is above the sum of the others\n");
        row("Mass=1 Inertia=1,1,1,0,2,0", "E305 the mass of Body b cannot be: its inertia is not positive definite\n");
        row("Mass=1 Box k { Size=1,1,1 Mass=1 Material=g Surface=s }",
            "E214 Body b has a Mass, which is spread over its geoms; Box k cannot have its own\n");
        row("Box k { Size=1,1,1 Mass=1 Density=2 Material=g Surface=s }",
            "E214 Box k has both Mass and Density, only one can hold\n");
        row("Mesh k { File=open.obj Density=2 Material=g Surface=s }",
            "E305 Mesh k has no mass: the mesh is not closed, so that it has no volume; give it Mass in place of Density\n");
        row("Mesh k { File=open.obj Mass=2 Material=g Surface=s }", "");
    }
    void massFaults() {
        QFETCH(QString, text);
        QFETCH(QString, said);
        std::string messages;
        (void)massOf(text.toStdString(), &messages);
        QCOMPARE(QString::fromStdString(messages), said);
    }

    /// All geoms: pose, sizes and flags; a mesh with three scales.
    void geoms() {
        const Resolved r =
            sample::resolved("Material g { } Surface s { }\nRobotConfig C { Body b { Pos=1,2,3 HPR=10,20,30 Mass=2\n"
                             "  Cylinder c { Radius=2cm Length=3cm Pos=1,-1,2 HPR=0,0,90 Material=g Surface=s }\n"
                             "  Capsule p { Radius=4cm Length=5cm Collide=false Material=g Surface=s }\n"
                             "  Mesh m { File=cube.obj Scale=2,3,4 Visible=false Material=g Surface=s }\n"
                             "  Convex v { File=cube.obj Scale=0.5 Material=g Surface=s }\n"
                             "  Mesh bare { File=cube.obj Shape=none Material=g Surface=s }\n"
                             "  Mesh whole { File=cube.obj Shape=mesh Material=g Surface=s } } }\n"
                             "Robot r { Config=C Pos=7,8,9 HPR=-90,0,0 }\n"
                             "StaticConfig L { Mesh m { File=cube.obj Material=g Surface=s } Plane f { HPR=0,5,0 Material=g "
                             "Surface=s } }\nStatic l { Config=L Pos=3,2,1 HPR=0,10,0 }\n");
        SAYS(r, "");
        const BodySpec& b = r.config().bodies.at(0);
        QVERIFY(near(b.pose.position, Vec3(1, 2, 3)));
        QVERIFY(b.pose.rotation.isApprox(rotationFromHpr(Vec3(10, 20, 30) * kDegree), 1e-12));
        const auto& g = b.geoms;
        QVERIFY(g[0].shape == GeomShape::Cylinder && g[0].radius == 0.02 && g[0].length == 0.03);
        QVERIFY(near(g[0].pose.position, Vec3(1, -1, 2)) && near(g[0].pose.rotation * Vec3(0, 0, 1), Vec3(0, -1, 0)));
        QVERIFY(g[0].collide && g[0].visible && g[0].material == 1 && g[0].surface == 1);
        QVERIFY(g[1].shape == GeomShape::Capsule && g[1].radius == 0.04 && g[1].length == 0.05 && !g[1].collide);
        QVERIFY(g[2].shape == GeomShape::Mesh && !g[2].visible && g[2].collideAsHull && g[2].hull);
        QCOMPARE(g[2].mesh->points[7], (std::array<double, 3>{2, 3, 4}));
        QVERIFY(g[3].shape == GeomShape::Convex && g[3].collideAsHull && g[3].mesh == g[3].hull && g[3].mesh->points.size() == 8);
        QVERIFY(!g[4].collide && !g[4].collideAsHull);
        QVERIFY(g[5].collide && !g[5].collideAsHull);
        const RobotSpec& robot = r.experiment->robots.at(0);
        QVERIFY(near(robot.pose * Vec3(1, 0, 0), Vec3(7, 7, 9)));
        const StaticSpec& land = r.experiment->statics.at(0);
        QVERIFY(land.name == "l" && land.configName == "L" && near(land.pose.position, Vec3(3, 2, 1)));
        QVERIFY(land.geoms->at(0).collide && !land.geoms->at(0).collideAsHull);
    }

    /// Each field of a joint, with different numbers.
    void joints() {
        const std::string bodies = "Body a { Pos=1,2,3 Mass=1 Inertia=1,1,1 } Body b { Pos=4,5,6 Mass=1 Inertia=1,1,1 }\n";
        const Resolved r = sample::resolved(
            "RobotConfig C { " + bodies +
            "Hinge h { Parent=a Child=b Axis=0,3,4 Anchor=1,2,3 LowStop=-30 HighStop=60 Damping=0.1 Friction=0.2 Stiffness=0.3 "
            "}\n"
            "Slider s { Parent=world Child=a Axis=-2,0,0 LowStop=-1cm HighStop=2cm Damping=0.4 Friction=0.5 Stiffness=0.6 } }\n"
            "RobotConfig D { " +
            bodies +
            "Universal u { Parent=b Child=a Axis=0,0,2 Axis2=0,5,0 } }\n"
            "RobotConfig E { " +
            bodies +
            "Suspension w { Parent=a Child=b Axis=0,0,1 Axis2=3,4,0 Travel=7cm Stiffness=800 Damping=90 } }\n"
            "RobotConfig F { " +
            bodies +
            "Ball k { Parent=a Child=b Anchor=9,8,7 } }\n"
            "Robot c { Config=C } Robot d { Config=D } Robot e { Config=E } Robot f { Config=F }\n");
        SAYS(r, "");
        const JointSpec &h = r.config(0).joints.at(0), &s = r.config(0).joints.at(1), &u = r.config(1).joints.at(0),
                        &w = r.config(2).joints.at(0), &k = r.config(3).joints.at(0);
        QVERIFY(h.type == JointType::Hinge && h.parent == 0 && h.child == 1);
        QVERIFY(near(h.axis, Vec3(0, 0.6, 0.8)) && near(h.anchor, Vec3(1, 2, 3)));
        QVERIFY(std::abs(*h.lowStop + 30 * kDegree) < 1e-15 && std::abs(*h.highStop - 60 * kDegree) < 1e-15);
        QVERIFY(h.damping == 0.1 && h.friction == 0.2 && h.stiffness == 0.3);
        QVERIFY(s.type == JointType::Slider && s.parent == kWorldBody && s.child == 0 && near(s.axis, Vec3(-1, 0, 0)));
        QVERIFY(near(s.anchor, Vec3(1, 2, 3)) && *s.lowStop == -0.01 && *s.highStop == 0.02);
        QVERIFY(s.damping == 0.4 && s.friction == 0.5 && s.stiffness == 0.6);
        QVERIFY(u.type == JointType::Universal && u.parent == 1 && u.child == 0 && near(u.axis, Vec3(0, 0, 1)) &&
                near(u.axis2, Vec3(0, 1, 0)));
        QVERIFY(w.type == JointType::Suspension && near(w.axis2, Vec3(0.6, 0.8, 0)) && w.travel == 0.07 && w.stiffness == 800 &&
                w.damping == 90);
        QVERIFY(k.type == JointType::Ball && near(k.anchor, Vec3(9, 8, 7)) && !k.lowStop && !k.highStop);
    }

    void jointFaults_data() {
        QTest::addColumn<QString>("joint");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* joint, const char* said) { QTest::newRow(joint) << joint << said; };
        row("Hinge j { Parent=a Child=b Axis=0,0,0 }", "E307 the Axis of Hinge j is zero, it has no direction\n");
        row("Universal j { Parent=a Child=b Axis=0,0,1 Axis2=0,0,0 }",
            "E307 the Axis2 of Universal j is zero, it has no direction\n");
        row("Universal j { Parent=a Child=b Axis=0,0,1 Axis2=0,0,-3 }",
            "E307 Axis and Axis2 of Universal j point the same way\n");
        row("Universal j { Parent=a Child=b Axis=0,0,1 Axis2=0,1,0.1 }",
            "E307 Axis and Axis2 of Universal j are not at a right angle\n");
        row("Universal j { Parent=a Child=b Axis=0,0,1 Axis2=0,1,0.0005 }", "");
        row("Suspension j { Parent=a Child=b Axis=0,0,1 Axis2=0,1,0.5 Travel=1 }", "");
        row("Hinge j { Parent=a Child=b LowStop=2 HighStop=1 }", "E307 the LowStop of Hinge j is above its HighStop\n");
        row("Hinge j { Parent=a Child=b LowStop=-1 HighStop=-1 }",
            "E307 Hinge j starts at 0, above its HighStop: it is pushed there at once; place its bodies between the stops\n");
        row("Hinge j { Parent=a Child=b LowStop=1 HighStop=2 }",
            "E307 Hinge j starts at 0, below its LowStop: it is pushed there at once; place its bodies between the stops\n");
        row("Hinge j { Parent=a Child=b } Slider k { Parent=b Child=a }",
            "E334 two joints join the same bodies, j and k: they act against each other; keep one of them\n");
    }
    void jointFaults() {
        QFETCH(QString, joint);
        QFETCH(QString, said);
        SAYS(sample::resolved("RobotConfig C { Body a { Mass=1 Inertia=1,1,1 } Body b { Mass=1 Inertia=1,1,1 }\n" +
                              joint.toStdString() + " }\n"),
             said);
    }

    /// Settings, surfaces and materials: each field by itself differs from its default.
    void fields() {
        const Resolved r = sample::resolved(
            "Tick = 2ms  Duration = 3  Seed = 4  Gravity = 1,2,3  Solver = quick  Iterations = 6  ErrorReduction = 0.7\n"
            "Title = \"a\"  Description = \"b\"\n"
            "Surface s { Friction=0.1 Restitution=0.2 RollingFriction=3mm Softness=0.4 }\n"
            "Material m { ColorRGB=0.1,0.2,0.3 TextureScale=4 Shininess=0.5 Opacity=0.6 Emission=0.7,0.8,0.9 TextureMap=box }\n");
        SAYS(r, "");
        const SettingsSpec& e = r.experiment->settings;
        QVERIFY(e.tick == 0.002 && e.duration == 3 && e.seed == 4 && near(e.gravity, Vec3(1, 2, 3)));
        QVERIFY(e.solver == SolverChoice::Quick && e.iterations == 6 && e.errorReduction == 0.7 && e.title == "a" &&
                e.description == "b");
        const SurfaceSpec& s = r.experiment->surfaces.at(1);
        QVERIFY(s.name == "s" && s.friction == 0.1 && s.restitution == 0.2 && s.rollingFriction == 0.003 && s.softness == 0.4);
        const MaterialSpec& m = r.experiment->materials.at(1);
        QCOMPARE(m.colour, (std::array<double, 3>{0.1, 0.2, 0.3}));
        QCOMPARE(m.emission, (std::array<double, 3>{0.7, 0.8, 0.9}));
        QVERIFY(m.textureScale == 4 && m.shininess == 0.5 && m.opacity == 0.6 && m.textureMap == "box");
    }

    /// A Grid: x first, about its centre, turned with it; one number serves both ways.
    void grids() {
        const Resolved r = sample::resolved(
            sample::rover("Grid g { Config=Rover Count=2,3 Spacing=4,1 Pos=10,20,5 HPR=90,0,0 }\n"
                          "Grid line { Config=Rover Count=3 Spacing=2 }\nGrid square { Config=Rover Count=2,2 Spacing=2 }\n"));
        SAYS(r, "");
        const auto at = [&](const std::string& name) {
            for (const RobotSpec& robot : r.experiment->robots)
                if (robot.name == name) return robot.pose.position;
            return Vec3(Vec3::Constant(1e9));
        };
        QVERIFY(near(at("g_0"), Vec3(11, 18, 5)) && near(at("g_1"), Vec3(11, 22, 5)) && near(at("g_2"), Vec3(10, 18, 5)) &&
                near(at("g_5"), Vec3(9, 22, 5)));
        QVERIFY(near(at("line_0"), Vec3(-2, 0, 0)) && near(at("line_2"), Vec3(2, 0, 0)));
        QVERIFY(near(at("square_1"), Vec3(1, -1, 0)) && near(at("square_2"), Vec3(-1, 1, 0)));
        QVERIFY(r.experiment->robots[0].pose.rotation.isApprox(rotationFromHpr(Vec3(90, 0, 0) * kDegree), 1e-12));
    }

    /// A name of a member is taken, and only such a name.
    void namesOfMembersAreTaken() {
        const auto messages = [](const std::string& name) {
            return sample::resolved(sample::rover("Grid swarm { Config=Rover Count=3 Spacing=1 }\nRobot " + name +
                                                  " { Config=Rover Pos=9,0,0 }\n"))
                .messages();
        };
        for (const char* taken : {"swarm_0", "swarm_2"})
            QCOMPARE(messages(taken), std::string("E303 the name ") + taken + " belongs to a member of Grid swarm\n");
        for (const char* free : {"swarm_3", "swarm_", "swarm_02", "swarm0", "swarm_x"}) QCOMPARE(messages(free), std::string());
    }

    /// A block of an unknown kind may be the body that a config lacks: only the kind is reported.
    void configsOfUnknownParts() {
        const auto errors = [](const char* inside) {
            return sample::resolved(std::string("RobotConfig C { ") + inside + " }\nRobot r { Config=C }\n")
                .diagnostics.errorCount();
        };
        QCOMPARE(errors(""), std::size_t{1});
        QCOMPARE(errors("Bodi b { Box x { Size=1,1,1 Mass=1 } }"), std::size_t{1});
    }

    /// Members of a Scatter: inside the turned and moved area, apart, clear of a turned obstacle; the seed moves all of them.
    void scatters() {
        const std::string text = "StaticConfig Wall { Box b { Size=6,0.4,1 Pos=0,0,0.5 Material=grey Surface=rubber } }\n"
                                 "Static wall { Config=Wall Pos=5,1,0 HPR=45,0,0 }\n"
                                 "Scatter s { Config=Rover Count=40 Area=-1,-3,2,4 MinDistance=0.35 Pos=5,1,0 HPR=90,0,0 ";
        const Resolved r = sample::resolved(sample::rover(text + "Heading=30 }\n"));
        SAYS(r, "");
        const auto& robots = r.experiment->robots;
        QCOMPARE(robots.size(), std::size_t{40});
        const double c = std::sqrt(0.5);
        for (std::size_t i = 0; i < robots.size(); ++i) {
            const Vec3 p = robots[i].pose.position - Vec3(5, 1, 0), local(p.y(), -p.x(), p.z());
            QVERIFY(local.x() >= -1 && local.x() <= 2 && local.y() >= -3 && local.y() <= 4);
            const double along = c * (p.x() + p.y()), across = c * (p.y() - p.x());
            QVERIFY2(std::abs(across) > 0.2 || std::abs(along) > 3, "it overlaps the wall");
            QVERIFY(near(robots[i].pose.rotation * Vec3(1, 0, 0), rotationFromHpr(Vec3(120, 0, 0) * kDegree) * Vec3(1, 0, 0)));
            for (std::size_t k = 0; k < i; ++k) QVERIFY((p + Vec3(5, 1, 0) - robots[k].pose.position).norm() >= 0.35);
        }
        const auto firstOf = [](const Resolved& other) { return other.experiment->robots.at(0).pose.position; };
        QCOMPARE(firstOf(sample::resolved(sample::rover(text + "Heading=30 }\n"))), firstOf(r));
        QVERIFY(firstOf(sample::resolved(sample::rover(text + "Seed=2 }\n"))) != firstOf(r));
        QVERIFY(firstOf(sample::resolved(sample::rover("Seed = 2\n" + text + "}\n"))) ==
                firstOf(sample::resolved(sample::rover(text + "Seed=2 }\n"))));
        const auto heading = [](const Resolved& other, std::size_t i) {
            return other.experiment->robots.at(i).pose.rotation.angularDistance(Quat::Identity());
        };
        const Resolved random = sample::resolved(sample::rover(text + "}\n"));
        QVERIFY(heading(random, 0) != heading(random, 1));
    }

    /// Robots with equal values share one config; any one different value makes another.
    void sharesEqualConfigs() {
        const Resolved r = sample::resolved(
            sample::rover("Robot a { Config=Rover }\nRobot b { Config=Rover Pos=1,2,3 HPR=1,2,3 Walker w { } }\n"
                          "Robot c { Config=Rover wheelRadius=0.06 }\nRobot d { Config=Rover wheelRadius=0.0600000000001 }\n"
                          "Robot e { Config=Rover leftMotor.Resistance=3 }\nRobot f { Config=Rover rightMotor.Resistance=3 }\n"
                          "Robot g { Config=Rover leftMotor.Resistance=3 }\n"));
        SAYS(r, "");
        const auto of = [&](std::size_t i) { return r.experiment->robots[i].config.get(); };
        QCOMPARE(of(0), of(1));
        QCOMPARE(of(4), of(6));
        for (std::size_t i : {2, 3, 4, 5})
            for (std::size_t k : {0, 2, 3, 4, 5}) QVERIFY(i == k || of(i) != of(k));
        QCOMPARE(r.config(3).bodies.at(1).geoms[0].radius, 0.0600000000001);
    }

    /// A relative path leads elsewhere from another folder.
    void sharesNoConfigsWithFilesOfOtherFolders() {
        const std::string at = " Config=K b.hull.File=\"body.obj\" }\n";
        const Resolved r = imported("Material g { } Surface s { }\n"
                                    "RobotConfig K { Body b { Mesh hull { File=\"cube.obj\" Mass=1 Material=g Surface=s } } }\n",
                                    "Robot red {" + at + "Robot red2 { Pos=3,0,0" + at, "Robot blue { Pos=6,0,0" + at);
        QVERIFY2(!r.diagnostics.hasErrors(), r.messages().c_str());
        const auto reach = [&](std::size_t robot) { return r.config(robot).bodies.at(0).geoms.at(0).mesh->points.at(7)[0]; };
        QCOMPARE(r.experiment->robots[0].config, r.experiment->robots[1].config);
        QCOMPARE(reach(0), 0.5);
        QCOMPARE(reach(2), 1.0);
    }

    /// Only where the value is that of one of them.
    void importedFilesDisagree_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("later");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const char* text, const char* later, const char* said) {
            QTest::newRow(name) << text << later << said;
        };
        row("on a value", "", "Tick = 0.005",
            "E215 imported files disagree: Tick is 0.01 in inner.sim and 0.005 here; the later one holds\n");
        row("on a value with a unit", "", "Tick = 5 ms",
            "E215 imported files disagree: Tick is 0.01 in inner.sim and 5 ms here; the later one holds\n");
        row("on one of their own", "Tick = 0.02\n", "Tick = 0.005", "");
        row("not, in another unit", "", "Tick = 10 ms", "");
        row("not, with more digits", "", "Tick = 0.010", "");
    }
    void importedFilesDisagree() {
        QFETCH(QString, text);
        QFETCH(QString, later);
        const Resolved r = imported(text.toStdString(), "Tick = 0.01", later.toStdString());
        QTEST(QString::fromStdString(r.messages()), "said");
    }

    void aDisagreementFurtherInIsDecidedByTheImportingFile() {
        Resolved r;
        addText(r, "main.sim", "#import both.sim\nTick = 0.02\n");
        addText(r, "both.sim", "#import a.sim\n#import b.sim\n");
        addText(r, "a.sim", "Tick = 0.01");
        addText(r, "b.sim", "Tick = 0.005");
        r.texts->imports[r.texts->trees[0]->items()[0].as<ImportItem>()] = 1;
        for (const FileId file : {2, 3}) r.texts->imports[r.texts->trees[1]->items().at(file - 2).as<ImportItem>()] = file;
        r.texts->firstSet = 4;
        r.outline = Outline::build(r.texts, sample::kindsWithWalker(), r.diagnostics);
        SAYS(r, "");
        r.experiment = resolve(*r.outline, sample::assets(), r.diagnostics);
        QCOMPARE(r.experiment->settings.tick, 0.02);
    }

    /// Also those that are at the same place in two files.
    void everyLooseBodyOfAStaticIsReported() {
        const auto part = [](const char* name) {
            return std::string("PartConfig ") + name + " { Body b { Box x { Size=1,1,1 Mass=1 Material=g Surface=s } } }\n";
        };
        const Resolved r = imported("Material g { } Surface s { }\nStaticConfig S { Part k { Config=K } Part l { Config=L } }\n",
                                    part("K"), part("L"));
        const QString all = QString::fromStdString(r.messages());
        QVERIFY2(all.contains(u"no joint holds Body k.b") && all.contains(u"no joint holds Body l.b"), qPrintable(all));
    }

    /// In whatever order: each of them once in the thirteenth place.
    void everySettingOfALongBlockCounts() {
        struct Setting {
            std::string key;
            double MediumSettings::*field;
            double number;
        };
        std::vector<Setting> all{{"Frequency", &MediumSettings::frequency, 900000000},
                                 {"Exponent", &MediumSettings::exponent, 2.5},
                                 {"Shadowing", &MediumSettings::shadowing, 3},
                                 {"CorrelationDistance", &MediumSettings::correlation, 4},
                                 {"GroundPermittivity", &MediumSettings::permittivity, 5},
                                 {"WallLoss", &MediumSettings::wallLoss, 6},
                                 {"NoiseFloor", &MediumSettings::noiseFloor, -97},
                                 {"ImplementationLoss", &MediumSettings::implementationLoss, 8},
                                 {"CaptureMargin", &MediumSettings::captureMargin, 9},
                                 {"CarrierSense", &MediumSettings::carrierSense, -70},
                                 {"Offsets", &MediumSettings::offsets, 11},
                                 {"ClockDrift", &MediumSettings::clockDrift, 12}};
        for (std::size_t round = 0; round < all.size(); ++round) {
            std::string text = "RadioMedium air { Model=log_distance Mac=csma PacketErrors=true Collisions=true";
            const auto add = [&](const Setting& s) {
                text += " " + s.key + "=" + QByteArray::number(s.number, 'f', 1).toStdString();
            };
            for (const Setting& s : all) add(s);
            const Resolved once = sample::resolved(text + " }\n");
            QVERIFY2(once.diagnostics.errorCount() == 0, once.messages().c_str());
            for (const Setting& s : all) QVERIFY2(once.experiment->medium.*s.field == s.number, s.key.c_str());
            const Setting& thirteenth = all[8];
            add(thirteenth);
            const std::string twice = sample::resolved(text + " }\n").messages();
            QVERIFY2(twice.find("E210 " + thirteenth.key + " is set twice in one block") != std::string::npos, twice.c_str());
            std::rotate(all.begin(), all.begin() + 1, all.end());
        }
    }

    /// Overrides of geoms, bodies, joints and devices reach exactly the part that they name.
    void overrides() {
        const Resolved r = sample::resolved(sample::rover(
            "Robot a { Config=Rover SelfCollision=true chassis.hull.Size=1,2,3 leftWheel.Pos=4,5,6 rightAxle.Damping=0.7\n"
            "  rightMotor.GearRatio=8 touch.MinForce=9 base.Control=pi leftWheel.tyre.Mass=1 }\nRobot plain { Config=Rover }\n"));
        SAYS(r, "");
        const RobotConfigSpec &a = r.config(0), &plain = r.config(1);
        QVERIFY(a.selfCollision && !plain.selfCollision);
        QVERIFY(near(a.bodies[0].geoms[0].size, Vec3(1, 2, 3)) && near(plain.bodies[0].geoms[0].size, Vec3(0.3, 0.2, 0.1)));
        QVERIFY(near(a.bodies[1].pose.position, Vec3(4, 5, 6)) && near(a.bodies[2].pose.position, Vec3(0, -0.1, 0.05)));
        QVERIFY(a.bodies[1].mass.mass == 1 && a.bodies[2].mass.mass == 0.15);
        QVERIFY(a.joints[1].damping == 0.7 && a.joints[0].damping == 0);
        QVERIFY(near(a.joints[0].anchor, Vec3(4, 5, 6))); // the child's origin
        QVERIFY(a.devices[1].number("GearRatio") == 8 && a.devices[0].number("GearRatio") == 1);
        QVERIFY(a.devices[3].number("MinForce") == 9 && a.devices[2].text("Control") == "pi");
    }
};

QTEST_APPLESS_MAIN(ResolverTest)
#include "resolver_test.moc"
