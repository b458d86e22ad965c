// Motion profiles of a drive.
#include "devices/drive_profile.h"

#include <QtTest>

#include <random>

using namespace trundle;

namespace {
constexpr DriveLimits kLimits{1, 4};

/// Drives the current amount to its end: the distance covered and the number of ticks (-1: it did not end).
struct Driven {
    ChassisMotion travel;
    int ticks = 0;
    double fastest = 0, hardest = 0;
};
Driven driveOut(DriveProfile& profile, double h, double lastSpeed = 0) {
    Driven d;
    while (profile.busy() && d.ticks < 1000000) {
        const ChassisMotion v = profile.next(kLimits, h);
        d.travel.linear += v.linear * h;
        d.travel.angular += v.angular * h;
        d.fastest = std::max(d.fastest, std::abs(v.linear));
        d.hardest = std::max(d.hardest, std::abs(v.linear - lastSpeed) / h);
        lastSpeed = v.linear;
        ++d.ticks;
    }
    if (profile.busy()) d.ticks = -1;
    return d;
}
} // namespace

class DriveProfileTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A base that turns when an amount starts brakes from there, within its acceleration, on both axes.
    void anAmountStartsFromTheVelocity() {
        for (const ChassisMotion& moving : {ChassisMotion{.5, 0}, {0, 1.5}, {.5, 1.5}, {-.5, -1.5}})
            for (const ChassisMotion& amount : {ChassisMotion{2, 0}, {0, 3}, {2, 3}}) {
                DriveProfile profile;
                profile.aim(moving);
                ChassisMotion last;
                for (int i = 0; i < 200; ++i) last = profile.next(kLimits, .01);
                QVERIFY(std::abs(last.linear - moving.linear) + std::abs(last.angular - moving.angular) < 1e-12);
                QVERIFY(!profile.start({.3, .9}, amount, kLimits));
                double hardest = 0;
                for (int i = 0; i < 5; ++i) {
                    const ChassisMotion v = profile.next(kLimits, .01);
                    hardest = std::max({hardest, std::abs(v.linear - last.linear) / (.01 * kLimits.linear),
                                        std::abs(v.angular - last.angular) / (.01 * kLimits.angular)});
                    last = v;
                }
                QVERIFY2(hardest < 2.001, qPrintable(QString::number(hardest))); // braking and the new motion may add up
                profile.aim({}); // again from what it has now, also within the amount
                const ChassisMotion next = profile.next(kLimits, .01);
                QVERIFY(std::abs(next.linear - last.linear) < .0201 * kLimits.linear);
                QVERIFY2(std::abs(next.angular - last.angular) < .0201 * kLimits.angular,
                         qPrintable(QString("%1 %2").arg(next.angular).arg(last.angular)));
            }
    }

    void brakesFirstAgainstItsMotion_data() {
        QTest::addColumn<ChassisMotion>("moving");
        QTest::addColumn<ChassisMotion>("amount");
        const auto row = [](const char* name, const ChassisMotion& moving, const ChassisMotion& amount) {
            QTest::newRow(name) << moving << amount;
        };
        row("ahead, to go back", {.5, 0}, {-2, 0});
        row("turning left, to turn right", {0, 1.5}, {0, -3});
        row("turning right, to turn left", {0, -1.5}, {0, 3});
        row("ahead and left, to go ahead and right", {.5, 1.5}, {2, -3});
        row("ahead and left, to go back and left", {.5, 1.5}, {-2, 3});
        row("aside, to the other side", {0, 0, .5}, {0, 0, -2});
    }
    /// What turns or drives the other way brakes before it starts, so that no axis has more than its acceleration.
    void brakesFirstAgainstItsMotion() {
        QFETCH(ChassisMotion, moving);
        QFETCH(ChassisMotion, amount);
        DriveProfile profile;
        profile.aim(moving);
        ChassisMotion last;
        for (int i = 0; i < 200; ++i) last = profile.next(kLimits, .01);
        const auto like = [](double speed, double way) { return way == 0 ? 0 : std::copysign(speed, way); };
        QVERIFY(!profile.start({like(.3, amount.linear), like(.9, amount.angular), like(.3, amount.lateral)}, amount, kLimits));
        ChassisMotion gone;
        for (int i = 0; profile.busy() && i < 100000; ++i) {
            const ChassisMotion v = profile.next(kLimits, .01);
            const double linear = std::hypot(v.linear - last.linear, v.lateral - last.lateral),
                         angular = std::abs(v.angular - last.angular);
            QVERIFY2(linear < .0101 * kLimits.linear && angular < .0101 * kLimits.angular,
                     qPrintable(QString("%1: %2 %3").arg(i).arg(linear).arg(angular)));
            gone.linear += .01 * v.linear, gone.angular += .01 * v.angular, gone.lateral += .01 * v.lateral;
            last = v;
        }
        QVERIFY(!profile.busy());
        QVERIFY(std::abs(gone.linear - amount.linear) + std::abs(gone.lateral - amount.lateral) < 1e-9);
        QVERIFY(std::abs(gone.angular - amount.angular) < 1e-9);
    }

    void amountsEndExactly_data() {
        QTest::addColumn<double>("v");
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("endX");
        QTest::addColumn<double>("endAngle");
        QTest::newRow("straight") << .2 << 0. << 1. << 0. << 1. << 0.;
        QTest::newRow("backwards") << -.2 << 0. << -1. << 0. << -1. << 0.;
        QTest::newRow("on the spot") << 0. << -2. << 0. << -3.1 << 0. << -3.1;
        QTest::newRow("arc by length") << .3 << 1. << .6 << 0. << .6 << 2.;
        QTest::newRow("arc by angle") << .3 << 1. << 0. << 2. << .6 << 2.;
        QTest::newRow("arc backwards by angle") << -.3 << 1. << 0. << 2. << -.6 << 2.;
        QTest::newRow("both, one slows down for the other") << .3 << 1. << 3. << 1. << 3. << 1.;
        QTest::newRow("too short to reach the speed") << 1. << 0. << .01 << 0. << .01 << 0.;
        QTest::newRow("less than a tick") << 1. << 0. << 1e-7 << 0. << 1e-7 << 0.;
    }
    void amountsEndExactly() {
        QFETCH(double, v);
        QFETCH(double, w);
        QFETCH(double, x);
        QFETCH(double, angle);
        QFETCH(double, endX);
        QFETCH(double, endAngle);
        for (const double h : {.001, .01, .03, .0371}) {
            DriveProfile profile;
            QVERIFY(!profile.start({v, w}, {x, angle}, kLimits));
            const Driven d = driveOut(profile, h);
            QVERIFY(d.ticks > 0);
            QVERIFY2(std::abs(d.travel.linear - endX) < 1e-12 && std::abs(d.travel.angular - endAngle) < 1e-12,
                     qPrintable(QString("%1 m, %2 rad").arg(d.travel.linear, 0, 'g', 17).arg(d.travel.angular, 0, 'g', 17)));
            QVERIFY(d.fastest <= std::abs(v) + 1e-12);
            QVERIFY(d.hardest <= kLimits.linear + 1e-6);
            const ChassisMotion after = profile.next(kLimits, h);
            QVERIFY(after.linear == 0 && after.angular == 0);
        }
    }

    void withoutLimitsAnAmountIsDrivenAtFullSpeed() {
        DriveProfile profile;
        QVERIFY(!profile.start({.5, 0}, {1, 0}, {}));
        int ticks = 0;
        for (; profile.busy() && ticks < 1000; ++ticks) {
            const double v = profile.next({}, .01).linear;
            QVERIFY(std::abs(v - .5) < 1e-9);
        }
        QCOMPARE(ticks, 200);
    }

    void fromAnyVelocityTheAmountCountsFromTheCommand_data() {
        QTest::addColumn<double>("v0");
        QTest::addColumn<double>("w0");
        QTest::addColumn<double>("x");
        QTest::newRow("same way") << .5 << 0. << 2.;
        QTest::newRow("faster than wanted") << 1.5 << 0. << 2.;
        QTest::newRow("the other way") << -.5 << 0. << 2.;
        QTest::newRow("shorter than the way to stop") << .5 << 0. << .01;
        QTest::newRow("hardly longer than the way to stop") << .5 << 0. << .1251;
        QTest::newRow("just the way to stop") << .5 << 0. << .125;
        QTest::newRow("while turning") << .2 << 1. << 1.;
    }
    void fromAnyVelocityTheAmountCountsFromTheCommand() {
        QFETCH(double, v0);
        QFETCH(double, w0);
        QFETCH(double, x);
        DriveProfile profile;
        profile.aim({v0, w0});
        double last = 0;
        for (int i = 0; i < 300; ++i) last = profile.next(kLimits, .01).linear;
        QCOMPARE(last, v0);
        QVERIFY(!profile.start({.5, 0}, {x, 0}, kLimits));
        const Driven d = driveOut(profile, .01, v0);
        QVERIFY2(std::abs(d.travel.linear - x) < 1e-12, qPrintable(QString::number(d.travel.linear, 'g', 17)));
        QVERIFY2(d.hardest <= kLimits.linear + 1e-6, qPrintable(QString::number(d.hardest)));
    }

    /// Amounts on both axes with unlike limits, or none on one: no axis exceeds its speed or its limit, and one of these is reached.
    void bothAxesKeepTheirLimits() {
        std::mt19937_64 random(20261123);
        const auto within = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        constexpr double h = 0.002;
        for (int round = 0; round < 60; ++round) {
            const DriveLimits limits{round % 3 == 1 ? 0 : within(0.2, 3), round % 3 == 2 ? 0 : within(0.2, 3)};
            const double sign = round % 2 ? 1 : -1, turn = round % 4 < 2 ? 1 : -1;
            const ChassisMotion speed{sign * within(0.1, 1), turn * within(0.1, 1)};
            const ChassisMotion amount{sign * within(0.5, 2), turn * within(0.5, 2)};
            DriveProfile profile;
            QVERIFY(!profile.start(speed, amount, limits));
            ChassisMotion travel, last, fastest, hardest;
            for (int i = 0; profile.busy() && i < 100'000; ++i) {
                const ChassisMotion v = profile.next(limits, h);
                travel.linear += v.linear * h;
                travel.angular += v.angular * h;
                fastest = {std::max(fastest.linear, std::abs(v.linear)), std::max(fastest.angular, std::abs(v.angular))};
                hardest = {std::max(hardest.linear, std::abs(v.linear - last.linear) / h),
                           std::max(hardest.angular, std::abs(v.angular - last.angular) / h)};
                last = v;
            }
            QVERIFY(std::abs(travel.linear - amount.linear) < 1e-9 && std::abs(travel.angular - amount.angular) < 1e-9);
            const double shares[] = {fastest.linear / std::abs(speed.linear), fastest.angular / std::abs(speed.angular),
                                     limits.linear > 0 ? hardest.linear / limits.linear : 0,
                                     limits.angular > 0 ? hardest.angular / limits.angular : 0};
            for (const double share : shares) QVERIFY2(share < 1 + 1e-6, qPrintable(QString::number(share)));
            const double pace = std::max(shares[0], shares[1]), push = std::max(shares[2], shares[3]);
            QVERIFY2(push > 1 - 1e-6, qPrintable(QString::number(push)));
            const double length = std::max(std::abs(amount.linear / speed.linear), std::abs(amount.angular / speed.angular));
            if (length > 8) QVERIFY2(pace > 1 - 1e-6, qPrintable(QString::number(pace))); // long enough to reach a speed
        }
    }

    void rejectsInvalidValues_data() {
        QTest::addColumn<double>("v");
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("angle");
        QTest::newRow("no velocity") << 0. << 0. << 1. << 0.;
        QTest::newRow("no velocity but a turn") << 0. << 1. << 1. << 0.;
        QTest::newRow("opposite signs") << -.2 << 0. << 1. << 0.;
        QTest::newRow("no turn rate") << .2 << 0. << 0. << 1.;
        QTest::newRow("opposite turn") << .2 << -1. << 0. << 1.;
        QTest::newRow("beyond all numbers") << 1e-300 << 1e200 << 1e200 << 0.;
    }
    void rejectsInvalidValues() {
        QFETCH(double, v);
        QFETCH(double, w);
        QFETCH(double, x);
        QFETCH(double, angle);
        DriveProfile profile;
        profile.aim({1, 0});
        for (int i = 0; i < 200; ++i) (void)profile.next(kLimits, .01);
        QVERIFY(profile.start({v, w}, {x, angle}, kLimits).has_value());
        QVERIFY(!profile.busy());
        double speed = 1;
        for (int i = 0; i < 110; ++i) speed = profile.next(kLimits, .01).linear;
        QCOMPARE(speed, 0.);
    }

    void rampsKeepTheCurve() {
        DriveProfile profile;
        profile.aim({.3, 1});
        for (int i = 0; i < 100; ++i) {
            const ChassisMotion v = profile.next(kLimits, .01);
            QVERIFY(std::abs(v.angular - v.linear / .3) < 1e-12);
        }
        profile.aim({});
        double speed = .3;
        int ticks = 0;
        while (speed > 0 && ++ticks < 100) speed = profile.next(kLimits, .01).linear;
        QCOMPARE(ticks, 30);
    }
};

QTEST_APPLESS_MAIN(DriveProfileTest)
#include "drive_profile_test.moc"
