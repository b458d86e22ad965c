// Descriptions of kinds, the registry, and reading of property values.
#include <QTest>

#include "schema/registry.h"
#include "schema/value_reader.h"

using namespace trundle;

namespace {

struct Thing {
    double length = 2, angle = 0, ratio = 1;
    int count = 3;
    bool on = true;
    std::string mode = "slow", name;
    std::array<double, 3> place{1, 2, 3};
    std::optional<double> extra;
    static void describe(Describe<Thing>& d) {
        d.help("A thing.");
        d.field("Length", &Thing::length, metres().above(0).atMost(10), "How long.");
        d.field("Angle", &Thing::angle, degrees().within(-180, 180), "How turned.");
        d.field("Ratio", &Thing::ratio, number().within(0, 1), "Which part.");
        d.field("Count", &Thing::count, number().within(1, 10), "How many.");
        d.field("On", &Thing::on, flag(), "Whether.");
        d.field("Mode", &Thing::mode, oneOf("slow|fast"), "How.");
        d.field("Name", &Thing::name, text(), "Who.");
        d.field("Place", &Thing::place, metres(), "Where.");
        d.field("Extra", &Thing::extra, number(), "Perhaps.");
        d.field("Needed", &Thing::length, metres().required(), "Surely.");
    }
};

GivenElement number(double value, std::string unit = {}) {
    GivenElement e;
    e.kind = GivenElement::Kind::Number;
    e.number = value;
    e.unit = std::move(unit);
    return e;
}
GivenElement word(std::string text) {
    GivenElement e;
    e.text = std::move(text);
    return e;
}

} // namespace

class ValueReaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aKindFromItsClass() {
        const Kind kind = kindOf<Thing>("Thing", Role::Device, {"RobotConfig"});
        QCOMPARE(kind.help, "A thing.");
        QCOMPARE(kind.find("Mode")->choices, (std::vector<std::string>{"slow", "fast"}));
        QCOMPARE(kind.find("Length")->defaultValue->numbers, std::vector<double>{2});
        QVERIFY(!kind.find("Extra")->defaultValue);
        QVERIFY(kind.find("Needed")->required && !kind.find("Needed")->defaultValue);
        QCOMPARE(kind.find("Place")->minCount, 3u);
        QVERIFY(!kind.find("length"));
    }

    void twoModulesWithOneKind() {
        Registry registry;
        Kind a = kindOf<Thing>("Thing", Role::Device, {"RobotConfig"}), b = a;
        a.module = "one.so";
        b.module = "two.so";
        QVERIFY(registry.add(a).ok());
        const Status status = registry.add(b);
        QVERIFY(!status.ok());
        QVERIFY(status.error().message.find("one.so") != std::string::npos &&
                status.error().message.find("two.so") != std::string::npos);
        QCOMPARE(registry.inside("RobotConfig").size(), 1u);
        QVERIFY(registry.inside("").empty());
    }

    void values_data() {
        QTest::addColumn<QString>("property");
        QTest::addColumn<int>("which");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("said");
        const char* names[] = {"cm",    "unit",   "angle",     "percent", "above",   "most",
                               "whole", "number", "dimension", "nounit",  "unknown", "nan"};
        const std::tuple<const char*, double, const char*> rows[] = {
            {"Length", 0.03, ""},
            {"Length", 3, ""},
            {"Angle", std::numbers::pi / 2, ""},
            {"Ratio", 0.5, ""},
            {"Length", 0, "Length is 0, it must be above 0"},
            {"Length", 0, "Length is 2000 cm, it must be at most 10 m"},
            {"Count", 0, "Count is a number (2.5), it must be a whole number"},
            {"Length", 0, "Length is a word (long), it must be a number"},
            {"Length", 0, "Length is a length (m), kg is a mass"},
            {"Ratio", 0, "Ratio has no unit, it cannot be in m"},
            {"Length", 0, "there is no unit mmm"},
            {"Angle", 0, "Angle is 200, it must be from -180 to 180 deg"}};
        for (int i = 0; i < 12; ++i)
            QTest::newRow(names[i]) << std::get<0>(rows[i]) << i << std::get<1>(rows[i]) << std::get<2>(rows[i]);
    }
    void values() {
        QFETCH(QString, property);
        QFETCH(int, which);
        QFETCH(double, value);
        QFETCH(QString, said);
        const GivenElement given[] = {number(3, "cm"), number(3),          number(90),       number(50, "%"),
                                      number(0),       number(2000, "cm"), number(2.5),      word("long"),
                                      number(3, "kg"), number(1, "m"),     number(3, "mmm"), number(200)};
        const Kind kind = kindOf<Thing>("Thing", Role::Device, {});
        Diagnostics diagnostics;
        GivenValue g;
        g.elements = {given[which]};
        const auto read = readValue(*kind.find(property.toStdString()), g, diagnostics);
        QCOMPARE(read.has_value(), said.isEmpty());
        if (read) QVERIFY(std::abs(read->numbers[0] - value) < 1e-15);
        else QCOMPARE(QString::fromStdString(diagnostics.all()[0].message), said);
    }

    /// A limit that is left out is out of range; one that is not is inside.
    void limits_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<bool>("opensLow");
        QTest::addColumn<bool>("opensHigh");
        QTest::addColumn<bool>("isInside");
        for (const bool low : {false, true})
            for (const bool high : {false, true}) {
                QTest::addRow("low %d %d", low, high) << 1.0 << low << high << !low;
                QTest::addRow("high %d %d", low, high) << 3.0 << low << high << !high;
                QTest::addRow("between %d %d", low, high) << 2.0 << low << high << true;
            }
    }
    void limits() {
        QFETCH(double, value);
        QFETCH(bool, opensLow);
        QFETCH(bool, opensHigh);
        QFETCH(bool, isInside);
        Property property;
        property.name = "Share";
        property.minimum = 1;
        property.maximum = 3;
        property.minExclusive = opensLow;
        property.maxExclusive = opensHigh;
        for (const PropertyType type : {PropertyType::Number, PropertyType::Integer}) {
            property.type = type;
            Diagnostics diagnostics;
            GivenValue given;
            given.elements = {number(value)};
            QCOMPARE(readValue(property, given, diagnostics).has_value(), isInside);
        }
    }

    /// A decimal comma is repaired where both parts are written as digits beside it; a value of a Param has no text to repair.
    void suggestsADecimalPoint_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("literal");
        QTest::addColumn<QString>("fixed");
        QTest::newRow("comma") << "0,25" << true << "0.25";
        QTest::newRow("zeros") << "3,050" << true << "3.050";
        QTest::newRow("only zeros") << "3,00" << true << "3.00";
        QTest::newRow("from a Param") << "0,25" << false << "";
        QTest::newRow("a blank") << "0, 25" << true << "";
        QTest::newRow("a fraction") << "1.5,2" << true << "";
        QTest::newRow("a sign") << "0,-2" << true << "";
        QTest::newRow("three") << "1,2,3" << true << "";
    }
    void suggestsADecimalPoint() {
        QFETCH(QString, text);
        QFETCH(bool, literal);
        QFETCH(QString, fixed);
        GivenValue given;
        for (qsizetype at = 0; at < text.size();) {
            const qsizetype end = text.indexOf(',', at) < 0 ? text.size() : text.indexOf(',', at);
            while (text[at] == ' ') ++at;
            GivenElement e = number(text.mid(at, end - at).toDouble());
            e.literal = literal;
            e.range = {0, {std::uint32_t(at), std::uint32_t(end)}};
            given.elements.push_back(e);
            at = end + 1;
        }
        const Kind kind = kindOf<Thing>("Thing", Role::Device, {});
        Diagnostics d;
        QVERIFY(!readValue(*kind.find("Ratio"), given, d));
        QCOMPARE(d.all()[0].fixes.empty(), fixed.isEmpty());
        if (fixed.isEmpty()) return;
        QCOMPARE(QString::fromStdString(d.all()[0].fixes[0].title), fixed);
        const TextEdit& edit = d.all()[0].fixes[0].edits.at(0);
        QCOMPARE(text.replace(edit.range.range.begin, edit.range.range.size(), QString::fromStdString(edit.text)), fixed);
    }

    /// What is offered without a unit is the same amount, in SI.
    void suggestsTheNumberWithoutItsUnit_data() {
        QTest::addColumn<QString>("property");
        QTest::addColumn<double>("amount");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("offered");
        QTest::newRow("mm") << "Extra" << 5.0 << "mm"
                            << "0.005";
        QTest::newRow("digits of the conversion") << "Extra" << 1.1 << "mm"
                                                  << "0.0011";
        QTest::newRow("SI") << "Extra" << 5.0 << "m"
                            << "5";
        QTest::newRow("a product in SI") << "Extra" << 5.0 << "m^2 kg/s^2"
                                         << "5";
        QTest::newRow("out of range") << "Ratio" << 3.0 << "m"
                                      << "";
        QTest::newRow("in range") << "Ratio" << 30.0 << "cm"
                                  << "0.3";
        QTest::newRow("no whole number") << "Count" << 150.0 << "cm"
                                         << "";
        QTest::newRow("a whole number") << "Count" << 200.0 << "cm"
                                        << "2";
    }
    void suggestsTheNumberWithoutItsUnit() {
        QFETCH(QString, property);
        QFETCH(double, amount);
        QFETCH(QString, unit);
        QFETCH(QString, offered);
        GivenElement e = number(amount, unit.toStdString());
        e.range = {0, {0, 6}};
        e.unitRange = {0, {2, 6}};
        GivenValue given;
        given.elements = {e};
        const Kind kind = kindOf<Thing>("Thing", Role::Device, {});
        Diagnostics d;
        QVERIFY(!readValue(*kind.find(property.toStdString()), given, d));
        QCOMPARE(d.all()[0].fixes.empty(), offered.isEmpty());
        if (!offered.isEmpty()) QCOMPARE(QString::fromStdString(d.all()[0].fixes[0].edits.at(0).text), offered);
    }

    /// A number that only becomes infinite in SI units is out of range too.
    void numbersStayFiniteInSiUnits() {
        Property p;
        p.name = "Rate";
        p.scale = 1e6;
        p.minimum = -HUGE_VAL;
        p.maximum = HUGE_VAL;
        for (const auto& [n, good] : {std::pair(1e301, true), {1e303, false}, {-1e303, false}}) {
            Diagnostics d;
            GivenValue g;
            g.elements = {number(n)};
            QCOMPARE(readValue(p, g, d).has_value(), good);
            if (!good) QVERIFY(d.all()[0].message.ends_with("it must be smaller"));
        }
    }

    void readsListsAndWords() {
        const Kind kind = kindOf<Thing>("Thing", Role::Device, {});
        Diagnostics d;
        GivenValue two, three, choice;
        two.elements = {number(1), number(2)};
        three.elements = {number(1), number(2, "mm"), word("x")};
        choice.elements = {word("fsat")};
        QVERIFY(!readValue(*kind.find("Place"), two, d));
        QCOMPARE(d.all()[0].message, "Place has 2 elements, it takes three numbers");
        QVERIFY(!readValue(*kind.find("Place"), three, d));
        QCOMPARE(d.all()[1].message, "the 3rd element of Place is a word (x), it must be a number");
        QVERIFY(!readValue(*kind.find("Mode"), choice, d));
        QCOMPARE(d.all()[2].message, "Mode is fsat, it must be slow or fast");
        QCOMPARE(d.all()[2].suggestions, std::vector<std::string>{"fast"});
    }
};

QTEST_APPLESS_MAIN(ValueReaderTest)
#include "value_reader_test.moc"
