#include "model/resolve/record.h"

namespace trundle {

const ResolvedValue* Record::find(std::string_view property) const {
    for (std::size_t i = 0; kind && i < kind->properties.size(); ++i) {
        if (kind->properties[i].name == property) return values[i] ? &*values[i] : nullptr;
    }
    return nullptr;
}

SourceRange Record::rangeOf(std::string_view property, SourceRange otherwise) const {
    const ResolvedValue* value = find(property);
    return value && value->range.known() ? value->range : otherwise;
}

bool Record::given(std::string_view property) const {
    const ResolvedValue* value = find(property);
    return value && value->origin != Origin::Default;
}

SourceRange Record::givenOutside(std::string_view property) const {
    for (const auto& [index, value] : names)
        if (kind->properties[index].name == property && value.elements.size() == 1 && value.elements[0].level > 0)
            return value.elements[0].source;
    return {};
}

double ComponentSpec::number(std::string_view key, double otherwise) const {
    const ResolvedValue* v = find(key);
    return v && !v->value.numbers.empty() ? v->value.numbers[0] : otherwise;
}

std::string ComponentSpec::text(std::string_view key, std::string otherwise) const {
    const ResolvedValue* v = find(key);
    return v && !v->value.texts.empty() ? v->value.texts[0] : otherwise;
}

std::vector<std::string> ComponentSpec::texts(std::string_view key) const {
    const ResolvedValue* v = find(key);
    return v ? v->value.texts : std::vector<std::string>();
}

} // namespace trundle
