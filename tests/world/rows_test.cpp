// The rows of joints and contacts that hang together, solved sparsely: against what a solution must fulfil, and in place of ODE's solver.
#include <QtTest>

#include <Eigen/Dense>
#include <limits>
#include <numeric>
#include <random>

#include "world/fixtures.h"
#include "world/ode/lcp/elimination_order.h"
#include "world/ode/lcp/row_solver.h"
#include "world/ode/lcp/side_search.h"
#include "world/ode/lcp/solve_lcp.h"

using namespace fixture;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class JointTree { Chain, Star, Random };

/// Bodies in a tree of hinges, motors with a limit, and contacts with friction on some of the bodies; random positions.
struct Island {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
    std::vector<double> bounds;
    std::vector<int> normals;
    std::vector<std::vector<int>> joints; ///< rows

    Island(JointTree tree, int bodies, int motors, int contacts, std::uint32_t seed) : m_random(seed) {
        for (int child = 1; child < bodies; ++child) {
            const int parent = tree == JointTree::Chain  ? child - 1
                               : tree == JointTree::Star ? 0
                                                    : static_cast<int>(m_random() % unsigned(child));
            joints.emplace_back();
            for (int k = 0; k < 5; ++k) joints.back().push_back(addRow(child, parent, -kInfinity, kInfinity, -1));
        }
        for (int i = 0; i < motors && i + 1 < bodies; ++i) addRow(i + 1, 0, -0.5, 0.5, -1);
        for (int i = 0; i < contacts; ++i) {
            const int of = static_cast<int>(m_random() % unsigned(bodies));
            const Vec3 point = random6().head<3>(), up = random6().head<3>().normalized(), along = up.unitOrthogonal();
            const int normal = addRow(of, -1, 0, kInfinity, -1);
            m_rows.back().a << up, point.cross(up);
            for (const Vec3& way : {along, Vec3(up.cross(along))}) {
                addRow(of, -1, -0.5, 0.5, i % 2 ? normal : -1);
                m_rows.back().a << way, point.cross(way);
            }
        }
        finish(bodies);
    }

private:
    struct Row {
        int first, second;
        Eigen::Matrix<double, 6, 1> a, b;
    };

    Eigen::Matrix<double, 6, 1> random6() {
        std::normal_distribution<double> normal;
        Eigen::Matrix<double, 6, 1> v;
        for (double& x : v) x = normal(m_random);
        return v;
    }
    int addRow(int first, int second, double low, double high, int normal) {
        m_rows.push_back({first, second, random6(), random6()});
        bounds.insert(bounds.end(), {low, high});
        normals.push_back(normal);
        return static_cast<int>(m_rows.size()) - 1;
    }
    void finish(int bodies) {
        const auto n = static_cast<Eigen::Index>(m_rows.size());
        Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(n, 6 * bodies);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Row& row = m_rows[std::size_t(i)];
            jacobian.block<1, 6>(i, 6 * row.first) = row.a.transpose();
            if (row.second >= 0) jacobian.block<1, 6>(i, 6 * row.second) = row.b.transpose();
        }
        matrix = jacobian * jacobian.transpose() + 1e-4 * Eigen::MatrixXd::Identity(n, n);
        right.resize(n);
        for (double& x : right) x = random6()[0];
    }

    std::mt19937 m_random;
    std::vector<Row> m_rows;
};

std::vector<double> solutionOf(const Island& island, bool& solved) {
    const auto n = static_cast<unsigned>(island.right.size());
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix = island.matrix;
    std::vector<double> pairs(2 * n), x(n);
    for (unsigned i = 0; i < n; ++i) pairs[2 * i] = island.right[i];
    RowSolver solver;
    solved = solver.solve({n, matrix.data(), n, island.bounds.data(), island.normals.data()}, pairs.data());
    for (unsigned i = 0; i < n; ++i) x[i] = pairs[2 * i + 1];
    return x;
}

/// By how much x misses what it must fulfil with these bounds.
double missOf(const Island& island, const std::vector<double>& x, const std::vector<double>& bounds) {
    const Eigen::VectorXd excess =
        island.matrix * Eigen::Map<const Eigen::VectorXd>(x.data(), Eigen::Index(x.size())) - island.right;
    double miss = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double low = bounds[2 * i], high = bounds[2 * i + 1], w = excess[Eigen::Index(i)];
        miss = std::max({miss, low - x[i], x[i] - high});
        if (x[i] > low + 1e-9) miss = std::max(miss, w);
        if (x[i] < high - 1e-9) miss = std::max(miss, -w);
    }
    return miss;
}

/// Values that are zero before and not after, for rows in this order.
int filledBy(std::vector<std::vector<bool>> pattern, std::span<const unsigned> order) {
    int filled = 0;
    for (std::size_t k = 0; k < order.size(); ++k)
        for (std::size_t a = k + 1; a < order.size(); ++a)
            for (std::size_t b = k + 1; b < a; ++b)
                if (pattern[order[a]][order[k]] && pattern[order[b]][order[k]] && !pattern[order[a]][order[b]]) {
                    pattern[order[a]][order[b]] = pattern[order[b]][order[a]] = true;
                    ++filled;
                }
    return filled;
}

/// A base on three wheels, each with 16 free rollers at its rim: 52 bodies, 51 hinges.
std::shared_ptr<RobotConfigSpec> omniBase(std::uint32_t rubber) {
    constexpr double kReach = 0.18, kRadius = 0.06, kRoller = 0.012;
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(
        body("chassis", at(0, 0, 0.08), massOfCylinder(3, 0.15, 0.06), {cylinder("hull", 0.15, 0.06, {}, rubber)}));
    for (int w = 0; w < 3; ++w) {
        const double angle = 2 * kPi * w / 3;
        const Vec3 outward(std::cos(angle), std::sin(angle), 0), along(-outward.y(), outward.x(), 0), up = Vec3::UnitZ();
        const Vec3 centre = kReach * outward + kRadius * up;
        const int hub = static_cast<int>(config->bodies.size());
        const std::string wheel = std::to_string(w);
        config->bodies.push_back(body("hub" + wheel, {centre, Quat::Identity()}, massOfSphere(0.1, 0.03), {}));
        config->joints.push_back(joint("axle" + wheel, JointType::Hinge, 0, hub, centre, outward));
        config->devices.push_back(row("motor" + wheel, "axle" + wheel));
        for (int k = 0; k < 16; ++k) {
            const double turn = 2 * kPi * k / 16;
            const Vec3 to = std::sin(turn) * along - std::cos(turn) * up, place = centre + (kRadius - kRoller) * to;
            const std::string name = wheel + "_" + std::to_string(k);
            config->joints.push_back(joint("roller" + name, JointType::Hinge, hub, static_cast<int>(config->bodies.size()), place,
                                           std::cos(turn) * along + std::sin(turn) * up));
            config->bodies.push_back(body("roller" + name, {place, Quat::Identity()}, massOfSphere(0.01, kRoller),
                                          {sphere("tread", kRoller, {}, rubber)}));
        }
    }
    return config;
}

} // namespace

class RowsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void solvesIslands_data() {
        QTest::addColumn<int>("tree");
        QTest::addColumn<int>("bodies");
        for (const int bodies : {1, 2, 3, 7, 8, 20, 60}) {
            QTest::addRow("chain of %d", bodies) << int(JointTree::Chain) << bodies;
            QTest::addRow("star of %d", bodies) << int(JointTree::Star) << bodies;
            QTest::addRow("tree of %d", bodies) << int(JointTree::Random) << bodies;
        }
    }
    void solvesIslands() {
        QFETCH(int, tree);
        QFETCH(int, bodies);
        int settled = 0;
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            const Island island(JointTree(tree), bodies, 4, 1 + bodies / 8, seed);
            bool solved = false;
            const std::vector<double> x = solutionOf(island, solved);
            QVERIFY(solved);
            std::vector<double> bounds = island.bounds; // friction's are those of the loads in the same solution
            for (std::size_t i = 0; i < x.size(); ++i)
                if (island.normals[i] >= 0) {
                    bounds[2 * i + 1] *= x[std::size_t(island.normals[i])];
                    bounds[2 * i] = -bounds[2 * i + 1];
                }
            const double miss = missOf(island, x, bounds);
            settled += miss < 1e-5;
        }
        qInfo("%d of 20", settled);
        QVERIFY(settled >= 18); // with friction this strong on levers this long there may be no such loads
    }

    /// A body that is pressed with a face on a wall, four contacts, and pulled along it: from the factor of the solution without bounds
    /// alone, all but exactly.
    void findsWhatSlips() {
        int slipping = 0;
        for (std::uint32_t seed = 0; seed < 50; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> any(-1, 1);
            Eigen::MatrixXd jacobian(12, 6);
            for (int i = 0; i < 4; ++i) {
                const Vec3 at(0.1, i % 2 ? 0.1 : -0.1, i < 2 ? 0.03 : -0.03);
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec3 way = Vec3::Unit(axis);
                    jacobian.row(axis == 0 ? i : 3 + 2 * i + axis) << way.transpose(), 10 * at.cross(way).transpose();
                }
            }
            const Eigen::MatrixXd matrix = jacobian * jacobian.transpose() + 1e-6 * Eigen::MatrixXd::Identity(12, 12);
            Eigen::VectorXd body = Eigen::VectorXd::NullaryExpr(6, [&] { return any(random); });
            body[0] = 2;
            const Eigen::VectorXd right = jacobian * body;
            const Eigen::LLT<Eigen::MatrixXd> cholesky(matrix);
            Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> factor = cholesky.matrixL();
            const Eigen::VectorXd divided = cholesky.matrixL().solve(right), inside = cholesky.solve(right);
            factor.diagonal() = factor.diagonal().cwiseInverse().eval();
            std::vector<double> low(12, 0), high(12, kInfinity);
            std::vector<unsigned> loads(12, 0);
            for (unsigned i = 4; i < 12; ++i) {
                high[i] = 0.3;
                loads[i] = (i - 4) / 2;
            }
            SideSearch search;
            QVERIFY(search.solve({12, 4, factor.data(), {divided.data(), 12}, {inside.data(), 12}, low, high, loads}));
            const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(search.solution().data(), 12),
                                  excess = matrix * x - right;
            for (unsigned i = 0; i < 12; ++i) {
                const double most = i < 4 ? kInfinity : 0.3 * x[loads[i]], least = i < 4 ? 0 : -most;
                QVERIFY(x[i] > least - 1e-12 && x[i] < most + 1e-12);
                if (x[i] > least + 1e-12) QVERIFY(excess[i] < 1e-12);
                if (x[i] < most - 1e-12) QVERIFY(excess[i] > -1e-12);
                slipping += i >= 4 && std::abs(x[i]) > most - 1e-12;
            }
        }
        qInfo("%d of 400 rows slip", slipping);
        QVERIFY(slipping > 100 && slipping < 380);
    }

    /// Joints in a tree are eliminated without filling much of what was zero, in whatever order they come.
    void fillsLittleInTrees() {
        int filled = 0, filledAsTheyCome = 0;
        for (std::uint32_t seed = 0; seed < 30; ++seed) {
            const Island island(JointTree::Random, 30, 0, 0, seed);
            const auto rows = static_cast<unsigned>(island.right.size()), words = (rows + 63) / 64;
            std::vector<unsigned> mixed(rows);
            for (unsigned i = 0; i < rows; ++i) mixed[i] = i;
            std::mt19937 random(seed);
            std::ranges::shuffle(mixed, random);
            std::vector<std::vector<bool>> pattern(rows, std::vector<bool>(rows));
            std::vector<std::uint64_t> bits(std::size_t(rows) * words);
            for (unsigned i = 0; i < rows; ++i)
                for (unsigned j = 0; j < rows; ++j) {
                    pattern[i][j] = island.matrix(mixed[i], mixed[j]) != 0;
                    if (pattern[i][j]) bits[std::size_t(i) * words + j / 64] |= std::uint64_t(1) << j % 64;
                }
            EliminationOrder order;
            const auto found = order.find(bits, rows, words);
            QCOMPARE(found.size(), std::size_t(rows));
            filled += filledBy(pattern, found);
            std::iota(mixed.begin(), mixed.end(), 0u);
            filledAsTheyCome += filledBy(pattern, mixed);
        }
        qInfo("filled: %d, as they come: %d", filled, filledAsTheyCome);
        QVERIFY(100 * filled < filledAsTheyCome);
    }

    /// Rows that contradict each other are left to ODE.
    void refusesWhatIsSingular() {
        Island island(JointTree::Star, 3, 0, 0, 1);
        island.matrix.row(3) = island.matrix.row(2);
        island.matrix.col(3) = island.matrix.col(2);
        bool solved = true;
        (void)solutionOf(island, solved);
        QVERIFY(!solved);
    }

    /// So are rows with nothing on the diagonal, in islands of any size.
    void refusesZeroOnTheDiagonal() {
        for (const int bodies : {3, 60}) {
            Island island(JointTree::Chain, bodies, 0, 0, 1);
            island.matrix(0, 0) = 0;
            bool solved = true;
            (void)solutionOf(island, solved);
            QVERIFY(!solved);
        }
    }

    /// A heap in which the sides of the rows do not settle is left to ODE, whose work for one row at a time is less.
    void leavesHeapsToOde() {
        Scene scene;
        const std::uint32_t wood = scene.surface(0.5);
        scene.spec->settings.solver = SolverChoice::Exact;
        scene.scenery({plane("floor", {}, wood)});
        for (int i = 0; i < 8; ++i) {
            const double x = 0.102 * (i % 2), y = 0.102 * (i / 2 % 2), shift = 0.05 * (i / 4);
            scene.loose("crate" + std::to_string(i), at(x + shift, y + shift, 0.05 + 0.1 * (i / 4)),
                        massOfBox(1, Vec3::Constant(0.1)), {box("crate", Vec3::Constant(0.1), {}, wood)});
        }
        auto world = scene.build();
        const SolvedIslands before = solvedIslands();
        QVERIFY(run(*world, 0.3));
        QVERIFY(solvedIslands().leftToOde > before.leftToOde);
    }

    /// ODE calls it for every island, and its own solver is not needed.
    void takesThePlaceOfOdes() {
        Scene scene = r0Scene();
        scene.scenery({plane("floor", {}, 1)}).robot("r", at(0, 0, 0), r0());
        auto world = scene.build();
        const SolvedIslands before = solvedIslands();
        QVERIFY(run(*world, 1));
        QCOMPARE(solvedIslands().count, before.count + 100);
        QCOMPARE(solvedIslands().leftToOde, before.leftToOde);
    }

    /// A base on rollers turns on the spot as fast as its wheels say.
    void omniBaseTurns() {
        Scene scene;
        const std::uint32_t rubber = scene.surface(1);
        scene.scenery({plane("floor", {}, rubber)}).robot("base", {}, omniBase(rubber));
        auto world = scene.build();
        const SolvedIslands before = solvedIslands();
        for (int i = 0; i < 300; ++i) {
            for (const char* motor : {"base/motor0", "base/motor1", "base/motor2"}) command(*world, motor, 2, 0.01, 5);
            QVERIFY(world->tick().ok());
        }
        const double turned = hprFromRotation(world->robotPose(0).rotation)[0];
        qInfo("turned by %.3f rad in 3 s", turned);
        QVERIFY(std::abs(std::abs(turned) - 2 * 0.06 / 0.18 * 3) < 0.05);
        QVERIFY(solvedIslands().count - before.count >= 300);
        QCOMPARE(solvedIslands().leftToOde, before.leftToOde);
    }
};

QTEST_APPLESS_MAIN(RowsTest)
#include "rows_test.moc"
