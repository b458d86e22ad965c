// Parts of the tools without a view: typed numbers, texts of joints and of robot parts, snapping on the floor, repeated clicks.
#include <numbers>

#include <QSignalSpy>
#include <QtTest>

#include "editor/viewport/gizmo/direction_drag.h"
#include "editor/viewport/tools/floor_snap.h"
#include "editor/viewport/tools/joint_text.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/tools/picking.h"
#include "editor/viewport/tools/robot_part.h"
#include "editor/viewport/tools/typed_numbers.h"

using namespace trundle;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

void typeInto(TypedNumbers& typed, const char* text) {
    for (const char* c = text; *c; ++c) {
        const bool isTab = *c == '\t', isBack = *c == '<';
        (void)typed.type(isTab    ? int(Qt::Key_Tab)
                         : isBack ? int(Qt::Key_Backspace)
                                  : *c,
                         isTab || isBack ? QString() : QString(QLatin1Char(*c)));
    }
}

BodySpec bodyOf(std::initializer_list<GeomSpec> geoms) {
    BodySpec body;
    body.geoms = geoms;
    return body;
}

GeomSpec geomOf(GeomShape shape, const Vec3& position = Vec3::Zero(), const Vec3& hprDegrees = Vec3::Zero()) {
    GeomSpec geom;
    geom.shape = shape;
    geom.pose = {position, rotationFromHpr(hprDegrees * kDegree)};
    return geom;
}

} // namespace

class ToolPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void typedNumbersOfTwo_data() {
        QTest::addColumn<QByteArray>("keys"); // \t: Tab, <: Backspace
        QTest::addColumn<QString>("first");   // as shown; the cursor is |
        QTest::addColumn<QString>("second");
        QTest::addColumn<QList<double>>("numbers"); // 99: none
        const auto row = [](const char* keys, const char* first, const char* second, QList<double> numbers) {
            QTest::addRow("%s", QByteArray(keys).replace('\t', "Tab").constData())
                << QByteArray(keys) << QString::fromLatin1(first) << QString::fromLatin1(second) << numbers;
        };
        row("", "m1", "m2", {99, 99});
        row("\t", "m1", "m2", {99, 99});
        row("1.5", "1.5|", "m2", {1.5, 99});
        row("1,5", "1,5|", "m2", {1.5, 99});
        row("1\t2", "1", "2|", {1, 2});
        row("1\t", "1", "|", {1, 99});
        row("\t2", "m1", "2|", {99, 2});
        row("1\t2\t", "1|", "2", {1, 2});
        row("1\t2\t3\t4", "13", "24|", {13, 24});
        row("\t-45", "m1", "-45|", {99, -45});
        row("-4\t5", "4", "5|", {4, 5});
        row("\t4-5", "m1", "45|", {99, 45});
        row("25 cm\t1.5rad", "25 cm", "1.5rad|", {0.25, 1.5 / kDegree});
        row("2 parsec", "2 parsec|", "m2", {99, 99});
        row("cm2", "2|", "m2", {2, 99});
        row("12<<\t3<4", "m1", "4|", {99, 4});
    }
    void typedNumbersOfTwo() {
        QFETCH(QByteArray, keys);
        QFETCH(QList<double>, numbers);
        TypedNumbers typed(true);
        typeInto(typed, keys.constData());
        const auto shown = [&](bool second) {
            return typed.shown(second, second ? QStringLiteral("m2") : QStringLiteral("m1"))
                .replace(QStringLiteral("▏"), QStringLiteral("|"));
        };
        QTEST(shown(false), "first");
        QTEST(shown(true), "second");
        for (const bool second : {false, true})
            QVERIFY(std::abs(typed.number(second, second ? "deg" : "m").value_or(99) - numbers[second ? 1 : 0]) < 1e-9);
        typed.clear(); // the next number is the first one
        QVERIFY(typed.empty());
        typeInto(typed, "7");
        QCOMPARE(shown(false), QStringLiteral("7|"));
        QCOMPARE(shown(true), QStringLiteral("m2"));
    }

    void keysOfTypedNumbers() {
        TypedNumbers typed(false);
        QVERIFY(!typed.type(Qt::Key_Backspace, {}));
        QVERIFY(!typed.type(Qt::Key_M, QStringLiteral("m")) && !typed.type(Qt::Key_Minus, QStringLiteral("-")));
        QVERIFY(typed.type(Qt::Key_Tab, {}));
        QVERIFY(!typed.type(Qt::Key_Minus, QStringLiteral("-"))); // no negative second one
        QVERIFY(typed.type(Qt::Key_1, QStringLiteral("1")) && typed.type(Qt::Key_Backspace, {}));
        QVERIFY(!typed.type(Qt::Key_Backspace, {}) && !typed.type(Qt::Key_1, QStringLiteral("11")));
        for (int i = 0; i < 25; ++i) QVERIFY(typed.type(Qt::Key_1, QStringLiteral("1")));
        QVERIFY(!typed.type(Qt::Key_1, QStringLiteral("1")));
    }

    void textsOfJoints_data() {
        QTest::addColumn<QByteArray>("kind");
        QTest::addColumn<QByteArray>("child");
        QTest::addColumn<int>(
            "body"); // 0 wheel about y, 1 box, 2 ball, 3 two cylinders, 4 cylinder beside its origin, 5 ball beside it
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* kind, const char* child, int body, const char* text) {
            QTest::addRow("%s of %s %d", kind, child, body) << QByteArray(kind) << QByteArray(child) << body << QByteArray(text);
        };
        row("Hinge", "leftWheel", 0, "Hinge leftAxle { Parent=p Child=leftWheel Axis=0,1,0 }");
        row("Hinge", "wheel", 0, "Hinge axle { Parent=p Child=wheel Axis=0,1,0 }");
        row("Hinge", "left.roller", 0, "Hinge rollerAxle { Parent=p Child=left.roller Axis=0,1,0 }");
        row("Hinge", "arm", 1, "Hinge armHinge { Parent=p Child=arm Anchor=0.11,-0.22,0.3 Axis=1,0,0 }");
        row("Slider", "arm", 1, "Slider armSlider { Parent=p Child=arm Axis=1,0,0 }");
        row("Slider", "leftWheel", 0, "Slider leftWheelSlider { Parent=p Child=leftWheel Axis=1,0,0 }");
        row("Fixed", "arm", 1, "Fixed armMount { Parent=p Child=arm }");
        row("Ball", "caster", 2, "Ball casterJoint { Parent=p Child=caster }");
        row("Ball", "caster", 5, "Ball casterJoint { Parent=p Child=caster Anchor=0.11,-0.22,0.3 }");
        row("Universal", "arm", 1, "Universal armJoint { Parent=p Child=arm Anchor=0.11,-0.22,0.3 }");
        row("Suspension", "leftWheel", 0, "Suspension leftAxle { Parent=p Child=leftWheel }");
        row("Hinge", "pair", 3, "Hinge pairAxle { Parent=p Child=pair Axis=0,1,0 }");
        row("Hinge", "rim", 4, "Hinge rimHinge { Parent=p Child=rim Anchor=0.11,-0.22,0.3 Axis=1,0,0 }");
    }
    void textsOfJoints() {
        QFETCH(QByteArray, kind);
        QFETCH(QByteArray, child);
        QFETCH(int, body);
        const Vec3 across(0, 0, 90), back(0, 0, -90);
        const BodySpec bodies[] = {
            bodyOf({geomOf(GeomShape::Cylinder, {}, across)}),
            bodyOf({geomOf(GeomShape::Box)}),
            bodyOf({geomOf(GeomShape::Sphere)}),
            bodyOf({geomOf(GeomShape::Cylinder, {0, 0.1, 0}, across), geomOf(GeomShape::Cylinder, {0, -0.1, 0}, back)}),
            bodyOf({geomOf(GeomShape::Cylinder, {0.1, 0, 0}, across)}),
            bodyOf({geomOf(GeomShape::Sphere, {0, 0, 0.1})})};
        JointPick pick{"p", child.toStdString(), &bodies[body], {}, {0.1122, -0.2181, 0.2999}, Vec3(0.98, 0.1, 0.1).normalized()};
        QTEST(QByteArray::fromStdString(jointText(kind.toStdString(), pick, 0.005)).replace("0.11,-0.22,0.3", "0.11,-0.22,0.3"),
              "text");
    }

    /// Near a main axis it is that; else as it is, with its largest number positive.
    void axesOfJoints() {
        const BodySpec box = bodyOf({geomOf(GeomShape::Box)}), wheel = bodyOf({geomOf(GeomShape::Cylinder, {}, {0, 0, 90})});
        const auto axis = [&](const Vec3& normal) {
            return jointText("Slider", JointPick{"p", "c", &box, {}, {}, normal}, 0.005);
        };
        QCOMPARE(axis({0, 0.1, -0.99}), std::string("Slider cSlider { Parent=p Child=c }")); // up is the default
        QCOMPARE(axis({-0.98, 0.1, 0}), std::string("Slider cSlider { Parent=p Child=c Axis=1,0,0 }"));
        QCOMPARE(axis({-0.8, 0.6, 0}), std::string("Slider cSlider { Parent=p Child=c Axis=0.8,-0.6,0 }"));
        QCOMPARE(axis({0.6, 0, 0.8}), std::string("Slider cSlider { Parent=p Child=c Axis=0.6,0,0.8 }"));
        JointPick turned{"p", "wheel", &wheel, {Vec3::Zero(), rotationFromHpr({40 * kDegree, 0, 0})}, {}, Vec3::UnitX()};
        QCOMPARE(jointText("Hinge", turned, 0.005), std::string("Hinge axle { Parent=p Child=wheel Axis=-0.6428,0.766,0 }"));
        QCOMPARE(jointText("Suspension", turned, 0.005),
                 std::string("Suspension axle { Parent=p Child=wheel Axis2=-0.6428,0.766,0 }"));
    }

    /// Which side a part is written for, and how it turns to another one; a wheel fits the side opposite as it is.
    void sidesOfRobotParts() {
        const auto text = [](const char* pos, const char* joint) {
            return std::string("Body wheel { Pos=") + pos + " Sphere s { Radius=0.1 } }\n" + joint +
                   " Parent=chassis Child=wheel Axis=0,1,0 }\n";
        };
        const auto left = RobotPart::of(text("0.05,0.2,0.1", "Hinge axle {")),
                   right = RobotPart::of(text("0.05,-0.2,0.1", "Hinge axle {")),
                   rear = RobotPart::of(text("-0.3,0.1,0.1", "Fixed f {")),
                   corner = RobotPart::of(text("0.2,0.2,0", "Fixed f {"));
        QVERIFY(left && right && rear && corner);
        QVERIFY(left->side == Vec3::UnitY() && right->side == Vec3(0, -1, 0) && rear->side == Vec3(-1, 0, 0) &&
                corner->side == Vec3::UnitX());
        QVERIFY(left->isWheel && right->isWheel && !rear->isWheel);
        QVERIFY((left->position - Vec3(0.05, 0.2, 0.1)).norm() < 1e-12 && left->axis == Vec3::UnitY());
        QVERIFY(!RobotPart::of("Box b { Size=1,1,1 }") && !RobotPart::of("Body b { }"));
        QVERIFY(!RobotPart::of(text("$x,0.2,0.1", "Hinge axle {"))->isWheel); // a formula: as if without a place
        const auto heading = [](const Quat& q) { return hprFromRotation(q).x() / kDegree; };
        QVERIFY(std::abs(heading(left->rotationTo({0, -1, 0}))) < 1e-9); // the wheel opposite
        QVERIFY(std::abs(heading(left->rotationTo({1, 0, 0})) + 90) < 1e-9);
        QVERIFY(std::abs(std::abs(heading(rear->rotationTo({1, 0, 0}))) - 180) < 1e-9);
        QVERIFY(std::abs(heading(rear->rotationTo({0, 1, 0})) + 90) < 1e-9);
        QVERIFY((left->rotationTo(Vec3(0, 0.6, 0.8)) * Vec3::UnitY() - Vec3(0, 0.6, 0.8)).norm() < 1e-9);
    }

    void textsOfRobotParts() {
        const std::string text = "Body wheel { Pos=0,0.2,0.1 Cylinder c { Radius=0.1 } }\n"
                                 "Hinge axle { Parent=chassis Child=wheel Axis=0,1,0 }\n"
                                 "RotaryMotor motor { Joint=axle }\nTouchSensor feel { Body=wheel }\n";
        const auto part = RobotPart::of(text);
        QVERIFY(part.has_value());
        const std::string right = textAt(text, *part, {{Vec3(0.1, -0.2, 0.1), Quat::Identity()}, "base", "right"});
        QCOMPARE(right, std::string("Body rightWheel { Pos=0.1,-0.2,0.1 Cylinder c { Radius=0.1 } }\n"
                                    "Hinge rightAxle { Parent=base Child=rightWheel Axis=0,1,0 }\n"
                                    "RotaryMotor rightMotor { Joint=rightAxle }\nTouchSensor rightFeel { Body=rightWheel }\n"));
        const std::string turned = textAt(text, *part, {{Vec3(0.3, 0, 0.1), rotationFromHpr({-90 * kDegree, 0, 0})}, "base", {}});
        QCOMPARE(turned, std::string("Body wheel { Pos=0.3,0,0.1 HPR=-90,0,0 Cylinder c { Radius=0.1 } }\n"
                                     "Hinge axle { Parent=base Child=wheel Axis=1,0,0 }\n"
                                     "RotaryMotor motor { Joint=axle }\nTouchSensor feel { Body=wheel }\n"));
        QCOMPARE(deviceTextAt("Lidar scan { Body=chassis Beams=8 }", "arm", {Vec3(0.10004, 0, 0.2), Quat::Identity()}),
                 std::string("Lidar scan { Body=arm Beams=8 Pos=0.1,0,0.2 }"));
        QCOMPARE(deviceTextAt("Lidar scan { Body=chassis Pos=0,0,0 }", "arm",
                              {Vec3(0, 0.1, 0), rotationFromHpr({90 * kDegree, 0, 0})}),
                 std::string("Lidar scan { Body=arm Pos=0,0.1,0 HPR=90,0,0 }"));
    }

    void cornersOnTheFloor_data() {
        using To = FloorSnap::To;
        QTest::addColumn<QList<double>>("corners");
        QTest::addColumn<QList<double>>("cursor");
        QTest::addColumn<double>("step");
        QTest::addColumn<QList<double>>("point");
        QTest::addColumn<int>("to");
        const auto row = [](const char* name, QList<double> corners, QList<double> cursor, double step, QList<double> point,
                            To to) { QTest::newRow(name) << corners << cursor << step << point << int(to); };
        const double slope = std::sqrt(0.5);
        row("first, on the grid", {}, {1.02, -0.53}, 0.05, {1, -0.55}, To::Grid);
        row("first, free", {}, {1.02, -0.53}, 0, {1.02, -0.53}, To::Nothing);
        row("along -x", {2, 1}, {0.48, 1.04}, 0.1, {0.5, 1}, To::Direction);
        row("along -y", {2, 1}, {2.03, -0.98}, 0.1, {2, -1}, To::Direction);
        row("in steps of 15 degrees", {0, 0}, {1.02, 1}, 0, {1.02, 1}, To::Nothing);
        row("45 degrees", {0, 0}, {1.02, 1}, 0.1, {1.4 * slope, 1.4 * slope}, To::Direction);
        row("between directions: the grid", {0, 0}, {1, 0.131}, 0.05, {1, 0.15}, To::Grid);
        row("a right angle to the left", {0, 0, 1, 1}, {0.02, 2.03}, 0.1, {1 - 1.4 * slope, 1 + 1.4 * slope}, To::RightAngle);
        row("a right angle to the right", {0, 0, 1, 1}, {2.03, 0.02}, 0.1, {1 + 1.4 * slope, 1 - 1.4 * slope}, To::RightAngle);
        row("straight on", {0, 0, 1, 0.05}, {2, 0.13}, 0.1, {1 + 1 / std::hypot(1, 0.05), 0.05 + 0.05 / std::hypot(1, 0.05)},
            To::Direction);
        row("straight on across 180 degrees", {0, 0, -1, 0.02}, {-2, -0.03}, 0.1,
            {-1 - 1 / std::hypot(1, 0.02), 0.02 + 0.02 / std::hypot(1, 0.02)}, To::Direction);
    }
    void cornersOnTheFloor() {
        QFETCH(QList<double>, corners);
        QFETCH(QList<double>, cursor);
        QFETCH(double, step);
        QFETCH(QList<double>, point);
        std::vector<FloorPoint> path;
        for (qsizetype i = 0; i < corners.size(); i += 2) path.push_back({corners[i], corners[i + 1]});
        FloorSnapOptions options;
        options.step = step;
        const FloorSnap snap = snapOnFloor({cursor[0], cursor[1]}, path, options);
        QVERIFY2(std::hypot(snap.point[0] - point[0], snap.point[1] - point[1]) < 1e-6,
                 QByteArray::number(snap.point[0]) + " " + QByteArray::number(snap.point[1]));
        QTEST(int(snap.to), "to");
        options.length = 2.5; // as typed: in the same direction
        options.angle = -120;
        const FloorSnap typed = snapOnFloor({cursor[0], cursor[1]}, path, options);
        if (path.empty()) return;
        const double x = path.back()[0] + 2.5 * std::cos(120 * kDegree), y = path.back()[1] - 2.5 * std::sin(120 * kDegree);
        QVERIFY(std::hypot(typed.point[0] - x, typed.point[1] - y) < 1e-9);
    }

    /// The next of the chain only for another click at the same place on what is selected.
    void clicksGoAlongTheChain() {
        PickCycle cycle;
        const std::vector<std::string> chain{"robot", "robot.body", "robot.body.geom"};
        QCOMPARE(cycle.next({100, 100}, chain, {}), std::string("robot"));
        QCOMPARE(cycle.next({103, 101}, chain, "robot"), std::string("robot.body"));
        QCOMPARE(cycle.next({103, 101}, chain, "robot.body"), std::string("robot.body.geom"));
        QCOMPARE(cycle.next({103, 101}, chain, "robot.body.geom"), std::string("robot"));
        QCOMPARE(cycle.next({103, 101}, chain, "robot"), std::string("robot.body"));
        QCOMPARE(cycle.next({103, 101}, chain, "another"), std::string("robot")); // selected otherwise
        QCOMPARE(cycle.next({110, 101}, chain, "robot"), std::string("robot"));   // too far away
        QCOMPARE(cycle.next({110, 101}, {"robot", "arena"}, "robot"), std::string("robot"));
        QCOMPARE(cycle.next({110, 101}, {}, "robot"), std::string());
    }

    void measuredPoints() {
        Measurement measured;
        QSignalSpy changed(&measured, &Measurement::changed);
        measured.clear(); // nothing to clear
        measured.setNext(std::nullopt);
        QCOMPARE(changed.size(), 0);
        measured.setNext(Vec3(9, 9, 9));
        measured.add({1, 2, 3});
        QVERIFY(!measured.next());
        measured.setNext(Vec3(5, 5, 5));
        measured.add({4, 5, 6});
        QCOMPARE(measured.points().size(), std::size_t(2));
        measured.add({7, 8, 9}); // a new measurement
        QCOMPARE(measured.points(), std::vector<Vec3>{Vec3(7, 8, 9)});
        QCOMPARE(changed.size(), 5);
    }

    /// Of the two points of the sphere under a ray the one on the side where the drag began; beside it the nearest one.
    void directionsUnderARay() {
        const Vec3 centre(1, 2, 3);
        const ViewRay ray{centre + Vec3(10, 0.3, 0), -Vec3::UnitX()};
        const double depth = std::sqrt(0.25 - 0.09);
        for (const double side : {1., -1.}) {
            const auto both = directionsUnder(ray, centre, Vec3(side, 0, 0), 0.5);
            QVERIFY((both[0] - Vec3(side * depth, 0.3, 0) / 0.5).norm() < 1e-9);
            QVERIFY((both[1] - Vec3(-side * depth, 0.3, 0) / 0.5).norm() < 1e-9);
        }
        const auto beside = directionsUnder(ray, centre, Vec3::UnitX(), 0.2);
        QVERIFY((beside[0] - Vec3::UnitY()).norm() < 1e-9 && beside[0] == beside[1]);
    }

    void snappedDirections_data() {
        QTest::addColumn<QList<double>>("first"); // heading and elevation, degrees
        QTest::addColumn<QList<double>>("second");
        QTest::addColumn<QList<double>>("snapped");
        QTest::newRow("steps") << QList<double>{38, 22} << QList<double>{140, 50} << QList<double>{45, 15};
        QTest::newRow("backwards") << QList<double>{-128, -34} << QList<double>{140, 50} << QList<double>{-135, -30};
        QTest::newRow("near x") << QList<double>{5, 3} << QList<double>{140, 50} << QList<double>{0, 0};
        QTest::newRow("near -y") << QList<double>{-86, -4} << QList<double>{140, 50} << QList<double>{-90, 0};
        QTest::newRow("near down") << QList<double>{33, -84} << QList<double>{140, 50} << QList<double>{0, -90};
        QTest::newRow("the other one near -x") << QList<double>{38, 22} << QList<double>{177, 4} << QList<double>{180, 0};
        QTest::newRow("not near enough") << QList<double>{9, 0} << QList<double>{140, 50} << QList<double>{15, 0};
    }
    void snappedDirections() {
        QFETCH(QList<double>, first);
        QFETCH(QList<double>, second);
        QFETCH(QList<double>, snapped);
        const auto way = [](const QList<double>& angles) {
            const double heading = angles[0] * kDegree, up = angles[1] * kDegree;
            return Vec3(std::cos(up) * std::cos(heading), std::cos(up) * std::sin(heading), std::sin(up));
        };
        QVERIFY((snappedDirection({way(first), way(second)}, 15) - way(snapped)).norm() < 1e-9);
    }
};

QTEST_APPLESS_MAIN(ToolPartsTest)
#include "tool_parts_test.moc"
