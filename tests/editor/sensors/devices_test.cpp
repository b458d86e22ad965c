// Which readings a device has in a run, what they read, and the true values beside them; with signals of made-up layouts.

#include <numbers>

#include <QtTest>

#include "app/application.h"
#include "editor/running/session_fixture.h"
#include "editor/sensors/sensor_device.h"
#include "editor/sensors/shown_devices.h"
#include "editor/widgets/apply_theme.h"

using namespace trundle;

namespace {

/// A robot of which a test chooses the signals.
const QByteArray kRobot = R"(RobotConfig C {
  Body base { Box hull { Size=0.2,0.2,0.1 Mass=1 } }
  Imu imu { Body=base Pos=0.1,0,0 HPR=90,0,0 }
  Gps gps { Body=base Pos=0,0.2,0 }
  Compass north { Body=base HPR=30,0,0 }
  RangeSensor eye { Body=base MinRange=0.1 MaxRange=4 }
  LightSensor lamp { Body=base MaxIlluminance=800 }
  Battery pack { Capacity=1 Voltage=12 }
  Transceiver radio { Body=base }
}
Robot r { Config=C }
)";

struct DeviceFixture : SessionFixture {
    RunResults run;
    SignalLayout layout;

    DeviceFixture() {
        if (!open(kRobot)) return;
        run.built = document.loaded();
        run.experiment = document.loaded()->experiment;
        layout.beginRobot("r");
    }
    void add(const char* name, const char* unit, std::uint32_t count = 1, SignalDirection direction = SignalDirection::Output) {
        layout.add(name, unit, SignalType::Real, direction, count);
    }
    std::optional<SensorDevice> device(const char* path) {
        run.layout = std::make_shared<const SignalLayout>(layout);
        return sensorDeviceAt(run, path);
    }
    LiveSnapshot snapshot(const std::vector<double>& values) const {
        auto block = std::make_shared<SignalBlock>(layout);
        std::ranges::copy(values, block->slots().begin());
        LiveSnapshot snapshot;
        snapshot.block = block;
        return snapshot;
    }
};

const Reading* readingOf(const SensorDevice& device, const char* name) {
    const auto it = std::ranges::find(device.readings, name, &Reading::name);
    return it == device.readings.end() ? nullptr : &*it;
}

QList<double> numbersOf(const Reading::Read& read, std::size_t count, const LiveSnapshot& snapshot) {
    double numbers[8] = {};
    read(snapshot, numbers);
    return QList<double>(numbers, numbers + count);
}

bool areNear(const QList<double>& a, const QList<double>& b) {
    return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < 1e-9; });
}

} // namespace

class SensorDevicesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    /// A pose is a position and three angles, a velocity two vectors; many numbers are their extremes.
    void readingsOfSignals() {
        DeviceFixture f;
        f.add("eye/pose", "m", 7, SignalDirection::Truth);
        f.add("eye/velocity", "m/s", 6, SignalDirection::Truth);
        f.add("eye/odometry", "", 3);
        f.add("eye/four", "N", 4);
        f.add("eye/five", "N", 5);
        f.add("eye/heading", "rad");
        f.add("eye/bend", "rad");
        f.add("eye/set", "V", 1, SignalDirection::Command);
        const auto device = f.device("r.eye");
        QVERIFY(device);
        const Quat turn = rotationFromHpr({0.7, -0.2, 0.1});
        const LiveSnapshot s = f.snapshot({1, 2, 3, turn.w(), turn.x(), turn.y(), turn.z(), 4, 5, 6,    7,   8, 9, 10, 11, 0.5, //
                                           1, 2, 3, 4,        5,        -7,       9,        3, 1, 0.25, 0.5, 6});
        const auto is = [&](const char* name, const char* unit, const QList<double>& numbers) {
            const Reading* reading = readingOf(*device, name);
            return reading && reading->unit == unit && qsizetype(reading->count) == numbers.size() &&
                   areNear(numbersOf(reading->read, reading->count, s), numbers);
        };
        QVERIFY(is("pose position", "m", {1, 2, 3}));
        QVERIFY(is("pose HPR", "rad", {0.7, -0.2, 0.1}));
        QVERIFY(is("velocity", "m/s", {4, 5, 6}));
        QVERIFY(is("velocity, angular", "rad/s", {7, 8, 9}));
        QVERIFY(is("odometry x, y", "m", {10, 11}));
        QVERIFY(is("odometry heading", "rad", {0.5}));
        QVERIFY(is("four", "N", {1, 2, 3, 4}));
        QVERIFY(is("five least, greatest", "N", {-7, 9}));
        QVERIFY(readingOf(*device, "odometry heading")->isAngle && readingOf(*device, "heading")->isAngle);
        QVERIFY(!readingOf(*device, "bend")->isAngle && !readingOf(*device, "four")->isAngle);
        QVERIFY(readingOf(*device, "set")->commanded && !readingOf(*device, "bend")->commanded);
        QVERIFY(readingOf(*device, "five least, greatest")->help.find("5 numbers") != std::string::npos);
    }

    void limitsOfReadings_data() {
        QTest::addColumn<QByteArray>("device");
        QTest::addColumn<QByteArray>("signal");
        QTest::addColumn<QList<double>>("limits"); // empty: none
        QTest::newRow("range") << QByteArray("eye") << QByteArray("range") << QList<double>{0.1, 4};
        QTest::newRow("light") << QByteArray("lamp") << QByteArray("illuminance") << QList<double>{0, 800};
        QTest::newRow("a device without that property") << QByteArray("eye") << QByteArray("illuminance") << QList<double>{};
        QTest::newRow("level") << QByteArray("pack") << QByteArray("level") << QList<double>{0, 1};
        QTest::newRow("voltage of what has no MaxVoltage") << QByteArray("pack") << QByteArray("voltage") << QList<double>{};
    }
    void limitsOfReadings() {
        QFETCH(QByteArray, device);
        QFETCH(QByteArray, signal);
        QFETCH(QList<double>, limits);
        DeviceFixture f;
        f.add((device + "/" + signal).constData(), "1");
        const auto found = f.device("r." + device);
        QVERIFY(found && found->readings.size() == 1);
        const auto& is = found->readings[0].limits;
        QCOMPARE(is ? (QList<double>{is->first, is->second}) : QList<double>(), limits);
    }

    /// A dial for a heading, a gauge for the level of what has a capacity. No reading before the time of the first one.
    void picturesAndFirstReadings() {
        DeviceFixture f;
        f.add("north/heading", "rad");
        f.add("eye/level", "");
        f.add("eye/time", "s");
        f.add("pack/level", "");
        QCOMPARE(int(f.device("r.north")->picture), int(SensorPicture::Dial));
        QCOMPARE(int(f.device("r.pack")->picture), int(SensorPicture::Battery));
        QCOMPARE(int(f.device("r.eye")->picture), int(SensorPicture::None));
        QVERIFY(!f.device("r.pack")->hasReading);
        for (const auto& [time, has] : {std::pair(-1., false), {0., true}, {2., true}})
            QCOMPARE(f.device("r.eye")->hasReading(f.snapshot({0, 0, time, 0})), has);
        QVERIFY(!f.device("r.none") && !f.device("q.eye"));
    }

    /// The number of an object is shown as its name; a signal that is only called so is a number.
    void objectsHaveNames() {
        DeviceFixture f;
        f.add("eye/object", "", 1, SignalDirection::Truth);
        f.add("lamp/object", "", 1, SignalDirection::Output);
        QVERIFY(f.device("r.eye")->readings[0].names && !f.device("r.lamp")->readings[0].names);
    }

    /// In the frame of a sensor that is turned on its body, which is turned in the world.
    void trueValuesOfTurnedSensors() {
        DeviceFixture f;
        f.add("base/pose", "m", 7, SignalDirection::Truth);
        f.add("base/velocity", "m/s", 6, SignalDirection::Truth);
        f.add("imu/angularVelocity", "rad/s", 3);
        f.add("gps/position", "m", 3);
        f.add("gps/velocity", "m/s", 3);
        f.add("north/heading", "rad");
        f.add("eye/range", "m");
        f.add("eye/trueRange", "m");
        f.add("eye/trueCount", "", 2);
        f.add("eye/count", "");
        const Quat body = rotationFromHpr({-0.5, 0, 0});
        const Vec3 linear(1, -2, 0.5), rate(0.3, 0.2, -0.4);
        const LiveSnapshot s = f.snapshot({5, 6, 7, body.w(), body.x(), body.y(), body.z(), 1, -2, 0.5, 0.3, 0.2, -0.4, //
                                           0, 0, 0, 0,        0,        0,        0,        0, 0,  0,   1,   2,   3,    4, 5});
        const auto real = [&](const char* path, const char* name, const Vec3& wanted, std::size_t count = 3) {
            const auto device = f.device(path);
            const Reading* reading = readingOf(*device, name);
            return reading && reading->readTrue &&
                   areNear(numbersOf(reading->readTrue, count, s), QList<double>(wanted.data(), wanted.data() + count));
        };
        const Quat mounting = rotationFromHpr({std::numbers::pi / 2, 0, 0});
        QVERIFY(real("r.imu", "angularVelocity", (body * mounting).conjugate() * rate));
        QVERIFY(real("r.gps", "position", Vec3(5, 6, 7) + body * Vec3(0, 0.2, 0)));
        QVERIFY(real("r.gps", "velocity", linear + rate.cross(body * Vec3(0, 0.2, 0))));
        QVERIFY(real("r.north", "heading", Vec3(-0.5 + std::numbers::pi / 6, 0, 0), 1));
        QVERIFY(real("r.eye", "range", Vec3(2, 0, 0), 1)); // from its own signal, which is no reading of its own
        QVERIFY(!readingOf(*f.device("r.eye"), "trueRange"));
        QVERIFY(!readingOf(*f.device("r.eye"), "count")->readTrue); // of another size
        QVERIFY(readingOf(*f.device("r.eye"), "trueCount"));
    }

    /// Sensors are first, then what is no sensor, each device once.
    void orderOfDevices() {
        DeviceFixture f;
        const auto& kinds = *f.document.loaded()->registry;
        const auto joined = [](const std::vector<std::string>& all) {
            QByteArrayList words;
            for (const std::string& each : all) words << QByteArray::fromStdString(each);
            return words.join(' ');
        };
        QCOMPARE(joined(devicesOf(*f.run.experiment, kinds, std::string("r"))),
                 QByteArray("r.imu r.gps r.north r.eye r.lamp r.pack r.radio"));
        QCOMPARE(joined(devicesOf(*f.run.experiment, kinds, std::string("r.base"))),
                 QByteArray("r.imu r.gps r.north r.eye r.lamp r.radio"));
        QCOMPARE(joined(devicesOf(*f.run.experiment, kinds, {"r.eye", "r.base", "r.pack", "r.eye"})),
                 QByteArray("r.eye r.imu r.gps r.north r.lamp r.radio r.pack"));
    }
};

QTEST_MAIN(SensorDevicesTest)
#include "devices_test.moc"
