// What distance sensors measure, drawn over the 3D view.
#include <numbers>

#include <QtTest>

#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/beams.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kScanner = R"(Tick = 0.01
#import common/materials.sim
#import common/surfaces.sim
#import arenas/medium_arena.sim
Static arena { Config=MediumArena Pos=0,0,0 }
RobotConfig Scanner {
  Body base { Box hull { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=2 Material=grey Surface=plastic } }
  Lidar scan { Body=base Pos=0,0,0.15 Beams=4 MaxRange=5 }
  RangeSensor front { Body=base Pos=0,0,0.2 Type=ultrasonic MaxRange=3 }
  GroundSensor below { Body=base Pos=0.5,0,0.02 }
}
Robot robot0 { Config=Scanner Pos=-0.5,0,0 }
)";

} // namespace

class BeamsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;

    QImage shown() { return m_window->view().grab().toImage().convertToFormat(QImage::Format_RGB32); }
    void step() {
        m_window->session.step();
        EVENTUALLY(m_window->session.results().snapshot && m_window->session.results().snapshot->tick > 0);
        EVENTUALLY(m_window->panel->views().isUpToDate());
    }

private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kScanner));
        m_window->look({0, 0, 7}, {0, 0.001, 0});
        EVENTUALLY(m_window->panel->views().isUpToDate());
    }
    void cleanup() { m_window.reset(); }

    void modelsAreThoseOfTheExperiment() {
        const auto& sensors = m_window->panel->world().rangeSensors();
        QCOMPARE(sensors.size(), std::size_t(3));
        QCOMPARE(sensors[2].signal(), std::string("robot0/below/reflectance"));
        QCOMPARE(sensors[0].signal(), std::string("robot0/scan/ranges"));
        QVERIFY(sensors[0].closed && sensors[0].directions.size() == 4);
        const Vec3 ways[] = {-Vec3::UnitX(), -Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitY()};
        for (std::size_t i = 0; i < 4; ++i) QVERIFY((sensors[0].directions[i] - ways[i]).norm() < 1e-12);
        QCOMPARE(sensors[1].signal(), std::string("robot0/front/range"));
        QVERIFY(std::abs(sensors[1].coneAngle - std::numbers::pi / 6) < 1e-12);
    }

    /// In the middle of the picture, by the colour 0.60,0.59,0.56 of the floor.
    void aGroundSensorIsADotAsBrightAsItsReading() {
        m_window->selection.select("robot0.below");
        step();
        const QImage drawn = shown();
        const double expected = 255 * std::sqrt(0.2126 * 0.36 + 0.7152 * 0.59 * 0.59 + 0.0722 * 0.56 * 0.56);
        const QColor middle = drawn.pixelColor(drawn.width() / 2, drawn.height() / 2);
        QVERIFY2(std::abs(middle.red() - expected) < 1.5 && middle.red() == middle.green() && middle.green() == middle.blue(),
                 qPrintable(middle.name()));
    }

    void selectedSensorsAreDrawnUnasked() {
        const QImage plain = shown();
        m_window->selection.select("robot0.scan");
        const QImage selected = shown();
        QVERIFY(selected != plain);
        m_window->selection.select("robot0.front");
        QVERIFY(shown() != selected);
        m_window->selection.clear();
        QCOMPARE(shown(), plain);
        m_window->trigger("view.overlayBeams");
        const QImage all = shown();
        QVERIFY(all != plain);
        m_window->trigger("view.overlayBeams");
        QCOMPARE(shown(), plain);
    }

    void aDotIsWhereABeamHits() {
        step();
        m_window->trigger("view.overlayBeams");
        const QImage image = shown();
        for (const Vec3& hit : {Vec3(-2, 0, 0.15), Vec3(2, 0, 0.15), Vec3(-0.5, 2, 0.15), Vec3(-0.5, -2, 0.15)}) {
            const QPointF at = m_window->at(hit);
            const QColor colour = image.pixelColor(at.toPoint());
            QVERIFY2(colour.red() > 180 && colour.green() < 130,
                     qPrintable(QStringLiteral("%1 %2: ").arg(at.x()).arg(at.y()) + colour.name()));
        }
    }

    /// A lidar of hundreds of beams: floor and robot stay readable, what it has measured is seen.
    void manyBeamsLeaveThePictureReadable() {
        QVERIFY(m_window->open(QByteArray(kScanner).replace("Beams=4", "Beams=360")));
        EVENTUALLY(m_window->panel->views().isUpToDate());
        step();
        const QImage plain = shown();
        m_window->selection.select("robot0.scan");
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QImage drawn = shown();
        double change = 0;
        int strong = 0, hits = 0;
        for (int y = 0; y < plain.height(); ++y)
            for (int x = 0; x < plain.width(); ++x) {
                const QColor a = plain.pixelColor(x, y), b = drawn.pixelColor(x, y);
                const int most =
                    std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
                change += most;
                strong += most > 24;
                hits += most > 60;
            }
        const double pixels = double(plain.width()) * plain.height();
        const QByteArray measured =
            "mean " + QByteArray::number(change / pixels) + ", strong " + QByteArray::number(strong / pixels);
        QVERIFY2(change / pixels < 6 && strong / pixels < 0.06, measured);
        QVERIFY2(hits > 300, QByteArray::number(hits)); // dots
    }

    void aReadingIsDrawnWhereItWasMeasured() {
        const RangeModel sensor{"r/scan", "r", 0, {}, 5, 0, 2, 1, false, false, {Vec3::UnitX(), Vec3::UnitY()}};
        SignalLayout layout;
        layout.beginRobot("r");
        layout.add("base/velocity", "m/s", SignalType::Real, SignalDirection::Truth, 6);
        layout.add("scan/ranges", "m", SignalType::Real, SignalDirection::Output, 2);
        layout.add("scan/time", "s", SignalType::Real, SignalDirection::Output, 1);
        auto block = std::make_shared<SignalBlock>(layout);
        const double values[] = {1, 2, 0, 0, 0, 0.5, 3, 4, -1};
        std::copy(std::begin(values), std::end(values), block->slots().begin());
        LiveSnapshot snapshot;
        snapshot.block = block;
        snapshot.time = 1;
        snapshot.tick = 100;
        QVERIFY(distancesOf(sensor, layout, snapshot).empty()); // no reading yet
        block->slots()[8] = 0.8;
        QCOMPARE(distancesOf(sensor, layout, snapshot)[1], 4.);
        const Pose at = poseAtReading(sensor, "base", layout, snapshot, {Vec3(5, 5, 0), rotationFromHpr({0.3, 0, 0})});
        QVERIFY((at.position - Vec3(4.8, 4.6, 0)).norm() < 1e-12);
        QVERIFY(at.rotation.angularDistance(rotationFromHpr({0.2, 0, 0})) < 1e-12);
    }
};

QTEST_MAIN(BeamsTest)
#include "beams_test.moc"
