// The Sensors dock shows what the selected and the pinned devices of a run measure.

#include <numbers>

#include <QLabel>
#include <QToolButton>
#include <QtTest>

#include "editor/document/selection.h"
#include "editor/running/session_fixture.h"
#include "editor/sensors/battery_gauge.h"
#include "editor/sensors/heading_dial.h"
#include "editor/sensors/polar_plot.h"
#include "editor/sensors/reading_row.h"
#include "editor/sensors/sensor_card.h"
#include "editor/sensors/sensor_image.h"
#include "editor/sensors/sensors_panel.h"
#include "editor/sensors/shown_devices.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/theme.h"
#include "eventually.h"

using namespace trundle;

namespace {

/// A box that rests on a floor before a wall, 1 m from the sensors at its centre.
const QByteArray kStation = R"(Tick = 0.01  Seed = 3
#import common/materials.sim
#import common/surfaces.sim
RobotConfig Station {
  Body box { Box hull { Size=0.2,0.2,0.1 Pos=0,0,0.05 Mass=1 } }
  Body wheel { Pos=0,0.2,0.1 Cylinder tyre { Radius=0.05 Length=0.02 HPR=0,0,90 Mass=0.1 } }
  Hinge axle { Parent=box Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.03 BackEmfConstant=0.03 Resistance=2 MaxVoltage=12 }
  RangeSensor front { Body=box Pos=0,0,0.3 MinRange=0.02 MaxRange=4 }
  Lidar scan { Body=box Pos=0,0,0.3 Beams=8 MinRange=0.1 MaxRange=4 UpdatePeriod=0.05 }
  Imu imu { Body=box }
  Compass north { Body=box Bias=10 }
  Gps gps { Body=box Pos=0,0,0.1 Noise=0.5 }
  GroundSensor floor { Body=box Pos=0.2,0,0.05 MaxHeight=0.2 }
  TouchSensor feel { Geom=box.hull }
  Battery pack { Capacity=1 Voltage=12 StartLevel=0.5 }
  Camera eye { Body=box Pos=0,0,0.3 Resolution=32,24 }
}
StaticConfig Yard { Plane ground { } Box wall { Size=0.1,4,2 Pos=1.05,0,1 } }
Static yard { Config=Yard }
Robot one { Config=Station }
Robot two { Config=Station Pos=0,2,0 HPR=90,0,0 }
)";

struct SensorsFixture : SessionFixture {
    SensorsFixture() {
        panel.resize(900, 500);
        panel.show();
        (void)QTest::qWaitForWindowExposed(&panel, kTimeoutMs);
    }
    bool runFor(double seconds) {
        const std::uint64_t ticks = tick() + std::uint64_t(std::lround(100 * seconds));
        session.runFor(seconds);
        return QTest::qWaitFor([&] { return session.state() == RunState::Paused && tick() == ticks; }, 60000) && settled();
    }
    bool settled() {
        return QTest::qWaitFor([&] { return panel.isSettled(); }, 10000);
    }
    [[nodiscard]] QStringList shown() const {
        QStringList paths;
        for (const SensorCard* card : panel.cards()) paths << QString::fromStdString(card->device().path);
        return paths;
    }
    [[nodiscard]] SensorCard* card(const char* path) const {
        return panel.findChild<SensorCard*>(QStringLiteral("sensor.") + QLatin1String(path));
    }
    [[nodiscard]] ReadingRow* row(const char* device, const char* name) const {
        const SensorCard* found = card(device);
        return found ? found->findChild<ReadingRow*>(QStringLiteral("reading.") + QLatin1String(name)) : nullptr;
    }
    [[nodiscard]] QString hint() const {
        const auto* label = panel.findChild<QLabel*>(QStringLiteral("sensorsEmpty"));
        return label->isVisible() ? label->text() : QString();
    }

    Selection selection;
    SensorsPanel panel{document, selection, session, nullptr};
};

/// Whether a polar plot has a dot at this part of its radius above its middle.
bool hasDot(PolarPlot& polar, double up) {
    const QImage plot = polar.grab().toImage();
    const int radius = std::min(plot.width(), plot.height()) / 2 - 3, dy = -int(up * radius);
    for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x)
            if (plot.pixelColor(plot.width() / 2 + x, plot.height() / 2 + dy + y) == ink(Ink::Accent)) return true;
    return false;
}

/// The first number of a signal.
double numberOf(const SensorsFixture& f, const char* signal) {
    const RunResults& run = f.session.results();
    return run.snapshot->block->slots()[run.layout->find(signal)->offset];
}

} // namespace

class SensorsPanelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SensorsFixture> m_fixture;

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }
    void init() { m_fixture = std::make_unique<SensorsFixture>(); }
    void cleanup() { m_fixture.reset(); }

    void hintsSayWhatToDo() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.hint().startsWith(QStringLiteral("Open an experiment")));
        QVERIFY(f.open(kStation));
        EVENTUALLY(f.hint().startsWith(QStringLiteral("Run the experiment (F5)")));
        QVERIFY(f.runFor(0.01));
        EVENTUALLY(f.hint().startsWith(QStringLiteral("Select a robot")));
        f.selection.select("yard");
        EVENTUALLY(f.hint().startsWith(QStringLiteral("The selection has no devices")));
        f.selection.select("one");
        EVENTUALLY(f.hint().isEmpty());
        f.session.reset();
        EVENTUALLY(f.hint().startsWith(QStringLiteral("Run the experiment")));
        QVERIFY(f.panel.cards().empty());
    }

    /// A robot cart_2 is no member of a robot cart.
    void devicesOfARobotAreItsOwn() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(QByteArray(kStation).replace("Robot one", "Robot cart").replace("Robot two", "Robot cart_2")));
        const LoadedProject& loaded = *f.document.loaded();
        const auto devices = devicesOf(*loaded.experiment, *loaded.registry, std::string("cart"));
        QVERIFY(!devices.empty());
        for (const std::string& device : devices) QVERIFY2(device.starts_with("cart."), device.c_str());
        QCOMPARE(devicesOf(*loaded.experiment, *loaded.registry, std::string("cart.eye")), std::vector<std::string>{"cart.eye"});
    }

    void showsWhatIsSelected() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("two.north");
        QVERIFY(f.runFor(0.02));
        QCOMPARE(f.shown(), QStringList{QStringLiteral("two.north")});
        f.selection.select("one"); // all of its devices: sensors, then the others, in the order of the text
        const QString all =
            QStringLiteral("one.front one.scan one.imu one.north one.gps one.floor one.feel one.eye one.motor one.pack");
        EVENTUALLY_EQUAL(f.shown().join(u' '), all);
        f.selection.select("one.axle"); // a joint: what is mounted on it
        EVENTUALLY_EQUAL(f.shown(), QStringList{QStringLiteral("one.motor")});
        f.selection.select("RobotConfig.Station.imu"); // in the config: of the first robot
        EVENTUALLY_EQUAL(f.shown(), QStringList{QStringLiteral("one.imu")});
        f.selection.set({"two.front", "one.front", "two.front"});
        EVENTUALLY_EQUAL(f.shown(), (QStringList{QStringLiteral("two.front"), QStringLiteral("one.front")}));
    }

    /// A click on the floor selects nothing; what is driven remains in the panel.
    void theEditedModelIsShownUnselected() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.document.editedModel().open("RobotConfig.Station");
        f.selection.select("RobotConfig.Station.imu");
        QVERIFY(f.runFor(0.02));
        const QStringList imu{QStringLiteral("RobotConfig.Station.imu")};
        EVENTUALLY_EQUAL(f.shown(), imu);
        f.selection.clear();
        EVENTUALLY_EQUAL(f.panel.cards().size(), std::size_t(10));
        f.selection.select("StaticConfig.TrundlePreviewFloor");
        QVERIFY(f.settled());
        QCOMPARE(f.panel.cards().size(), std::size_t(10));
    }

    void everySignalOfADeviceIsReadable() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.set({"one", "two"});
        QVERIFY(f.runFor(0.1));
        int signalCount = 0;
        for (const SensorCard* card : f.panel.cards()) {
            const QString prefix = QString::fromStdString(card->device().path).replace(u'.', u'/') + u'/';
            for (const SignalEntry& entry : f.session.results().layout->entries()) {
                if (!entry.path.starts_with(prefix.toStdString())) continue;
                ++signalCount;
                const std::string name = entry.path.substr(std::size_t(prefix.size()));
                const bool found = std::ranges::any_of(card->rows(), [&](const ReadingRow* row) {
                    const bool isTrueOf =
                        name.starts_with("true") && row->reading().readTrue && row->reading().name.substr(1) == name.substr(5);
                    return row->reading().signal == entry.path || isTrueOf;
                });
                QVERIFY2(found, entry.path.c_str());
            }
            for (const ReadingRow* row : card->rows())
                QVERIFY2(row->text() != QStringLiteral("–"), qPrintable(row->objectName()));
        }
        QVERIFY(signalCount > 60);
    }

    void numbersAreThoseOfTheRun() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one");
        QVERIFY(f.runFor(0.5));
        QCOMPARE(f.row("one.front", "range")->text(), QStringLiteral("1.000 m"));
        QCOMPARE(f.row("one.front", "object")->text(), QStringLiteral("yard/wall"));
        QCOMPARE(f.row("one.pack", "voltage")->text(), QStringLiteral("12.00 V"));
        QCOMPARE(f.row("one.feel", "pressed")->text(), QStringLiteral("true"));
        const ReadingRow* ranges = f.row("one.scan", "ranges least, greatest");
        QVERIFY(ranges && ranges->text().startsWith(QStringLiteral("1.000, ")));
        const ReadingRow* acceleration = f.row("one.imu", "acceleration");
        QVERIFY(acceleration->text().endsWith(QStringLiteral("9.810 m/s^2")) ||
                acceleration->text().contains(QStringLiteral("9.8")));
    }

    void trueValuesAreThoseOfThePoses() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("two");
        QVERIFY(f.runFor(0.2));
        QCOMPARE(f.row("two.north", "heading")->text().section(u' ', 0, 0).toDouble(), 100.0);
        QCOMPARE(f.row("two.north", "heading")->trueText().section(u' ', 0, 0).toDouble(), 90.0);
        const QStringList place = f.row("two.gps", "position")->trueText().split(QStringLiteral(", "));
        QCOMPARE(place.size(), 3);
        QVERIFY(std::abs(place[1].toDouble() - 2) < 0.01 && std::abs(place[0].toDouble()) < 0.01);
        QVERIFY(f.row("two.gps", "position")->text() != f.row("two.gps", "position")->trueText());
        QVERIFY(f.row("two.front", "range")->reading().readTrue);
        QVERIFY(!f.row("two.front", "trueRange")); // beside "range"
        QVERIFY(!f.row("two.pack", "voltage")->reading().readTrue);
        const int high = f.row("two.north", "heading")->sizeHint().height();
        f.panel.findChild<QToolButton*>(QStringLiteral("sensorsTrue"))->click();
        QVERIFY(f.row("two.north", "heading")->sizeHint().height() < high);
    }

    /// That of a device beside the middle of a turned robot that rotates: its way in a tick before and after, over the time.
    void trueVelocityIsThatOfTheDevice() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(
            "Tick=0.01 Gravity=0,0,0\nRobotConfig Probe { Body box { Box hull { Size=0.4,0.2,0.1 Pos=0.05,0.02,0 Mass=1 } }\n"
            "  Gps middle { Body=box } Gps corner { Body=box Pos=0.3,0.1,0 } }\n"
            "Robot other { Config=Probe Pos=0,5,0 }\nRobot one { Config=Probe HPR=90,0,0 }\n"));
        f.selection.select("one");
        QVERIFY(f.runFor(0.01));
        QVERIFY(f.session.robots().push("one/box", {2, 0, 0}, {0, 0.2, 0}));
        QVERIFY(f.runFor(0.1));
        f.session.robots().endPush();
        QVERIFY(f.runFor(0.1));
        const auto vector = [&](const char* device, const char* name) {
            double numbers[3];
            f.row(device, name)->reading().readTrue(*f.session.results().snapshot, numbers);
            return Vec3(numbers);
        };
        const Vec3 middle = vector("one.middle", "position"), corner = vector("one.corner", "position");
        QVERIFY(f.runFor(0.01));
        const Vec3 ofMiddle = vector("one.middle", "velocity"), ofCorner = vector("one.corner", "velocity");
        QVERIFY(f.runFor(0.01));
        // 0.2 N s at 0.2 m turn it with at most 0.04 / (m (0.4² + 0.2²) / 12) = 2.4 rad/s; then the velocity of a point 0.32 m
        // from its middle changes by at most 2.4² * 0.32 * 0.01 = 0.02 m/s in a tick.
        QVERIFY((ofMiddle - (vector("one.middle", "position") - middle) / 0.02).norm() < 0.02);
        QVERIFY((ofCorner - (vector("one.corner", "position") - corner) / 0.02).norm() < 0.02);
        QVERIFY((ofCorner - ofMiddle).norm() > 0.2);
    }

    void limitsComeFromTheProperties() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one");
        QVERIFY(f.runFor(0.05));
        const auto limits = [&](const char* device, const char* name) { return f.row(device, name)->reading().limits; };
        QCOMPARE(limits("one.front", "range"), std::optional(std::pair(0.02, 4.0)));
        QCOMPARE(limits("one.floor", "reflectance"), std::optional(std::pair(0.0, 1.0)));
        QCOMPARE(limits("one.motor", "voltage"), std::optional(std::pair(-12.0, 12.0)));
        QCOMPARE(limits("one.pack", "charge"), std::optional(std::pair(0.0, 3600.0)));
        QVERIFY(!limits("one.pack", "voltage"));
        QVERIFY(f.card("one.scan")->findChild<PolarPlot*>() && !f.card("one.front")->findChild<PolarPlot*>());
        QVERIFY(f.card("one.north")->findChild<HeadingDial*>());
        QVERIFY(f.card("one.pack")->findChild<BatteryGauge*>());
    }

    void traceKeepsTheLastValues() {
        Trace trace(2);
        for (int i = 0; i < 1000; ++i) {
            const double values[] = {double(i), -double(i)};
            trace.add(0.1 * i, values);
        }
        QCOMPARE(trace.size(), Trace::kCapacity);
        for (std::size_t i = 0; i < trace.size(); ++i) {
            QCOMPARE(trace.value(i, 0), 700.0 + double(i));
            QCOMPARE(trace.value(i, 1), -700.0 - double(i));
        }
        QVERIFY(trace.isConnected(0));
        trace.interrupt();
        const double next[] = {7, 8}, again[] = {9, 10}, early[] = {1, 2};
        trace.add(200, next);
        QVERIFY(!trace.isConnected(trace.size() - 1) && trace.isConnected(trace.size() - 2));
        trace.add(200, again); // the same time
        QCOMPARE(trace.size(), Trace::kCapacity);
        QCOMPARE(trace.value(trace.size() - 1, 1), 10.0);
        trace.add(0, early); // another run
        QCOMPARE(trace.size(), std::size_t(1));
        QCOMPARE(trace.value(0, 0), 1.0);
    }

    void tracesGrowAndAResetClearsThem() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one.gps");
        QVERIFY(f.runFor(0.1));
        for (int i = 0; i < 5; ++i) QVERIFY(f.runFor(0.1));
        const ReadingRow* row = f.row("one.gps", "position");
        QVERIFY(row->trace().size() >= 6);
        QCOMPARE(row->trace().time(row->trace().size() - 1), f.session.results().time());
        QCOMPARE(row->trace().value(row->trace().size() - 1, 0), numberOf(f, "one/gps/position"));
        f.selection.set({"one.gps", "one.front"}); // the card stays with its trace
        EVENTUALLY_EQUAL(f.panel.cards().size(), std::size_t(2));
        QCOMPARE(f.row("one.gps", "position"), row);
        f.session.reset();
        EVENTUALLY(f.panel.cards().empty());
        QVERIFY(f.runFor(0.01));
        QVERIFY(f.row("one.gps", "position")->trace().size() <= 2);
    }

    void pinsStayWhateverIsSelected() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one.front");
        QVERIFY(f.runFor(0.01));
        QTest::mouseClick(f.card("one.front")->findChild<QToolButton*>(QStringLiteral("sensorPin")), Qt::LeftButton);
        f.selection.select("two.north");
        EVENTUALLY_EQUAL(f.shown(), (QStringList{QStringLiteral("one.front"), QStringLiteral("two.north")}));
        QTest::mouseClick(f.panel.findChild<QToolButton*>(QStringLiteral("sensorsUnpin")), Qt::LeftButton);
        EVENTUALLY_EQUAL(f.shown(), QStringList{QStringLiteral("two.north")});
    }

    void hiddenItDoesNothing() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one");
        QVERIFY(f.runFor(0.1));
        f.panel.hide();
        const int before = f.panel.updateCount();
        QVERIFY(f.runFor(0.5));
        QCOMPARE(f.panel.updateCount(), before);
        f.panel.show();
        EVENTUALLY(f.panel.updateCount() > before && f.panel.isSettled());
        QCOMPARE(f.row("one.front", "range")->trace().time(f.row("one.front", "range")->trace().size() - 1), 0.6);
    }

    /// More cards than are displayed at once take turns, and all show what was measured last.
    void manyCardsTakeTurns() {
        SensorsFixture& f = *m_fixture;
        QByteArray text = kStation;
        for (int i = 0; i < 20; ++i)
            text.replace("RangeSensor front", "RangeSensor extra" + QByteArray::number(i) + " { Body=box Pos=0,0,1 MaxRange=4 }\n  RangeSensor front");
        QVERIFY(f.open(text));
        f.selection.select("one");
        QVERIFY(f.runFor(0.1));
        QVERIFY(f.panel.cards().size() > 2 * SensorsPanel::kCardsAtOnce);
        const int before = f.panel.updateCount();
        QVERIFY(f.runFor(0.2));
        QVERIFY(f.panel.updateCount() >= before + 3);
        for (int i = 0; i < 20; ++i) {
            const auto* row = f.row(("one.extra" + std::to_string(i)).c_str(), "range");
            QVERIFY(row);
            QCOMPARE(row->trace().time(row->trace().size() - 1), 0.3);
        }
    }

    void theCameraPictureFillsItsCard() {
        SensorImage image(nullptr, "one/eye");
        image.resize(420, 190);
        image.show();
        QVERIFY(QTest::qWaitForWindowExposed(&image, kTimeoutMs));
        QCOMPARE(image.findChild<QWidget*>(QStringLiteral("cameraWall"))->size(), image.size());
    }

    void newValuesMoveNothing() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.select("one");
        QVERIFY(f.runFor(0.01));
        std::vector<QRect> before;
        for (const SensorCard* card : f.panel.cards()) before.push_back(card->geometry());
        QVERIFY(f.runFor(1));
        for (std::size_t i = 0; i < before.size(); ++i) QCOMPARE(f.panel.cards()[i]->geometry(), before[i]);
        for (const QSize& size : {QSize(280, 400), QSize(1600, 300)}) { // every card is whole at any width
            f.panel.resize(size);
            EVENTUALLY(f.panel.cards().front()->parentWidget()->width() <= size.width());
            for (const SensorCard* card : f.panel.cards()) {
                QVERIFY(card->geometry().right() <= card->parentWidget()->width());
                QVERIFY(card->height() >= card->sizeHint().height());
            }
        }
    }

    void paintsBarAndPolarPlot() {
        SensorsFixture& f = *m_fixture;
        QVERIFY(f.open(kStation));
        f.selection.set({"one.front", "one.scan"});
        QVERIFY(f.runFor(0.3));
        f.panel.showTrue(false);
        // A bar of 1 m between 0.02 and 4 m: filled up to a quarter.
        const QImage bar = f.row("one.front", "range")->grab().toImage();
        const auto isAccent = [&](int x) {
            for (int y = 0; y < bar.height() / 2; ++y)
                if (bar.pixelColor(x, y) == ink(Ink::Accent)) return true;
            return false;
        };
        QVERIFY(isAccent(bar.width() / 8));
        QVERIFY(!isAccent(bar.width() / 2));
        // The wall is 1 m ahead: a dot above the middle, none behind it.
        auto* polar = f.card("one.scan")->findChild<PolarPlot*>();
        QVERIFY(hasDot(*polar, 0.25));
        QVERIFY(!hasDot(*polar, -0.25));
    }

    /// The name of a robot in a Repeat has several words, that of a device in a Part too.
    void membersOfARepeatHaveTheirPictures() {
        SensorsFixture& f = *m_fixture;
        const QByteArray robots = kStation.mid(kStation.indexOf("Robot one"));
        QVERIFY(f.open(QByteArray(kStation)
                           .replace(robots, "Repeat row { Count=2 Pos=0,$index,0 Robot cart { Config=Station } }\n"
                                            "PartConfig Head {\n"
                                            "  Lidar scan { Body=$carrier Pos=0,0,0.3 Beams=8 MaxRange=4 UpdatePeriod=0.05 }\n"
                                            "}\n")
                           .replace("  Battery pack", "  Part head { Config=Head carrier=box }\n  Battery pack")));
        f.selection.set({"row_1.cart.scan", "row_1.cart.head.scan", "row_1.cart.eye"});
        QVERIFY(f.runFor(0.3));
        QCOMPARE(f.panel.cards().size(), std::size_t(3));
        for (const char* path : {"row_1.cart.scan", "row_1.cart.head.scan"})
            QVERIFY2(hasDot(*f.card(path)->findChild<PolarPlot*>(), 0.25), path);
        QCOMPARE(f.card("row_1.cart.head.scan")->device().component, std::string("row_1.cart/head.scan"));
        QCOMPARE(f.card("row_1.cart.eye")->device().component, std::string("row_1.cart/eye"));
    }
};

QTEST_MAIN(SensorsPanelTest)
#include "panel_test.moc"
