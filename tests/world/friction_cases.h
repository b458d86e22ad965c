#pragma once
// Cases of Coulomb friction: measured against expected values, at three tick lengths and with both solvers.

#include <QtTest>

#include <functional>

#include "world/friction_scenes.h"

namespace fixture {

/// Measured value and the value of Coulomb's law, in the same unit.
struct Figures {
    double measured = 0, expected = 1;
};
struct Conditions {
    double tick = 0.01;
    SolverChoice solver = SolverChoice::Exact;
    EngineChoice engine = EngineChoice::General;
};
using Measure = std::function<Figures(const Conditions&)>;

struct Case {
    std::string name;
    Measure measure;
    double most = 0.02, mostAt30 = 0.04; ///< relative
    double quickUpTo = 1;                ///< s: longest tick at which the quick solver also keeps the bounds
    double wheeledUpTo = 0;              ///< s: longest tick at which the wheeled engine keeps the bounds too
};

inline void addCases(const std::vector<Case>& cases) {
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("tick");
    QTest::addColumn<int>("solver");
    QTest::addColumn<bool>("wheeled");
    int index = 0;
    for (const Case& c : cases) {
        for (const double tick : {0.005, 0.01, 0.03})
            if (tick <= c.wheeledUpTo) QTest::addRow("%s, %g ms, wheeled", c.name.c_str(), 1e3 * tick) << index << tick << 0 << true;
        for (const double tick : {0.005, 0.01, 0.03})
            for (const SolverChoice solver : {SolverChoice::Exact, SolverChoice::Quick})
                if (solver == SolverChoice::Exact || tick <= c.quickUpTo)
                    QTest::addRow("%s, %g ms, %s", c.name.c_str(), 1e3 * tick, solver == SolverChoice::Quick ? "quick" : "exact")
                        << index << tick << int(solver) << false;
        ++index;
    }
}
inline void check(const Case& c, const Conditions& conditions) {
    const Figures f = c.measure(conditions);
    const double off = f.measured / f.expected - 1;
    qInfo("%.5g, Coulomb %.5g: %+.2f %%", f.measured, f.expected, 100 * off);
    QVERIFY(std::abs(off) <= (conditions.tick > 0.02 ? c.mostAt30 : c.most));
}

inline Scene sceneOf(const Conditions& c) {
    Scene scene(c.tick);
    scene.spec->settings.solver = c.solver;
    scene.spec->settings.engine = c.engine;
    return scene;
}

inline double rad(double degrees) { return degrees * kPi / 180; }

/// Gravity vector for a slope of `angle` degrees that falls towards `heading`; the floor itself stays level.
inline Vec3 slopeGravity(double angle, double heading) {
    return g * Vec3(std::sin(rad(angle)) * std::cos(rad(heading)), std::sin(rad(angle)) * std::sin(rad(heading)),
                    -std::cos(rad(angle)));
}

inline std::vector<Eigen::Vector2d> corners(double x, double y) { return {{x, y}, {-x, y}, {x, -y}, {-x, -y}}; }

} // namespace fixture
