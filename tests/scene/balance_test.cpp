// Mass of posed robots, ellipsoids of inertia, and what robots rest on.
#include <QtTest>

#include "model/mass_properties.h"
#include "scene/queries/balance.h"

using namespace trundle;

namespace {

BodySpec boxBody(const Vec3& size, const Vec3& at, double mass) {
    BodySpec body;
    GeomSpec box;
    box.shape = GeomShape::Box;
    box.size = size;
    body.pose.position = at;
    body.mass = withMass(solidOf(box).value(), mass);
    body.geoms.push_back(box);
    return body;
}

std::shared_ptr<const ExperimentSpec> experimentOf(std::vector<BodySpec> bodies) {
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies = std::move(bodies);
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->robots.resize(1);
    experiment->robots[0].name = "r";
    experiment->robots[0].config = config;
    return experiment;
}

std::optional<Balance> balanceOf(const std::shared_ptr<const ExperimentSpec>& experiment) {
    return trundle::balanceOf(ObjectIndex(experiment), 0, startPoses(*experiment));
}

} // namespace

class BalanceTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wholeIsTheSumOfItsBodies() {
        const auto experiment =
            experimentOf({boxBody(Vec3::Constant(0.1), {0, 0, 0.05}, 1), boxBody(Vec3::Constant(0.1), {0.4, 0, 0.05}, 3)});
        const MassProperties whole = massOf(ObjectIndex(experiment), 0, startPoses(*experiment));
        QCOMPARE(whole.mass, 4.0);
        QVERIFY(whole.centre.isApprox(Vec3(0.3, 0, 0.05), 1e-12));
        QVERIFY(std::abs(whole.inertia(2, 2) - (4 * 0.01 / 6 + 0.09 + 3 * 0.01)) < 1e-12); // Steiner
    }

    void ellipsoidOfASolidEllipsoidIsItself() {
        const Vec3 axes(0.3, 0.2, 0.1); // I = m/5 (b^2 + c^2)
        MassProperties mass{5, Vec3::Zero(), Vec3(0.04 + 0.01, 0.09 + 0.01, 0.09 + 0.04).asDiagonal().toDenseMatrix()};
        const InertiaEllipsoid made = ellipsoidOf(mass);
        Vec3 sorted = made.semiAxes;
        std::sort(sorted.data(), sorted.data() + 3);
        QVERIFY(sorted.isApprox(Vec3(0.1, 0.2, 0.3), 1e-9));
        for (int k = 0; k < 3; ++k) {
            int main = 0;
            made.axes.col(k).cwiseAbs().maxCoeff(&main);
            QVERIFY(std::abs(made.semiAxes[k] - axes[main]) < 1e-9);
        }
        QVERIFY(std::abs(made.axes.determinant() - 1) < 1e-9);
    }

    void aBoxRestsOnItsFoot() {
        const auto balance = balanceOf(experimentOf({boxBody({0.4, 0.2, 0.1}, {1, 2, 0.3}, 1)}));
        QVERIFY(balance && balance->isStable());
        QCOMPARE(balance->polygon.size(), std::size_t(4));
        QVERIFY(std::abs(balance->level - 0.25) < 1e-12);
        QVERIFY(std::abs(balance->margin - 0.1) < 1e-12);
        QVERIFY(balance->centre.isApprox(Vec3(1, 2, 0.25), 1e-12));
    }

    void aLoadBeyondTheEdgeTurnsItOver() {
        const auto balance =
            balanceOf(experimentOf({boxBody({0.2, 0.2, 0.1}, {0, 0, 0.05}, 1), boxBody({0.1, 0.1, 0.1}, {0.4, 0, 0.4}, 1)}));
        QVERIFY(balance && !balance->isStable());
        QVERIFY(std::abs(balance->margin + 0.1) < 1e-12);
    }

    /// Off the middle of the world, to each side: how far from the edge, or beyond it.
    void marginsHaveASignAndDigits_data() {
        QTest::addColumn<Vec3>("load"); // m, of as much mass as the base, from its middle
        QTest::addColumn<double>("margin");
        QTest::addColumn<std::string>("text");
        QTest::newRow("in the middle") << Vec3(0, 0, 0.3) << 0.1 << std::string("Stable: 100 mm to the edge");
        QTest::newRow("towards +x") << Vec3(0.3, 0, 0.3) << 0.05 << std::string("Stable: 50 mm to the edge");
        QTest::newRow("towards -y") << Vec3(0, -0.19, 0.3) << 0.005 << std::string("Stable: 5.0 mm to the edge");
        QTest::newRow("beyond -x") << Vec3(-0.5, 0, 0.3) << -0.05 << std::string("Falls over: 50 mm beyond the edge");
        QTest::newRow("beyond +y") << Vec3(0, 0.213, 0.3) << -0.0065 << std::string("Falls over: 6.5 mm beyond the edge");
        QTest::newRow("beyond a corner") << Vec3(0.46, 0.28, 0.3) << -0.05 << std::string("Falls over: 50 mm beyond the edge");
    }
    void marginsHaveASignAndDigits() {
        QFETCH(Vec3, load);
        QFETCH(double, margin);
        QFETCH(std::string, text);
        const Vec3 at(3, -2, 1);
        BodySpec top = boxBody(Vec3::Constant(0.1), at + load, 1), lamp = boxBody(Vec3::Constant(0.1), at - Vec3(0, 0, 0.5), 0);
        lamp.geoms[0].collide = false; // lower, but it touches nothing
        lamp.mass = {};
        const auto balance = balanceOf(experimentOf({boxBody({0.4, 0.2, 0.1}, at, 1), top, lamp}));
        QVERIFY(balance);
        QVERIFY(std::abs(balance->level - 0.95) < 1e-12);
        QVERIFY2(std::abs(balance->margin - margin) < 1e-9, qPrintable(QString::number(balance->margin)));
        QCOMPARE(balance->isStable(), margin > 0);
        QCOMPARE(balanceText(*balance), text);
    }

    /// A box tips where its centre of mass is above its edge: tan = half of a side by half of the height.
    void aBoxTipsAboutItsEdges() {
        const auto balance = balanceOf(experimentOf({boxBody({0.4, 0.2, 0.6}, {1, 2, 0.3}, 1)}));
        QVERIFY(balance);
        QVERIFY(std::abs(balance->height - 0.3) < 1e-12);
        QVERIFY(std::abs(tipAngle(*balance, {1, 0, 0}) - std::atan(2 / 3.)) < 1e-9);
        QVERIFY(std::abs(tipAngle(*balance, {0, -3, 0}) - std::atan(1 / 3.)) < 1e-9);
        QVERIFY(std::abs(tipAngle(*balance, {2, 1, 0}) - std::atan(std::hypot(0.2, 0.1) / 0.3)) < 1e-9); // the corner
        QCOMPARE(leastTipAngle(*balance), tipAngle(*balance, {0, 1, 0}));
        QCOMPARE(tippingText(*balance, 0), std::string("forward 34°, backward 34°, left 18°, right 18°; least 18°"));
        QCOMPARE(tippingText(*balance, std::numbers::pi / 2),
                 std::string("forward 18°, backward 18°, left 34°, right 34°; least 18°"));
    }

    /// What it stands on may be anywhere: on a table, in a pit, the robot itself placed there.
    void tippingDoesNotDependOnTheHeightOfTheGround() {
        for (const double ground : {-2.5, 0., 0.75, 40.}) {
            auto experiment = std::make_shared<ExperimentSpec>(*experimentOf({boxBody({0.4, 0.2, 0.6}, {0, 0, 0.3}, 1)}));
            experiment->robots[0].pose = {{1, 2, ground}, rotationFromHpr({std::numbers::pi / 2, 0, 0})}; // faces along y
            const auto balance = balanceOf(experiment);
            QVERIFY(balance && balance->isStable());
            QVERIFY(std::abs(balance->level - ground) < 1e-12);
            QVERIFY(std::abs(balance->height - 0.3) < 1e-12);
            QVERIFY(balance->centre.isApprox(Vec3(1, 2, ground), 1e-12));
            QVERIFY(std::abs(tipAngle(*balance, {0, 1, 0}) - std::atan(2 / 3.)) < 1e-9);
            QVERIFY(std::abs(tipAngle(*balance, {-1, 0, 0}) - std::atan(1 / 3.)) < 1e-9);
            QVERIFY(std::abs(leastTipAngle(*balance) - std::atan(1 / 3.)) < 1e-9);
        }
    }

    void theNearestEdgeIsTheMarginAway() {
        const auto balance =
            balanceOf(experimentOf({boxBody({0.4, 0.2, 0.6}, {1, 2, 0.3}, 1), boxBody({0.1, 0.1, 0.1}, {1, 2.05, 0.7}, 1)}));
        QVERIFY(balance && balance->isStable());
        QVERIFY(nearestEdge(*balance).isApprox(Vec3(1, 2.1, 0), 1e-9));
        QVERIFY(std::abs((nearestEdge(*balance) - balance->centre).norm() - balance->margin) < 1e-12);
    }

    void whatIsNotStableTipsOnAnySlope() {
        const auto balance =
            balanceOf(experimentOf({boxBody({0.2, 0.2, 0.1}, {0, 0, 0.05}, 1), boxBody({0.1, 0.1, 0.1}, {0.4, 0, 0.4}, 1)}));
        QVERIFY(balance);
        QCOMPARE(tipAngle(*balance, {1, 0, 0}), 0.0);
        QCOMPARE(leastTipAngle(*balance), 0.0);
    }

    void twoWheelsAreALine() {
        const auto wheel = [](double y) {
            BodySpec body;
            GeomSpec tyre;
            tyre.shape = GeomShape::Cylinder;
            tyre.radius = 0.05;
            tyre.length = 0.02;
            tyre.pose.rotation = rotationFromHpr({0, 0, std::numbers::pi / 2});
            body.pose.position = {0, y, 0.05};
            body.mass = placed(withMass(solidOf(tyre).value(), 0.1), tyre.pose);
            body.geoms.push_back(tyre);
            return body;
        };
        const auto balance = balanceOf(experimentOf({boxBody({0.1, 0.2, 0.1}, {0, 0, 0.1}, 1), wheel(0.12), wheel(-0.12)}));
        QVERIFY(balance && !balance->isStable());
        QCOMPARE(balance->polygon.size(), std::size_t(2));
        QCOMPARE(balanceText(*balance), std::string("Falls over: it rests on a line"));
    }

    /// A ball does not fall over; a box on its corner does.
    void whatRestsOnAPointMayRollOrTip() {
        BodySpec ball = boxBody(Vec3::Constant(0.1), {0, 0, 0.05}, 1);
        ball.geoms[0].shape = GeomShape::Sphere;
        ball.geoms[0].radius = 0.05;
        BodySpec corner = boxBody(Vec3::Constant(0.1), {0, 0, 0.1}, 1);
        corner.pose.rotation = rotationFromHpr({0.3, 0.5, 0.7});
        for (const BodySpec& body : {ball, corner}) {
            const auto balance = balanceOf(experimentOf({body}));
            QVERIFY(balance && !balance->isStable());
            QCOMPARE(balance->polygon.size(), std::size_t(1));
            QCOMPARE(balanceText(*balance), std::string("Rests on a point: it may roll or tip"));
        }
    }

    void whatIsHeldByTheWorldNeedsNoSupport() {
        auto experiment = std::make_shared<ExperimentSpec>(*experimentOf({boxBody(Vec3::Constant(0.1), {0, 0, 1}, 1)}));
        auto config = std::make_shared<RobotConfigSpec>(*experiment->robots[0].config);
        JointSpec foot;
        foot.type = JointType::Fixed;
        config->joints.push_back(foot);
        experiment->robots[0].config = config;
        QVERIFY(!balanceOf(experiment));
    }

    /// By a joint of the experiment to the world or to another robot; a spring holds nothing.
    void whatAnotherRobotHoldsNeedsNoSupport() {
        auto experiment = std::make_shared<ExperimentSpec>(*experimentOf({boxBody(Vec3::Constant(0.1), {0, 0, 1}, 1)}));
        experiment->robots.push_back(experiment->robots[0]);
        experiment->springs.push_back({{}, 1, 0});
        experiment->joints.push_back({{}, kWorldBody, 1});
        QVERIFY(balanceOf(experiment));
        for (const auto& [parent, child] : {std::pair(kWorldBody, 0), {0, 1}, {1, 0}}) {
            experiment->joints[0].parentRobot = parent;
            experiment->joints[0].childRobot = child;
            QVERIFY(!balanceOf(experiment));
        }
    }

    /// On its ends: a lying cylinder and capsule, a mesh; on feet of which one is a little shorter.
    void shapesRestOnTheirEnds_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("level");
        QTest::newRow("cylinder") << int(GeomShape::Cylinder) << -0.05;
        QTest::newRow("capsule") << int(GeomShape::Capsule) << -0.05;
        QTest::newRow("mesh") << int(GeomShape::Mesh) << -0.02;
    }
    void shapesRestOnTheirEnds() {
        QFETCH(int, shape);
        QFETCH(double, level);
        BodySpec body = boxBody(Vec3::Constant(0.1), {1, 0, 0}, 2);
        GeomSpec& geom = body.geoms[0];
        geom.shape = GeomShape(shape);
        geom.radius = 0.05;
        geom.length = 0.3;
        geom.pose = {Vec3(0.1, 0.2, 0), rotationFromHpr({0, std::numbers::pi / 2, 0})}; // along x
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->points = {{0.02, 0, -0.15}, {0.02, 0, 0.15}, {-0.05, 0, 0}};
        if (geom.shape == GeomShape::Mesh) geom.mesh = mesh;
        const auto balance = balanceOf(experimentOf({body}));
        QVERIFY(balance);
        QCOMPARE(balance->polygon.size(), std::size_t(2));
        double low = 9, high = -9;
        for (const Vec3& p : balance->polygon) low = std::min(low, p.x()), high = std::max(high, p.x());
        QVERIFY(std::abs(low - 0.95) < 1e-9 && std::abs(high - 1.25) < 1e-9);
        QVERIFY2(std::abs(balance->level - level) < 1e-9, qPrintable(QString::number(balance->level)));
    }

    void feetOfNearlyTheSameLengthCarry() {
        for (const auto& [shorter, corners] : {std::pair(1e-3, 8), {3e-3, 4}}) {
            BodySpec body = boxBody({0.1, 0.1, 0.1}, {0, 0, 0.05}, 1);
            GeomSpec other = body.geoms[0];
            other.pose.position = {0.5, 0.3, shorter};
            body.geoms.push_back(other);
            const auto balance = balanceOf(experimentOf({body}));
            QVERIFY(balance && balance->level == 0);
            QCOMPARE(balance->polygon.size(), std::size_t(corners == 8 ? 6 : 4)); // the hull of two squares
        }
    }

    void fixedBodiesWeighNothing() {
        BodySpec anchor = boxBody(Vec3::Constant(0.1), {5, 0, 0.05}, 3);
        anchor.isFixed = true;
        const auto experiment = experimentOf({boxBody(Vec3::Constant(0.1), {1, 0, 0.05}, 2), anchor});
        QCOMPARE(massOf(ObjectIndex(experiment), 0, startPoses(*experiment)).mass, 2.0);
    }

    void axesAreRightHandedInAnyOrder() {
        Vec3 moments(0.02, 0.03, 0.04);
        std::sort(moments.data(), moments.data() + 3);
        do {
            for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(0.4, 0.7, -1.1), Vec3(2, -1, 0.3)}) {
                const Mat3 r = rotationFromHpr(turn).toRotationMatrix();
                const InertiaEllipsoid made = ellipsoidOf({0.5, Vec3::Zero(), r * moments.asDiagonal() * r.transpose()});
                QVERIFY(std::abs(made.axes.determinant() - 1) < 1e-9);
                for (int k = 0; k < 3; ++k)
                    QVERIFY(std::abs(made.semiAxes[k] - std::sqrt(5 * (0.09 - 2 * made.moments[k]))) < 1e-9);
            }
        } while (std::next_permutation(moments.data(), moments.data() + 3));
    }

    void textsAtTheirLimits() {
        Balance balance;
        balance.polygon = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
        for (const auto& [margin, text] : {std::pair(0.01, "Stable: 10 mm to the edge"),
                                           {0.0099, "Stable: 9.9 mm to the edge"},
                                           {0., "Falls over: 0.0 mm beyond the edge"}}) {
            balance.margin = margin;
            QCOMPARE(balanceText(balance), std::string(text));
        }
    }

    void theNearestEdgeEndsAtItsCorners() {
        Balance balance; // the centre is beside both ends of the long edge's line
        balance.polygon = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 4, 0), Vec3(0, 4, 0)};
        balance.centre = {0.9, 3.8, 0};
        QVERIFY(nearestEdge(balance).isApprox(Vec3(1, 3.8, 0), 1e-12));
        balance.centre = {-1, 5, 0};
        QVERIFY(nearestEdge(balance).isApprox(Vec3(0, 4, 0), 1e-12));
    }
};

QTEST_APPLESS_MAIN(BalanceTest)
#include "balance_test.moc"
