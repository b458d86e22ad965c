// Mass, centre of mass and inertia of geoms and meshes.
#include <QTest>

#include <numbers>

#include "base/rng.h"
#include "model/convex_hull.h"
#include "model/mass_properties.h"

using namespace trundle;

namespace {

TriangleMesh boxMesh(const Vec3& size, const Vec3& centre) {
    TriangleMesh m;
    for (int i = 0; i < 8; ++i) {
        const Vec3 p = centre + 0.5 * size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
        m.points.push_back({p.x(), p.y(), p.z()});
    }
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

double random01(std::uint64_t i) { return toUnit(randomBits(5, 0, 0, i)); }

} // namespace

class MassPropertiesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBoxAsMeshIsABox() {
        GeomSpec box;
        box.size = {1, 2, 3};
        const MassProperties a = solidOf(box).value(), b = solidOf(boxMesh({1, 2, 3}, {100, -50, 7})).value();
        QVERIFY(std::abs(a.mass - 6) < 1e-12 && std::abs(b.mass - 6) < 1e-9);
        QVERIFY((b.centre - Vec3(100, -50, 7)).norm() < 1e-9);
        QVERIFY((a.inertia - b.inertia).norm() < 1e-9);
        TriangleMesh inside = boxMesh({1, 2, 3}, {0, 0, 0});
        for (auto& t : inside.triangles) std::swap(t[0], t[1]);
        QVERIFY(std::abs(solidOf(inside).value().mass - 6) < 1e-12);
    }

    void anOpenMeshHasNone() {
        TriangleMesh open = boxMesh({1, 1, 1}, {0, 0, 0});
        open.triangles.pop_back();
        QVERIFY(!solidOf(open).ok());
    }

    /// Three separate vertices for each triangle, as in STL.
    void anUnweldedMeshIsClosed() {
        const TriangleMesh box = boxMesh({1, 1, 1}, {0, 0, 0});
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
