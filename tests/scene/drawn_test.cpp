// Draw calls and triangles of an image, which determine the drawing time without a graphics card.
#include <QtTest>

#include <numbers>

#include <osgUtil/SceneView>
#include <osgUtil/Statistics>

#include "render/sample_experiment.h"
#include "scene/nodes/osg_types.h"
#include "scene/scene.h"

using namespace trundle;

namespace {

struct Drawn {
    unsigned draws = 0, triangles = 0, points = 0;
};

/// Counts the draw calls and triangles of an image with this mask without drawing, so no OpenGL is needed.
Drawn drawnOf(Scene& scene, const CameraView& view, int width, int height, std::uint32_t mask) {
    osg::ref_ptr<osgUtil::SceneView> drawing = new osgUtil::SceneView;
    drawing->setDefaults(osgUtil::SceneView::NO_SCENEVIEW_LIGHT);
    drawing->setState(new osg::State);
    drawing->setFrameStamp(new osg::FrameStamp);
    drawing->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    drawing->getCamera()->setViewport(0, 0, width, height);
    const double half = 0.05 * std::tan(0.5 * view.fieldOfView), aspect = double(height) / width;
    drawing->getCamera()->setProjectionMatrixAsFrustum(-half, half, -half * aspect, half * aspect, 0.05, 10000);
    drawing->getCamera()->setViewMatrixAsLookAt(toOsg(view.eye), toOsg(view.target), toOsg(view.up));
    drawing->setSceneData(&scene.root());
    drawing->setCullMask(mask);
    drawing->cull();
    osgUtil::Statistics counts;
    drawing->getStats(counts);
    Drawn drawn{static_cast<unsigned>(counts.numDrawables)};
    for (const auto& [mode, number] : counts.getPrimitiveCountMap()) {
        if (mode == GL_TRIANGLES) drawn.triangles += number;
        if (mode == GL_POINTS) drawn.points += number;
    }
    return drawn;
}

/// A camera that sees all 49 robots.
CameraView aboveTheCrowd() {
    CameraView view;
    view.eye = {-6.4, 0, 3.3};
    view.target = {0, 0, 0};
    view.fieldOfView = 60 * std::numbers::pi / 180;
    return view;
}

} // namespace

class DrawnTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void smallObjectsHaveFewTriangles_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<unsigned>("most"); // triangles of a robot with its wheels
        QTest::newRow("64") << 64 << 40u;   // two boxes and a ball of eight; wheels less than two pixels large are left out
        QTest::newRow("320") << 320 << 90u;
        QTest::newRow("640") << 640 << 120u;
        QTest::newRow("1920") << 1920 << 400u;
    }
    void smallObjectsHaveFewTriangles() {
        QFETCH(int, width);
        QFETCH(unsigned, most);
        Scene scene(*sampleExperiment({49, 0.7, false, 4}));
        const Drawn drawn = drawnOf(scene, aboveTheCrowd(), width, width * 3 / 4, kMaskRobots);
        QVERIFY(drawn.draws >= 49 && drawn.draws <= 3 * 49);
        QVERIFY2(drawn.triangles >= 24 * 49 && drawn.triangles <= most * 49, qPrintable(QString::number(drawn.triangles / 49.0)));
    }

    /// Walls around the eye: their size on the screen is infinite, of the whole static as of all levels of detail.
    void whatIsAroundTheEyeIsDrawn() {
        const auto experiment = sampleExperiment({1, 0.7, true, 4});
        Scene scene(*experiment);
        scene.makeData(*experiment);
        for (const double aside : {0.0, 1e-9, 1e-3, 0.1}) {
            CameraView view;
            view.eye = {aside, 0.3, 0.2};
            view.target = {aside + 1, 0.3, 0.2};
            view.fieldOfView = 60 * std::numbers::pi / 180;
            for (const std::uint32_t mask : {kMaskStatics, kMaskData})
                QVERIFY(drawnOf(scene, view, 320, 240, mask).triangles > 0);
        }
    }

    /// At any distance; a point casts no shadow.
    void drawsTinyObjectsAsPoints() {
        const auto experiment = sampleExperiment({49, 0.7, true, 6});
        Scene scene(*experiment);
        scene.setHidden({"arena"});
        CameraView view = aboveTheCrowd();
        QCOMPARE(drawnOf(scene, view, 640, 480, kMaskRobots).points, 0u);
        for (const double factor : {20., 200.}) {
            view.eye = factor * aboveTheCrowd().eye;
            const Drawn far = drawnOf(scene, view, 160, 120, kMaskRobots | kMaskShadows);
            QCOMPARE(far.points, 49u);
            QCOMPARE(far.draws, 49u);
            QCOMPARE(far.triangles, 0u);
        }
        // The point is hidden and shown together with its object.
        scene.makeData(*experiment);
        scene.setHidden({"arena", "robot3"});
        scene.followData();
        for (const std::uint32_t mask : {kMaskRobots, kMaskData}) QCOMPARE(drawnOf(scene, view, 160, 120, mask).points, 48u);
        scene.setHidden({"arena", "robot3/chassis/hull"});
        scene.setHidden({"arena"});
        QCOMPARE(drawnOf(scene, view, 160, 120, kMaskRobots).points, 49u);
    }

    /// In colour and in data images; what is hidden in another way is compared with.
    void whatMovesInAStaticIsHiddenWithIt() {
        const auto experiment = sampleExperiment({2, 0.7, true, 6});
        experiment->robots[0].name = "arena";
        experiment->robots[0].scenery = experiment->statics[0].geoms;
        Scene scene(*experiment);
        scene.makeData(*experiment);
        CameraView view = aboveTheCrowd();
        view.eye *= 0.3;
        const auto trianglesOf = [&](const std::vector<std::string>& hidden, std::uint32_t mask) {
            scene.setHidden(hidden);
            scene.followData();
            return drawnOf(scene, view, 640, 480, mask).triangles;
        };
        const std::vector<std::string> each{"arena", "arena/chassis", "arena/leftWheel", "arena/rightWheel"};
        for (const std::uint32_t mask : {kMaskRobots, kMaskData}) {
            const unsigned all = trianglesOf({}, mask), others = trianglesOf(each, mask);
            QVERIFY(others > 0 && all > others);
            QCOMPARE(trianglesOf({"arena"}, mask), others);
            QCOMPARE(trianglesOf({}, mask), all);
        }
    }

    void theShadowsOfAllAreOneDrawAndNoMoreThanTheirOutlines() {
        Scene scene(*sampleExperiment({49, 0.7, true, 6}));
        for (const int width : {64, 320, 640, 1920}) {
            const auto count = [&](std::uint32_t mask) { return drawnOf(scene, aboveTheCrowd(), width, width * 3 / 4, mask); };
            const Drawn bodies = count(kMaskRobots | kMaskStatics), both = count(kMaskRobots | kMaskStatics | kMaskShadows);
            QCOMPARE(both.draws, bodies.draws + 1);
            QVERIFY2(both.triangles - bodies.triangles <= bodies.triangles, qPrintable(QString::number(width)));
        }
    }

    void texturedMeshCastsOneShadow() {
        auto experiment = sampleExperiment({0, 1, true, 4});
        const auto picture = [] {
            auto raster = std::make_shared<Raster>();
            raster->width = raster->height = 1;
            raster->pixels = {255, 0, 0};
            return raster;
        };
        std::vector<GeomSpec> geoms;
        for (int i = 0; i < 5; ++i) {
            GeomSpec box;
            box.name = "box" + std::to_string(i);
            box.size = {0.1, 0.1, 0.1};
            box.pose.position = {0.2 * i, 0, 0.05};
            box.material = static_cast<std::uint32_t>(experiment->materials.size());
            experiment->materials.emplace_back().picture = picture();
            geoms.push_back(box);
        }
        StaticSpec row;
        row.name = "row";
        row.geoms = std::make_shared<const std::vector<GeomSpec>>(geoms);
        experiment->statics.push_back(row);
        Scene scene(*experiment);
        scene.setHidden({"arena"});
        QCOMPARE(drawnOf(scene, aboveTheCrowd(), 640, 480, kMaskStatics).draws, 5u);
        const Drawn both = drawnOf(scene, aboveTheCrowd(), 640, 480, kMaskStatics | kMaskShadows);
        QCOMPARE(both.draws, 6u);
        // Hidden parts cast no shadow.
        scene.setHidden({"arena", "row/box1", "row/box2"});
        const Drawn fewer = drawnOf(scene, aboveTheCrowd(), 640, 480, kMaskStatics | kMaskShadows);
        QCOMPARE(fewer.triangles, both.triangles * 3 / 5);
    }
};

QTEST_APPLESS_MAIN(DrawnTest)
#include "drawn_test.moc"
