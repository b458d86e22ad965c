// Mirror images, footprints, gears and masses piece by piece: with turned Parts, second axes and points off the middle.
#include <QTest>

#include <numbers>

#include "model/convex_hull.h"
#include "model/dotted_path.h"
#include "model/gear_line.h"
#include "model/mass_properties.h"
#include "model/resolve/footprint.h"
#include "model/resolve/mirror.h"

using namespace trundle;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A Part with Mirror along an axis, turned and moved.
struct MirroredPart {
    explicit MirroredPart(int axis) : matrix(Mat3::Identity()) {
        PartFields fields;
        fields.pos = {1, 2, 3};
        fields.hpr = {30 * kDegree, 20 * kDegree, -10 * kDegree};
        fields.mirror = std::string(1, "xyz"[axis]);
        placement = PartPlacement(fields);
        matrix(axis, axis) = -1;
        turn = rotationFromHpr(Vec3(30, 20, -10) * kDegree).toRotationMatrix();
    }
    [[nodiscard]] Vec3 point(const Vec3& p) const { return Vec3(1, 2, 3) + turn * (matrix * p); }

    PartPlacement placement;
    Mat3 matrix, turn;
};

ComponentSpec device(const char* kind, const std::map<std::string, std::vector<double>>& values) {
    ComponentSpec spec;
    spec.kind = kind;
    for (const auto& [key, numbers] : values) spec.values[key] = {{PropertyType::Number, numbers, {}}, {}, Origin::Config};
    return spec;
}

/// The surface of a box with one more point on its top, not in the middle, counter-clockwise from outside.
TriangleMesh boxMesh(const Vec3& low, const Vec3& size, bool isInsideOut) {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.points.push_back(
            {low.x() + (i & 1 ? size.x() : 0), low.y() + (i & 2 ? size.y() : 0), low.z() + (i & 4 ? size.z() : 0)});
    mesh.points.push_back({low.x() + 0.9 * size.x(), low.y() + 0.8 * size.y(), low.z() + size.z()});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2},
                      {1, 3, 7}, {1, 7, 5}, {4, 5, 8}, {5, 7, 8}, {7, 6, 8}, {6, 4, 8}, {4, 8, 4}}; // the last one has no area
    if (isInsideOut) reverseTriangles(mesh, std::vector<bool>(mesh.triangles.size(), true));
    return mesh;
}

} // namespace

class PlacementEdgesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void axes_data() {
        QTest::addColumn<int>("axis");
        for (int axis = 0; axis < 3; ++axis) QTest::addRow("%c", "xyz"[axis]) << axis;
    }
    void axes() {
        QFETCH(int, axis);
        const MirroredPart part(axis);
        JointSpec strut;
        strut.type = JointType::Suspension;
        strut.axis = Vec3(0.1, 0.2, 0.9).normalized();
        strut.axis2 = Vec3(0.1, 0.95, 0.2).normalized();
        strut.anchor = {0.5, 0.25, -0.5};
        JointSpec image = strut;
        part.placement.place(image);
        QVERIFY((image.axis - part.turn * (part.matrix * strut.axis)).norm() < 1e-12); // it slides the mirrored way
        const Vec3 line = part.turn * (part.matrix * strut.axis2);
        QVERIFY(std::abs(std::abs(image.axis2.dot(line)) - 1) < 1e-12);
        QVERIFY((part.turn.transpose() * image.axis2).dot(strut.axis2) > 0); // what turns keeps its sense
        QVERIFY((image.anchor - part.point(strut.anchor)).norm() < 1e-12);
        SpringSpec spring;
        spring.anchor = {1, 2, 3};
        spring.anchor2 = {-3, 0.5, 1};
        const SpringSpec before = spring;
        part.placement.place(spring);
        QVERIFY((spring.anchor - part.point(before.anchor)).norm() < 1e-12 &&
                (spring.anchor2 - part.point(before.anchor2)).norm() < 1e-12);
        MassProperties mass{2, {0.1, 0.2, 0.3}, Mat3::Zero()};
        mass.inertia << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
        MassProperties mirrored = mass;
        part.placement.mirror(mirrored);
        QVERIFY((mirrored.centre - part.matrix * mass.centre).norm() < 1e-15);
        QVERIFY((mirrored.inertia - part.matrix * mass.inertia * part.matrix).norm() < 1e-15);
    }

    /// On a body of the part they are mirrored alone; on another one they count from the Part's pose too.
    void devices_data() { axes_data(); }
    void devices() {
        QFETCH(int, axis);
        const MirroredPart part(axis);
        const Vec3 at(0.5, 0.25, -0.5);
        for (const bool isOnOwnBody : {true, false}) {
            ComponentSpec base = device("SkidDrive", {{"Pos", {at.x(), at.y(), at.z()}},
                                                      {"LeftMotor", {1}},
                                                      {"RightMotor", {2}},
                                                      {"FrontMotor", {3}},
                                                      {"BackMotor", {4}},
                                                      {"FrontLeft", {5}}});
            part.placement.place(base, isOnOwnBody);
            const auto number = [&](const char* key) { return base.find(key)->value.numbers[0]; };
            const Vec3 pos(base.find("Pos")->value.numbers.data());
            QVERIFY((pos - (isOnOwnBody ? Vec3(part.matrix * at) : part.point(at))).norm() < 1e-12);
            QCOMPARE(std::pair(number("LeftMotor"), number("RightMotor")), axis == 1 ? std::pair(2., 1.) : std::pair(1., 2.));
            QCOMPARE(std::pair(number("FrontMotor"), number("BackMotor")), axis == 0 ? std::pair(4., 3.) : std::pair(3., 4.));
            QCOMPARE(number("FrontLeft"), 5.); // of which there is no other
            ComponentSpec belt = device("Belt", {{"Heading", {30 * kDegree}}});
            part.placement.place(belt, isOnOwnBody);
            const double expected[] = {150, -30, 30};
            QVERIFY(std::abs(belt.find("Heading")->value.numbers[0] - expected[axis] * kDegree) < 1e-12);
        }
    }

    void footprints() {
        GeomSpec drum;
        drum.shape = GeomShape::Cylinder;
        drum.radius = 0.1;
        drum.length = 0.5;
        const Footprint round = footprintsOf(drum, {})[0];
        for (int i = 0; i < 64; ++i) { // no part of it sticks out
            const double a = i * std::numbers::pi / 32;
            QVERIFY(round.meets(0.1999 * Eigen::Vector2d(std::cos(a), std::sin(a)), 0.1, -1, 1));
            QVERIFY(!round.meets(0.204 * Eigen::Vector2d(std::cos(a), std::sin(a)), 0.1, -1, 1));
        }
        GeomSpec sail;
        sail.shape = GeomShape::Mesh;
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
        mesh->triangles = {{0, 1, 2}};
        sail.mesh = mesh;
        const auto faces = footprintsOf(sail, {});
        QCOMPARE(faces.size(), std::size_t(1));
        QVERIFY(faces[0].meets({1, 1}, 0.1, -1, 1) && !faces[0].meets({3, 3}, 0.1, -1, 1)); // inside of a triangle, beside it
        sail.collideAsHull = true;
        const auto whole = footprintsOf(sail, {});
        QVERIFY(whole.size() == 1 && whole[0].meets({3, 3}, 0.1, -1, 1));
    }

    /// Whichever body two joints have in common.
    void endsOfGears() {
        const auto isEnds = [](const std::optional<GearEnds>& ends, int first, int second, double one, double other) {
            return ends && ends->first == first && ends->second == second && ends->firstSense == one &&
                   ends->secondSense == other;
        };
        QVERIFY(isEnds(gearEnds(0, 1, 0, 2), 1, 2, 1, 1));
        QVERIFY(isEnds(gearEnds(0, 1, 2, 0), 1, 2, 1, -1));
        QVERIFY(isEnds(gearEnds(1, 0, 0, 2), 1, 2, -1, 1));
        QVERIFY(isEnds(gearEnds(1, 0, 2, 0), 1, 2, -1, -1));
        QVERIFY(!gearEnds(0, 1, 2, 3) && !gearEnds(0, 1, 0, 1));
    }

    /// Also of one that is inside out, far from the origin, and whose points are not evenly spread.
    void massOfAMesh() {
        for (const Vec3& low : {Vec3(0, 0, 0), Vec3(-7, 3, 11)})
            for (const bool isInsideOut : {false, true}) {
                const Vec3 size(0.5, 1, 3);
                const auto solid = solidOf(boxMesh(low, size, isInsideOut));
                QVERIFY2(solid.ok(), solid.ok() ? "" : solid.error().message.c_str());
                GeomSpec box;
                box.size = size;
                const MassProperties expected = solidOf(box).value();
                QVERIFY(std::abs(solid.value().mass - 1.5) < 1e-9);
                QVERIFY((solid.value().centre - (low + size / 2)).norm() < 1e-9);
                QVERIFY((solid.value().inertia - expected.inertia).norm() < 1e-9);
            }
    }

    /// A lying cylinder is the same from both sides, whatever way it was laid down.
    void cylindersThatLie() {
        GeomSpec geom;
        geom.shape = GeomShape::Cylinder;
        const auto same = [](const Quat& a, const Quat& b) {
            return (a.coeffs() - b.coeffs()).norm() < 1e-12 || (a.coeffs() + b.coeffs()).norm() < 1e-12;
        };
        for (const Vec3& hpr : {Vec3(0, 90, 0), Vec3(0, 0, 90)}) {
            geom.pose.rotation = rotationFromHpr(-hpr * kDegree);
            QVERIFY(same(shapeRotation(geom), rotationFromHpr(hpr * kDegree)));
            geom.pose.rotation = rotationFromHpr(hpr * kDegree);
            QVERIFY(same(shapeRotation(geom), geom.pose.rotation));
        }
        geom.shape = GeomShape::Box;
        geom.pose.rotation = rotationFromHpr(Vec3(0, -90, 0) * kDegree);
        QVERIFY(same(shapeRotation(geom), geom.pose.rotation));
    }

    void namesOfMembers() {
        for (const char* none : {"_3", "a_", "a_3x", "a_03", "a3", "a_-1", "a_99999999999999999999999"})
            QVERIFY2(!memberName(none), none);
        for (const auto& [name, stem, index] : {std::tuple("a_0", "a", 0u), {"a_b_12", "a_b", 12u}})
            QVERIFY(memberName(name) && memberName(name)->stem == stem && memberName(name)->index == index);
        const std::vector<std::array<double, 3>> few{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}};
        QCOMPARE(farthestPoints(few, 5), few);
        const auto less = farthestPoints(few, 4); // none from the inside
        QVERIFY(less.size() <= 4 && std::ranges::find(less, few[4]) == less.end());
    }
};

QTEST_APPLESS_MAIN(PlacementEdgesTest)
#include "placement_edges_test.moc"
