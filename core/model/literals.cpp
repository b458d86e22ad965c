#include "model/literals.h"

#include <cmath>

#include "base/units.h"

namespace trundle {
namespace {

using ElementKind = GivenElement::Kind;

bool areSameNumbers(const GivenElement& a, const GivenElement& b) {
    const UnitInfo *unit = findUnit(a.unit), *other = findUnit(b.unit);
    if (unit && other && unit->dimension != other->dimension) return false;
    const auto first = plainNumber(a), second = plainNumber(b);
    return first && second && std::abs(*first - *second) <= kUnitRounding * std::abs(*first);
}

} // namespace

GivenElement literalOf(const Element& element, FileId file) {
    GivenElement given;
    given.range = {file, element.range};
    switch (element.kind) {
    case Element::Kind::Number:
        given.kind = GivenElement::Kind::Number;
        given.number = element.number;
        given.unit = element.unit;
        if (!element.unit.empty()) given.unitRange = {file, element.unitRange};
        break;
    case Element::Kind::Word:
        given.kind = GivenElement::Kind::Word;
        given.text = element.text;
        break;
    case Element::Kind::String:
        given.kind = GivenElement::Kind::String;
        given.text = element.text;
        break;
    case Element::Kind::Boolean:
        given.kind = GivenElement::Kind::Boolean;
        given.boolean = element.boolean;
        break;
    case Element::Kind::ParamRef:
    case Element::Kind::Expression: break;
    }
    return given;
}

std::string baseUnit(std::string_view dimension) {
    if (dimension == "rate") return "deg/s"; // so that its product with a time is in degrees
    if (dimension == "angular acceleration") return "deg/s^2";
    return plainUnit(dimension);
}

std::string plainUnit(std::string_view dimension) {
    if (dimension == "angle") return "deg";
    if (dimension == "charge") return "Ah"; // as Capacity is
    for (const std::string& name : allUnitNames()) {
        const UnitInfo* unit = findUnit(name);
        if (unit->dimension == dimension && unit->factor == 1) return name;
    }
    return {};
}

std::optional<double> plainNumber(const GivenElement& element) {
    const UnitInfo* unit = findUnit(element.unit);
    return unit ? convertUnit(element.number, element.unit, plainUnit(unit->dimension)) : element.number;
}

bool areEqual(const GivenElement& a, const GivenElement& b) {
    if (a.kind == ElementKind::Number || b.kind == ElementKind::Number) return a.kind == b.kind && areSameNumbers(a, b);
    if (a.kind == ElementKind::Boolean || b.kind == ElementKind::Boolean) return a.kind == b.kind && a.boolean == b.boolean;
    return a.text == b.text;
}

} // namespace trundle
