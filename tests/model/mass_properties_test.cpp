// Mass, centre of mass and inertia of geoms and meshes.
#include <QTest>

#include <numbers>

#include "base/rng.h"
#include "model/convex_hull.h"
#include "model/mass_properties.h"
#include "model_fixture.h"

Q_DECLARE_METATYPE(trundle::TriangleMesh)

using namespace trundle;
using sample::boxMesh;

namespace {

double random01(std::uint64_t i) { return toUnit(randomBits(5, 0, 0, i)); }

} // namespace

class MassPropertiesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBoxAsMeshIsABox() {
        GeomSpec box;
        box.size = {1, 2, 3};
        const MassProperties a = solidOf(box).value(),
                             b = solidOf(boxMesh({1, 2, 3}, {Vec3(100, -50, 7), Quat::Identity()})).value();
        QVERIFY(std::abs(a.mass - 6) < 1e-12 && std::abs(b.mass - 6) < 1e-9);
        QVERIFY((b.centre - Vec3(100, -50, 7)).norm() < 1e-9);
        QVERIFY((a.inertia - b.inertia).norm() < 1e-9);
        TriangleMesh inside = boxMesh({1, 2, 3}, {});
        for (auto& t : inside.triangles) std::swap(t[0], t[1]);
        QVERIFY(std::abs(solidOf(inside).value().mass - 6) < 1e-12);
    }

    void anOpenMeshHasNone() {
        TriangleMesh open = boxMesh({1, 1, 1}, {});
        open.triangles.pop_back();
        QVERIFY(!solidOf(open).ok());
    }

    /// Meshes without a known volume: each differs from a box in one place.
    void meshesThatAreNoSolid_data() {
        QTest::addColumn<TriangleMesh>("mesh");
        const TriangleMesh box = boxMesh({1, 2, 3}, {Vec3(0.2, 5, -1), Quat::Identity()});
        TriangleMesh twice = box, flipped = box, flat = box, extra = box;
        twice.triangles.insert(twice.triangles.end(), box.triangles.begin(), box.triangles.end());
        std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
        for (auto& p : flat.points) p[1] = 7;
        extra.triangles.push_back(box.triangles[5]);
        QTest::newRow("each triangle twice") << twice;
        QTest::newRow("one triangle twice") << extra;
        QTest::newRow("one triangle turned over") << flipped;
        QTest::newRow("flat") << flat;
        QTest::newRow("empty") << TriangleMesh{};
    }
    void meshesThatAreNoSolid() {
        QFETCH(TriangleMesh, mesh);
        const auto solid = solidOf(mesh);
        QVERIFY(!solid.ok());
        QCOMPARE(solid.error().code, Code::BadMass);
    }

    /// Three separate vertices for each triangle, as in STL.
    void anUnweldedMeshIsClosed() {
        const TriangleMesh box = boxMesh({1, 1, 1}, {});
        TriangleMesh loose;
        for (const auto& t : box.triangles) {
            const auto n = static_cast<std::uint32_t>(loose.points.size());
            for (const std::uint32_t i : t) loose.points.push_back(box.points[i]);
            loose.triangles.push_back({n, n + 1, n + 2});
        }
        QVERIFY(std::abs(solidOf(loose).value().mass - 1) < 1e-12);
    }

    /// A capsule compared with a sum over thin discs.
    void aCapsule() {
        GeomSpec c;
        c.shape = GeomShape::Capsule;
        c.radius = 0.3;
        c.length = 0.8;
        double volume = 0, along = 0, across = 0;
        const int n = 200000;
        const double half = 0.7, dz = 2 * half / n;
        for (int i = 0; i < n; ++i) {
            const double z = -half + (i + 0.5) * dz, beyond = std::max(0.0, std::abs(z) - 0.4);
            const double r2 = 0.09 - beyond * beyond, m = std::numbers::pi * r2 * dz;
            volume += m;
            along += m * r2 / 2;
            across += m * (r2 / 4 + z * z);
        }
        const MassProperties p = solidOf(c).value();
        QVERIFY(std::abs(p.mass - volume) < 1e-8);
        QVERIFY(std::abs(p.inertia(2, 2) - along) < 1e-8);
        QVERIFY(std::abs(p.inertia(0, 0) - across) < 1e-8);
    }

    void twoHalvesMakeAWhole() {
        GeomSpec half, whole;
        half.size = {1, 1, 1};
        whole.size = {2, 1, 1};
        const MassProperties s = sum({placed(solidOf(half).value(), {Vec3(-0.5, 0, 0), Quat::Identity()}),
                                      placed(solidOf(half).value(), {Vec3(0.5, 0, 0), Quat::Identity()})});
        QVERIFY((s.inertia - solidOf(whole).value().inertia).norm() < 1e-12);
    }

    /// A box turned by 30 degrees about z, against the closed form of its products of inertia.
    void aTurnedBox() {
        GeomSpec box;
        box.size = {1, 2, 3};
        const double c = std::sqrt(0.75), s = 0.5, xx = 6.0 / 12 * (4 + 9), yy = 6.0 / 12 * (1 + 9), zz = 6.0 / 12 * (1 + 4);
        const Pose turned{Vec3(5, -7, 11), rotationFromHpr(Vec3(30, 0, 0) * std::numbers::pi / 180)};
        const MassProperties p = placed(solidOf(box).value(), turned);
        Mat3 expected;
        expected << c * c * xx + s * s * yy, s * c * (xx - yy), 0, s * c * (xx - yy), s * s * xx + c * c * yy, 0, 0, 0, zz;
        QVERIFY((p.inertia - expected).norm() < 1e-12);
        QCOMPARE(p.centre, Vec3(5, -7, 11));
    }

    /// A solid with its centre off its origin, turned about all axes: the same as the mesh of its turned points.
    void placesASolid() {
        for (const Vec3& hpr : {Vec3(0.5, 0, 0), Vec3(0, 0.6, 0), Vec3(0, 0, -0.7), Vec3(0.4, -0.9, 1.3)}) {
            const Pose within{Vec3(0.3, -0.2, 0.7), rotationFromHpr(Vec3(0.2, 0.5, -0.3))};
            const Pose pose{Vec3(-1, 2, 0.5), rotationFromHpr(hpr)};
            const MassProperties whole = solidOf(boxMesh({1, 2, 3}, pose * within)).value();
            const MassProperties p = placed(solidOf(boxMesh({1, 2, 3}, within)).value(), pose);
            QVERIFY((p.inertia - whole.inertia).norm() < 1e-9);
            QVERIFY((p.centre - whole.centre).norm() < 1e-12);
        }
    }

    /// Two turned solids of different mass, against the point masses of both (the parallel axis theorem, term by term).
    void sumsTurnedSolids() {
        GeomSpec box, rod;
        box.size = {0.2, 0.5, 0.9};
        rod.shape = GeomShape::Cylinder;
        rod.radius = 0.1;
        rod.length = 1.5;
        const MassProperties a =
            placed(withMass(solidOf(box).value(), 3), {Vec3(1, 2, -1), rotationFromHpr(Vec3(0.4, 0.2, 0.9))});
        const MassProperties b = placed(withMass(solidOf(rod).value(), 5), {Vec3(-2, 0.5, 3), rotationFromHpr(Vec3(-1, 0.7, 0))});
        const MassProperties total = sum({a, b});
        QCOMPARE(total.mass, 8.0);
        QVERIFY((total.centre - Vec3((3 - 10) / 8.0, (6 + 2.5) / 8.0, (-3 + 15) / 8.0)).norm() < 1e-12);
        const double reduced = 3 * 5 / 8.0; // of two bodies about their common centre
        const Vec3 d(3, 1.5, -4);
        Mat3 expected = a.inertia + b.inertia;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) expected(i, k) += reduced * ((i == k ? d.squaredNorm() : 0) - d[i] * d[k]);
        QVERIFY((total.inertia - expected).norm() < 1e-12);
        QVERIFY((sum({b, a}).inertia - total.inertia).norm() < 1e-12);
    }

    /// Scaling a mass scales the inertia and leaves the centre.
    void scalesTheMass() {
        const MassProperties solid = solidOf(boxMesh({1, 2, 3}, {Vec3(4, 5, 6), Quat::Identity()})).value();
        const MassProperties light = withMass(solid, 1.5);
        QCOMPARE(light.mass, 1.5);
        QVERIFY((light.centre - Vec3(4, 5, 6)).norm() < 1e-12);
        QVERIFY((light.inertia - solid.inertia / 4).norm() < 1e-9);
    }

    /// Closed forms with different numbers along each axis.
    void plainShapes() {
        GeomSpec g;
        g.radius = 0.3;
        g.shape = GeomShape::Sphere;
        const double pi = std::numbers::pi, ball = 4.0 / 3 * pi * 0.027;
        QVERIFY((solidOf(g).value().inertia - Mat3(0.4 * ball * 0.09 * Mat3::Identity())).norm() < 1e-15);
        g.shape = GeomShape::Cylinder;
        g.length = 0.8;
        const double m = pi * 0.09 * 0.8, across = m * (3 * 0.09 + 0.64) / 12;
        QCOMPARE(solidOf(g).value().mass, m);
        QVERIFY((solidOf(g).value().inertia - Mat3(Vec3(across, across, m * 0.045).asDiagonal())).norm() < 1e-15);
        g.shape = GeomShape::Plane;
        QVERIFY(!solidOf(g).ok());
        g.shape = GeomShape::Mesh; // without points
        QVERIFY(!solidOf(g).ok());
        QVERIFY(sum({}).mass == 0 && !checkMass(sum({})).ok());
    }

    /// The limits, along each axis and with axes that are not principal.
    void inertiaOfATurnedBody() {
        const Mat3 r = rotationFromHpr(Vec3(0.4, 0.8, -0.5)).toRotationMatrix();
        for (const Vec3& moments : {Vec3(1, 2, 3), Vec3(3, 1, 2), Vec3(2, 3, 1)}) {
            const auto of = [&](double more) {
                const Vec3 m = moments + more * Vec3((moments.array() > 2.5).cast<double>());
                return checkMass({1, Vec3::Zero(), Mat3(r * m.asDiagonal() * r.transpose())}).ok();
            };
            QVERIFY(of(0) && of(-0.5));
            QVERIFY(!of(0.001));
        }
        QVERIFY(!checkMass({1, Vec3::Zero(), Mat3(1e-19 * Mat3::Identity())}).ok());
        QVERIFY(checkMass({1, Vec3::Zero(), Mat3(2e-18 * Mat3::Identity())}).ok());
        QVERIFY(!checkMass({1, Vec3(0, std::nan(""), 0), Mat3::Identity()}).ok());
        QVERIFY(!checkMass({std::numeric_limits<double>::infinity(), Vec3::Zero(), Mat3::Identity()}).ok());
    }

    void rejectsImpossibleInertia() {
        const auto of = [](double x, double y, double z) {
            return checkMass({1, Vec3::Zero(), Vec3(x, y, z).asDiagonal().toDenseMatrix()}).ok();
        };
        QVERIFY(of(1, 1, 1));
        QVERIFY(of(1, 1, 2)); // a flat disc
        QVERIFY(!of(1, 1, 2.1));
        QVERIFY(!of(1, 1, -1));
        QVERIFY(!of(1, 1, 0));
        QVERIFY(!of(1, std::nan(""), 1));
        QVERIFY(!checkMass({0, Vec3::Zero(), Mat3::Identity()}).ok());
    }

    /// The hull contains all points, is closed, and its vertices are some of the points.
    void hulls() {
        for (int round = 0; round < 40; ++round) {
            std::vector<std::array<double, 3>> points;
            const int count = 4 + round * 5;
            for (int i = 0; i < count; ++i) {
                std::array<double, 3> p;
                for (int k = 0; k < 3; ++k) {
                    p[k] = random01(static_cast<std::uint64_t>(round * 10000 + i * 3 + k));
                    if (round % 2) p[k] = std::round(p[k] * 4) / 4; // many coplanar points
                }
                points.push_back(p);
            }
            const auto hull = convexHull(points);
            if (!hull) {
                QVERIFY(round % 2);
                continue;
            }
            QVERIFY(solidOf(*hull).ok());
            for (const auto& t : hull->triangles) {
                const auto v = [&](int i) { return Vec3(hull->points[t[i]][0], hull->points[t[i]][1], hull->points[t[i]][2]); };
                const Vec3 normal = (v(1) - v(0)).cross(v(2) - v(0)).normalized();
                for (const auto& p : points) QVERIFY(normal.dot(Vec3(p[0], p[1], p[2]) - v(0)) < 1e-7);
            }
        }
    }

    void aFlatCloudHasNoHull() {
        QVERIFY(!convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}));
        QVERIFY(!convexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
        QVERIFY(!convexHull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
        QVERIFY(!convexHull({}));
    }
};

QTEST_APPLESS_MAIN(MassPropertiesTest)
#include "mass_properties_test.moc"
