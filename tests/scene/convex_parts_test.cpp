// Meshes as several convex hulls: what is made of boxes is found again, a cup stays open, and all hulls together cover the mesh.
#include <QTest>

#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/shapes/convex_parts.h"
#include "scene/shapes/mesh_fit.h"

using namespace trundle;

namespace {

/// An extruded outline, counter-clockwise, from z = 0 to `high`; its caps as fans about triangles given.
TriangleMesh extruded(const std::vector<std::array<double, 2>>& outline, const std::vector<std::array<std::uint32_t, 3>>& cap,
                      double high) {
    TriangleMesh mesh;
    const auto n = std::uint32_t(outline.size());
    for (const double z : {0., high})
        for (const auto& [x, y] : outline) mesh.points.push_back({x, y, z});
    for (const auto& [a, b, c] : cap) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({a + n, b + n, c + n});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t k = (i + 1) % n;
        mesh.triangles.push_back({i, k, k + n});
        mesh.triangles.push_back({i, k + n, i + n});
    }
    return mesh;
}

/// An L of two legs, 0.3 x 0.2 m outside, 0.05 m thick, 0.1 m high.
TriangleMesh bracket() {
    return extruded({{0, 0}, {0.3, 0}, {0.3, 0.05}, {0.05, 0.05}, {0.05, 0.2}, {0, 0.2}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0.1);
}

/// Open at the top: radius 0.1 m, wall and bottom 0.02 m, 0.2 m high.
TriangleMesh cup() {
    constexpr std::uint32_t kSides = 24;
    const std::array<std::array<double, 2>, 4> profile{{{0.1, 0}, {0.1, 0.2}, {0.08, 0.2}, {0.08, 0.02}}};
    TriangleMesh mesh;
    for (const auto& [r, z] : profile)
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const double a = 2 * std::numbers::pi * i / kSides;
            mesh.points.push_back({r * std::cos(a), r * std::sin(a), z});
        }
    for (std::uint32_t ring = 0; ring < 3; ++ring)
        for (std::uint32_t i = 0; i < kSides; ++i) {
            const std::uint32_t k = (i + 1) % kSides, a = ring * kSides, b = a + kSides;
            mesh.triangles.push_back({a + i, a + k, b + k});
            mesh.triangles.push_back({a + i, b + k, b + i});
        }
    const auto middle = std::uint32_t(mesh.points.size());
    mesh.points.push_back({0, 0, 0});
    mesh.points.push_back({0, 0, 0.02});
    for (std::uint32_t i = 0; i < kSides; ++i) {
        mesh.triangles.push_back({middle, (i + 1) % kSides, i});
        mesh.triangles.push_back({middle + 1, 3 * kSides + i, 3 * kSides + (i + 1) % kSides});
    }
    return mesh;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

} // namespace

class ConvexPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBracketIsItsTwoLegs() {
        const ConvexParts parts = convexPartsOf(bracket());
        QCOMPARE(parts.hulls.size(), std::size_t(2));
        QVERIFY2(std::abs(sum(parts.volumes) - 0.1 * (0.3 * 0.05 + 0.05 * 0.15)) < 1e-9, QByteArray::number(sum(parts.volumes)));
        QVERIFY2(parts.largest < 1e-9, QByteArray::number(parts.largest));
        const std::vector<MeshFit> fits = fitsAround(bracket());
        QVERIFY(fits.back().geom.shape == GeomShape::Convex && fits.back().largest > 0.02); // one hull is far from it
    }

    void aConvexMeshIsOneHull() {
        const ConvexParts parts = convexPartsOf(extruded({{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}}, {{0, 1, 2}, {0, 2, 3}}, 0.1));
        QCOMPARE(parts.hulls.size(), std::size_t(1));
        QVERIFY(std::abs(parts.volumes[0] - 0.006) < 1e-9 && parts.largest < 1e-9);
    }

    void aCupStaysOpen() {
        const ConvexParts parts = convexPartsOf(cup(), 16);
        QVERIFY2(parts.hulls.size() > 4 && parts.hulls.size() <= 16, QByteArray::number(int(parts.hulls.size())));
        QVERIFY2(parts.mean < 0.006, QByteArray::number(parts.mean));
        // The hull of all holds 6.2 l, the material 2.7 l: the parts are much nearer to that.
        QVERIFY2(sum(parts.volumes) < 0.0038, QByteArray::number(sum(parts.volumes)));
        QCOMPARE(convexPartsOf(cup(), 16).volumes, parts.volumes);
    }

    void theirNumberIsLimited() {
        for (const std::size_t most : {std::size_t(1), std::size_t(3)}) QVERIFY(convexPartsOf(cup(), most).hulls.size() <= most);
    }

    void whatIsFlatOrEmptyHasNone() {
        QVERIFY(convexPartsOf({}).hulls.empty());
        TriangleMesh flat;
        flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        flat.triangles = {{0, 1, 2}};
        QVERIFY(convexPartsOf(flat).hulls.empty());
    }
};

QTEST_APPLESS_MAIN(ConvexPartsTest)
#include "convex_parts_test.moc"
