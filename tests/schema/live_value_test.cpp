// Setting a field of an object that runs: each guard, and the value that arrives.
#include <QTest>

#include <cmath>
#include <stdexcept>

#include <trundle/kind_table.h>

#include "schema/live_value.h"

using namespace trundle;

namespace {

struct Motor {
    double gain = 1, angle = 0.5, fixed = 3;
    int steps = 4;
    bool on = false;
    std::string name = "old";
    std::vector<double> levels{1, 2};
    static void describe(Describe<Motor>& d) {
        d.field("Gain", &Motor::gain, number().above(0).below(10).live(), "Open at both ends.");
        d.field("Angle", &Motor::angle, degrees().within(-90, 180).live(), "In another unit than the class.");
        d.field("Steps", &Motor::steps, number().within(1, 9).live(), "Whole.");
        d.field("On", &Motor::on, flag().live(), "Whether.");
        d.field("Name", &Motor::name, text().live(), "Who.");
        d.field("Levels", &Motor::levels, number().counted(1, 3).live(), "Several.");
        d.field("Fixed", &Motor::fixed, number(), "Not during a run.");
    }
};

PropertyValue numbers(std::vector<double> n, PropertyType type = PropertyType::Number) { return {type, std::move(n), {}}; }

struct Live {
    std::unique_ptr<KindTable> table = border::commonTable<Motor>("Motor", TRUNDLE_DEVICE);
    void* instance = table->kind.create();
    ~Live() { table->kind.destroy(instance); }
    Motor& motor() const { return border::at<Motor>(instance).object; }
    Status set(const char* property, const PropertyValue& value) const {
        return setLive(table->kind, instance, "left", property, value);
    }
};

} // namespace

class LiveValueTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachFieldTakesItsOwnValue() {
        const Live live;
        QVERIFY(live.set("Gain", numbers({2.5})).ok());
        QVERIFY(live.set("Angle", numbers({1.25})).ok());
        QVERIFY(live.set("Steps", numbers({7}, PropertyType::Integer)).ok());
        QVERIFY(live.set("On", numbers({1}, PropertyType::Boolean)).ok());
        QVERIFY(live.set("Name", {PropertyType::Text, {}, {"new"}}).ok());
        QVERIFY(live.set("Levels", numbers({5, 6, 7})).ok());
        const Motor& m = live.motor();
        QCOMPARE(m.gain, 2.5);
        QCOMPARE(m.angle, 1.25);
        QCOMPARE(m.steps, 7);
        QCOMPARE(m.on, true);
        QCOMPARE(m.name, std::string("new"));
        QCOMPARE(m.levels, (std::vector<double>{5, 6, 7}));
        QCOMPARE(m.fixed, 3.0);
    }

    void refusals_data() {
        QTest::addColumn<QString>("property");
        QTest::addColumn<QList<double>>("given");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* property, const QList<double>& given, const char* said) {
            QTest::addRow("%s %g", property, given.value(0)) << property << given << said;
        };
        const char* const range = " of left is out of the range that the running code describes";
        const auto out = [&](const char* property, double value) {
            row(property, {value}, (std::string(property) + range).c_str());
        };
        row("Fixed", {1}, "Fixed of left does not change during a run");
        row("gain", {1}, "left has no property gain");
        row("Gain2", {1}, "left has no property Gain2");
        row("Gain", {}, "Gain of left does not take that many values");
        row("Levels", {1, 2, 3, 4}, "Levels of left does not take that many values");
        row("Gain", {HUGE_VAL}, "Gain of left must be finite");
        row("Levels", {1, std::nan("")}, "Levels of left must be finite");
        out("Gain", 0);
        out("Gain", 10);
        out("Steps", 0);
        out("Steps", 10);
        out("Angle", 3.2); // rad; the limits are in degrees
        out("Angle", -1.6);
    }
    void refusals() {
        QFETCH(QString, property);
        QFETCH(QList<double>, given);
        QFETCH(QString, said);
        const Live live;
        const Status done = live.set(property.toLatin1(), numbers({given.begin(), given.end()}));
        QVERIFY(!done.ok());
        QCOMPARE(QString::fromStdString(done.error().message), said);
        QCOMPARE(live.motor().gain, 1.0);
        QCOMPARE(live.motor().angle, 0.5);
        QCOMPARE(live.motor().steps, 4);
        QCOMPARE(live.motor().levels.size(), std::size_t{2});
    }

    /// A limit that was rounded on its way from degrees is still inside; one at 1 and at 9 too.
    void limitsAreInside() {
        const Live live;
        for (const double angle : {-90 * M_PI / 180, 180 * M_PI / 180}) QVERIFY(live.set("Angle", numbers({angle})).ok());
        for (const double steps : {1, 9}) QVERIFY(live.set("Steps", numbers({steps}, PropertyType::Integer)).ok());
        for (const double gain : {1e-300, 9.999999}) QVERIFY(live.set("Gain", numbers({gain})).ok());
    }

    void withoutAnInstance() {
        const Live live;
        QVERIFY(!setLive(live.table->kind, nullptr, "left", "Gain", numbers({2})).ok());
        TrundleKind deaf = live.table->kind;
        deaf.set = nullptr;
        QVERIFY(!setLive(deaf, live.instance, "left", "Gain", numbers({2})).ok());
    }

    /// What the object's own code refuses, with its reason where it gives one.
    void theCodeRefuses() {
        const Live live;
        TrundleKind kind = live.table->kind;
        kind.set = [](void*, std::uint32_t, const TrundleValue*) -> std::int32_t { return 1; };
        kind.lastError = [](void*) -> const char* { return "too hot"; };
        QCOMPARE(setLive(kind, live.instance, "left", "Gain", numbers({2})).error().message,
                 std::string("left refuses its Gain: too hot"));
        kind.lastError = nullptr;
        QCOMPARE(setLive(kind, live.instance, "left", "Gain", numbers({2})).error().message,
                 std::string("left refuses its Gain"));
    }
};

QTEST_APPLESS_MAIN(LiveValueTest)
#include "live_value_test.moc"
