// The scene graph: nodes, sharing, picking.
#include <QtTest>

#include <set>

#include <osg/Geometry>
#include <osg/NodeVisitor>

#include "render/sample_experiment.h"
#include "scene/queries/framing.h"
#include "scene/scene.h"

using namespace trundle;

namespace {

/// Counts the nodes below a node, shared ones once. Parents that belong to shadows are ignored.
struct Count : osg::NodeVisitor {
    std::set<osg::Geometry*> geometries;
    std::set<osg::Node*> nodes;
    std::size_t drawings = 0;
    Count() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setTraversalMask(kMaskRobots | kMaskStatics); }
    void apply(osg::Node& node) override {
        nodes.insert(&node);
        traverse(node);
    }
    void apply(osg::Geometry& geometry) override {
        geometries.insert(&geometry);
        ++drawings;
    }
};

Count countOf(Scene& scene) {
    Count count;
    scene.root().accept(count);
    return count;
}

ViewRay downAt(double x, double y) { return {{x, y, 5}, {0, 0, -1}}; }

} // namespace

class SceneTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aThousandRobotsShareTheirGeometry() {
        Scene one(*sampleExperiment({1})), many(*sampleExperiment({1000}));
        const Count few = countOf(one), lots = countOf(many);
        QCOMPARE(lots.geometries.size(), few.geometries.size());
        QCOMPARE(many.store().made(), one.store().made());
        QCOMPARE(one.store().made(), std::size_t(3)); // chassis, wheel, arena
        // Each further robot adds one node and one per body.
        QCOMPARE(lots.nodes.size() - few.nodes.size(), std::size_t(999 * 4));
        QVERIFY(lots.drawings > 999 * 3);
    }

    /// Thousands of balls that all differ share nothing: those that come late are drawn coarsely, so that they fit into memory.
    void manyDifferentShapesAreCoarse() {
        const auto experiment = sampleExperiment({1});
        const std::vector<MaterialSpec> materials;
        ShapeStore store;
        std::size_t first = 0, last = 0, all = 0;
        std::vector<osg::ref_ptr<osg::Group>> kept;
        for (int i = 0; i < 4000; ++i) {
            GeomSpec ball;
            ball.shape = GeomShape::Sphere;
            ball.radius = 0.01 + 1e-6 * i;
            kept.push_back(store.nodeOf(std::span(&ball, 1), materials));
            Count count;
            count.setTraversalMask(~0u);
            kept.back()->accept(count);
            last = 0;
            for (const osg::Geometry* geometry : count.geometries) last += geometry->getVertexArray()->getNumElements();
            if (i == 0) first = last;
            all += last;
        }
        QVERIFY2(first > 5000 && last < 500 && all < 30'000'000, qPrintable(QString("%1 %2 %3").arg(first).arg(last).arg(all)));
        kept.clear();
        store.forgetUnused();
        GeomSpec ball;
        ball.shape = GeomShape::Sphere;
        ball.radius = 1;
        Count again;
        again.setTraversalMask(~0u);
        store.nodeOf(std::span(&ball, 1), materials)->accept(again);
        std::size_t points = 0;
        for (const osg::Geometry* geometry : again.geometries) points += geometry->getVertexArray()->getNumElements();
        QCOMPARE(points, first);
    }

    void rebuildsOnlyChangedNodes() {
        auto experiment = sampleExperiment({2});
        auto other = std::make_shared<RobotConfigSpec>(*experiment->robots[1].config);
        experiment->robots[1].config = other;
        QCOMPARE(Scene(*experiment).store().made(), std::size_t(3));
        other->bodies[1].geoms[0].radius *= 2;
        QCOMPARE(Scene(*experiment).store().made(), std::size_t(4));
    }

    void aSceneAfterAnEditIsMadeOfWhatIsThere() {
        auto store = std::make_shared<ShapeStore>();
        Scene before(*sampleExperiment({300}), store);
        const std::size_t made = store->made();
        auto edited = sampleExperiment({300});
        edited->robots[7].pose.position.x() += 1;
        edited->robots[9].name = "renamed";
        Scene after(*edited, store);
        QCOMPARE(store->made(), made);
        edited->materials[3].colour = {0, 1, 0};
        Scene recoloured(*edited, store);
        QCOMPARE(store->made(), made + 1); // the body with the red bumper
    }

    /// Balls that differ in one value of their materials share no shape; those of equal materials do.
    void whatDiffersInAMaterialIsDrawnApart() {
        std::vector<MaterialSpec> materials(9);
        for (std::size_t k = 0; k < 3; ++k) materials[1 + k].colour[k] = 0.3, materials[4 + k].emission[k] = 0.3;
        materials[7].opacity = 0.5;
        materials[8].shininess = 0.5;
        ShapeStore store;
        std::vector<osg::ref_ptr<osg::Group>> kept;
        for (int round = 0; round < 2; ++round)
            for (std::uint32_t m = 0; m < materials.size(); ++m) {
                GeomSpec ball;
                ball.shape = GeomShape::Sphere;
                ball.radius = 0.1;
                ball.material = m;
                kept.push_back(store.nodeOf(std::span(&ball, 1), materials));
            }
        QCOMPARE(store.made(), materials.size());
        std::set<osg::Group*> shapes;
        for (const auto& shape : kept) shapes.insert(shape.get());
        QCOMPARE(shapes.size(), materials.size());
    }

    void releasesUnusedPictures() {
        auto store = std::make_shared<ShapeStore>();
        auto scene = std::make_unique<Scene>(*sampleExperiment({2}), store);
        store->forgetUnused();
        (void)Scene(*sampleExperiment({2}), store);
        QCOMPARE(store->made(), std::size_t(3));
        scene.reset();
        store->forgetUnused();
        (void)Scene(*sampleExperiment({2}), store);
        QCOMPARE(store->made(), std::size_t(6));
    }

    void aPickNamesRobotBodyAndGeom() {
        const auto experiment = sampleExperiment({1});
        Scene scene(*experiment);
        const auto hit = [&](double x, double y) {
            const auto h = scene.pick(downAt(x, y));
            return h ? h->path : std::string("nothing");
        };
        QCOMPARE(hit(0, 0), std::string("robot0/chassis/hull"));
        QCOMPARE(hit(0.16, 0.14), std::string("robot0/chassis/bumper"));
        QCOMPARE(hit(0.06, 0.13), std::string("robot0/leftWheel/tyre"));
        QCOMPARE(hit(0.06, -0.13), std::string("robot0/rightWheel/tyre"));
        QCOMPARE(hit(2.05, 0.3), std::string("arena/east"));
        QCOMPARE(hit(-1, 1), std::string("nothing"));
        const auto floor = scene.pick(downAt(-1, 1), kMaskFloor | kMaskRobots);
        QVERIFY(floor);
        QCOMPARE(floor->path, std::string("arena/floor"));
        const auto roof = scene.pick(downAt(0, 0));
        QVERIFY(std::abs(roof->point.z() - 0.14) < 1e-6 && std::abs(roof->distance - 4.86) < 1e-6);
        QVERIFY(!scene.pick(downAt(0, 0), kMaskStatics)); // objects outside the mask are not picked
    }

    void aMovedRobotIsPickedWhereItIs() {
        const auto experiment = sampleExperiment({1});
        Scene scene(*experiment);
        BodyPoses poses = startPoses(*experiment);
        for (Pose& pose : poses) pose.position += Vec3(1, 1, 0);
        scene.setPoses(poses);
        QVERIFY(!scene.pick(downAt(0, 0)));
        QCOMPARE(scene.pick(downAt(1, 1))->path, std::string("robot0/chassis/hull"));
    }

    void posesOfAnotherExperimentOrNoPosesChangeNothing() {
        const auto experiment = sampleExperiment({2});
        Scene scene(*experiment);
        scene.setPoses(BodyPoses(3));
        BodyPoses broken = startPoses(*experiment);
        for (Pose& pose : broken) pose.position.x() = std::nan("");
        scene.setPoses(broken);
        QVERIFY(scene.pick(downAt(-0.35, -0.35)));
        QVERIFY(scene.bounds().size().allFinite());
    }

    void omitsInvisibleAndBroken() {
        auto experiment = sampleExperiment({1});
        auto geoms = *experiment->statics[0].geoms;
        geoms[1].visible = false;
        geoms[2].size.x() = std::nan("");
        geoms[3].material = 9999; // drawn with the default material
        geoms[4].pose.position.z() = INFINITY;
        experiment->statics[0].geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
        Scene scene(*experiment);
        QVERIFY(!scene.pick(downAt(0.5, 2.05)));
        QVERIFY(!scene.pick(downAt(0.5, -2.05)));
        QVERIFY(scene.pick(downAt(2.05, 0.3)));
        QVERIFY(!scene.pick(downAt(-2.05, 0.3)));
    }

    void robotsWithoutAConfigAndEmptyExperimentsAreScenes() {
        ExperimentSpec empty;
        Scene nothing(empty);
        QVERIFY(nothing.bounds().empty());
        empty.robots.resize(3);
        empty.statics.resize(2);
        Scene hollow(empty);
        QVERIFY(hollow.bounds().empty());
        QVERIFY(isUsable(defaultView(empty, {}, 640, 480)));
    }

    void theDefaultViewShowsRobotsAndTheirRoom() {
        const auto experiment = sampleExperiment({4});
        const CameraView view = defaultView(*experiment, startPoses(*experiment), 1280, 720);
        for (const Vec3& corner : {Vec3(2.1, 2.1, 0), Vec3(-2.1, 2.1, 0.3), Vec3(2.1, -2.1, 0.3), Vec3(-2.1, -2.1, 0)}) {
            const auto at = project(view, 1280, 720, corner);
            QVERIFY(at && at->x > 0 && at->x < 1280 && at->y > 0 && at->y < 720);
        }
    }

    void robotStaysVisibleInLargeHall() {
        const auto experiment = sampleExperiment({1, 0.7, true, 400});
        const CameraView view = defaultView(*experiment, startPoses(*experiment), 1280, 720);
        const auto front = project(view, 1280, 720, {0.15, 0, 0.09}), back = project(view, 1280, 720, {-0.15, 0, 0.09});
        QVERIFY(front && back);
        QVERIFY(std::hypot(front->x - back->x, front->y - back->y) > 20);
    }
};

QTEST_APPLESS_MAIN(SceneTest)
#include "scene_test.moc"
