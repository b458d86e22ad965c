// Wording of numbers, limits, counts and lists in messages.
#include <QTest>

#include <cmath>

#include "schema/value_words.h"

Q_DECLARE_METATYPE(trundle::Property)

using namespace trundle;

namespace {

using Words = std::vector<std::string>;

/// A property with limits; an infinite one is no limit.
Property limited(double low, double high, bool above = false, bool below = false, std::string unit = {}) {
    Property p;
    p.minimum = low;
    p.maximum = high;
    p.minExclusive = above;
    p.maxExclusive = below;
    p.unit = std::move(unit);
    return p;
}

Property counted(std::uint32_t low, std::uint32_t high, PropertyType type = PropertyType::Number) {
    Property p;
    p.type = type;
    p.minCount = low;
    p.maxCount = high;
    return p;
}

} // namespace

class ValueWordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The text of a number is the shortest that gives the same number again, and has no negative zero.
    void numbers() {
        for (const double n : {1.0, -1.0, 0.1, 1.0 / 3, 1e300, -2.5e-300, 123456789.125, 5e-324, 9007199254740993.0}) {
            const std::string text = numberText(n);
            QCOMPARE(std::strtod(text.c_str(), nullptr), n);
            QVERIFY(text.size() <= 24);
        }
        QCOMPARE(numberText(-0.0), std::string("0"));
        QCOMPARE(numberText(0.1), std::string("0.1"));
    }

    void elements() {
        GivenElement e;
        for (const auto kind : {GivenElement::Kind::Word, GivenElement::Kind::String}) {
            e.kind = kind;
            for (const std::size_t length : {0, 57, 60}) {
                e.text = std::string(length, 'x');
                QCOMPARE(elementText(e), e.text);
            }
            e.text = std::string(57, 'x') + "abcd"; // 61: longer than the text that replaces it
            QCOMPARE(elementText(e), std::string(57, 'x') + "...");
        }
        e.kind = GivenElement::Kind::Number;
        e.number = -3.5;
        QCOMPARE(elementText(e), std::string("-3.5"));
        e.unit = "cm";
        QCOMPARE(elementText(e), std::string("-3.5 cm"));
        e.kind = GivenElement::Kind::Boolean;
        QCOMPARE(elementText(e), std::string("false"));
        e.boolean = true;
        QCOMPARE(elementText(e), std::string("true"));
    }

    void limits_data() {
        QTest::addColumn<Property>("property");
        QTest::addColumn<QString>("text");
        const auto row = [](const Property& p, const char* text) { QTest::newRow(*text ? text : "none") << p << text; };
        row(limited(-HUGE_VAL, HUGE_VAL), "");
        row(limited(-HUGE_VAL, HUGE_VAL, true, true, "m"), "");
        row(limited(2, HUGE_VAL, false, false, "m"), "at least 2 m");
        row(limited(2, HUGE_VAL, true, false, "m"), "above 2 m");
        row(limited(0, HUGE_VAL, true, false, "m"), "above 0");
        row(limited(-HUGE_VAL, 7, false, false, "kg"), "at most 7 kg");
        row(limited(-HUGE_VAL, 7, false, true), "below 7");
        row(limited(-180, 90, false, false, "deg"), "from -180 to 90 deg");
        row(limited(1, 5, true, false, "m"), "above 1 m and at most 5 m");
        row(limited(1, 5, false, true, "m"), "at least 1 m and below 5 m");
        row(limited(0, 5, true, true, "m"), "above 0 and below 5 m");
    }
    void limits() {
        QFETCH(Property, property);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(limitText(property)), text);
    }

    /// Of two limits that form no closed range only the violated one is named; a value at an exclusive limit violates it.
    void theLimitThatIsViolated() {
        const Property open = limited(1, 5, true, true, "m"), low = limited(1, 5, false, true), closed = limited(1, 5);
        QCOMPARE(brokenLimitText(open, 1), std::string("above 1 m"));
        QCOMPARE(brokenLimitText(open, 0.5), std::string("above 1 m"));
        QCOMPARE(brokenLimitText(open, 5), std::string("below 5 m"));
        QCOMPARE(brokenLimitText(open, 9), std::string("below 5 m"));
        QCOMPARE(brokenLimitText(low, 0.5), std::string("at least 1"));
        QCOMPARE(brokenLimitText(low, 5), std::string("below 5"));
        QCOMPARE(brokenLimitText(open, HUGE_VAL), std::string("above 1 m and below 5 m"));
        for (const double value : {0.0, 7.0, HUGE_VAL}) QCOMPARE(brokenLimitText(closed, value), std::string("from 1 to 5"));
    }

    /// A list is cut where that makes it shorter: one word more than allowed is still written.
    void lists() {
        const Words words{"a", "b", "c", "d", "e"};
        const auto of = [&](std::size_t count, std::size_t most) { return listText(std::span(words).first(count), "and", most); };
        QCOMPARE(of(0, 3), std::string());
        QCOMPARE(of(1, 3), std::string("a"));
        QCOMPARE(of(2, 3), std::string("a and b"));
        QCOMPARE(of(3, 3), std::string("a, b and c"));
        QCOMPARE(of(4, 3), std::string("a, b, c and d"));
        QCOMPARE(of(5, 3), std::string("a, b, c ... (5 in all)"));
        QCOMPARE(listText(Words{"x", "y"}), std::string("x or y"));
        Words many;
        for (int i = 1; i <= 14; ++i) many.push_back(std::to_string(i));
        QCOMPARE(listText(many), std::string("1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 ... (14 in all)"));
        many.pop_back();
        QCOMPARE(listText(many), std::string("1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 or 13"));
    }

    void counts() {
        using T = PropertyType;
        QCOMPARE(countText(counted(1, 1)), std::string("a number"));
        QCOMPARE(countText(counted(1, 1, T::Integer)), std::string("a whole number"));
        QCOMPARE(countText(counted(1, 1, T::Boolean)), std::string("true or false"));
        QCOMPARE(countText(counted(1, 1, T::Choice)), std::string("a word"));
        QCOMPARE(countText(counted(1, 1, T::Text)), std::string("a text"));
        QCOMPARE(countText(counted(1, 1, T::File)), std::string("a file name"));
        QCOMPARE(countText(counted(1, 1, T::Reference)), std::string("a name"));
        QCOMPARE(countText(counted(3, 3)), std::string("three numbers"));
        QCOMPARE(countText(counted(9, 9, T::Integer)), std::string("nine whole numbers"));
        QCOMPARE(countText(counted(10, 10, T::Text)), std::string("10 texts"));
        QCOMPARE(countText(counted(2, 3, T::Reference)), std::string("two to three names"));
        QCOMPARE(countText(counted(0, 1000, T::File)), std::string("no to 1000 file names"));
        QCOMPARE(countText(counted(0, 1001, T::Choice)), std::string("one or more words"));
        QCOMPARE(countText(counted(1, 4000)), std::string("one or more numbers"));
        QCOMPARE(countText(counted(2, 4000)), std::string("two or more numbers"));
    }

    void articles() {
        for (const char* word : {"angle", "Encoder", "input", "Ode", "ultrasound"})
            QCOMPARE(withArticle(word), std::string("an ") + word);
        for (const char* word : {"Body", "length", "Universal", "unit", "speed in m/s"})
            QCOMPARE(withArticle(word), std::string("a ") + word);
        QCOMPARE(withArticle(""), std::string("a "));
    }

    /// The best suggestion is the fix, but only where the text has a place that it can replace.
    void suggestions() {
        const SourceRange place{0, {3, 7}};
        Diagnostic with, without, none;
        suggestWords(with, {"near", "far"}, place);
        QCOMPARE(with.suggestions, (Words{"near", "far"}));
        QCOMPARE(with.fixes.size(), std::size_t{1});
        QCOMPARE(with.fixes[0].title, std::string("near"));
        QCOMPARE(with.fixes[0].edits.at(0).range, place);
        QCOMPARE(with.fixes[0].edits.at(0).text, std::string("near"));
        suggestWords(without, {"near"}, {});
        QCOMPARE(without.suggestions, Words{"near"});
        QVERIFY(without.fixes.empty());
        suggest(none, "Radius", Words{"Mass", "Pos"}, place);
        QVERIFY(none.fixes.empty() && none.suggestions.empty());
    }
};

QTEST_APPLESS_MAIN(ValueWordsTest)
#include "value_words_test.moc"
