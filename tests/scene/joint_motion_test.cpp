// Where bodies are with their joints at given positions.
#include <QtTest>

#include <numbers>

#include "scene/queries/joint_motion.h"

using namespace trundle;

namespace {

constexpr double kQuarter = std::numbers::pi / 2;

JointSpec joint(const char* name, JointType type, int parent, int child, const Vec3& anchor, const Vec3& axis) {
    JointSpec made;
    made.name = name;
    made.type = type;
    made.parent = parent;
    made.child = child;
    made.anchor = anchor;
    made.axis = axis;
    return made;
}

/// A chain along x: base at 0, link at 1, tip at 2.
RobotConfigSpec chain() {
    RobotConfigSpec config;
    config.bodies.resize(3);
    for (int i = 0; i < 3; ++i) config.bodies[std::size_t(i)].pose.position = {double(i), 0, 0};
    config.joints = {joint("shoulder", JointType::Hinge, 0, 1, {0.5, 0, 0}, Vec3::UnitZ()),
                     joint("slide", JointType::Slider, 1, 2, {2, 0, 0}, Vec3::UnitX())};
    return config;
}

Vec3 place(const RobotConfigSpec& config, const std::vector<double>& positions, std::size_t body) {
    return bodyMotions(config, jointCoordinates(config), positions)[body] * config.bodies[body].pose.position;
}

} // namespace

class JointMotionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void childrenFollow() {
        const RobotConfigSpec config = chain();
        QVERIFY(place(config, {kQuarter, 0.25}, 0).isZero(1e-12));
        QVERIFY(place(config, {kQuarter, 0.25}, 1).isApprox(Vec3(0.5, 0.5, 0), 1e-12));
        QVERIFY(place(config, {kQuarter, 0.25}, 2).isApprox(Vec3(0.5, 1.75, 0), 1e-12)); // it slides along the turned axis
    }

    void theFirstBodyStaysAlsoAsAChild() {
        RobotConfigSpec config = chain();
        std::swap(config.joints[0].parent, config.joints[0].child);
        QVERIFY(place(config, {kQuarter, 0}, 0).isZero(1e-12));
        QVERIFY(place(config, {kQuarter, 0}, 1).isApprox(Vec3(0.5, -0.5, 0), 1e-12)); // the parent turns the other way
    }

    void whatIsJoinedToTheWorldStays() {
        RobotConfigSpec config = chain();
        config.joints.push_back(joint("foot", JointType::Fixed, kWorldBody, 2, {}, Vec3::UnitZ()));
        QVERIFY(place(config, {kQuarter, 0}, 2).isApprox(Vec3(2, 0, 0), 1e-12));
        QVERIFY(!place(config, {kQuarter, 0}, 0).isZero(0.1));
    }

    void positionsStayWithinTheirStops() {
        RobotConfigSpec config = chain();
        config.joints[0].highStop = 1;
        const auto coordinates = jointCoordinates(config);
        QCOMPARE(coordinates.size(), std::size_t(2));
        QVERIFY(coordinates[0].hasHigh && !coordinates[0].hasLow);
        std::vector<double> positions(2, 0.0);
        setJointPosition(config, coordinates, 0, 2, positions);
        QCOMPARE(positions[0], 1.0);
        setJointPosition(config, coordinates, 0, -2, positions);
        QCOMPARE(positions[0], -2.0);
    }

    void gearsTurnTheirJoints() {
        RobotConfigSpec config = chain();
        GearSpec gear;
        gear.joint = 1;
        gear.other = 0;
        gear.ratio = 0.1; // m/rad
        config.gears = {gear};
        std::vector<double> positions(2, 0.0);
        setJointPosition(config, jointCoordinates(config), 0, 0.5, positions);
        QCOMPARE(positions[1], 0.05);
        setJointPosition(config, jointCoordinates(config), 1, 0.02, positions);
        QCOMPARE(positions[0], 0.2);
    }

    void aBallTiltsNoFartherThanItsStop() {
        RobotConfigSpec config = chain();
        config.joints[0].type = JointType::Ball;
        config.joints[0].swingStop = 0.3;
        const std::vector<Pose> motions = bodyMotions(config, jointCoordinates(config), std::vector<double>{1, 1, 0.7, 0});
        const Vec3 tilted = motions[1].rotation * Vec3(Vec3::UnitZ());
        QVERIFY(std::abs(std::acos(tilted.z()) - 0.3) < 1e-9);
    }

    /// Two axes: a Universal's child turns about the second one within the first, a Suspension's rolls about it where it has slid to.
    void jointsOfTwoAxes() {
        RobotConfigSpec config = chain();
        config.joints.pop_back();
        JointSpec& two = config.joints[0];
        two.axis2 = Vec3::UnitY();
        const Vec3 ahead = Vec3::UnitX(), up = Vec3::UnitZ(), side = Vec3::UnitY();
        const auto moved = [&](double first, double second) {
            return bodyMotions(config, jointCoordinates(config), std::vector<double>{first, second})[1];
        };
        two.type = JointType::Universal;
        QCOMPARE(jointCoordinates(config).size(), std::size_t(2));
        QVERIFY((moved(kQuarter, 0).rotation * ahead).isApprox(side, 1e-12));
        QVERIFY((moved(0, kQuarter).rotation * ahead).isApprox(-up, 1e-12));
        QVERIFY((moved(kQuarter, kQuarter).rotation * ahead).isApprox(-up, 1e-12)); // about y first, then about z
        QVERIFY((moved(kQuarter, kQuarter).rotation * side).isApprox(-ahead, 1e-12));
        QVERIFY((moved(kQuarter, kQuarter) * two.anchor).isApprox(two.anchor, 1e-12));
        two.type = JointType::Suspension;
        QVERIFY((moved(0.2, 0) * two.anchor).isApprox(two.anchor + 0.2 * up, 1e-12));
        QVERIFY((moved(0.2, kQuarter) * two.anchor).isApprox(two.anchor + 0.2 * up, 1e-12));
        QVERIFY((moved(0.2, kQuarter).rotation * ahead).isApprox(-up, 1e-12));
        QVERIFY((moved(0.2, kQuarter).rotation * side).isApprox(side, 1e-12));
    }

    void aLoopIsFollowedOnce() {
        RobotConfigSpec config = chain();
        config.joints.push_back(joint("close", JointType::Hinge, 0, 2, {0, 0, 0}, Vec3::UnitZ()));
        QVERIFY(place(config, {kQuarter, 0, 0}, 1).isApprox(Vec3(0.5, 0.5, 0), 1e-12));
    }

    /// Stops as they are; without them a half turn or 10 cm, beyond the one that there is.
    void rangesOfCoordinates() {
        RobotConfigSpec config = chain();
        config.joints[0].lowStop = 4; // beyond a half turn
        config.joints[1].highStop = -0.3;
        JointSpec two = joint("two", JointType::Universal, 0, 2, {}, Vec3::UnitZ()), strut = two;
        two.lowStop = -1, two.highStop = 2, two.lowStop2 = -0.25, two.highStop2 = 0.75;
        strut.type = JointType::Suspension;
        for (const double travel : {0., 0.05}) {
            strut.travel = travel;
            config.joints.push_back(strut);
        }
        config.joints.push_back(two);
        const double half = std::numbers::pi;
        const std::tuple<double, double, bool, bool> expected[] = {
            {4, 4 + half, true, false}, {-0.4, -0.3, false, true},   {-0.1, 0.1, false, false}, {-half, half, false, false},
            {-0.05, 0.05, true, true},  {-half, half, false, false}, {-1, 2, true, true},       {-0.25, 0.75, true, true}};
        const auto coordinates = jointCoordinates(config);
        QCOMPARE(coordinates.size(), std::size(expected));
        for (std::size_t i = 0; i < coordinates.size(); ++i) {
            const auto& [low, high, hasLow, hasHigh] = expected[i];
            const JointCoordinate& c = coordinates[i];
            QVERIFY2(std::abs(c.low - low) < 1e-12 && std::abs(c.high - high) < 1e-12, qPrintable(QString::number(i)));
            QVERIFY(c.hasLow == hasLow && c.hasHigh == hasHigh);
        }
    }

    /// What a gear turns passes its free range; the second coordinate of a joint turns no gear.
    void gearsPassAFreeRange() {
        RobotConfigSpec config = chain();
        JointSpec& two = config.joints[0];
        two.type = JointType::Universal;
        two.axis2 = Vec3::UnitY();
        GearSpec gear;
        gear.joint = 1;
        gear.other = 0;
        gear.ratio = 0.4; // m/rad
        config.gears = {gear};
        const auto coordinates = jointCoordinates(config);
        std::vector<double> positions(3, 0.0);
        setJointPosition(config, coordinates, 1, 0.5, positions);
        QCOMPARE(positions, (std::vector{0., 0.5, 0.}));
        setJointPosition(config, coordinates, 0, 2, positions);
        QCOMPARE(positions, (std::vector{2., 0.5, 0.8}));
        setJointPosition(config, coordinates, 0, 9, positions); // by hand no farther than its own
        QCOMPARE(positions, (std::vector{std::numbers::pi, 0.5, 0.4 * std::numbers::pi}));
    }

    /// Less than its stop a Ball tilts as it is turned.
    void aBallTiltsFreelyBelowItsStop() {
        RobotConfigSpec config = chain();
        config.joints[0].type = JointType::Ball;
        config.joints[0].swingStop = 0.3;
        for (const auto& [asked, is] : {std::pair(0.2, 0.2), {0.29, 0.29}, {0.5, 0.3}}) {
            const Vec3 tilted = bodyMotions(config, jointCoordinates(config), std::vector<double>{asked, 0, 0, 0})[1].rotation *
                                Vec3(Vec3::UnitZ());
            QVERIFY(std::abs(std::acos(tilted.z()) - is) < 1e-9);
        }
    }
};

QTEST_APPLESS_MAIN(JointMotionTest)
#include "joint_motion_test.moc"
