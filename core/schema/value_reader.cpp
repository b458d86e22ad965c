#include "schema/value_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/units.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

using ElementKind = GivenElement::Kind;

constexpr double kLargestWhole = 9007199254740992.0; ///< 2^53: all smaller whole numbers are exact
constexpr double kDefaultWhole = 2147483647.0;       ///< limit of whole numbers without a declared limit

const char* kindWord(ElementKind kind) {
    switch (kind) {
    case ElementKind::Number: return "a number";
    case ElementKind::Boolean: return "true or false";
    case ElementKind::String: return "a text";
    case ElementKind::Word: return "a word";
    }
    return "";
}

std::string dimensionWord(std::string_view unit) {
    const UnitInfo* info = findUnit(unit);
    return info ? std::string(info->dimension) : std::string();
}

/// A converted number, without the last digits that the conversion has made up: 0.0011 for 1.1 mm.
std::string convertedText(double value) {
    char buffer[40];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 12).ptr};
}

class Reader {
public:
    Reader(const Property& property, const GivenValue& given, Diagnostics& diagnostics)
        : m_property(property), m_given(given), m_diagnostics(diagnostics) {}

    std::optional<PropertyValue> read() {
        if (isQuotedNumbers() || !countFits()) return std::nullopt;
        PropertyValue value{m_property.type, {}, {}};
        for (std::size_t i = 0; i < m_given.elements.size(); ++i) {
            m_index = i;
            if (!readElement(m_given.elements[i], value)) return std::nullopt;
        }
        warnOfLastUnit();
        return value;
    }

private:
    bool countFits() {
        const std::size_t count = m_given.elements.size();
        if (count >= m_property.minCount && count <= m_property.maxCount) return true;
        if (count == 0) return false; // the parser has already reported the missing value
        Diagnostic& d = m_diagnostics.error(Code::WrongCount, m_given.range,
                                            m_property.name + " has " + std::to_string(count) +
                                                (count == 1 ? " element" : " elements") + ", it takes " + countText(m_property));
        suggestPoint(d);
        if (const GivenElement* element = fromList()) addSourceNote(d, *element);
        return false;
    }

    /// `Pos="1 2 3"`, as XML has it.
    bool isQuotedNumbers() {
        const bool isNumeric = m_property.type == PropertyType::Number || m_property.type == PropertyType::Integer;
        if (!isNumeric || m_given.elements.size() != 1 || m_given.elements[0].kind != ElementKind::String) return false;
        const GivenElement& element = m_given.elements[0];
        std::string numbers;
        for (std::size_t at = 0; (at = element.text.find_first_not_of(" ,;\t", at)) != std::string::npos;) {
            const std::size_t end = std::min(element.text.find_first_of(" ,;\t", at), element.text.size());
            const std::string each = element.text.substr(at, end - at);
            double number = 0;
            const auto [rest, fault] = std::from_chars(each.data(), each.data() + each.size(), number);
            if (fault != std::errc() || rest != each.data() + each.size()) return false;
            numbers += (numbers.empty() ? "" : ",") + each;
            at = end;
        }
        if (numbers.empty()) return false;
        Diagnostic& d =
            m_diagnostics.error(Code::WrongType, m_given.range,
                                m_property.name + " is a text; numbers are written without quotes, with commas between");
        if (element.literal) d.fixes.push_back({numbers, {{element.range, numbers}}});
        addSourceNote(d, element);
        return true;
    }

    /// The first element of the Param that is the whole value, or is a list in it; nullptr: the number of elements is that of the text.
    const GivenElement* fromList() const {
        const std::vector<GivenElement>& all = m_given.elements;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool isList = i + 1 < all.size() && all[i].range == all[i + 1].range;
            if (all[i].source.known() && (isList || all[i].range == m_given.range)) return &all[i];
        }
        return nullptr;
    }

    /// Suggests a decimal point for a decimal comma: `0,25`.
    void suggestPoint(Diagnostic& d) const {
        if (m_property.type != PropertyType::Number || m_property.maxCount != 1 || m_given.elements.size() != 2) return;
        const GivenElement& whole = m_given.elements[0];
        const GivenElement& part = m_given.elements[1];
        const auto isDigits = [](const GivenElement& e) {
            const double most = std::pow(10.0, std::min(e.range.range.size(), 15u));
            return e.kind == ElementKind::Number && e.literal && e.number == std::floor(e.number) && std::abs(e.number) < most &&
                   !std::signbit(e.number);
        };
        const bool oneComma = part.range.range.begin == whole.range.range.end + 1;
        if (!oneComma || !isDigits(whole) || !isDigits(part) || !whole.unit.empty() || !part.unit.empty()) return;
        const std::string digits = numberText(part.number);
        if (digits.size() > part.range.range.size()) return;
        const std::string number =
            numberText(whole.number) + "." + std::string(part.range.range.size() - digits.size(), '0') + digits;
        d.fixes.push_back({number, {{{whole.range.file, {whole.range.range.end, part.range.range.begin}}, "."}}});
    }

    bool readElement(const GivenElement& element, PropertyValue& value) {
        switch (m_property.type) {
        case PropertyType::Number:
        case PropertyType::Integer: return readNumber(element, value);
        case PropertyType::Boolean: return readBoolean(element, value);
        case PropertyType::Choice: return readChoice(element, value);
        case PropertyType::Text:
        case PropertyType::File:
        case PropertyType::Reference: return readText(element, value);
        }
        return false;
    }

    Diagnostic& typeFault(const GivenElement& element, const std::string& needed) {
        const std::string is = element.kind == ElementKind::Boolean
                                   ? elementText(element)
                                   : std::string(kindWord(element.kind)) + " (" + elementText(element) + ")";
        Diagnostic& d =
            m_diagnostics.error(Code::WrongType, placeOf(element), subject() + " is " + is + ", it must be " + needed);
        addSourceNote(d, element);
        return d;
    }
    static void addSourceNote(Diagnostic& d, const GivenElement& element) {
        if (element.source.known()) d.notes.push_back({kGivenHere, element.source});
    }
    bool wrongType(const GivenElement& element, const std::string& needed) {
        typeFault(element, needed);
        return false;
    }

    /// In a list, that of the element.
    SourceRange placeOf(const GivenElement& element) const {
        return m_given.elements.size() > 1 && element.range.known() ? element.range : m_given.range;
    }

    /// "Radius", or "the 2nd number of Size" in a list.
    std::string subject() const {
        if (m_given.elements.size() == 1) return m_property.name;
        static const char* const order[] = {"1st", "2nd", "3rd"};
        const std::string place = m_index < 3 ? order[m_index] : std::to_string(m_index + 1) + "th";
        return "the " + place + " element of " + m_property.name;
    }

    bool readNumber(const GivenElement& element, PropertyValue& value) {
        if (element.kind != ElementKind::Number)
            return wrongType(element, m_property.type == PropertyType::Integer ? "a whole number" : "a number");
        std::optional<double> number = inPropertyUnit(element);
        if (!number) return false;
        if (m_property.type == PropertyType::Integer && !element.literal) number = wholeIfRounded(*number);
        if (m_property.type == PropertyType::Integer && *number != std::floor(*number))
            return wrongType(element, "a whole number");
        if (!inRange(*number)) return outOfRange(element, *number);
        value.numbers.push_back(*number * m_property.scale);
        return true;
    }

    /// The effective limits: whole numbers always have limits, so that they fit the C++ type of the field.
    Property limits() const {
        Property p = m_property;
        if (p.type == PropertyType::Integer) {
            if (!std::isfinite(p.minimum)) p.minimum = -kDefaultWhole;
            if (!std::isfinite(p.maximum)) p.maximum = kDefaultWhole;
            p.maximum = std::min(p.maximum, kLargestWhole);
            p.minimum = std::max(p.minimum, -kLargestWhole);
        }
        return p;
    }

    bool inRange(double number) const {
        if (!std::isfinite(number) || !std::isfinite(number * m_property.scale)) return false;
        double low = m_property.minimum, high = m_property.maximum;
        if (m_property.type == PropertyType::Integer) {
            const Property p = limits();
            low = p.minimum;
            high = p.maximum;
        }
        const bool above = m_property.minExclusive ? number > low : number >= low;
        const bool below = m_property.maxExclusive ? number < high : number <= high;
        return above && below;
    }

    bool outOfRange(const GivenElement& element, double value) {
        std::string limit = brokenLimitText(limits(), value);
        if (limit.empty()) limit = "smaller";
        Diagnostic& d = m_diagnostics.error(Code::OutOfRange, placeOf(element),
                                            subject() + " is " + elementText(element) + ", it must be " + limit);
        addSourceNote(d, element);
        if (!element.literal || element.number >= 0) return false;
        GivenElement positive = element;
        positive.number = -element.number;
        Diagnostics silent;
        Reader trial(m_property, m_given, silent);
        const std::optional<double> number = trial.inPropertyUnit(positive);
        if (number && inRange(*number)) {
            const std::string text = numberText(positive.number) + unitBehind(element);
            d.fixes.push_back({text, {{element.range, text}}});
            d.suggestions = {text};
        }
        return false;
    }

    std::optional<double> inPropertyUnit(const GivenElement& element) {
        if (element.unit.empty() || element.unit == m_property.unit) return element.number;
        const SourceRange place = element.unitRange.known() ? element.unitRange : placeOf(element);
        const UnitInfo* unit = findUnit(element.unit);
        if (!unit && !exponentsOf(element.unit)) {
            Diagnostic& d = m_diagnostics.error(Code::UnknownUnit, place, "there is no unit " + element.unit);
            std::vector<std::string> legal = fittingUnits();
            if (legal.empty()) legal = allUnitNames();
            suggest(d, element.unit, legal, element.unitRange);
            if (d.suggestions.empty() && legal.size() < 10) d.message += "; " + m_property.name + " takes " + listText(legal);
            addSourceNote(d, element);
            return std::nullopt;
        }
        if (m_property.unit.empty()) {
            if (unit && element.unit == "%") return element.number * unit->factor;
            Diagnostic& d = m_diagnostics.error(Code::WrongDimension, place,
                                                m_property.name + " has no unit, it cannot be in " + element.unit);
            dropUnit(d, element);
            addSourceNote(d, element);
            return std::nullopt;
        }
        if (const std::optional<double> converted = convertUnit(element.number, element.unit, m_property.unit)) return converted;
        const std::string own = dimensionWord(m_property.unit);
        std::string message =
            m_property.name + " is " + (own.empty() ? "in " + m_property.unit : withArticle(own) + " (" + m_property.unit + ")");
        message += ", " + element.unit + " is " + (unit ? withArticle(unit->dimension) : "not");
        Diagnostic& d = m_diagnostics.error(Code::WrongDimension, place, message);
        if (element.literal) d.suggestions = fittingUnits();
        addSourceNote(d, element);
        return std::nullopt;
    }

    /// As it is written, with a blank before it or without.
    static std::string unitBehind(const GivenElement& element) {
        const bool blank = element.unitRange.known() && element.unitRange.range.begin > element.range.range.begin &&
                           element.range.range.size() > numberText(element.number).size() + element.unit.size();
        return (blank ? " " : "") + element.unit;
    }

    /// `30,20,10 cm` is often meant for all three.
    void warnOfLastUnit() {
        const std::vector<GivenElement>& all = m_given.elements;
        if (all.size() < 2 || m_property.unit.empty() || all.back().unit.empty()) return;
        const GivenElement& last = all.back();
        const auto isPlain = [](const GivenElement& e) { return e.kind == ElementKind::Number && e.literal && e.unit.empty(); };
        const bool isAlone = last.literal && last.unitRange.known() && std::all_of(all.begin(), all.end() - 1, isPlain);
        if (!isAlone || convertUnit(1, last.unit, m_property.unit) == 1) return;
        std::vector<std::string> others;
        std::vector<TextEdit> edits;
        for (const GivenElement& e : all) {
            if (&e == &last || e.number == 0) continue;
            others.push_back(numberText(e.number));
            edits.push_back({{e.range.file, {e.range.range.end, e.range.range.end}}, unitBehind(last)});
        }
        if (others.empty()) return;
        Diagnostic& d =
            m_diagnostics.warning(Code::WrongDimension, last.unitRange,
                                  last.unit + " counts for " + numberText(last.number) + " alone; " + listText(others, "and") +
                                      (others.size() == 1 ? " is in " : " are in ") + m_property.unit);
        d.fixes.push_back({"write " + last.unit + " behind each", std::move(edits)});
    }

    /// The number without a unit is the same amount in SI.
    void dropUnit(Diagnostic& d, const GivenElement& element) const {
        if (!element.literal || !element.unitRange.known()) return;
        const UnitInfo* unit = findUnit(element.unit);
        const double plain = unit ? element.number * unit->factor : element.number;
        if (!inRange(plain) || (m_property.type == PropertyType::Integer && plain != std::floor(plain))) return;
        d.fixes.push_back({convertedText(plain), {{element.range, convertedText(plain)}}});
    }

    std::vector<std::string> fittingUnits() const {
        std::vector<std::string> units;
        const std::string dimension = dimensionWord(m_property.unit);
        if (dimension.empty()) return units;
        for (const std::string& name : allUnitNames()) {
            if (dimensionWord(name) == dimension) units.push_back(name);
        }
        return units;
    }

    bool readBoolean(const GivenElement& element, PropertyValue& value) {
        if (element.kind == ElementKind::Boolean) {
            value.numbers.push_back(element.boolean ? 1 : 0);
            return true;
        }
        Diagnostic& d = typeFault(element, "true or false");
        static const std::string yes[] = {"yes", "Yes", "on", "On", "True", "TRUE", "1", "YES", "ON"};
        static const std::string no[] = {"no", "No", "off", "Off", "False", "FALSE", "0", "NO", "OFF"};
        const std::string text = elementText(element);
        const SourceRange place = element.literal ? element.range : SourceRange{};
        if (std::count(std::begin(yes), std::end(yes), text)) suggestWords(d, {"true"}, place);
        if (std::count(std::begin(no), std::end(no), text)) suggestWords(d, {"false"}, place);
        return false;
    }

    bool readChoice(const GivenElement& element, PropertyValue& value) {
        if (element.kind != ElementKind::Word && element.kind != ElementKind::String)
            return wrongType(element, "one of " + listText(m_property.choices));
        if (std::count(m_property.choices.begin(), m_property.choices.end(), element.text)) {
            value.texts.push_back(element.text);
            return true;
        }
        Diagnostic& d =
            m_diagnostics.error(Code::UnknownChoice, placeOf(element),
                                subject() + " is " + elementText(element) + ", it must be " + listText(m_property.choices));
        addSourceNote(d, element);
        suggest(d, element.text, m_property.choices, element.literal ? element.range : SourceRange{});
        return false;
    }

    bool readText(const GivenElement& element, PropertyValue& value) {
        const bool text = element.kind == ElementKind::Word || element.kind == ElementKind::String;
        if (!text) {
            const char* needed = m_property.type == PropertyType::Text   ? "a text"
                                 : m_property.type == PropertyType::File ? "a file name"
                                                                         : "a name";
            return wrongType(element, needed);
        }
        value.texts.push_back(element.text);
        return true;
    }

    const Property& m_property;
    const GivenValue& m_given;
    Diagnostics& m_diagnostics;
    std::size_t m_index = 0;
};

} // namespace

std::optional<PropertyValue> readValue(const Property& property, const GivenValue& given, Diagnostics& diagnostics) {
    return Reader(property, given, diagnostics).read();
}

} // namespace trundle
