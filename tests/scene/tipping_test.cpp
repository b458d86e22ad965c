// The slopes on which bodies tip, as Properties lists them, against what they do in the simulation.
#include <QtTest>

#include "scene/queries/balance.h"
#include "world/fixtures.h"

using namespace trundle;

class TippingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tipsOnSteeperSlopesAlone_data() {
        QTest::addColumn<double>("heading"); // degrees, in which the slope goes down
        QTest::newRow("forward") << 0.;
        QTest::newRow("left") << 90.;
        QTest::newRow("backward") << 180.;
        QTest::newRow("over a corner") << 30.;
    }
    /// A column with a load on one side, on rough ground: below the angle it rests, above it lies down.
    void tipsOnSteeperSlopesAlone() {
        QFETCH(double, heading);
        const double turn = heading * fixture::kPi / 180;
        const Vec3 down(std::cos(turn), std::sin(turn), 0);
        for (const double off : {-1., 1.}) { // degrees
            fixture::Scene scene;
            const std::uint32_t rough = scene.surface(3);
            const MassProperties mass = fixture::massOfBox(2, {0.2, 0.3, 0.5}, {0.03, 0, 0.02});
            scene.loose("column", fixture::at(0, 0, 0.25), mass, {fixture::box("block", {0.2, 0.3, 0.5}, {}, rough)});
            scene.scenery({fixture::plane("floor", {}, rough)});
            const auto balance = balanceOf(ObjectIndex(scene.spec), 0, startPoses(*scene.spec));
            QVERIFY(balance && balance->isStable());
            const double slope = tipAngle(*balance, down) + off * fixture::kPi / 180;
            scene.spec->settings.gravity = fixture::g * (std::sin(slope) * down - std::cos(slope) * Vec3::UnitZ());
            const auto world = scene.build();
            QVERIFY(world && fixture::run(*world, 4));
            const double height = fixture::position(*world, "column/body").z(); // 0.25 m upright, at most 0.15 m lying
            QVERIFY2((height < 0.2) == (off > 0), qPrintable(QStringLiteral("%1 degrees: its middle is at %2 m")
                                                                 .arg(slope * 180 / fixture::kPi)
                                                                 .arg(height)));
        }
    }
};

QTEST_APPLESS_MAIN(TippingTest)
#include "tipping_test.moc"
