#include "editor/properties/row.h"

#include <algorithm>

#include "project/objects/value_text.h"

namespace trundle {
namespace {

constexpr std::uint32_t kMaxFields = 6;

/// Whether the value has exactly one element per number of the property.
bool oneByOne(const FieldValue& v, const Property& p) {
    if (v.broken || v.elements.size() > p.maxCount) return false;
    if (v.formula && v.parts.size() != v.elements.size()) return false;
    return v.elements.empty() || v.elements.size() >= p.minCount;
}

bool single(const Row& row) {
    const bool isOne = !row.property() || row.property()->maxCount == 1;
    return isOne && std::none_of(row.values.begin(), row.values.end(), [](const FieldValue& v) {
               return v.formula || v.broken || v.elements.size() > 1;
           });
}

} // namespace

std::vector<std::string> Row::choices() const {
    if (property()) return property()->type == PropertyType::Choice ? property()->choices : std::vector<std::string>();
    const ParamDescription* said = first().description;
    const auto isOther = [&](const FieldValue& v) {
        return !v.description || v.description->property.choices != said->property.choices;
    };
    return said && std::ranges::none_of(values, isOther) ? said->property.choices : std::vector<std::string>();
}

bool Row::mixed() const {
    return std::any_of(values.begin(), values.end(), [&](const FieldValue& v) { return v.text != first().text; });
}

bool Row::mixedElement(std::size_t i) const {
    const std::string mine = first().element(i);
    return std::any_of(values.begin(), values.end(), [&](const FieldValue& v) { return v.element(i) != mine; });
}

bool Row::given() const {
    return std::any_of(values.begin(), values.end(), [](const FieldValue& v) { return v.given(); });
}

bool Row::isLong() const {
    return std::any_of(values.begin(), values.end(), [](const FieldValue& v) { return v.isLong; });
}

std::size_t Row::fieldCount() const { return property() ? property()->maxCount : 1; }

EditorKind Row::editor() const {
    const Property* p = property();
    if (!p && !isLong() && !choices().empty() && single(*this)) return EditorKind::Choice;
    if (!p && !isLong() && candidates && single(*this)) return EditorKind::Reference;
    if (!p || isLong()) return EditorKind::Line;
    switch (p->type) {
    case PropertyType::Number:
    case PropertyType::Integer:
        if (p->maxCount > kMaxFields ||
            !std::all_of(values.begin(), values.end(), [&](const FieldValue& v) { return oneByOne(v, *p); }))
            return EditorKind::Line;
        return isColour(*p) ? EditorKind::Colour : EditorKind::Numbers;
    case PropertyType::Boolean: return single(*this) ? EditorKind::Flag : EditorKind::Line;
    case PropertyType::Choice: return single(*this) ? EditorKind::Choice : EditorKind::Line;
    case PropertyType::Reference: return EditorKind::Reference;
    case PropertyType::File: return single(*this) ? EditorKind::File : EditorKind::Line;
    case PropertyType::Text: return candidates ? EditorKind::Reference : EditorKind::Line;
    }
    return EditorKind::Line;
}

} // namespace trundle
