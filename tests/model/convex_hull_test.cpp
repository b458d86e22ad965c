// Hulls of known solids, of many points, and of point sets without volume.
#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

#include <trundle/geometry.h>

#include "model/convex_hull.h"

using namespace trundle;

namespace {

using Points = std::vector<std::array<double, 3>>;

double volume(const TriangleMesh& hull) {
    double six = 0;
    for (const auto& t : hull.triangles)
        six += Vec3(hull.points[t[0]].data()).cross(Vec3(hull.points[t[1]].data())).dot(Vec3(hull.points[t[2]].data()));
    return six / 6;
}

Points onABall(int count) {
    std::mt19937 rng(3);
    std::normal_distribution<double> n;
    Points points;
    for (int i = 0; i < count; ++i) {
        const double x = n(rng), y = n(rng), z = n(rng);
        const Vec3 p = Vec3(x, y, z).normalized();
        points.push_back({p.x(), p.y(), p.z()});
    }
    return points;
}

} // namespace

class ConvexHullTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ofACube() {
        Points points;
        for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
        points.push_back({0.5, 0.5, 0.5});
        points.push_back({1, 1, 1});
        const auto hull = convexHull(points);
        QVERIFY(hull);
        QCOMPARE(hull->points.size(), std::size_t{8});
        QCOMPARE(hull->triangles.size(), std::size_t{12});
        QVERIFY(std::abs(volume(*hull) - 1) < 1e-12);
    }

    void ofAGrid() { // many points in one plane and on one line
        Points points;
        for (int x = 0; x <= 4; ++x)
            for (int y = 0; y <= 4; ++y)
                for (int z = 0; z <= 2; ++z) points.push_back({0.1 * x, 0.1 * y, 0.1 * z});
        const auto hull = convexHull(points);
        QVERIFY(hull);
        QVERIFY(std::abs(volume(*hull) - 0.4 * 0.4 * 0.2) < 1e-9);
    }

    void ofManyPoints() {
        const Points points = onABall(5000);
        const auto whole = convexHull(points);
        QVERIFY(whole);
        QVERIFY(std::abs(volume(*whole) / (4.0 / 3 * std::numbers::pi) - 1) < 0.01);
        QVERIFY(convexHull(points)->triangles == whole->triangles);
    }

    void fewPointsReachAsFar() {
        const Points points = onABall(5000), few = farthestPoints(points, 96);
        QVERIFY(few.size() > 80 && few.size() <= 96);
        for (const auto& p : few) QVERIFY(std::find(points.begin(), points.end(), p) != points.end());
        const auto hull = convexHull(few);
        QVERIFY(hull);
        QVERIFY(std::abs(volume(*hull) / (4.0 / 3 * std::numbers::pi) - 1) < 0.1);
        QVERIFY(farthestPoints(few, 96) == few); // already few enough points
    }

    void noneWithoutVolume() {
        QVERIFY(!convexHull(Points{}));
        QVERIFY(!convexHull(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        QVERIFY(!convexHull(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}));
        QVERIFY(!convexHull(Points(20, {1, 2, 3})));
        QVERIFY(!convexHull(Points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
    }
};

QTEST_APPLESS_MAIN(ConvexHullTest)
#include "convex_hull_test.moc"
