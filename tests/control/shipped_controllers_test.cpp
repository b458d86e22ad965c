// What each shipped controller without a radio commands, tick by tick: amounts, directions, order, ends.
#include "control/scripted_controller.h"

using sdktest::kDegree, sdktest::ScriptedController;
using Values = ScriptedController::Values;

namespace {

/// A white image with a block of one colour: columns [left, right), rows [top, bottom).
void show(ScriptedController& seen, int width, int height, int left, int right, int top, int bottom,
          std::array<int, 3> colour = {217, 26, 20}) {
    seen.host.width = static_cast<std::uint32_t>(width);
    seen.host.height = static_cast<std::uint32_t>(height);
    seen.host.pixels.assign(3u * seen.host.width * seen.host.height, 255);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            for (int i = 0; i < 3; ++i)
                seen.host.pixels[static_cast<std::size_t>(3 * (y * width + x) + i)] =
                    static_cast<std::uint8_t>(colour[std::size_t(i)]);
}

} // namespace

class ShippedControllersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Names, units, ranges, defaults: what experiments are written against.
    void theirFields_data() {
        QTest::addColumn<QString>("module");
        for (const char* module :
             {"controllers/libarc_motion.so", "controllers/libblob_follow.so", "controllers/libbraitenberg.so",
              "controllers/libbump_and_turn.so", "controllers/libcollect.so", "controllers/libdocking.so", "controllers/libline_follow.so",
              "controllers/liblinear_motion.so", "controllers/liblidar_map.so", "controllers/libmote.so",
              "controllers/libnetwork_navigator.so", "controllers/libpick_and_place.so", "controllers/librandom_drive.so", "controllers/libstriker.so",
              "controllers/libwall_follow.so",
              "libMyRobotController.so", "libmy_controller.so"})
            QTest::newRow(module) << QString(module);
    }
    void theirFields() {
        QFETCH(QString, module);
        auto library = trundle::DynamicLibrary::open(TRUNDLE_BINARY_DIR "/lib/trundle/" + module.toStdString());
        QVERIFY(library);
        library.value().keepLoaded();
        const TrundleModule* table = library.value().function<const TrundleModule*()>(TRUNDLE_ENTRY_SYMBOL)();
        QStringList lines;
        for (std::uint32_t k = 0; k < table->kindCount; ++k) {
            const TrundleKind& kind = *table->kinds[k];
            lines << QString("%1 %2").arg(module, kind.name);
            QVERIFY(kind.role == TRUNDLE_CONTROLLER && *kind.help);
            for (std::uint32_t i = 0; i < kind.fieldCount; ++i) lines << fieldLine(kind.fields[i]);
            for (std::uint32_t i = 0; i < kind.signalCount; ++i)
                lines << QString("  publishes %1 x%2 type %3 direction %4")
                             .arg(kind.signals[i].name)
                             .arg(kind.signals[i].count)
                             .arg(kind.signals[i].type)
                             .arg(kind.signals[i].direction);
        }
        QFile expected(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/shipped_controllers.txt"));
        QVERIFY(expected.open(QIODevice::ReadOnly));
        const QString all = QString::fromUtf8(expected.readAll());
        QVERIFY2(("\n" + all + "\n").contains("\n" + lines.join('\n') + "\n\n"),
                 qPrintable("not in the file:\n" + lines.join('\n')));
    }

    void anArcIsDrivenOnceAndReported_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("angle"); // deg
        QTest::addColumn<QString>("command");
        QTest::newRow("left") << 0.3 << 90. << "0.3 0.5 for 0 1.570796, number 1";
        QTest::newRow("right: the turn rate has the sign of the angle") << 0.3 << -90. << "0.3 -0.5 for 0 -1.570796, number 1";
        QTest::newRow("backwards") << -0.2 << 180. << "-0.2 0.5 for 0 3.141593, number 1";
        QTest::newRow("on the spot") << 0. << -45. << "0 -0.5 for 0 -0.785398, number 1";
    }
    void anArcIsDrivenOnceAndReported() {
        QFETCH(double, speed);
        QFETCH(double, angle);
        QFETCH(QString, command);
        ScriptedController arc("controllers/libarc_motion.so", "ArcMotion",
                               {{"Speed", {speed}}, {"TurnRate", {0.5}}, {"Angle", {angle * kDegree}}});
        QVERIFY(arc.setup());
        arc.update(0);
        QCOMPARE(arc.command(), command);
        arc.update(0.1);
        QCOMPARE(arc.calls(), QString()); // still under way
        arc.stand(1, 2, 1.5);
        arc.arrive();
        arc.update(0.2);
        QCOMPARE(arc.calls(), QString("print 1 done: turned 85.9437 deg of %1 deg by odometry").arg(angle));
        arc.update(0.3);
        QCOMPARE(arc.calls(), QString()); // reported once
        QCOMPARE(arc.command(), command);
    }

    void aLineIsDrivenOnceAndReported_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<QString>("command");
        QTest::newRow("forwards") << 0.75 << "0.25 0 for 0.75 0, number 1";
        QTest::newRow("backwards") << -0.75 << "-0.25 0 for -0.75 0, number 1";
    }
    void aLineIsDrivenOnceAndReported() {
        QFETCH(double, distance);
        QFETCH(QString, command);
        ScriptedController line("controllers/liblinear_motion.so", "LinearMotion", {{"Distance", {distance}}, {"Speed", {0.25}}});
        QVERIFY(line.setup());
        line.update(0);
        QCOMPARE(line.command(), command);
        line.update(0.1);
        QCOMPARE(line.calls(), QString());
        line.stand(-0.3, 0.4, 1);
        line.arrive();
        line.update(0.2);
        QCOMPARE(line.calls(), QString("print 1 done: drove 0.5 m of 0.75 m by odometry"));
        line.update(0.3);
        QCOMPARE(line.calls(), QString());
    }

    /// Random numbers: first the side (below one half is left), then the angle between the two of TurnAngle.
    void bumpsBackOffThenTurnThenDriveOn() {
        ScriptedController robot("controllers/libbump_and_turn.so", "BumpAndTurn",
                                 {{"Speed", {0.4}}, {"BackOff", {0.15}}, {"TurnRate", {1.5}}, {"TurnAngle", {1, 2}}});
        QVERIFY(robot.setup());
        robot.update(0);
        QCOMPARE(robot.command(), QString("0.4 0"));
        int number = 0;
        for (const auto& [side, share, angle] : {std::tuple{0.49, 0.25, "1.5 for 0 1.25"}, {0.5, 0.75, "-1.5 for 0 -1.75"}}) {
            robot.touch(true);
            robot.update();
            QCOMPARE(robot.calls(), QString("print 1 touched"));
            QCOMPARE(robot.command(), QString("-0.4 0 for -0.15 0, number %1").arg(++number));
            robot.update(); // still backing off, still touched
            QCOMPARE(robot.command(), QString("-0.4 0 for -0.15 0, number %1").arg(number));
            robot.arrive();
            robot.host.randoms = {side, share};
            robot.update();
            QCOMPARE(robot.command(), QString("0 %1, number %2").arg(angle).arg(++number));
            robot.update();
            QCOMPARE(robot.command(), QString("0 %1, number %2").arg(angle).arg(number)); // turning
            robot.touch(false);
            robot.arrive();
            robot.update(); // notices that it has turned
            robot.update();
            QCOMPARE(robot.command(), QString("0.4 0"));
            QCOMPARE(robot.calls(), QString());
            QVERIFY(robot.host.randoms.empty());
        }
    }

    void randomDriveChangesOnceEachPeriod() {
        ScriptedController robot("controllers/librandom_drive.so", "RandomDrive",
                                 {{"Speed", {0.8}}, {"TurnRate", {2}}, {"Period", {0.3}}});
        QVERIFY(robot.setup());
        robot.host.randoms = {0, 0}; // the speed, then the turn rate
        robot.update(0);
        QCOMPARE(robot.command(), QString("-0.2 -2"));
        robot.host.randoms = {1 - 0x1p-53, 0.75};
        for (const double time : {0.1, 0.2, 0.29}) {
            robot.update(time);
            QCOMPARE(robot.command(), QString("-0.2 -2"));
        }
        robot.update(0.3);
        QCOMPARE(robot.command(), QString("0.8 1"));
        // Counted in periods, the millionth change is on time: the sum of a million times 0.3 would be 6e-6 s late.
        for (int i = 2; i < 1000000; ++i) robot.update(i * 0.3);
        robot.host.randoms = {0.4, 0.25};
        robot.update(1000000 * 0.3 - 1e-7);
        QVERIFY(robot.host.randoms.size() == 2);
        robot.update(1000000 * 0.3);
        QCOMPARE(robot.command(), QString("0.2 -1"));
    }

    void theControllerOfTheThesisDrivesForItsSeconds() {
        ScriptedController robot("libMyRobotController.so", "MyRobotController", {{"RobotControllerVar", {1.5}}});
        QVERIFY(robot.setup());
        for (const auto& [time, command] : {std::pair{0., "0.2 0"}, {1.49, "0.2 0"}, {1.5, "0 0"}, {2., "0 0"}}) {
            robot.update(time);
            QCOMPARE(robot.command(), QString(command));
        }
        ScriptedController still("libMyRobotController.so", "MyRobotController");
        still.host.slots.clear();
        still.host.directions.clear();
        QVERIFY(still.setup()); // a robot without a drive
        still.update(0);
        QCOMPARE(still.calls(), QString());
    }

    void theTemplateDrivesACircle() {
        ScriptedController robot("libmy_controller.so", "MyController", {{"Speed", {0.1}}, {"TurnRate", {-0.7}}});
        QVERIFY(robot.setup());
        robot.update(0);
        QCOMPARE(robot.command(), QString("0.1 -0.7"));
    }

    void aBlobIsFollowed_data() {
        QTest::addColumn<QList<int>>("block"); // left, right, top, bottom in an image of 20 x 10
        QTest::addColumn<QList<int>>("colour");
        QTest::addColumn<QString>("command");
        const QList<int> red{217, 26, 20};
        QTest::newRow("nothing: it turns left to look around") << QList<int>{0, 0, 0, 0} << red << "0 0.6";
        QTest::newRow("five pixels are too few") << QList<int>{9, 10, 0, 5} << red << "0 0.6";
        QTest::newRow("six are enough") << QList<int>{9, 11, 0, 3} << red << "0.4 0";
        QTest::newRow("to the right: it turns right") << QList<int>{13, 15, 0, 5} << red << "0.16 -0.36";
        QTest::newRow("to the left: it turns left") << QList<int>{5, 7, 5, 10} << red << "0.16 0.36";
        QTest::newRow("at the left edge it turns on the spot, at most at TurnRate") << QList<int>{0, 1, 0, 10} << red << "0 0.6";
        QTest::newRow("at the right edge") << QList<int>{19, 20, 0, 10} << red << "0 -0.6";
        QTest::newRow("a darker red") << QList<int>{9, 11, 0, 3} << QList<int>{100, 12, 9} << "0.4 0";
        QTest::newRow("nearly black") << QList<int>{9, 11, 0, 3} << QList<int>{38, 4, 3} << "0 0.6";
        QTest::newRow("pale: saturation 0.44") << QList<int>{9, 11, 0, 3} << QList<int>{200, 112, 112} << "0 0.6";
        QTest::newRow("saturation 0.46") << QList<int>{9, 11, 0, 3} << QList<int>{200, 108, 108} << "0.4 0";
        QTest::newRow("orange, 22 deg from it") << QList<int>{9, 11, 0, 3} << QList<int>{200, 76, 0} << "0.4 0";
        QTest::newRow("yellow orange, 31 deg") << QList<int>{9, 11, 0, 3} << QList<int>{200, 105, 0} << "0 0.6";
        QTest::newRow("pink, 20 deg to the other side") << QList<int>{9, 11, 0, 3} << QList<int>{200, 0, 62} << "0.4 0";
        QTest::newRow("blue") << QList<int>{9, 11, 0, 3} << QList<int>{20, 26, 217} << "0 0.6";
        QTest::newRow("it covers 9 of 20 columns") << QList<int>{6, 15, 0, 5} << red << "0.37 -0.045";
        QTest::newRow("it covers half: it is there") << QList<int>{5, 15, 0, 5} << red << "0 0";
    }
    void aBlobIsFollowed() {
        QFETCH(QList<int>, block);
        QFETCH(QList<int>, colour);
        QFETCH(QString, command);
        ScriptedController robot("controllers/libblob_follow.so", "BlobFollow",
                                 {{"Speed", {0.4}}, {"TurnRate", {0.6}}, {"KeepEvery", {0}}});
        QVERIFY(robot.setup());
        show(robot, 20, 10, block[0], block[1], block[2], block[3], {colour[0], colour[1], colour[2]});
        robot.update(0);
        QCOMPARE(robot.command(), command);
        const bool there = command == "0 0";
        QCOMPARE(robot.calls(), QString(there ? "print 1 there" : ""));
        show(robot, 20, 10, 9, 11, 0, 3);
        robot.update(0.1);
        QCOMPARE(robot.command(), QString(there ? "0 0" : "0.4 0")); // where it is there it stays
        QCOMPARE(robot.calls(), QString());
    }

    void aBlobAroundTheEndOfTheHues() {
        // Cyan is the hue of 180 deg, where the angle jumps from pi to -pi.
        ScriptedController robot("controllers/libblob_follow.so", "BlobFollow", {{"Color", {0, 1, 1}}, {"KeepEvery", {0}}});
        QVERIFY(robot.setup());
        for (const std::array<int, 3> colour : {std::array{0, 230, 200}, std::array{0, 200, 230}}) {
            show(robot, 20, 10, 9, 11, 0, 3, colour);
            robot.update(0);
            QCOMPARE(robot.command(), QString("0.3 0"));
        }
    }

    void picturesAreKeptNowAndThen() {
        for (const int every : {0, 1, 3}) {
            ScriptedController robot("controllers/libblob_follow.so", "BlobFollow", {{"KeepEvery", {double(every)}}});
            QVERIFY(robot.setup());
            show(robot, 4, 4, 0, 0, 0, 0);
            QStringList expected;
            for (int i = 0; i < 7; ++i) {
                if (every && i % every == 0)
                    expected << QString("save eye robot7_%1.jpg").arg(expected.size(), 5, 10, QChar('0'));
                robot.update(i);
            }
            QCOMPARE(robot.calls(), expected.join(" | "));
        }
        ScriptedController robot("controllers/libblob_follow.so", "BlobFollow", {{"KeepEvery", {1}}});
        QVERIFY(robot.setup());
        show(robot, 4, 4, 0, 0, 0, 0);
        robot.host.keepsPictures = false; // a run without logs
        for (int i = 0; i < 3; ++i) robot.update(i);
        QCOMPARE(robot.calls(), QString("save eye robot7_00000.jpg"));
    }

    void withoutImagesItStays() {
        ScriptedController robot("controllers/libblob_follow.so", "BlobFollow");
        QVERIFY(robot.setup());
        robot.drive("linearVelocity") = 0.3;
        robot.host.blind = true;
        robot.update(0);
        QCOMPARE(robot.calls(), QString("print 2 cannot see, stays where it is: it is dark"));
        QCOMPARE(robot.command(), QString("0 0"));
        robot.host.blind = false;
        show(robot, 20, 10, 9, 11, 0, 3);
        robot.update(1);
        QCOMPARE(robot.calls() + robot.command(), QString("0 0"));
    }

private:
    static QString fieldLine(const TrundleField& f) {
        QStringList defaults;
        for (std::uint32_t i = 0; i < f.defaultValue.count; ++i)
            defaults << (f.type == TRUNDLE_TEXT || f.type == TRUNDLE_CHOICE
                             ? QString(f.defaultValue.texts[i])
                             : QString::number(f.defaultValue.numbers[i] / f.scale, 'g', 6));
        return QString("  %1 [%2] type %3 x%4..%5 in %6%7, %8%9 flags %10 = %11%12")
            .arg(f.name, f.unit)
            .arg(f.type)
            .arg(f.minCount)
            .arg(f.maxCount)
            .arg(f.flags & TRUNDLE_MIN_EXCLUSIVE ? "(" : "[")
            .arg(f.minimum)
            .arg(f.maximum)
            .arg(f.flags & TRUNDLE_MAX_EXCLUSIVE ? ")" : "]")
            .arg(f.flags)
            .arg(defaults.join(','), *f.help ? "" : " help missing") +
               (f.type == TRUNDLE_TEXT && *f.choices ? QStringLiteral(" needs %1").arg(f.choices) : QString());
    }
};

QTEST_GUILESS_MAIN(ShippedControllersTest)
#include "shipped_controllers_test.moc"
