// Texture coordinates of shapes.
#include <QtTest>

#include "scene/shapes/picture_map.h"
#include "world/reflectance.h"

using namespace trundle;
using Eigen::Vector2f;
using Eigen::Vector3f;

class PictureMapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everySideOfABoxHasTheWholePictureUprightAndNotMirrored() {
        const ShapeMesh box = boxMesh({2, 1, 0.5}, false);
        const std::vector<Vector2f> at = pictureCoordinates(box, PictureMap::Box, 1);
        QCOMPARE(at.size(), box.indices.size());
        std::map<int, std::pair<Vector2f, Vector2f>> sides;
        for (std::size_t i = 0; i < at.size(); i += 3) {
            const Vector3f a = box.points[box.indices[i]], b = box.points[box.indices[i + 1]], c = box.points[box.indices[i + 2]];
            const Vector3f normal = (b - a).cross(c - a);
            // Triangles are counter-clockwise seen from outside; image rows count downwards, which reverses that.
            const Vector2f u = at[i + 1] - at[i], v = at[i + 2] - at[i];
            QVERIFY(u.x() * v.y() - u.y() * v.x() < 0);
            Eigen::Index axis = 0;
            normal.cwiseAbs().maxCoeff(&axis);
            auto& [low, high] =
                sides.try_emplace(int(2 * axis + (normal[axis] > 0)), Vector2f(9, 9), Vector2f(-9, -9)).first->second;
            for (std::size_t k = i; k < i + 3; ++k) {
                low = low.cwiseMin(at[k]);
                high = high.cwiseMax(at[k]);
                if (axis == 2) continue;
                QCOMPARE(at[k].y() < 0.5f, box.points[box.indices[k]].z() > 0); // its top is up
            }
        }
        QCOMPARE(sides.size(), std::size_t(6));
        for (const auto& [side, range] : sides) {
            QVERIFY(range.first.isApprox(Vector2f(0, 0)) || range.first.norm() < 1e-6f);
            QVERIFY(range.second.isApprox(Vector2f(1, 1)));
        }
    }

    void wrapsPictureAroundCylinderWithoutSeam() {
        const ShapeMesh tube = cylinderMesh(1, 2, 24);
        const std::vector<Vector2f> at = pictureCoordinates(tube, PictureMap::Cylinder, 1);
        float least = 9, most = -9;
        for (std::size_t i = 0; i < at.size(); i += 3) {
            const Vector3f a = tube.points[tube.indices[i]], b = tube.points[tube.indices[i + 1]],
                           c = tube.points[tube.indices[i + 2]];
            if (std::abs((b - a).cross(c - a).normalized().z()) > 0.5f) continue; // a cap
            const auto [low, high] = std::minmax({at[i].x(), at[i + 1].x(), at[i + 2].x()});
            QVERIFY2(high - low < 1.5f / 24, qPrintable(QString::number(high - low)));
            least = std::min(least, low), most = std::max(most, high);
        }
        QVERIFY(std::abs(most - least - 1) < 1.5f / 24);
    }

    void aSphereHasNoJumpEither() {
        const ShapeMesh ball = sphereMesh(1, 24);
        const std::vector<Vector2f> at = pictureCoordinates(ball, PictureMap::Sphere, 2);
        for (std::size_t i = 0; i < at.size(); i += 3) {
            const auto [low, high] = std::minmax({at[i].x(), at[i + 1].x(), at[i + 2].x()});
            QVERIFY2(high - low < 2 * 1.5f / 24, qPrintable(QString::number(high - low)));
        }
    }

    void theShapeDecidesWhereTheTextDoesNot() {
        QCOMPARE(pictureMapOf("auto", GeomShape::Box), PictureMap::Box);
        QCOMPARE(pictureMapOf("auto", GeomShape::Cylinder), PictureMap::Cylinder);
        QCOMPARE(pictureMapOf("auto", GeomShape::Sphere), PictureMap::Sphere);
        QCOMPARE(pictureMapOf("auto", GeomShape::Heightfield), PictureMap::Planar);
        QCOMPARE(pictureMapOf("sphere", GeomShape::Box), PictureMap::Sphere);
    }

    /// What a sensor sees at a point is what is drawn there.
    void aPointHasItsPlaceInThePicture_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("map");
        for (const GeomShape shape : {GeomShape::Box, GeomShape::Sphere, GeomShape::Cylinder, GeomShape::Capsule})
            for (const PictureMap map : {PictureMap::Planar, PictureMap::Box, PictureMap::Cylinder, PictureMap::Sphere})
                if (map != PictureMap::Sphere || shape == GeomShape::Sphere ||
                    shape == GeomShape::Capsule) // else not linear on a triangle
                    QTest::addRow("shape %d, map %d", int(shape), int(map)) << int(shape) << int(map);
    }
    void aPointHasItsPlaceInThePicture() {
        QFETCH(int, shape);
        QFETCH(int, map);
        GeomSpec geom;
        geom.shape = static_cast<GeomShape>(shape);
        geom.size = {0.6, 0.3, 0.2};
        geom.radius = 0.25;
        geom.length = 0.7;
        const char* words[] = {"planar", "box", "cylinder", "sphere"};
        MaterialSpec material;
        material.textureMap = words[map];
        auto picture = std::make_shared<Raster>();
        picture->width = 64, picture->height = 64;
        for (int y = 0; y < 64; ++y) // brighter to the right and down, and so unlike everywhere
            for (int x = 0; x < 64; ++x)
                for (int k = 0; k < 3; ++k)
                    picture->pixels.push_back(static_cast<std::uint8_t>(k == 0 ? 4 * x : k == 1 ? 4 * y : 0));
        material.picture = picture;
        const auto [low, size] = pictureBox(geom);
        const ShapeMesh mesh = shapeOf(geom, {200, false, 0});
        const std::vector<Vector2f> at = pictureCoordinates(mesh, static_cast<PictureMap>(map), 1);
        int compared = 0;
        for (std::size_t i = 0; i + 2 < at.size(); i += 3) {
            const Vector3f a = mesh.points[mesh.indices[i]], b = mesh.points[mesh.indices[i + 1]],
                           c = mesh.points[mesh.indices[i + 2]];
            const Vector3f middle = (a + b + c) / 3, normal = (b - a).cross(c - a).normalized();
            const Vector2f drawn = (at[i] + at[i + 1] + at[i + 2]) / 3;
            const bool isSeam = drawn.x() < 0.03f || drawn.x() > 0.97f || drawn.y() < 0.03f || drawn.y() > 0.97f;
            if (isSeam || middle.head<2>().norm() < 0.03f) continue;         // repeated; a pole
            const double u = drawn.x() - 0.5 / 64, v = drawn.y() - 0.5 / 64; // pixels stand for their middles
            const double red = 4 * 64 * u / 255, green = 4 * 64 * v / 255;
            const double expected = 0.2126 * red * red + 0.7152 * green * green;
            const double seen = reflectanceAt(material, geom.shape, middle.cast<double>(), normal.cast<double>(), low, size);
            QVERIFY2(std::abs(seen - expected) < 0.01,
                     qPrintable(QString("%1,%2: %3, not %4").arg(drawn.x()).arg(drawn.y()).arg(seen).arg(expected)));
            ++compared;
        }
        QVERIFY2(compared >= 4, qPrintable(QString::number(compared)));
    }
};

QTEST_APPLESS_MAIN(PictureMapTest)
#include "picture_map_test.moc"
