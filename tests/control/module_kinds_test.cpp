// The tables of a module: everything that makes them unusable is found before its code runs, one fault at a time.
#include "control/module_tables.h"

#include <QtTest>

#include <functional>

using namespace trundle;

namespace {

using Change = std::function<void(Tables&)>;

} // namespace

Q_DECLARE_METATYPE(Change)

class ModuleKindsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void copiesEverything() {
        Tables t;
        const auto kinds = kindsOfModule(&t.module, "lib.so");
        QVERIFY2(kinds.ok(), t.fault().c_str());
        const Kind& kind = kinds.value().at(0);
        QVERIFY(kind.name == "Walker" && kind.help == "Walks." && kind.role == Role::Controller && kind.module == "lib.so");
        QCOMPARE(kind.parents, (std::vector<std::string>{"Robot", "Grid", "Scatter"}));
        const Property &speed = kind.properties.at(0), &mood = kind.properties.at(1), &way = kind.properties.at(2);
        QVERIFY(speed.name == "Speed" && speed.unit == "m/s" && speed.maximum == 2 && speed.defaultValue->numbers.at(0) == 1);
        QVERIFY(mood.type == PropertyType::Choice && mood.choices.size() == 2 && mood.defaultValue->texts.at(0) == "slow");
        QVERIFY(way.minCount == 3 && way.maxCount == 3 && way.minimum == -5 && !way.defaultValue);
        const SignalDescription& where = kind.signals.at(0);
        QVERIFY(where.name == "where" && where.unit == "m" && where.count == 3 && where.direction == TRUNDLE_OUTPUT);
        QCOMPARE(kind.signals.at(1).type, std::uint32_t{TRUNDLE_INTEGER_SIGNAL});
        t.makeDevice();
        QCOMPARE(kindsOfModule(&t.module, "lib.so").value().at(0).parents, std::vector<std::string>{"RobotConfig"});
    }

    void faults_data() {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const char* fault, const Change& change) {
            QTest::newRow(name) << change << fault;
        };
        const char *fine = "", *kinds = "E404 lib.so cannot be used: its kind 'Walker' ";
        const auto own = [&](const char* what) { return QByteArray(kinds) + what; };
        row("valid", fine, [](Tables&) {});
        row("older minor", fine, [](Tables& t) { t.module.abiMinor = 0; });
        row("newer minor", "E406 lib.so is built for module interface 1.", [](Tables& t) { ++t.module.abiMinor; });
        row("newer major", "E406 lib.so is built for module interface 2.", [](Tables& t) { ++t.module.abiMajor; });
        row("magic", "E404 lib.so has a bad magic number", [](Tables& t) { t.module.magic ^= 1; });
        row("short module", "E404 lib.so has a description that is too short", [](Tables& t) { --t.module.size; });
        row("longer module", fine, [](Tables& t) { ++t.module.size; });
        row("no kinds", fine, [](Tables& t) { t.module.kindCount = 0; });
        row("too many kinds", "E404 lib.so has a broken table of kinds", [](Tables& t) { t.module.kindCount = 1001; });
        row("null kinds", "E404 lib.so has a broken table of kinds", [](Tables& t) { t.module.kinds = nullptr; });
        row("null kind", "E404 lib.so cannot be used: its kind number 1 is too short", [](Tables& t) { t.kinds[0] = nullptr; });
        row("short kind", "E404 lib.so cannot be used: its kind number 1 is too short", [](Tables& t) { t.kind.size = 8; });
        row("kind of ABI 1.0", fine, [](Tables& t) { t.kind.size = offsetof(TrundleKind, alternatives); });
        row("a kind twice", own("is there twice"), [](Tables& t) {
            t.kinds[1] = &t.kind;
            t.module.kindCount = 2;
        });
        row("kind's help without an end", "E404 lib.so cannot be used: its kind 'Walker' has no name or no end", [](Tables& t) {
            static const std::string kLong(5000, 'x'); // more than is read
            t.kind.help = kLong.c_str();
        });
        row("field's help without an end", own("has a broken field, number 2"), [](Tables& t) {
            static const std::string kLong(5000, 'x');
            t.fields[1].help = kLong.c_str();
        });
        row("no name", "E404 lib.so cannot be used: its kind number 1 has no name or no end",
            [](Tables& t) { t.kind.name = nullptr; });
        row("odd name", "E404 lib.so cannot be used: its kind '2nd' is no name", [](Tables& t) { t.kind.name = "2nd"; });
        row("the name of a unit", "E404 lib.so cannot be used: its kind 'Nm' has the name of a unit",
            [](Tables& t) { t.kind.name = "Nm"; });
        row("role", own("is neither a controller nor a device"), [](Tables& t) { t.kind.role = 3; });
        row("no create", own("lacks one of its functions"), [](Tables& t) { t.kind.create = nullptr; });
        row("no destroy", own("lacks one of its functions"), [](Tables& t) { t.kind.destroy = nullptr; });
        row("no set", own("lacks one of its functions"), [](Tables& t) { t.kind.set = nullptr; });
        row("no lastError", own("lacks one of its functions"), [](Tables& t) { t.kind.lastError = nullptr; });
        row("no setup", own("lacks one of its functions"), [](Tables& t) { t.kind.setupController = nullptr; });
        row("no update", own("lacks one of its functions"), [](Tables& t) { t.kind.update = nullptr; });
        row("device", fine, [](Tables& t) { t.makeDevice(); });
        row("device that only senses", fine, [](Tables& t) {
            t.makeDevice();
            std::swap(t.kind.act, t.kind.sense);
        });
        row("device without act and sense", own("lacks one of its functions"), [](Tables& t) {
            t.makeDevice();
            t.kind.act = nullptr;
        });
        row("device without setup", own("lacks one of its functions"), [](Tables& t) {
            t.makeDevice();
            t.kind.setupDevice = nullptr;
        });
        row("too many fields", own("has a broken table of fields or signals"), [](Tables& t) { t.kind.fieldCount = 1001; });
        row("null fields", own("has a broken table of fields or signals"), [](Tables& t) { t.kind.fields = nullptr; });
        row("null signals", own("has a broken table of fields or signals"), [](Tables& t) { t.kind.signals = nullptr; });
        row("null default", own("has a broken field, number 1"), [](Tables& t) { t.fields[0].defaultValue.numbers = nullptr; });
        row("endless default", own("has a broken field, number 1"), [](Tables& t) {
            t.fields[0].defaultValue.count = 100001; // of which only a few are there
        });
        row("null default text", own("has a broken field, number 2"), [](Tables& t) { t.texts[0] = nullptr; });
        row("field name", own("has a field whose name 'a b' is no name"), [](Tables& t) { t.fields[1].name = "a b"; });
        row("scale 0", own("has a field Way whose scale is no number"), [](Tables& t) { t.fields[2].scale = 0; });
        row("scale inf", own("has a field Way whose scale is no number"), [](Tables& t) { t.fields[2].scale = HUGE_VAL; });
        row("empty range", own("has a field Way whose range is empty"), [](Tables& t) { t.fields[2].minimum = 6; });
        row("range of NaN", own("has a field Way whose range is empty"), [](Tables& t) { t.fields[2].maximum = std::nan(""); });
        row("count upside down", own("has a field Way whose count is none"), [](Tables& t) { t.fields[2].minCount = 4; });
        row("count 0", own("has a field Way whose count is none"),
            [](Tables& t) { t.fields[2].minCount = t.fields[2].maxCount = 0; });
        row("count too large", own("has a field Way whose count is none"), [](Tables& t) { t.fields[2].maxCount = 100001; });
        row("no choices", own("has a field Mood without choices"), [](Tables& t) { t.fields[1].choices = ""; });
        row("default above the count", own("has a field Speed whose default has the wrong count"),
            [](Tables& t) { t.fields[0].defaultValue.count = 2; });
        row("default below the count", own("has a field Way whose default has the wrong count"), [](Tables& t) {
            t.fields[2].flags = 0;
            t.fields[2].defaultValue = {t.numbers, nullptr, 2};
        });
        row("default NaN", own("has a field Speed whose default is not finite"), [](Tables& t) { t.numbers[0] = std::nan(""); });
        row("default no choice", own("has a field Mood whose default is none of its choices"),
            [](Tables& t) { t.texts[0] = "slo"; });
        row("a field twice", own("has two fields named Speed"), [](Tables& t) { t.fields[2].name = "Speed"; });
        row("a field that every controller has", own("has a field Budget, which every controller has already"),
            [](Tables& t) { t.fields[0].name = "Budget"; });
        row("a device's field that every controller has", fine, [](Tables& t) {
            t.makeDevice();
            t.fields[0].name = "UpdatePeriod";
        });

        row("a name with a 0", fine, [](Tables& t) { t.fields[2].name = "Way0"; });
        row("a name of digits and _", fine, [](Tables& t) { t.fields[2].name = "_90"; });
        row("signals counted by two fields", fine, [](Tables& t) {
            t.makeDevice();
            for (const std::size_t i : {0u, 2u}) {
                t.fields[i].type = TRUNDLE_INTEGER;
                t.fields[i].minimum = 1;
                t.fields[i].minCount = t.fields[i].maxCount = 1;
            }
            t.fields[2].flags = TRUNDLE_REQUIRED; // it needs no default
            t.signals[0].countFields = 1 | 3u << 16;
        });
        row("the second of two broken", own("has a broken signal, number 1"), [](Tables& t) {
            t.makeDevice();
            t.fields[0].type = TRUNDLE_INTEGER;
            t.fields[0].minimum = 1;
            t.signals[0].countFields = 1 | 4u << 16;
        });
        row("signals of ABI 1.2", fine, [](Tables& t) {
            t.module.abiMinor = 2;
            t.signals[0].direction = TRUNDLE_COMMAND;
        });
        row("a command of ABI 1.3", own("has a signal where that is no output"), [](Tables& t) {
            t.module.abiMinor = 3;
            t.signals[0].direction = TRUNDLE_COMMAND;
        });
        row("alternatives behind the end of ABI 1.0", fine, [](Tables& t) {
            t.kind.size = offsetof(TrundleKind, alternatives);
            t.kind.alternativesCount = 5000;
        });

        row("a signal twice", own("has two signals named where"), [](Tables& t) { t.signals[1].name = "where"; });
        row("a signal and a field of one name", fine, [](Tables& t) { t.signals[1].name = "Speed"; });
        row("signal name", own("has a signal whose name 'a/b' is no name"), [](Tables& t) { t.signals[1].name = "a/b"; });
        row("signal without name", own("has a broken signal, number 2"), [](Tables& t) { t.signals[1].name = nullptr; });
        row("signal of no size", own("has a signal count of no size"), [](Tables& t) { t.signals[1].count = 0; });
        row("signal type", own("has a signal count of an unknown type"), [](Tables& t) { t.signals[1].type = 4; });
        row("signal direction", own("has a signal count of an unknown type"), [](Tables& t) {
            t.makeDevice();
            t.signals[1].direction = 4;
        });
        row("a controller's command", own("has a signal count that is no output"),
            [](Tables& t) { t.signals[1].direction = TRUNDLE_COMMAND; });
        row("a device's command", fine, [](Tables& t) {
            t.makeDevice();
            t.signals[1].direction = TRUNDLE_COMMAND;
        });
        row("a controller's command before 1.3", fine, [](Tables& t) {
            t.signals[1].direction = TRUNDLE_COMMAND;
            t.module.abiMinor = 2;
        });
        row("publishes 1000", fine, [](Tables& t) { t.signals[1].count = 997; });
        row("publishes 1001", own("publishes 1001 numbers; at most 1000 are possible"),
            [](Tables& t) { t.signals[1].count = 998; });
        const auto counted = [](Tables& t) { // a signal of as many numbers as the field Speed says
            t.makeDevice();
            t.fields[0].type = TRUNDLE_INTEGER;
            t.fields[0].minimum = 1;
            t.signals[1].countFields = 1;
        };
        row("counted signal", fine, counted);
        row("counted by two", fine, [counted](Tables& t) {
            counted(t);
            t.signals[1].countFields = 1 | 1 << 16;
        });
        row("counted by no field", own("has a broken signal, number 2"), [counted](Tables& t) {
            counted(t);
            t.signals[1].countFields = 4;
        });
        row("counted by half a field", own("has a broken signal, number 2"), [counted](Tables& t) {
            counted(t);
            t.signals[1].countFields = 1 << 16;
        });
        row("counted by a number", own("has a signal count counted by 'Speed', which is no field with one positive integer"),
            [counted](Tables& t) {
                counted(t);
                t.fields[0].type = TRUNDLE_NUMBER;
            });
        row("counted by zero", own("has a signal count counted by 'Speed'"), [counted](Tables& t) {
            counted(t);
            t.fields[0].minimum = 0;
        });
        row("a controller's counted signal", own("has a signal count counted by 'Speed'"), [counted](Tables& t) {
            counted(t);
            t.kind.role = TRUNDLE_CONTROLLER;
        });
        const auto choice = [](Tables& t) {
            t.fields[1] = t.fields[2];
            t.fields[1].name = "Other";
            t.kind.alternatives = t.alternatives;
            t.kind.alternativesCount = 1;
        };
        row("alternatives", fine, choice);
        row("alternatives of one", own("has a choice between fewer than two fields"), [choice](Tables& t) {
            choice(t);
            t.alternatives[0].names = "Way";
        });
        row("alternatives unknown", own("has a choice between fields with 'Sway', which it does not have"), [choice](Tables& t) {
            choice(t);
            t.alternatives[0].names = "Way|Sway";
        });
        row("alternatives with a default", own("has a choice between fields with Speed, which is always there"),
            [choice](Tables& t) {
                choice(t);
                t.alternatives[0].names = "Way|Speed";
            });
        row("alternatives likely", own("likens a field to one that it does not have"), [choice](Tables& t) {
            choice(t);
            t.alternatives[0].likely = "Pace";
        });
        row("null alternatives", own("has a broken table of alternatives"), [](Tables& t) { t.kind.alternativesCount = 1; });
    }
    void faults() {
        QFETCH(Change, change);
        QFETCH(QString, fault);
        Tables t;
        change(t);
        const QString said = QString::fromStdString(t.fault());
        QVERIFY2(fault.isEmpty() ? said.isEmpty() : said.startsWith(fault), qPrintable(said));
    }

    void noModule() { QVERIFY(!kindsOfModule(nullptr, "lib.so").ok()); }
    void fieldsOfEveryControllerComeOnce() {
        Tables t;
        Kind kind = kindsOfModule(&t.module, "lib.so").value().at(0);
        addControllerFields(kind);
        const std::size_t once = kind.properties.size();
        addControllerFields(kind);
        QCOMPARE(kind.properties.size(), once);
        t.makeDevice();
        Kind device = kindsOfModule(&t.module, "lib.so").value().at(0);
        addControllerFields(device);
        QCOMPARE(device.properties.size(), std::size_t(3));
    }
};

QTEST_APPLESS_MAIN(ModuleKindsTest)
#include "module_kinds_test.moc"
