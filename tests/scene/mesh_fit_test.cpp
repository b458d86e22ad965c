// Simple shapes around meshes: a mesh that is such a shape is found again, and every shape contains its mesh.
#include <QTest>

#include <cmath>

#include "model/shortest_turn.h"
#include "scene/shapes/mesh_fit.h"
#include "scene/shapes/shape_mesh.h"

using namespace trundle;

namespace {

/// The surface of a geom as a mesh, as fine as a modelling program would make it.
TriangleMesh meshOf(const GeomSpec& geom) {
    Fineness fine;
    fine.segments = 64;
    const ShapeMesh shape = bareShapeOf(geom, fine);
    TriangleMesh mesh;
    for (const Eigen::Vector3f& point : shape.points) {
        const Vec3 at = geom.pose * Vec3(point.cast<double>());
        mesh.points.push_back({at.x(), at.y(), at.z()});
    }
    for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3)
        mesh.triangles.push_back({shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]});
    return mesh;
}

GeomSpec solid(GeomShape shape) {
    GeomSpec geom;
    geom.shape = shape;
    geom.size = {0.3, 0.2, 0.1};
    geom.radius = 0.1, geom.length = 0.4;
    geom.pose.position = {1, -2, 0.5};
    return geom;
}

const MeshFit* fitOf(const std::vector<MeshFit>& fits, GeomShape shape) {
    for (const MeshFit& fit : fits)
        if (fit.geom.shape == shape) return &fit;
    return nullptr;
}

} // namespace

class MeshFitTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void findsTheShapeAgain_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<Vec3>("axis");
        QTest::newRow("box") << int(GeomShape::Box) << Vec3(0, 0, 1);
        QTest::newRow("sphere") << int(GeomShape::Sphere) << Vec3(0, 0, 1);
        for (const GeomShape shape : {GeomShape::Cylinder, GeomShape::Capsule})
            for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
                QTest::addRow("%s %g%g%g", shape == GeomShape::Cylinder ? "cylinder" : "capsule", axis.x(), axis.y(), axis.z())
                    << int(shape) << axis;
    }
    void findsTheShapeAgain() {
        QFETCH(int, shape);
        QFETCH(Vec3, axis);
        GeomSpec geom = solid(GeomShape(shape));
        if (geom.shape != GeomShape::Box) geom.pose.rotation = shortestTurn(Vec3::UnitZ(), axis);
        const std::vector<MeshFit> fits = fitsAround(meshOf(geom));
        QCOMPARE(fits.size(), std::size_t(5));
        const MeshFit& fit = *fitOf(fits, geom.shape);
        QVERIFY2(fit.largest < 0.003, QByteArray::number(fit.largest)); // of 64 segments
        QVERIFY(fit.mean <= fit.largest);
        QVERIFY2((fit.geom.pose.position - geom.pose.position).norm() < 0.002, "centre");
        for (const MeshFit& other : fits)
            if (other.geom.shape != geom.shape && other.geom.shape != GeomShape::Convex) QVERIFY(other.mean > fit.mean);
        if (geom.shape == GeomShape::Box) QVERIFY((fit.geom.size - geom.size).norm() < 1e-6);
        else QVERIFY(std::abs(fit.geom.radius - geom.radius) < 0.002);
        if (geom.shape == GeomShape::Cylinder || geom.shape == GeomShape::Capsule) {
            QVERIFY(std::abs(std::abs((fit.geom.pose.rotation * Vec3::UnitZ()).dot(axis)) - 1) < 1e-9);
            QVERIFY(std::abs(fit.geom.length - geom.length) < 0.004);
        }
        QVERIFY(fitOf(fits, GeomShape::Convex)->largest < 1e-6); // it is convex
    }

    void everyShapeContainsItsMesh() {
        std::srand(3);
        TriangleMesh mesh;
        for (std::uint32_t i = 0; i < 300; ++i) {
            const auto random = [] { return std::rand() / double(RAND_MAX) - 0.5; };
            mesh.points.push_back({3 * random(), random(), random() * random()});
            if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
        }
        for (const MeshFit& fit : fitsAround(mesh)) {
            if (fit.geom.shape == GeomShape::Convex) continue;
            for (const auto& point : mesh.points) {
                const Vec3 p = fit.geom.pose.inverse() * Vec3(point.data());
                const double out = std::hypot(p.x(), p.y()), past = std::abs(p.z()) - fit.geom.length / 2,
                             r = fit.geom.radius + 1e-9;
                switch (fit.geom.shape) {
                case GeomShape::Box: QVERIFY((p.cwiseAbs() - fit.geom.size / 2).maxCoeff() < 1e-9); break;
                case GeomShape::Sphere: QVERIFY(p.norm() <= r); break;
                case GeomShape::Cylinder: QVERIFY(out <= r && past < 1e-9); break;
                default: QVERIFY(std::hypot(out, std::max(past, 0.0)) <= r); break;
                }
            }
        }
    }

    void flatAndEmptyMeshes() {
        QVERIFY(fitsAround({}).empty());
        const std::vector<MeshFit> flat = fitsAround({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, nullptr});
        QCOMPARE(flat.size(), std::size_t(4)); // without a hull
        QVERIFY(flat[0].geom.size.z() > 0);    // the language has no box without a height
    }
};

QTEST_APPLESS_MAIN(MeshFitTest)
#include "mesh_fit_test.moc"
