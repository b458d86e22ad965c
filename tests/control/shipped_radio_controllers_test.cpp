// What the shipped controllers with a radio send, publish and command: routes of the motes, bearings, legs, detours, arrival.
#include "control/scripted_controller.h"

#include "controllers/mote/beacon.h"
#include "controllers/network_navigator/sweep.h"

using sdktest::kDegree, sdktest::ScriptedController;

namespace {

/// A sender around the robot, as heard while it turns: its signal strength is a parabola in dB around its bearing.
struct Sender {
    std::uint32_t address;
    double bearing; ///< deg
    double rssi;    ///< dBm at the peak
    Beacon beacon{1, 1, 10};
};
using Senders = std::vector<Sender>;

double strength(const Sender& sender, double heading) {
    const double off = std::remainder(heading - sender.bearing * kDegree, 2 * std::numbers::pi);
    return sender.rssi - 12 * off * off;
}

/// Turns the robot once around from `first` deg in steps of 10 deg; each sender is heard at each step.
void turnAround(ScriptedController& robot, const Senders& senders, double first = 0) {
    for (int step = 0; step <= 37; ++step) {
        const double before = first + 10 * (step - 1);
        if (step > 0)
            for (const Sender& s : senders)
                robot.host.heard.push_back({s.beacon.bytes(), strength(s, before * kDegree), s.address});
        robot.stand(0, 0, (first + 10 * step) * kDegree);
        robot.update(robot.host.now + 0.1);
    }
}

/// A navigator that has just finished its first sweep; it now turns, or drives.
struct Navigator : ScriptedController {
    explicit Navigator(const Senders& senders, const Values& values = {}, double random = 0.5)
        : ScriptedController("controllers/libnetwork_navigator.so", "NetworkNavigator", values) {
        if (!setup()) qFatal("no setup");
        update(0);
        update(0.1);
        sweep(senders, random);
    }
    void sweep(const Senders& senders, double random = 0.5) {
        turnAround(*this, senders);
        arrive();
        stand(0, 0, 0);
        host.randoms = {random};
        update(host.now + 0.1);
    }
    /// Ends the turn, if it turns: it then drives.
    void endTurn() {
        arrive();
        update(host.now + 0.1);
    }
};

} // namespace

class ShippedRadioControllersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void beaconsAreSixBytes() {
        const Beacon beacon{0x1234, 7, 0x89ab};
        QCOMPARE(beacon.bytes(), (std::vector<std::uint8_t>{0xb1, 0x12, 0x34, 7, 0x89, 0xab}));
        const auto back = Beacon::from(beacon.bytes());
        QVERIFY(back && back->flood == 0x1234 && back->hops == 7 && back->cost == 0x89ab && back->knowsTarget());
        QVERIFY(!Beacon{}.knowsTarget());
        QVERIFY(!Beacon::from({0xb0, 0x12, 0x34, 7, 0x89, 0xab}));
        QVERIFY(!Beacon::from({0xb1, 0x12, 0x34, 7, 0x89}));
        QVERIFY(!Beacon::from({0xb1, 0x12, 0x34, 7, 0x89, 0xab, 0}));
    }

    void aMoteSendsBeaconsAtRandomTimes() {
        ScriptedController mote("controllers/libmote.so", "Mote", {{"Period", {0.2}}, {"Power", {-7}}});
        mote.host.randoms = {0.25}; // the first at a quarter of the period
        QVERIFY(mote.setup());
        const QString beacon = "send 177 0 0 0 255 255 to 65535 with -7";
        const auto sends = [&](double time) {
            mote.update(time);
            return mote.calls();
        };
        QCOMPARE(sends(0.049), QString());
        mote.host.randoms = {0}; // the next after half a period
        QCOMPARE(sends(0.05), beacon);
        QCOMPARE(sends(0.149), QString());
        mote.host.randoms = {0.75}; // after 1.25 periods
        QCOMPARE(sends(0.151), beacon);
        QCOMPARE(sends(0.4), QString());
        QCOMPARE(sends(0.402), beacon);
        QCOMPARE(mote.host.slots["brain/hops"][0], -1.);
        QCOMPARE(mote.host.slots["brain/cost"][0], -1.);
    }

    void theTargetFloodsTheNetwork() {
        ScriptedController target("controllers/libmote.so", "Mote", {{"Target", {1}}, {"FloodPeriod", {1.5}}, {"Period", {0.1}}});
        target.host.randoms = {0};
        QVERIFY(target.setup());
        int number = 0;
        for (const double time : {0., 1., 1.4, 1.5, 2.9, 3., 3.2}) {
            if (time == 0 || time == 1.5 || time == 3) ++number;
            target.host.heard.push_back({Beacon{900, 3, 30}.bytes(), -40, 7}); // which it ignores
            target.host.randoms = {0.5};
            target.update(time);
            QCOMPARE(target.calls(), QString("send 177 0 %1 0 0 0 to 65535 with 0").arg(number));
            QCOMPARE(target.host.slots["brain/hops"][0], 0.);
            QCOMPARE(target.host.slots["brain/cost"][0], 0.);
        }
    }

    void aMoteKeepsItsBestRoute_data() {
        QTest::addColumn<int>("flood"); // of the second beacon; the first is of flood 65534, 2 hops, cost 25 with the hop
        QTest::addColumn<int>("hops");
        QTest::addColumn<int>("cost");
        QTest::addColumn<double>("rssi");
        QTest::addColumn<int>("newHops");
        QTest::addColumn<int>("newCost");
        QTest::newRow("the same flood, better") << 65534 << 0 << 14 << -60. << 1 << 24;
        QTest::newRow("the same flood, as good") << 65534 << 0 << 15 << -60. << 2 << 25;
        QTest::newRow("the same flood, worse") << 65534 << 0 << 16 << -60. << 2 << 25;
        QTest::newRow("an older flood, better") << 65533 << 0 << 0 << -60. << 2 << 25;
        QTest::newRow("the next flood, as good") << 65535 << 4 << 15 << -60. << 5 << 25;
        QTest::newRow("the next flood, worse") << 65535 << 0 << 16 << -60. << 2 << 25;
        QTest::newRow("two floods on, beyond the wrap, worse") << 0 << 0 << 16 << -60. << 2 << 25;
        QTest::newRow("two floods on, better") << 0 << 0 << 1 << -60. << 1 << 11;
        QTest::newRow("three floods on, worse: the old route is lost") << 1 << 8 << 90 << -60. << 9 << 100;
        QTest::newRow("a weak hop costs its missing dB") << 65534 << 0 << 0 << -85. << 1 << 20;
        QTest::newRow("a hop at GoodRssi") << 65534 << 0 << 0 << -75. << 1 << 10;
        QTest::newRow("too many hops") << 1 << 254 << 1 << -60. << 2 << 25;
        QTest::newRow("many hops") << 1 << 253 << 1 << -60. << 254 << 11;
        QTest::newRow("no route") << 1 << 0 << 0xffff << -60. << 2 << 25;
        QTest::newRow("too dear") << 1 << 0 << 0xffff - 10 << -60. << 2 << 25;
        QTest::newRow("nearly too dear") << 1 << 0 << 0xffff - 11 << -60. << 1 << 0xfffe;
    }
    void aMoteKeepsItsBestRoute() {
        QFETCH(int, flood);
        QFETCH(int, hops);
        QFETCH(int, cost);
        QFETCH(double, rssi);
        ScriptedController mote("controllers/libmote.so", "Mote");
        QVERIFY(mote.setup());
        mote.host.heard.push_back({Beacon{65534, 1, 15}.bytes(), -60, 7});
        mote.host.heard.push_back({{0xb0, 0, 0, 0, 0, 0}, -60, 7}); // no beacon
        mote.host.heard.push_back({Beacon{std::uint16_t(flood), std::uint8_t(hops), std::uint16_t(cost)}.bytes(), rssi, 8});
        mote.host.randoms = {0, 0};
        mote.update(100);
        QTEST(int(mote.host.slots["brain/hops"][0]), "newHops");
        QTEST(int(mote.host.slots["brain/cost"][0]), "newCost");
        QFETCH(int, newHops);
        QFETCH(int, newCost);
        const int now = newHops == 2 ? 65534 : flood;
        QCOMPARE(mote.calls(), QString("send 177 %1 %2 %3 %4 %5 to 65535 with 0")
                                   .arg(now >> 8)
                                   .arg(now & 255)
                                   .arg(newHops)
                                   .arg(newCost >> 8)
                                   .arg(newCost & 255));
    }

    void bearingOfAPeak_data() {
        QTest::addColumn<double>("bearing"); // deg
        for (const double bearing : {0., 3.3, 90., 171.7, 180., -179., -64.2}) QTest::addRow("%g deg", bearing) << bearing;
    }
    void bearingOfAPeak() {
        QFETCH(double, bearing);
        Sweep sweep;
        const Sender sender{5, bearing, -47.5};
        for (int heading = 0; heading < 360; heading += 7) sweep.add(5, heading * kDegree, strength(sender, heading * kDegree));
        const auto found = sweep.bearing(5);
        QVERIFY(found);
        QVERIFY2(std::abs(std::remainder(found->heading - bearing * kDegree, 2 * std::numbers::pi)) < 1e-6,
                 qPrintable(QString::number(found->heading / kDegree)));
        QVERIFY(std::abs(found->heading) <= std::numbers::pi + 1e-12);
        QVERIFY2(std::abs(found->rssi + 47.5) < 1e-6, qPrintable(QString::number(found->rssi)));
        QVERIFY(!sweep.bearing(6));
        sweep.clear();
        QVERIFY(!sweep.bearing(5));
    }

    void bearingsOfOddSamples() {
        Sweep few;
        for (int i = 0; i < 5; ++i) few.add(1, 0.1 * i, -50 + i);
        QVERIFY(!few.bearing(1)); // six are needed
        few.add(1, 0.5, -45);
        const auto rising = few.bearing(1); // a line has no peak: the strongest sample counts
        QVERIFY(rising && rising->heading == 0.5 && rising->rssi == -45);

        Sweep twoLobes; // the mean direction of two equal lobes is between them, where nothing was heard
        for (int i = -5; i <= 5; ++i) {
            twoLobes.add(1, 100 * kDegree + 0.05 * i, -40 - 0.01 * i * i);
            twoLobes.add(1, -100 * kDegree + 0.05 * i, -40.5 - 0.01 * i * i);
        }
        const auto one = twoLobes.bearing(1);
        QVERIFY(one && std::abs(one->heading - 100 * kDegree) < 1e-6);
        QVERIFY(std::abs(wrapAngle(3.5 * std::numbers::pi) + std::numbers::pi / 2) < 1e-12);
    }

    void aSweepReportsEachSender() {
        ScriptedController robot("controllers/libnetwork_navigator.so", "BearingSweep", {{"TurnRate", {0.8}}});
        QVERIFY(robot.setup());
        robot.update(0);
        QCOMPARE(robot.calls(), QString("open samples.csv | write 5 sender,heading [deg],RSSI [dBm]\n"));
        QCOMPARE(robot.command(), QString("0 0.8 for 0 6.457718, number 1")); // 370 deg
        turnAround(robot, {{3, 40, -50}, {2, -125.5, -60}});
        const QString samples = robot.calls();
        QCOMPARE(samples.count("write 5 "), 2 * 37);
        // Heard at the heading of the update before.
        QVERIFY2(samples.startsWith("write 5 3,0.000000,-55.848"), qPrintable(samples.left(200)));
        QVERIFY2(samples.contains("write 5 3,40.000000,-50.000000\n"), qPrintable(samples));
        robot.host.heard.push_back({Beacon{}.bytes(), -70, 9}); // one packet is no bearing
        robot.arrive();
        robot.update(9);
        QCOMPARE(robot.calls(), QString("write 5 9,370.000000,-70.000000\n | open bearings.csv | "
                                        "write 5 sender,packets,bearing [deg],RSSI [dBm]\n | "
                                        "write 5 2,37,-125.500000,-60.000000\n | "
                                        "print 1 sender 2 is at -125.5 deg, -60 dBm, from 37 packets | "
                                        "write 5 3,37,40.000000,-50.000000\n | "
                                        "print 1 sender 3 is at 40 deg, -50 dBm, from 37 packets"));
        robot.host.heard.push_back({Beacon{}.bytes(), -70, 9});
        robot.update(10);
        QCOMPARE(robot.calls(), QString()); // once
    }

    void aNavigatorStartsWithASweep() {
        ScriptedController robot("controllers/libnetwork_navigator.so", "NetworkNavigator");
        QVERIFY(robot.setup());
        robot.update(0);
        QCOMPARE(robot.calls(),
                 QString("open navigation.csv | write 5 time [s],mote,hops,cost,heading [deg],RSSI [dBm],leg [m]\n"));
        QCOMPARE(robot.command(), QString("0 0.5 for 0 6.457718, number 1"));
    }

    /// RssiAtOneMetre is -30 dBm: -50 dBm are 10 m, -36 dBm 1.995 m.
    void aLegLeadsTowardsTheBestMote_data() {
        QTest::addColumn<Senders>("senders");
        QTest::addColumn<double>("bearing"); // deg
        QTest::addColumn<double>("leg");     // m
        QTest::newRow("to the target, by four fifths of the distance") << Senders{{4, 30, -36, {1, 0, 0}}} << 30. << 1.596;
        QTest::newRow("a target is approached by at least 0.2 m") << Senders{{4, -30, -12, {1, 0, 0}}} << -30. << 0.2;
        QTest::newRow("before another mote it stops 0.7 m ahead") << Senders{{4, 170, -36, {1, 1, 10}}} << 170. << 1.295;
        QTest::newRow("not farther than Leg") << Senders{{4, -170, -50, {1, 1, 10}}} << -170. << 2.5;
        QTest::newRow("the lesser cost") << Senders{{4, 30, -36, {1, 2, 30}}, {5, 60, -36, {1, 3, 29}}} << 60. << 1.295;
        QTest::newRow("a weak signal costs: 10 + 15 against 24")
            << Senders{{4, 30, -90, {1, 1, 10}}, {5, 60, -36, {1, 2, 24}}} << 60. << 1.295;
        QTest::newRow("10 + 15 against 26") << Senders{{4, 30, -90, {1, 1, 10}}, {5, 60, -36, {1, 2, 26}}} << 30. << 2.5;
        QTest::newRow("of equal ones the first address")
            << Senders{{5, 60, -36, {1, 2, 10}}, {4, 30, -36, {1, 1, 10}}} << 30. << 1.295;
        QTest::newRow("who knows no route is ignored")
            << Senders{{4, 30, -36, Beacon{}}, {5, 60, -36, {1, 9, 99}}} << 60. << 1.295;
    }
    void aLegLeadsTowardsTheBestMote() {
        QFETCH(Senders, senders);
        QFETCH(double, bearing);
        QFETCH(double, leg);
        Navigator robot(senders, {{"Leg", {2.5}}, {"Speed", {0.4}}, {"ArrivedRssi", {50}}});
        const QString turn = QString::fromStdString(sdktest::Host::text(bearing * kDegree));
        QCOMPARE(robot.command(), QString("0 %1 for 0 %2, number 2").arg(bearing < 0 ? -1 : 1).arg(turn));
        robot.update();
        QVERIFY(robot.command().endsWith("number 2")); // still turning
        robot.endTurn();
        QCOMPARE(robot.drive("linearVelocity"), 0.4);
        QVERIFY2(std::abs(robot.drive("linearAmount") - leg) < 1e-3, qPrintable(robot.command()));
        QVERIFY(robot.drive("angularAmount") == 0 && robot.drive("sequence") == 3);
        const QString written = robot.calls().section("write 5 ", -1).trimmed();
        const QStringList cells = written.split(',');
        QCOMPARE(cells.size(), 7);
        QVERIFY2(std::abs(cells[4].toDouble() - bearing) < 1e-4 && std::abs(cells[6].toDouble() - leg) < 1e-3,
                 qPrintable(written));
        robot.arrive();
        robot.update();
        QCOMPARE(robot.command(), QString("0 0.5 for 0 6.457718, number 4")); // the next sweep
    }

    void aTurnOfNothingIsLeftOut() {
        Navigator robot({{4, 0.1, -36}});
        QVERIFY2(robot.command().startsWith("0.3 0 for 1.295"), qPrintable(robot.command()));
        Navigator turns({{4, 0.3, -36}});
        QVERIFY2(turns.command().startsWith("0 1 for 0 0.0052"), qPrintable(turns.command()));
    }

    void withoutAWayItDrivesRandomly_data() {
        QTest::addColumn<Senders>("senders");
        QTest::addColumn<bool>("leg"); // whether a line is written
        QTest::newRow("nothing is heard") << Senders{} << false;
        QTest::newRow("only one that knows no route") << Senders{{4, 30, -36, Beacon{}}} << false;
        QTest::newRow("it is too close to the only one") << Senders{{4, 30, -29, {1, 1, 10}}} << true;
    }
    void withoutAWayItDrivesRandomly() {
        QFETCH(Senders, senders);
        Navigator robot(senders, {{"Leg", {2.5}}}, 0.75); // three quarters between -180 and 180 deg
        QCOMPARE(robot.command(), QString("0 1 for 0 1.570796, number 2"));
        QTEST(robot.calls().contains("write 5 4"), "leg");
        robot.endTurn();
        QCOMPARE(robot.command(), QString("0.3 0 for 1.25 0, number 3"));
    }

    void obstaclesAreEvadedOnOneSide() {
        Navigator robot({{4, 40, -36, {1, 2, 50}}}, {{"BackOff", {0.35}}, {"Detour", {0.9}}, {"Speed", {0.25}}});
        const auto bump = [&](double random) { // how it turns away
            robot.touch(true);
            robot.host.randoms = {random};
            robot.update();
            robot.touch(false);
            const QString back = robot.command().section(',', 0, 0);
            robot.arrive();
            robot.update();
            const QString turn = robot.command().section(',', 0, 0);
            robot.endTurn();
            return back + "; " + turn + "; " + robot.command().section(',', 0, 0);
        };
        const QString left = "-0.25 0 for -0.35 0; 0 1 for 0 1.22173; 0.25 0 for 0.9 0";
        const QString right = QString(left).replace("0 1 for 0 1.2", "0 -1 for 0 -1.2");
        robot.endTurn();
        QCOMPARE(bump(0.5), right); // by chance
        for (int i = 0; i < 5; ++i) QCOMPARE(bump(0), right);
        for (int i = 0; i < 6; ++i) QCOMPARE(bump(0.9), left); // after six the other side
        QCOMPARE(bump(0), right);
        const auto sweepAgain = [&](const Sender& mote) {
            robot.arrive();
            robot.update();
            robot.sweep({mote});
            robot.endTurn();
        };
        sweepAgain({4, 40, -36, {1, 2, 50}}); // no progress: the side stays
        QCOMPARE(bump(0), right);
        sweepAgain({4, 40, -36, {1, 2, 49}}); // nearer than ever: by chance again
        QCOMPARE(bump(0), left);
    }

    void itArrivesOnceAndEndsTheRunAtRest() {
        Navigator robot({{4, 40, -36, {1, 2, 50}}});
        robot.endTurn();
        robot.touch(true);
        robot.update(19);
        robot.touch(false);
        (void)robot.calls();
        const auto hear = [&](const Beacon& beacon, double rssi) {
            robot.host.heard.push_back({beacon.bytes(), rssi, 4});
            robot.update(20);
            return robot.calls();
        };
        QCOMPARE(hear({1, 0, 0}, -28.1), QString()); // too weak
        QCOMPARE(hear({1, 1, 10}, -20), QString());  // not the target
        QCOMPARE(hear(Beacon{}, -20), QString());
        robot.stand(1, 2, 0.5);
        QCOMPARE(hear({1, 0, 0}, -28), QString("print 1 reached the target, RSSI -28 dBm, after 1 legs, 1 bumps and 20 s | "
                                               "write 5 20.000000,arrived,0,65535,28.647890,-28.000000,0.000000\n"));
        QCOMPARE(robot.command(), QString("0 0"));
        robot.stand(1, 2.1, 0.5);
        QCOMPARE(hear({1, 0, 0}, -20), QString()); // said once; it still rolls
        robot.stand(1, 2.1 + 9e-6, 0.5);
        QCOMPARE(hear({1, 0, 0}, -20), QString("finish reached"));
    }
};

QTEST_GUILESS_MAIN(ShippedRadioControllersTest)
#include "shipped_radio_controllers_test.moc"
