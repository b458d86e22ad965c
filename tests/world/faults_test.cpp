// Faults are reported and never crash: instability is reported with body and time, invalid specs are refused or tolerated.
#include <QtTest>

#include <functional>
#include <limits>

#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

/// Changes one value of a valid experiment: R0 on a floor.
using Spoil = std::function<void(ExperimentSpec&, RobotConfigSpec&, std::vector<GeomSpec>&)>;

struct FaultCase {
    const char* name;
    Spoil spoil;
    bool refused; ///< otherwise it builds and must run or report a fault, but not crash
};

std::shared_ptr<TriangleMesh> meshOf(std::vector<std::array<double, 3>> points,
                                     std::vector<std::array<std::uint32_t, 3>> triangles) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = std::move(points);
    mesh->triangles = std::move(triangles);
    return mesh;
}

GeomSpec meshGeom(std::shared_ptr<TriangleMesh> mesh, bool hull) {
    GeomSpec g = plane("mesh");
    g.shape = GeomShape::Mesh;
    g.mesh = std::move(mesh);
    g.collideAsHull = hull;
    return g;
}

GeomSpec heights(std::uint32_t columns, std::uint32_t rows, std::size_t count, float value) {
    auto map = std::make_shared<HeightMap>();
    map->columns = columns;
    map->rows = rows;
    map->heights.assign(count, value);
    GeomSpec g = plane("hills");
    g.shape = GeomShape::Heightfield;
    g.size = {10, 10, 1};
    g.heightMap = map;
    return g;
}

const std::vector<FaultCase>& faultCases() {
    static const std::vector<FaultCase> all{
        {"zero mass", [](auto&, auto& c, auto&) { c.bodies[1].mass.mass = 0; }, true},
        {"negative mass", [](auto&, auto& c, auto&) { c.bodies[1].mass.mass = -1; }, true},
        {"NaN mass", [](auto&, auto& c, auto&) { c.bodies[1].mass.mass = kNan; }, true},
        {"huge mass", [](auto&, auto& c, auto&) { c.bodies[0].mass.mass = 1e300; }, true},
        {"zero inertia", [](auto&, auto& c, auto&) { c.bodies[0].mass.inertia.setZero(); }, true},
        {"negative inertia", [](auto&, auto& c, auto&) { c.bodies[0].mass.inertia(1, 1) = -1; }, true},
        {"NaN inertia", [](auto&, auto& c, auto&) { c.bodies[0].mass.inertia(0, 1) = kNan; }, true},
        {"impossible inertia", [](auto&, auto& c, auto&) { c.bodies[0].mass.inertia = Vec3(1, 1, 5).asDiagonal(); }, true},
        {"NaN centre of mass", [](auto&, auto& c, auto&) { c.bodies[0].mass.centre.x() = kNan; }, true},
        {"zero box", [](auto&, auto& c, auto&) { c.bodies[0].geoms[0].size.x() = 0; }, true},
        {"negative radius", [](auto&, auto& c, auto&) { c.bodies[1].geoms[0].radius = -0.05; }, true},
        {"NaN length", [](auto&, auto& c, auto&) { c.bodies[1].geoms[0].length = kNan; }, true},
        {"infinite box", [](auto&, auto& c, auto&) { c.bodies[0].geoms[0].size.x() = kInf; }, true},
        {"plane on a body", [](auto&, auto& c, auto&) { c.bodies[0].geoms[0].shape = GeomShape::Plane; }, true},
        {"heightfield on a body", [](auto&, auto& c, auto&) { c.bodies[0].geoms.push_back(heights(3, 3, 9, 0)); }, true},
        {"robot at NaN", [](auto& e, auto&, auto&) { e.robots[0].pose.position.x() = kNan; }, true},
        {"robot far out", [](auto& e, auto&, auto&) { e.robots[0].pose.position.x() = 1e12; }, true},
        {"rotation of zeros", [](auto& e, auto&, auto&) { e.robots[0].pose.rotation = Quat(0, 0, 0, 0); }, true},
        {"no bodies",
         [](auto&, auto& c, auto&) {
             c.bodies.clear();
             c.joints.clear();
             c.devices.clear();
         },
         true},
        {"no config", [](auto& e, auto&, auto&) { e.robots[0].config.reset(); }, true},
        {"zero axis", [](auto&, auto& c, auto&) { c.joints[0].axis.setZero(); }, true},
        {"NaN axis", [](auto&, auto& c, auto&) { c.joints[0].axis.x() = kNan; }, true},
        {"joint to itself", [](auto&, auto& c, auto&) { c.joints[0].parent = c.joints[0].child; }, true},
        {"joint to nobody", [](auto&, auto& c, auto&) { c.joints[0].child = 17; }, true},
        {"stops crossed",
         [](auto&, auto& c, auto&) {
             c.joints[0].lowStop = 1;
             c.joints[0].highStop = -1;
         },
         true},
        {"NaN stop", [](auto&, auto& c, auto&) { c.joints[0].lowStop = kNan; }, true},
        {"negative damping", [](auto&, auto& c, auto&) { c.joints[0].damping = -1; }, true},
        {"universal with parallel axes",
         [](auto&, auto& c, auto&) {
             c.joints[0].type = JointType::Universal;
             c.joints[0].axis2 = c.joints[0].axis;
             c.devices.clear();
         },
         true},
        {"suspension of the world",
         [](auto&, auto& c, auto&) {
             c.joints[0].type = JointType::Suspension;
             c.joints[0].parent = kWorldBody;
         },
         true},
        {"zero tick", [](auto& e, auto&, auto&) { e.settings.tick = 0; }, true},
        {"NaN tick", [](auto& e, auto&, auto&) { e.settings.tick = kNan; }, true},
        {"NaN gravity", [](auto& e, auto&, auto&) { e.settings.gravity.z() = kNan; }, true},
        {"no iterations", [](auto& e, auto&, auto&) { e.settings.iterations = 0; }, true},
        {"joints that never close", [](auto& e, auto&, auto&) { e.settings.errorReduction = 0; }, true},
        {"joints that overshoot", [](auto& e, auto&, auto&) { e.settings.errorReduction = 2; }, true},
        {"NaN friction", [](auto& e, auto&, auto&) { e.surfaces[1].friction = kNan; }, true},
        {"restitution 2", [](auto& e, auto&, auto&) { e.surfaces[1].restitution = 2; }, true},
        {"no surface 99", [](auto&, auto& c, auto&) { c.bodies[0].geoms[0].surface = 99; }, true},
        {"mesh without triangles", [](auto&, auto&, auto& s) { s.push_back(meshGeom(meshOf({}, {}), false)); }, true},
        {"mesh of needles",
         [](auto&, auto&, auto& s) {
             s.push_back(meshGeom(meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), false));
         },
         true},
        {"mesh with a wrong index",
         [](auto&, auto&, auto& s) {
             s.push_back(meshGeom(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 9}}), false));
         },
         true},
        {"mesh with NaN",
         [](auto&, auto&, auto& s) {
             s.push_back(meshGeom(meshOf({{0, 0, kNan}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), false));
         },
         true},
        {"mesh that is not there", [](auto&, auto&, auto& s) { s.push_back(meshGeom(nullptr, false)); }, true},
        {"flat hull",
         [](auto&, auto& c, auto&) {
             c.bodies[0].geoms[0] = meshGeom(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}), true);
         },
         true},
        {"heightfield of one column", [](auto&, auto&, auto& s) { s.push_back(heights(1, 5, 5, 0)); }, true},
        {"heightfield with too few samples", [](auto&, auto&, auto& s) { s.push_back(heights(5, 5, 5, 0)); }, true},
        {"heightfield with NaN",
         [](auto&, auto&, auto& s) { s.push_back(heights(3, 3, 9, std::numeric_limits<float>::quiet_NaN())); }, true},
        {"joint to a kind of joint that has no motor", [](auto&, auto& c, auto&) { c.joints[0].type = JointType::Ball; }, true},

        {"robots in one place",
         [](auto& e, auto&, auto&) {
             for (int i = 0; i < 5; ++i) {
                 e.robots.push_back(e.robots[0]);
                 e.robots.back().name += char('a' + i);
             }
         },
         false},
        {"deep under the floor", [](auto& e, auto&, auto&) { e.robots[0].pose.position.z() = -3; }, false},
        {"microscopic wheels", [](auto&, auto& c, auto&) { c.bodies[1].geoms[0].radius = 1e-6; }, false},
        {"feather wheels", [](auto&, auto& c, auto&) { c.bodies[1].mass = massOfSphere(1e-8, 0.05); }, false},
        {"a mountain on wheels",
         [](auto&, auto& c, auto&) {
             c.bodies[0].mass = massOfBox(1e8, {0.3, 0.2, 0.1});
         },
         false},
        {"two joints for one wheel",
         [](auto&, auto& c, auto&) {
             c.joints.push_back(c.joints[0]);
             c.joints.back().name = "again";
         },
         false},
        {"everything fixed twice",
         [](auto&, auto& c, auto&) {
             for (int i = 0; i < 4; ++i)
                 c.joints.push_back(joint("f" + std::to_string(i), JointType::Fixed, i % 2, 2, {0, 0, 0}, Vec3::UnitZ()));
         },
         false},
        {"anchor far from its bodies",
         [](auto&, auto& c, auto&) {
             c.joints[0].anchor = {900, 0, 0};
         },
         false},
        {"stops on the spot", [](auto&, auto& c, auto&) { c.joints[0].lowStop = c.joints[0].highStop = 0; }, false},
        {"start outside the stops",
         [](auto&, auto& c, auto&) {
             c.joints[0].lowStop = 1;
             c.joints[0].highStop = 2;
         },
         false},
        {"infinitely stiff hinge", [](auto&, auto& c, auto&) { c.joints[0].stiffness = 1e12; }, false},
        {"friction of a million",
         [](auto& e, auto&, auto&) {
             for (auto& s : e.surfaces) s.friction = 1e6;
         },
         false},
        {"super balls",
         [](auto& e, auto&, auto&) {
             for (auto& s : e.surfaces) s.restitution = 1;
             e.robots[0].pose.position.z() = 2;
         },
         false},
        {"soft as a cloud",
         [](auto& e, auto&, auto&) {
             for (auto& s : e.surfaces) s.softness = 1e3;
         },
         false},
        {"gravity of a star", [](auto& e, auto&, auto&) { e.settings.gravity.z() = -1e4; }, false},
        {"microscopic wheels in long ticks",
         [](auto& e, auto& c, auto&) {
             c.bodies[1].geoms[0].radius = 1e-6;
             e.settings.tick = 0.1;
         },
         false},
        {"half a second a tick", [](auto& e, auto&, auto&) { e.settings.tick = 0.5; }, false},
        {"a floor that is tilted upside down", [](auto&, auto&, auto& s) { s[0].pose = at(0, 0, 5, degrees(0, 180, 0)); }, false},
        {"self collision of everything",
         [](auto&, auto& c, auto&) {
             c.selfCollision = true;
             c.joints.clear();
             c.devices.clear();
         },
         false},
    };
    return all;
}

} // namespace

class FaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void faultCase_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < faultCases().size(); ++i) QTest::newRow(faultCases()[i].name) << static_cast<int>(i);
    }
    /// No spec causes an assertion: it is refused with a message, or it runs, or it stops with a reason.
    void faultCase() {
        QFETCH(int, index);
        const FaultCase& faultCase = faultCases()[static_cast<std::size_t>(index)];
        Scene scene = r0Scene();
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        std::vector<GeomSpec> scenery{plane("floor", {}, 1)};
        scene.robot("r", {}, config);
        faultCase.spoil(*scene.spec, *config, scenery);
        scene.scenery(scenery);
        Diagnostics diagnostics;
        auto world = scene.build(rowOnly, diagnostics);
        QCOMPARE(world == nullptr, faultCase.refused);
        QCOMPARE(diagnostics.hasErrors(), faultCase.refused);
        for (const Diagnostic& d : diagnostics.all()) {
            qInfo("%s: %s", codeName(d.code).c_str(), d.message.c_str());
            QVERIFY(!d.message.empty());
        }
        if (!world) return;
        for (int i = 0; i < 200; ++i) {
            const Status status = world->tick();
            if (status.ok()) continue;
            qInfo("%s", status.error().message.c_str());
            QVERIFY(world->fault());
            return;
        }
        for (const double v : world->block().slots()) QVERIFY(std::isfinite(v));
    }

    /// An extreme push gives a fault with the body and the time, and the world stays stopped.
    void explosionIsNamed() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(run(*world, 0.1));
        QVERIFY(world->push("r/chassis", {0, 0, 1e7}, {0, 0, 0.1}).ok());
        const Status status = world->tick();
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, Code::BlowUp);
        qInfo("%s", status.error().message.c_str());
        QVERIFY(world->fault());
        QCOMPARE(QString::fromStdString(world->fault()->body).left(2), QString("r/"));
        QVERIFY(std::abs(world->fault()->time - 0.11) < 1e-9);
        const std::uint64_t ticks = world->ticks();
        QVERIFY(!world->tick().ok());
        QCOMPARE(world->ticks(), ticks);
    }

    /// The source range of a message is the name, not the whole block.
    void messagesNameObjects() {
        const SourceRange block{0, {0, 100}}, name{0, {6, 11}};
        Scene scene = r0Scene();
        auto config = r0();
        for (BodySpec& b : config->bodies) b.range = block, b.nameRange = name;
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, config);
        auto world = scene.build();
        QVERIFY(world->push("r/chassis", {0, 0, 1e7}, {0, 0, 0.1}).ok());
        QVERIFY(!world->tick().ok());
        QCOMPARE(world->fault()->range, name);

        config->bodies[1].mass.mass = -1;
        Diagnostics diagnostics;
        QVERIFY(!scene.build(rowOnly, diagnostics));
        QCOMPARE(diagnostics.all().at(0).range, name);
    }

    /// `joints` equal hinges hold one body of 1e-8 kg: more than one makes singular rows, four with friction more than any give helps.
    static Scene knotted(int joints, double friction) {
        Scene scene;
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("knot", at(0, 0, 1), massOfBox(1e-8, {0.1, 0.2, 0.3}), {}));
        for (int i = 0; i < joints; ++i) {
            config->joints.push_back(joint("j" + std::to_string(i), JointType::Hinge, kWorldBody, 0, {0.1, 0, 1}, Vec3::UnitY()));
            config->joints.back().friction = friction;
        }
        scene.robot("r", {}, config);
        scene.loose("alone", at(3, 2, 9, degrees(10, 20, 30)), massOfBox(2, {0.1, 0.2, 0.3}, {0.05, -0.03, 0.02}), {});
        return scene;
    }

    /// A tick that is repeated with more give starts from the state before it, with the same pushes: a free body far from the singular
    /// rows moves as without them.
    void repeatedTicksStartFromTheSameState() {
        std::vector<double> ends[3];
        for (const int joints : {1, 2, 4}) {
            auto world = knotted(joints, joints == 4 ? 1 : 0).build();
            for (int i = 0; i < 20; ++i) {
                QVERIFY(world->push("alone/body", {30, -20, 50}, position(*world, "alone/body") + Vec3(0.2, 0.3, -0.1)).ok());
                QVERIFY(world->tick().ok());
            }
            QVERIFY(joints == 1 ? world->solves().rescuedTicks == 0
                                : world->solves().rescuedTicks >= 19); // rows may just not be singular
            QCOMPARE(world->solves().quickTicks > 0, joints == 4);
            for (const char* path : {"alone/body/pose", "alone/body/velocity"}) {
                const auto entry = world->layout().find(path);
                ends[joints / 2].insert(ends[joints / 2].end(), slot(*world, path), slot(*world, path) + entry->count);
            }
        }
        QCOMPARE(ends[1], ends[0]);
        for (std::size_t i = 0; i < ends[0].size(); ++i) QVERIFY(std::abs(ends[2][i] - ends[0][i]) < 1e-9);
    }

    /// A rod of 10 micrograms on the floor makes ODE's exact solver fail an assertion: such ticks are repeated like those
    /// that it could not solve, and a world that cannot continue reports the body and a remedy.
    void recoversFromSolverAssertions() {
        for (int i = 0; i < 8; ++i) {
            Scene scene;
            scene.scenery({plane("floor")});
            const Vec3 size(0.01, 0.01, 0.5 + 0.2 * i);
            scene.loose("rod", at(0, 0, 0.012, degrees(20.0 * i, 90, 3.0 * i)), massOfBox(1e-8, size), {box("b", size)});
            auto world = scene.build();
            QVERIFY(world);
            for (int tick = 0; tick < 300; ++tick) {
                const Status status = world->tick();
                QVERIFY2(status.ok(), status.ok() ? "" : status.error().message.c_str());
            }
            QVERIFY(std::abs(world->robotPose(0).position.z()) < 0.05);
        }
    }

    void countsRequestedQuickTicks() {
        Scene scene = r0Scene();
        scene.spec->settings.solver = SolverChoice::Quick;
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(run(*world, 0.5));
        QCOMPARE(world->solves().quickTicks, world->ticks());
    }

    /// Every fault message names a body and a remedy, and does not quote the engine's messages.
    void everyFaultNamesABodyAndARemedy() {
        int faults = 0;
        for (const FaultCase& faultCase : faultCases()) {
            if (faultCase.refused) continue;
            Scene scene = r0Scene();
            auto config = std::make_shared<RobotConfigSpec>(*r0());
            std::vector<GeomSpec> scenery{plane("floor", {}, 1)};
            scene.robot("r", {}, config);
            faultCase.spoil(*scene.spec, *config, scenery);
            scene.scenery(scenery);
            auto world = scene.build();
            QVERIFY(world);
            for (int i = 0; i < 200 && !world->fault(); ++i) (void)world->tick();
            if (!world->fault()) continue;
            ++faults;
            const QString reason = QString::fromStdString(world->fault()->reason);
            QVERIFY2(!world->fault()->body.empty(), faultCase.name);
            QVERIFY2(reason.contains("Tick") || reason.contains("give it more mass"),
                     qPrintable(faultCase.name + (": " + reason)));
            for (const char* word : {"assert", "dx", "ODE", "matrix", ".cpp"})
                QVERIFY2(!reason.contains(word), qPrintable(reason));
        }
        QVERIFY(faults >= 2);
    }

    void pushesAreChecked() {
        Scene scene = r0Scene();
        scene.robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(!world->push("r/nobody", {1, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(!world->push("r/chassis", {kNan, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(!world->push("r/chassis", {1e30, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(!world->place("nobody", {}).ok());
        QVERIFY(!world->place("r", at(kNan, 0, 0)).ok());
        QVERIFY(!world->place("r", {Vec3::Zero(), Quat(0, 0, 0, 0)}).ok());
    }

    /// A commanded NaN stops the run with the device's name; it never reaches the engine.
    void nanCommandNamesTheDevice() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        command(*world, "r/leftMotor", kNan, 0, 5);
        const Status status = world->tick();
        QVERIFY(!status.ok());
        QCOMPARE(status.error().code, Code::DeviceSetup);
        QVERIFY(QString::fromStdString(status.error().message).contains("r/leftMotor"));
    }
};

QTEST_APPLESS_MAIN(FaultsTest)
#include "faults_test.moc"
