// What the views of a panel share: labels and hints, settings, joint positions, dragged objects, the scene's bounds and paths.
#include <limits>
#include <numbers>

#include <QApplication>
#include <QPainter>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "editor/viewport/context/dragged_object.h"
#include "editor/viewport/context/joint_positions.h"
#include "editor/viewport/context/label.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/view_hints.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/paint_record.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

namespace {

using Drawn = PaintedShape::Kind;

template <class Paint> PaintRecord painted(const QSize& size, Paint paint) {
    PaintRecord record(size);
    QPainter painter(&record);
    paint(painter);
    painter.end();
    return record;
}

/// The rectangles of labels, in the order of painting.
std::vector<QRectF> boxesOf(const PaintRecord& record) {
    std::vector<QRectF> boxes;
    for (const PaintedShape& shape : record.of(Drawn::Polygon)) boxes.push_back(shape.points.boundingRect());
    return boxes;
}

/// Robots whose rod turns about y at 0.1,0,0.2, and whose plate turns about x and about the turned y at its own origin.
const QByteArray kArms = R"(RobotConfig Arm {
  Body base { Box hull { Size=0.2,0.1,0.1 Mass=2 } }
  Body rod { Pos=0.1,0,0.4 HPR=0,30,0 Box bar { Size=0.05,0.05,0.4 Mass=1 } }
  Body plate { Pos=0,0.5,0.3 Box top { Size=0.2,0.1,0.02 Mass=1 } }
  Hinge elbow { Parent=base Child=rod Anchor=0.1,0,0.2 Axis=0,1,0 }
  Universal gimbal { Parent=base Child=plate Axis=1,0,0 Axis2=0,1,0 }
}
RobotConfig Plain { Body base { Box hull { Size=0.4,0.2,0.2 Mass=2 } } }
StaticConfig Yard { Box wall { Size=2,0.2,1 Pos=0,0,0.5 } }
StaticConfig Shed { Box wall { Size=1,0.2,3 Pos=0,0,1.5 } }
Static yard { Config=Yard Pos=0,-3,0 }
Static shed { Config=Shed Pos=0,4,0 }
Robot plain { Config=Plain Pos=3,0,0.5 }
Robot one { Config=Arm Pos=-1,0,0 HPR=90,0,0 }
Robot two { Config=Arm Pos=1,0.5,0 HPR=-40,0,0 }
)";

} // namespace

class ContextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        QCoreApplication::setOrganizationName(QStringLiteral("trundle-test"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }
    void init() { QSettings().clear(); }

    /// The required ones take their first places, others the first that is free, or none.
    void labelsGiveWay() {
        const QFontMetricsF metrics{QFont()};
        const QRectF area(0, 0, 500, 300);
        const QPointF a(100, 100), b(100, 200), c(300, 100);
        const LabelRequest first{QStringLiteral("first"), {a, b}, false}, needed{QStringLiteral("needed"), {a, c}, true},
            alone{QStringLiteral("alone"), {b, a}, false}, again{QStringLiteral("again"), {a}, true},
            last{QStringLiteral("last"), {b, c}, true};
        const auto places = [&](const std::vector<LabelRequest>& requests) {
            QStringList all;
            for (const PlacedLabel& label : placeLabels(requests, metrics, area))
                all << label.text + (label.middle == a ? u'a' : label.middle == b ? u'b' : u'c');
            return all.join(u' ');
        };
        QCOMPARE(places({first, needed}), QStringLiteral("neededa firstb"));
        QCOMPARE(places({first, needed, alone}), QStringLiteral("neededa firstb"));
        QCOMPARE(places({alone, first, needed}), QStringLiteral("neededa aloneb"));
        QCOMPARE(places({needed, again, last}), QStringLiteral("neededa againa lastb"));
        QCOMPARE(places({again, needed, last}), QStringLiteral("againa neededc lastb"));
    }

    void labelsStayInside_data() {
        QTest::addColumn<QPointF>("middle");
        QTest::addColumn<bool>("isMoved");
        QTest::newRow("in the middle") << QPointF(200, 100) << false;
        QTest::newRow("left") << QPointF(3, 100) << true;
        QTest::newRow("right") << QPointF(397, 100) << true;
        QTest::newRow("top") << QPointF(200, 2) << true;
        QTest::newRow("bottom") << QPointF(200, 199) << true;
        QTest::newRow("corner") << QPointF(399, 199) << true;
    }
    void labelsStayInside() {
        QFETCH(QPointF, middle);
        QFETCH(bool, isMoved);
        const QRectF area(0, 0, 400, 200);
        const auto boxes =
            boxesOf(painted(QSize(400, 200), [&](QPainter& p) { paintLabel(p, middle, QStringLiteral("some words")); }));
        QCOMPARE(boxes.size(), std::size_t(1));
        QVERIFY(area.contains(boxes[0]));
        QCOMPARE((boxes[0].center() - middle).manhattanLength() > 1e-6, isMoved);
        const LabelRequest request{QStringLiteral("some words"), {middle}, true};
        const auto placed = placeLabels({&request, 1}, QFontMetricsF{QFont()}, area);
        QVERIFY(area.contains(placed[0].rect));
    }

    /// The hint at the lower edge, in lines where the view is narrow; the one beside the mouse stays inside and off the other.
    void hintsStayReadable_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QPointF>("cursor");
        QTest::addColumn<bool>("isAbove"); // the cursor
        QTest::newRow("beside it") << QSize(800, 600) << QPointF(300, 200) << false;
        QTest::newRow("at the right edge") << QSize(800, 600) << QPointF(795, 200) << false;
        QTest::newRow("at the lower edge") << QSize(800, 600) << QPointF(100, 590) << true;
        QTest::newRow("at the other hint") << QSize(800, 600) << QPointF(390, 530) << true;
        QTest::newRow("in a narrow view") << QSize(110, 600) << QPointF(50, 500) << true;
        QTest::newRow("at the left edge") << QSize(800, 600) << QPointF(-40, 200) << false;
    }
    void hintsStayReadable() {
        QFETCH(QSize, size);
        QFETCH(QPointF, cursor);
        QFETCH(bool, isAbove);
        ViewHints hints;
        hints.setHint(QStringLiteral("Drag it · Esc cancels"));
        hints.setHovered("robot0", QStringLiteral("robot0"));
        const PaintRecord record = painted(size, [&](QPainter& p) { hints.paint(p, size, cursor); });
        std::vector<QRectF> boxes = boxesOf(record);
        const bool isNarrow = size.width() < 200;
        QCOMPARE(boxes.size(), std::size_t(isNarrow ? 3 : 2));
        const QRectF beside = boxes.back();
        boxes.pop_back();
        QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(beside));
        QCOMPARE(beside.bottom() < cursor.y() + 1, isAbove);
        for (const QRectF& line : boxes) {
            QVERIFY(!line.intersects(beside));
            QVERIFY(std::abs(line.center().x() - size.width() / 2.0) < 1e-6);
            QVERIFY(line.bottom() <= size.height() - 34 - 10);                 // over the scale bar
            if (isNarrow) QVERIFY(line.bottom() <= size.height() - 78 + 1e-6); // and over the axes
        }
        if (isNarrow) QVERIFY(boxes[0].bottom() <= boxes[1].top() + 1e-6);
    }

    void hintsReportChanges() {
        ViewHints hints;
        QSignalSpy hovered(&hints, &ViewHints::hoveredChanged), text(&hints, &ViewHints::textChanged);
        hints.setHovered("a", QStringLiteral("A"));
        QCOMPARE(hovered.size(), 1);
        QCOMPARE(text.size(), 1);
        hints.setHovered("a", QStringLiteral("A"));
        hints.setHovered("a", QStringLiteral("B"));
        QCOMPARE(hovered.size(), 1);
        QCOMPARE(text.size(), 2);
        hints.setHovered("b", QStringLiteral("B"));
        QCOMPARE(hovered.size(), 2);
        hints.setHint(QStringLiteral("H"));
        hints.setHint(QStringLiteral("H"));
        QCOMPARE(text.size(), 3);
    }

    /// All but the tool; what is not valid there, or is left out, is as at first.
    void settingsAreKept() {
        ViewSettings before;
        before.keepBetweenStarts();
        before.setTool(Tool::Rotate);
        before.setAxes(AxesOf::Local);
        before.setSnaps(false);
        before.setLook(LookChoice::Rich);
        before.setSteps(0.2, 7.5);
        before.show(kOverlayGrid, false);
        before.show(kOverlayBeams, true);
        ViewSettings now;
        QSignalSpy changed(&now, &ViewSettings::changed);
        now.keepBetweenStarts();
        QVERIFY(changed.size() >= 1);
        QVERIFY(now.tool() == Tool::Select && now.axes() == AxesOf::Local && !now.snaps() && now.look() == LookChoice::Rich);
        QCOMPARE(now.moveStep(), 0.2);
        QCOMPARE(now.rotationStep(), 7.5);
        QVERIFY(!now.shows(kOverlayGrid) && now.shows(kOverlayBeams) && now.shows(kOverlayShadows));
        QSettings().setValue(QStringLiteral("views/axes"), 99);
        QSettings().setValue(QStringLiteral("views/look"), -3);
        QSettings().setValue(QStringLiteral("views/turnStep"), -1);
        ViewSettings odd;
        odd.keepBetweenStarts();
        QVERIFY(odd.axes() == AxesOf::Local && odd.look() == LookChoice::Automatic);
        QCOMPARE(odd.rotationStep(), ViewSettings().rotationStep());
    }

    void stepsArePositive() {
        ViewSettings settings;
        QSignalSpy changed(&settings, &ViewSettings::changed);
        settings.setSteps(0.1, 30);
        settings.setSteps(0.1, 30);
        QCOMPARE(changed.size(), 1);
        settings.setSteps(0.1, 45);
        settings.setSteps(0.2, 45);
        QCOMPARE(changed.size(), 3);
        const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
        for (const double bad : {0., -1., nan, infinite}) {
            settings.setSteps(bad, 10);
            settings.setSteps(1, bad);
        }
        QCOMPARE(changed.size(), 3);
        QCOMPARE(settings.moveStep(), 0.2);
        QCOMPARE(settings.rotationStep(), 45.);
    }

    /// The bodies of the one robot alone, about the anchor of its joint; each axis of a Universal has a position of its own.
    void jointsMoveTheBodiesOfTheirRobot() {
        ViewWindow window(nullptr);
        QVERIFY(window.open(kArms));
        QVERIFY(!window.document.loaded()->diagnostics.hasErrors());
        ViewportScene& world = window.panel->world();
        const RobotSpec& two = world.objects()->experiment().robots[2];
        JointPositions& joints = jointPositions(world);
        const BodyPoses before = *world.poses();
        const auto poseOf = [&](const char* path) { return world.poseOf(*world.find(path)); };
        const auto turned = [&](const Vec3& axis, double angle, const Vec3& about, const Pose& start) {
            const Quat turn(Eigen::AngleAxisd(angle, axis));
            return two.pose * Pose{about + turn * (start.position - about), turn * start.rotation};
        };
        const auto same = [](const Pose& a, const Pose& b) {
            return (a.position - b.position).norm() < 1e-9 && a.rotation.angularDistance(b.rotation) < 1e-6;
        };
        joints.set(two, 0, 0.7);
        const Pose rod{Vec3(0.1, 0, 0.4), rotationFromHpr({0, std::numbers::pi / 6, 0})};
        QVERIFY(same(poseOf("two.rod"), turned(Vec3::UnitY(), 0.7, {0.1, 0, 0.2}, rod)));
        QVERIFY(same(poseOf("two.base"), two.pose));
        joints.set(two, 2, -0.4); // Axis2 of the gimbal
        QCOMPARE(joints.at(two, 0), 0.7);
        QCOMPARE(joints.at(two, 1), 0.);
        QCOMPARE(joints.at(two, 2), -0.4);
        QVERIFY(same(poseOf("two.plate"), turned(Vec3::UnitY(), -0.4, {0, 0.5, 0.3}, {Vec3(0, 0.5, 0.3), Quat::Identity()})));
        for (std::size_t i = 0; i < before.size() - 3; ++i) QVERIFY(same((*world.poses())[i], before[i]));
        joints.set(two, 0, 0);
        QVERIFY(same(poseOf("two.rod"), two.pose * rod));
        QVERIFY(!joints.empty());
        joints.set(two, 2, 0);
        QVERIFY(joints.empty()); // as at the start
    }

    /// They are measured again after whatever moves or hides an object.
    void boundsFollowTheScene() {
        ViewWindow window(nullptr);
        QVERIFY(window.open(kArms));
        ViewportScene& world = window.panel->world();
        const auto high = [&] { return world.bounds().high; };
        QVERIFY(std::abs(high().z() - 3) < 1e-9 && std::abs(high().y() - 4.1) < 1e-9 && std::abs(high().x() - 3.2) < 1e-9);
        world.setHidden({"shed"});
        QVERIFY(std::abs(high().z() - 1) < 1e-9 && high().y() < 2);
        world.setHidden({"shed", "yard", "plain", "one"});
        const double still = high().z();
        QVERIFY(still < 0.7);
        const RobotSpec& two = world.objects()->experiment().robots[2];
        jointPositions(world).set(two, 0, 1.5); // nearly level
        QVERIFY(high().z() < still - 0.1);
        jointPositions(world).reset();
        QVERIFY(std::abs(high().z() - still) < 1e-12);
        window.session.step();
        QVERIFY(QTest::qWaitFor([&] { return window.session.state() == RunState::Paused && world.isRunning(); }, 60000));
        (void)world.bounds();
        QVERIFY(window.session.robots().place("two", {Vec3(-1, 0, 5), Quat::Identity()}));
        QVERIFY(QTest::qWaitFor([&] { return world.poseOf(*world.find("two")).position.z() > 4; }, 60000));
        QVERIFY(high().z() > 5);
        window.session.reset();
        QVERIFY(QTest::qWaitFor([&] { return !world.isRunning(); }, 60000));
        QVERIFY(high().z() < 1);
    }

    /// A locked object is in the way of a ray or not, as asked for; a hidden one never is.
    void raysAndMarks() {
        ViewWindow window(nullptr);
        QVERIFY(window.open(kArms));
        ViewportScene& world = window.panel->world();
        const ViewRay down{Vec3(3, 0, 9), -Vec3::UnitZ()};
        const auto hits = [&](bool alsoLocked) { return world.hitsAlong(down, alsoLocked).size(); };
        QVERIFY(hits(false) == 1 && hits(true) == 1);
        world.setLocked({"plain"});
        QVERIFY(hits(false) == 0 && hits(true) == 1);
        world.setHidden({"plain"});
        QVERIFY(hits(false) == 0 && hits(true) == 0);
        QCOMPARE(world.hiddenInScene(), std::vector<std::string>{"plain"});
    }

    /// A path into a config means that of all instances, but not those of other configs.
    void pathsIntoConfigs_data() {
        QTest::addColumn<QByteArray>("path");
        QTest::addColumn<QByteArray>("objects");
        QTest::newRow("scenery") << QByteArray("StaticConfig.Shed.wall") << QByteArray("shed.wall");
        QTest::newRow("scenery, whole") << QByteArray("StaticConfig.Yard") << QByteArray("yard");
        QTest::newRow("body") << QByteArray("RobotConfig.Arm.rod") << QByteArray("one.rod two.rod");
        QTest::newRow("geom") << QByteArray("RobotConfig.Plain.base.hull") << QByteArray("plain.base.hull");
        QTest::newRow("unknown") << QByteArray("RobotConfig.None.base") << QByteArray();
    }
    void pathsIntoConfigs() {
        QFETCH(QByteArray, path);
        QFETCH(QByteArray, objects);
        ViewWindow window(nullptr);
        QVERIFY(window.open(kArms));
        const ViewportScene& world = window.panel->world();
        QByteArrayList found;
        for (const ObjectRef& object : world.objectsOf(path.toStdString()))
            found << QByteArray::fromStdString(world.objects()->pathOf(object));
        QCOMPARE(found.join(' '), objects);
    }

    /// Lines and areas that reach behind the camera end where they leave the picture; dots are squares about their points.
    void paintingIntoTheScene() {
        ViewWindow window(nullptr);
        window.look({0, 0, 1}, {1, 0, 1});
        View& view = window.view();
        const auto pixel = [&](const Vec3& point) { return *view.camera().pixelOf(point); };
        const QColor red(255, 0, 0);
        const QRectF all(-9, -9, view.width() + 18, view.height() + 18);
        const auto record = [&](const std::function<void(ScenePainter&)>& paint) {
            return painted(view.size(), [&](QPainter& p) {
                p.setPen(red);
                ScenePainter scene(p, view);
                paint(scene);
            });
        };
        const Vec3 front(2, 0.3, 0.9), behind(-3, 0.4, 1.1);
        for (const bool swapped : {false, true}) {
            const auto lines = record([&](ScenePainter& s) {
                                   swapped ? s.line(behind, front, red, 1) : s.line(front, behind, red, 1);
                               }).of(Drawn::Line, red);
            QCOMPARE(lines.size(), std::size_t(1));
            const QPointF ahead = lines[0].points[swapped ? 1 : 0], away = lines[0].points[swapped ? 0 : 1];
            QVERIFY((ahead - pixel(front)).manhattanLength() < 0.01 && all.contains(away));
            const QPointF way = pixel(front + 0.1 * (behind - front)) - pixel(front), by = away - ahead; // on the same line
            QVERIFY(std::abs(way.x() * by.y() - way.y() * by.x()) <
                    1e-3 * std::hypot(way.x(), way.y()) * std::hypot(by.x(), by.y()));
            QVERIFY(std::hypot(by.x(), by.y()) > 50);
        }
        QVERIFY(record([&](ScenePainter& s) { s.line(behind, Vec3(-1, 0, 1), red, 1); }).of(Drawn::Line).empty());
        QVERIFY(record([&](ScenePainter& s) { s.line({2, 9, 1}, {2, 9, 3}, red, 1); }).of(Drawn::Line).empty()); // beside it
        const std::vector<Vec3> area{{2, -0.2, 0.8}, {2, 0.2, 0.8}, {-2, 0.2, 0.8}, {-2, -0.2, 0.8}};
        const auto areas = record([&](ScenePainter& s) { s.polygon(area); }).of(Drawn::Polygon);
        QCOMPARE(areas.size(), std::size_t(1));
        QCOMPARE(areas[0].points.size(), 4);
        QVERIFY(areas[0].points.boundingRect().bottom() > view.height());
        const std::vector<Vec3> points{{2, 0, 1}, {2, 0.1, 1}, {2, 0.2, 1}, {2, 0.3, 1}};
        const PaintRecord path = record([&](ScenePainter& s) { s.path(points, {false, true, false, true}); });
        QCOMPARE(path.of(Drawn::Line).size(), std::size_t(2));
        QVERIFY(path.hasLine(pixel(points[0]), pixel(points[1]), red) && path.hasLine(pixel(points[2]), pixel(points[3]), red));
        const auto dots = record([&](ScenePainter& s) { s.dots(std::array{front, behind}, red, 7); }).of(Drawn::Polygon);
        QCOMPARE(dots.size(), std::size_t(1));
        const QRectF dot = dots[0].points.boundingRect();
        QVERIFY(std::abs(dot.width() - 7) < 1e-9 && (dot.center() - pixel(front)).manhattanLength() <= 1.01);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(ContextTest)
#include "context_test.moc"
