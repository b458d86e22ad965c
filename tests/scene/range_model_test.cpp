// What is drawn of sensors and pens: the directions of the beams that a Lidar measures along, and the ribbon of a line.
#include <QtTest>

#include <cmath>
#include <numbers>

#include "scene/pen_nodes.h"
#include "scene/queries/range_model.h"

using namespace trundle;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

ComponentSpec lidar(const std::map<std::string, double>& numbers) {
    ComponentSpec spec;
    spec.kind = "Lidar";
    spec.name = "scan";
    spec.values["Body"] = {{PropertyType::Reference, {}, {"hull"}}, {}, Origin::Config};
    for (const auto& [key, value] : numbers) spec.values[key] = {{PropertyType::Number, {value}, {}}, {}, Origin::Config};
    return spec;
}

PenLine lineOf(std::vector<PenLine::Point> points) {
    PenLine line;
    line.width = 0.02;
    line.points = std::move(points);
    return line;
}

bool isCovered(const TriangleMesh& mesh, double x, double y) {
    const auto side = [&](std::uint32_t from, std::uint32_t to) {
        const auto &a = mesh.points[from], &b = mesh.points[to];
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    };
    return std::ranges::any_of(mesh.triangles, [&](const auto& t) {
        const double p = side(t[0], t[1]), q = side(t[1], t[2]), r = side(t[2], t[0]);
        return (p >= 0 && q >= 0 && r >= 0) || (p <= 0 && q <= 0 && r <= 0);
    });
}

} // namespace

class RangeModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void beams_data() {
        QTest::addColumn<int>("beams");
        QTest::addColumn<double>("field");
        QTest::addColumn<double>("step"); // rad, from one beam to the next
        QTest::newRow("all around") << 8 << kTurn << kTurn / 8;
        QTest::newRow("an odd number all around") << 5 << kTurn << kTurn / 5;
        QTest::newRow("half around") << 5 << kTurn / 2 << kTurn / 8;
        QTest::newRow("nearly all around") << 5 << 0.99 * kTurn << 0.99 * kTurn / 4;
        QTest::newRow("two") << 2 << 1.0 << 1.0;
        QTest::newRow("one") << 1 << 1.0 << 0.0;
    }
    /// From the right to the left; of a full turn the last one is a step before the first.
    void beams() {
        QFETCH(int, beams);
        QFETCH(double, field);
        QFETCH(double, step);
        const auto model = rangeModelOf(lidar({{"MaxRange", 3}, {"Beams", beams}, {"FieldOfView", field}}));
        QVERIFY(model);
        QCOMPARE(model->closed, field == kTurn);
        QCOMPARE(model->directions.size(), std::size_t(beams));
        const double first = beams > 1 ? -field / 2 : 0;
        for (int i = 0; i < beams; ++i) {
            const double bearing = first + i * step;
            QVERIFY((model->directions[std::size_t(i)] - Vec3(std::cos(bearing), std::sin(bearing), 0)).norm() < 1e-12);
        }
    }

    void layers() {
        const auto model = rangeModelOf(lidar({{"MaxRange", 3}, {"Beams", 4}, {"Layers", 3}, {"VerticalFieldOfView", 0.6}}));
        QVERIFY(model);
        QCOMPARE(model->directions.size(), std::size_t(12));
        for (std::size_t i = 0; i < 12; ++i)
            QVERIFY(std::abs(std::asin(model->directions[i].z()) - 0.3 * (double(i / 4) - 1)) < 1e-12);
        QVERIFY(!rangeModelOf(lidar({{"MaxRange", 3}, {"Beams", 20001}})));
    }

    /// A line is as wide as it is, with round ends; between two strokes there is nothing.
    void ribbons() {
        const TriangleMesh one = ribbonOf(lineOf({{{0, 0, 0}, true}, {{1, 0, 0}, false}, {{1, 1, 0}, false}}));
        for (const auto& [x, y] :
             {std::pair{0., 0.}, {0.5, 0.}, {0.5, 0.0099}, {0.5, -0.0099}, {1., 0.5}, {1.0099, 0.5}, {1.009, 0.}, {-0.009, 0.}})
            QVERIFY(isCovered(one, x, y));
        for (const auto& [x, y] : {std::pair{0.5, 0.0101}, {-0.011, 0.}, {0.5, 0.5}, {1., 1.011}}) QVERIFY(!isCovered(one, x, y));
        const TriangleMesh two = ribbonOf(lineOf({{{0, 0, 0}, true}, {{1, 0, 0}, false}, {{2, 0, 0}, true}, {{3, 0, 0}, false}}));
        QVERIFY(isCovered(two, 0.5, 0) && isCovered(two, 2.5, 0) && isCovered(two, 2, 0));
        QVERIFY(!isCovered(two, 1.5, 0));
        for (const auto& p : two.points) QVERIFY(p[2] > 0 && p[2] < 0.005); // a little above the floor
        QVERIFY(ribbonOf(lineOf({})).triangles.empty());
    }

    void manyBeamsInLayersAreNotDrawn() {
        QVERIFY(rangeModelOf(lidar({{"MaxRange", 3}, {"Beams", 5000}, {"Layers", 4}})));
        QVERIFY(!rangeModelOf(lidar({{"MaxRange", 3}, {"Beams", 5001}, {"Layers", 4}})));
    }

    /// Without beams a sensor looks along one direction, in a cone; that of the ground looks down.
    void conesAndGroundSensors() {
        ComponentSpec sonar = lidar({{"MaxRange", 3}});
        QCOMPARE(rangeModelOf(sonar)->coneAngle, 0.);
        sonar.values["Type"] = {{PropertyType::Choice, {}, {"ultrasonic"}}, {}, Origin::Config};
        QCOMPARE(rangeModelOf(sonar)->coneAngle, kTurn / 12);
        QCOMPARE(rangeModelOf(sonar)->directions, std::vector<Vec3>{Vec3::UnitX()});
        const auto eye = rangeModelOf(lidar({{"MaxHeight", 0.04}}));
        QVERIFY(eye && eye->ground && eye->maxRange == 0.04);
        QCOMPARE(eye->directions, std::vector<Vec3>{-Vec3::UnitZ()});
    }
};

QTEST_APPLESS_MAIN(RangeModelTest)
#include "range_model_test.moc"
