// Texture coordinates of shapes.
#include <QtTest>

#include "scene/shapes/picture_map.h"

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
};

QTEST_APPLESS_MAIN(PictureMapTest)
#include "picture_map_test.moc"
