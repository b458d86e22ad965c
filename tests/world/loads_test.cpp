// What bears much more than its own weight, and blows of what is heavy, in short ticks as in long ones.
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

void addBlock(Scene& scene, const char* name, const Vec3& centre, double mass, const Vec3& size, std::uint32_t surface) {
    scene.loose(name, {centre, Quat::Identity()}, massOfBox(mass, size), {box("b", size, {}, surface)});
}

} // namespace

class LoadsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bearsWhatLiesOnIt_data() {
        QTest::addColumn<double>("below");
        QTest::addColumn<double>("above");
        QTest::addColumn<double>("h");
        QTest::addColumn<bool>("onBox");
        for (const auto& [below, above] : {std::pair(20., 470.), {0.2, 60.}, {25., 1000.}, {200., 2000.}, {20., 1.}})
            for (const double h : {0.001, 0.005, 0.01, 0.03})
                for (const bool onBox : {false, true})
                    QTest::addRow("%g kg below %g kg, %g ms, on a %s", below, above, 1e3 * h, onBox ? "box" : "plane")
                        << below << above << h << onBox;
    }
    /// The ground below a light thing gives no more under a load than three times what it gives under the thing alone.
    void bearsWhatLiesOnIt() {
        QFETCH(double, below);
        QFETCH(double, above);
        QFETCH(double, h);
        QFETCH(bool, onBox);
        Scene scene(h);
        const auto s = scene.surface(0.5);
        scene.scenery({onBox ? box("floor", {6, 6, 1}, at(0, 0, -0.5), s) : plane("floor", {}, s)});
        addBlock(scene, "low", {0, 0, 0.09}, below, {0.6, 0.5, 0.18}, s);
        addBlock(scene, "high", {0.02, 0.01, 0.225}, above, {0.3, 0.3, 0.09}, s);
        auto world = scene.build();
        QVERIFY(run(*world, 1.5));
        const Vec3 first = position(*world, "low/body");
        QVERIFY(run(*world, 1.5));
        const Vec3 low = position(*world, "low/body"), high = position(*world, "high/body");
        QVERIFY2(low.z() > 0.09 - 3.2e-4 && low.z() <= 0.09, qPrintable(QString::number(low.z(), 'g', 9)));
        QVERIFY2(high.z() > 0.225 - 6.4e-4, qPrintable(QString::number(high.z(), 'g', 9)));
        QVERIFY2((low - first).norm() < 1e-7, qPrintable(QString::number((low - first).norm())));
        QVERIFY(spin(*world, "low/body").norm() < 1e-6 && spin(*world, "high/body").norm() < 1e-6);
    }

    /// A load on a light thing that slides down a slope: both go down as Coulomb says, without turning.
    void slidesUnderALoad() {
        for (const double h : {0.001, 0.005, 0.01, 0.02})
            for (const double above : {5., 470.}) {
                const double friction = 0.5, slope = std::atan(friction) + 1.5 * kPi / 180;
                Scene scene(h);
                scene.spec->settings.gravity = g * Vec3(std::sin(slope), 0, -std::cos(slope));
                const auto floor = scene.surface(friction), rough = scene.surface(5);
                scene.scenery({plane("floor", {}, floor)});
                addBlock(scene, "low", {0, 0, 0.09}, 20, {0.6, 0.5, 0.18}, rough);
                addBlock(scene, "high", {0, 0, 0.225}, above, {0.3, 0.3, 0.09}, rough);
                auto world = scene.build();
                QVERIFY(run(*world, 0.3));
                const double before = velocity(*world, "low/body").x(), begin = world->time();
                QVERIFY(run(*world, 0.9));
                const double found = (velocity(*world, "low/body").x() - before) / (world->time() - begin);
                const double expected = g * (std::sin(slope) - friction * std::cos(slope));
                QVERIFY2(std::abs(found - expected) < 0.002 * friction * g,
                         qPrintable(QStringLiteral("%1 ms, %2 kg: %3, not %4").arg(1e3 * h).arg(above).arg(found).arg(expected)));
                QVERIFY(spin(*world, "high/body").norm() < 1e-3);
            }
    }

    void aBlowStopsWhateverIsHeavy_data() {
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("speed");
        for (const double mass : {0.01, 0.1, 1., 20., 500.})
            for (const auto& [h, speed] :
                 {std::pair(0.0005, 20.), {0.001, 18.}, {0.001, 0.5}, {0.003, 6.}, {0.01, 2.}, {0.03, 0.6}})
                QTest::addRow("%g kg, %g ms, %g m/s", mass, 1e3 * h, speed) << mass << h << speed;
    }
    /// Without restitution: in one tick, however heavy the ball and short the tick. A wall of 5 mm holds it.
    void aBlowStopsWhateverIsHeavy() {
        QFETCH(double, mass);
        QFETCH(double, h);
        QFETCH(double, speed);
        for (int phase = 0; phase < 5; ++phase) {
            Scene scene(h);
            scene.spec->settings.gravity = Vec3::Zero();
            const auto s = scene.surface(0.5);
            scene.scenery({box("wall", {0.005, 1, 1}, {}, s)});
            scene.ball("b", {-0.0125 - speed * h * (2 + phase / 5.), 0, 0}, mass, 0.01, s);
            auto world = scene.build();
            QVERIFY(world->push("b/body", {mass * speed / h, 0, 0}, position(*world, "b/body")).ok());
            double least = speed;
            for (int tick = 0; tick < 12; ++tick) {
                const double before = position(*world, "b/body").x();
                QVERIFY(run(*world, h));
                const double way = position(*world, "b/body").x() - before;
                if (before + 0.0125 > 1e-9) least = std::min(least, way / h);
                if (before + 0.0125 > 1e-9 && tick > 0 && way > 0)
                    QVERIFY2(way / h < 0.021 * speed, qPrintable(QString::number(way / h / speed)));
            }
            QVERIFY(position(*world, "b/body").x() < -0.005);
        }
    }

    /// Two that are free: they go on together, with the momentum that they had.
    void aBlowOfTwo() {
        for (const double h : {0.001, 0.01})
            for (const auto& [first, second] : {std::pair(1., 50.), {50., 1.}, {300., 200.}}) {
                Scene scene(h);
                scene.spec->settings.gravity = Vec3::Zero();
                const auto s = scene.surface(0.5);
                scene.ball("a", {-0.1, 0, 0}, first, 0.03, s);
                scene.ball("b", {0.1, 0, 0}, second, 0.05, s);
                auto world = scene.build();
                const double speed = 2;
                QVERIFY(world->push("a/body", {first * speed / h, 0, 0}, position(*world, "a/body")).ok());
                QVERIFY(run(*world, 0.3));
                const double together = first * speed / (first + second);
                QVERIFY(std::abs(velocity(*world, "a/body").x() - together) < 0.021 * speed);
                QVERIFY(std::abs(velocity(*world, "b/body").x() - together) < 0.021 * speed);
            }
    }

    /// A box at an odd angle on a cylinder touches it at two points. How deep it is when that is found has no say in what follows.
    void anObliqueBlowDoesNotDependOnItsPhase() {
        std::vector<double> ends;
        for (int phase = 0; phase < 8; ++phase) {
            Scene scene(0.01);
            scene.spec->settings.gravity = Vec3::Zero();
            const auto s = scene.surface(0);
            scene.scenery({cylinder("post", 0.1, 0.16, at(0, 0, 0, degrees(-69.35, 40.09, 26.45)), s)});
            const Vec3 size(0.2, 0.26, 0.14);
            scene.loose("a", at(-0.5 - 0.0003 * phase, 0.0036, 0.0018, degrees(4.45, 148.03, -95.59)), massOfBox(1, size),
                        {box("b", size, {}, s)});
            auto world = scene.build();
            QVERIFY(world->push("a/body", {25, 0, 0}, position(*world, "a/body")).ok());
            double x = 0;
            for (int tick = 0; tick < 250 && !(x > 0 && x < 0.245); ++tick) {
                QVERIFY(run(*world, 0.01));
                x = velocity(*world, "a/body").x();
            }
            ends.push_back(x);
        }
        const auto [least, most] = std::ranges::minmax(ends);
        qInfo("%.4f to %.4f m/s after the first blow", least, most);
        QVERIFY(most - least < 0.01); // it was 0.035
    }
};

QTEST_APPLESS_MAIN(LoadsTest)
#include "loads_test.moc"
