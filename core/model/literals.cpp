#include "model/literals.h"

#include "base/units.h"

namespace trundle {

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
    for (const std::string& name : allUnitNames()) {
        const UnitInfo* unit = findUnit(name);
        if (unit->dimension == dimension && unit->factor == 1) return name;
    }
    return {};
}

} // namespace trundle
