#include "model/param_description.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/units.h"
#include "model/literals.h"
#include "schema/value_reader.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

using ElementKind = GivenElement::Kind;

constexpr std::uint32_t kMostElements = 100000; ///< of a Param that is a list
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The number in `unit`; a plain one counts in the unit of plain numbers of its dimension. Nothing where the dimensions differ.
std::optional<double> numberIn(const std::string& unit, const GivenElement& element) {
    if (unit.empty()) return plainNumber(element);
    const UnitInfo* wanted = findUnit(unit);
    return convertUnit(element.number, element.unit.empty() && wanted ? plainUnit(wanted->dimension) : element.unit, unit);
}

std::vector<std::string> keyNames() {
    std::vector<std::string> names;
    for (const DescriptionKey& key : descriptionKeys()) names.push_back(key.name);
    return names;
}

class DescriptionReader {
public:
    DescriptionReader(const ParamItem& param, FileId file, Diagnostics& diagnostics)
        : m_param(param), m_file(file), m_diagnostics(diagnostics) {}

    ParamDescription read() {
        Property& property = m_out.property;
        property.name = m_param.name.text;
        property.minimum = -kInfinity;
        property.maximum = kInfinity;
        property.maxCount = kMostElements;
        m_out.range = {m_file, {m_param.open.begin, std::max(m_param.open.end, m_param.close.end)}};
        for (const Item& item : m_param.items) take(item);
        if (const auto* help = assignment("Help")) readHelp(*help);
        if (const auto* choices = assignment("Choices")) readChoices(*choices);
        readLimits();
        return std::move(m_out);
    }

private:
    void take(const Item& item) {
        const auto* a = item.as<AssignmentItem>();
        if (!a) {
            m_diagnostics.error(Code::WrongPlace, {m_file, item.range},
                                "what describes a Param are " + listText(keyNames(), "and") + ", nothing else");
            return;
        }
        if (a->path.empty()) return; // reported by the parser
        const SourceRange key{m_file, a->pathRange};
        const std::string& word = a->path.front().text;
        if (a->path.size() > 1 || std::ranges::find(descriptionKeys(), word, &DescriptionKey::name) == descriptionKeys().end()) {
            const std::string written = a->path.size() > 1 ? word + "." + a->path[1].text : word;
            Diagnostic& d = m_diagnostics.error(Code::UnknownKey, key,
                                                "there is no " + written + " of a Param; there are " +
                                                    listText(keyNames(), "and"));
            suggest(d, written, keyNames(), key);
        } else if (const AssignmentItem* first = assignment(word)) {
            Diagnostic& d = m_diagnostics.error(Code::DuplicateKey, key, word + " is set twice in one block");
            d.notes.push_back({"first set here", {m_file, first->pathRange}});
        } else {
            m_assignments.push_back(a);
        }
    }

    const AssignmentItem* assignment(std::string_view key) const {
        const auto at = std::ranges::find_if(m_assignments, [&](const auto* a) { return a->path.front().text == key; });
        return at == m_assignments.end() ? nullptr : *at;
    }

    /// The elements of a value, all written out; empty, with a diagnostic, if one is a Param or an expression.
    std::vector<GivenElement> literals(const AssignmentItem& a) {
        std::vector<GivenElement> all;
        if (a.value.broken) return all;
        for (const Element& element : a.value.elements) {
            if (element.kind == Element::Kind::ParamRef || element.kind == Element::Kind::Expression) {
                m_diagnostics.error(Code::WrongType, {m_file, element.range},
                                    a.path.front().text + " of a Param is written out, without $");
                return {};
            }
            all.push_back(literalOf(element, m_file));
        }
        return all;
    }

    std::optional<GivenElement> single(const AssignmentItem& a, ElementKind kind, const std::string& needed) {
        const std::vector<GivenElement> all = literals(a);
        if (all.empty()) return std::nullopt;
        const SourceRange place{m_file, a.value.range};
        const std::string& key = a.path.front().text;
        if (all.size() > 1) {
            m_diagnostics.error(Code::WrongCount, place,
                                key + " has " + std::to_string(all.size()) + " elements, it takes " + needed);
            return std::nullopt;
        }
        if (all[0].kind == kind) return all[0];
        Diagnostic& d =
            m_diagnostics.error(Code::WrongType, place, key + " is " + elementText(all[0]) + ", it must be " + needed);
        if (kind == ElementKind::String && all[0].kind == ElementKind::Word)
            d.fixes.push_back({"\"" + all[0].text + "\"", {{place, "\"" + all[0].text + "\""}}});
        return std::nullopt;
    }

    void readHelp(const AssignmentItem& a) {
        if (const auto text = single(a, ElementKind::String, "a text in double quotes")) m_out.property.help = text->text;
    }

    void readChoices(const AssignmentItem& a) {
        m_out.choices = literals(a);
        m_out.property.type = PropertyType::Choice;
        for (const GivenElement& choice : m_out.choices)
            m_out.property.choices.push_back(choice.kind == ElementKind::String ? choice.text : elementText(choice));
    }

    /// The unit of the limits is that of the first of them that has one, or of the Param's own value.
    void readLimits() {
        const auto* low = assignment("Min");
        const auto* high = assignment("Max");
        if (!low && !high) return;
        const auto minimum = low ? single(*low, ElementKind::Number, "a number") : std::nullopt;
        const auto maximum = high ? single(*high, ElementKind::Number, "a number") : std::nullopt;
        std::string& unit = m_out.property.unit;
        for (const auto& limit : {minimum, maximum})
            if (unit.empty() && limit) unit = limit->unit;
        if (unit.empty() && !m_param.value.elements.empty()) unit = m_param.value.elements[0].unit;
        if (unit == "%" || !findUnit(unit)) unit.clear();
        m_out.property.minimum = limit(minimum, -kInfinity, "Min");
        m_out.property.maximum = limit(maximum, kInfinity, "Max");
        m_out.hasLimits = std::isfinite(m_out.property.minimum) || std::isfinite(m_out.property.maximum);
        if (m_out.property.minimum <= m_out.property.maximum) return;
        m_diagnostics.error(Code::OutOfRange, {m_file, high->value.range},
                            "Max is " + elementText(*maximum) + ", it must be at least Min, " + elementText(*minimum));
        m_out.hasLimits = false;
    }

    double limit(const std::optional<GivenElement>& given, double none, const std::string& key) {
        if (!given) return none;
        if (!given->unit.empty() && !findUnit(given->unit)) {
            Diagnostic& d = m_diagnostics.error(Code::UnknownUnit, given->unitRange, "there is no unit " + given->unit);
            suggest(d, given->unit, allUnitNames(), given->unitRange);
            return none;
        }
        if (const std::optional<double> number = numberIn(m_out.property.unit, *given)) return *number;
        m_diagnostics.error(Code::WrongDimension, given->range,
                            key + " is in " + given->unit + ", the other values of " + m_out.property.name + " are in " +
                                m_out.property.unit);
        return none;
    }

    const ParamItem& m_param;
    FileId m_file;
    Diagnostics& m_diagnostics;
    std::vector<const AssignmentItem*> m_assignments;
    ParamDescription m_out;
};

/// Checks the elements of one value.
class ValueCheck {
public:
    ValueCheck(const ParamDescription& description, const GivenValue& value, Diagnostics& diagnostics)
        : m_description(description), m_value(value), m_diagnostics(diagnostics) {}

    bool run() {
        return std::ranges::all_of(m_value.elements, [&](const GivenElement& element) {
            if (!m_description.choices.empty()) return isChoice(element);
            return !m_description.hasLimits || isWithin(element);
        });
    }

private:
    bool isChoice(const GivenElement& element) {
        if (std::ranges::any_of(m_description.choices, [&](const GivenElement& choice) { return areEqual(choice, element); }))
            return true;
        const std::vector<std::string>& words = m_description.property.choices;
        Diagnostic& d = report(Code::UnknownChoice, element, "must be " + listText(words));
        suggest(d, element.text, words, element.literal ? element.range : SourceRange{});
        return false;
    }

    bool isWithin(const GivenElement& element) {
        const Property& property = m_description.property;
        if (element.kind != ElementKind::Number) {
            report(Code::WrongType, element, "must be a number");
            return false;
        }
        const std::optional<double> number = numberIn(property.unit, element);
        if (!number) {
            report(Code::WrongDimension, element, "must be in " + property.unit);
            return false;
        }
        const double play = kUnitRounding * std::abs(*number);
        if (*number >= property.minimum - play && *number <= property.maximum + play) return true;
        report(Code::OutOfRange, element, "must be " + brokenLimitText(property, *number));
        return false;
    }

    /// A number without a unit has the one in which it is read: "5 m" beside limits in mm.
    std::string shown(const GivenElement& element) const {
        std::string unit = m_description.property.unit;
        for (const GivenElement& choice : m_description.choices)
            if (unit.empty()) unit = choice.unit;
        const UnitInfo* info = findUnit(unit);
        const bool isPlain = element.kind == ElementKind::Number && element.unit.empty();
        const std::string plain = info && isPlain ? plainUnit(info->dimension) : std::string();
        return elementText(element) + (plain.empty() ? "" : " " + plain);
    }

    Diagnostic& report(Code code, const GivenElement& element, const std::string& needed) {
        const bool isPassedOn = element.source.known(); // by one Param after another, from where it is given
        Diagnostic& d = m_diagnostics.error(code, isPassedOn ? element.source : m_value.range,
                                            m_description.property.name + " is " + shown(element) + ", it " + needed);
        if (isPassedOn) d.notes.push_back({kUsedHere, m_value.range});
        d.notes.push_back({kDescribedHere, m_description.range});
        return d;
    }

    const ParamDescription& m_description;
    const GivenValue& m_value;
    Diagnostics& m_diagnostics;
};

} // namespace

std::string ParamDescription::limits() const {
    if (!choices.empty()) return listText(property.choices);
    return hasLimits ? limitText(property) : std::string();
}

const std::vector<DescriptionKey>& descriptionKeys() {
    static const std::vector<DescriptionKey> keys{
        {"Min", "The smallest number it may have."},
        {"Max", "The largest number it may have."},
        {"Choices", "All values that it may have, separated by commas."},
        {"Help", "What it is, shown in Properties and while typing."},
    };
    return keys;
}

std::shared_ptr<const ParamDescription> descriptionOf(const ParamItem& param, FileId file, Diagnostics& diagnostics) {
    if (param.open.size() == 0) return nullptr;
    return std::make_shared<const ParamDescription>(DescriptionReader(param, file, diagnostics).read());
}

bool checkValue(const ParamDescription& description, const GivenValue& value, Diagnostics& diagnostics) {
    return ValueCheck(description, value, diagnostics).run();
}

} // namespace trundle
