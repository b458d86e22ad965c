#pragma once
// The values of one block by the properties of its kind, and their conversion into the class that described the kind.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/component_spec.h"
#include "model/outline.h"
#include "schema/value_reader.h"

namespace trundle {

/// The overrides of an instance as a tree of names.
struct OverrideNode {
    std::map<std::string, OverrideNode, std::less<>> children;
    std::shared_ptr<const GivenValue> value;
    Origin origin = Origin::Instance;
    SourceRange word; ///< its name where it was written first, in a path
    const SourceAssignment* assignment = nullptr; ///< of the value
    const Part* writer = nullptr;                 ///< the block that has it

    void takeValueOf(const OverrideNode& other) {
        value = other.value;
        origin = other.origin;
        assignment = other.assignment;
        writer = other.writer;
    }
};

/// The overrides of what has that name inside; null: none.
[[nodiscard]] inline const OverrideNode* below(const OverrideNode* overrides, const std::string& name) {
    if (!overrides) return nullptr;
    const auto it = overrides->children.find(name);
    return it == overrides->children.end() ? nullptr : &it->second;
}

struct Record {
    const Kind* kind = nullptr;
    std::vector<std::optional<ResolvedValue>> values; ///< parallel to kind->properties; defaults filled in
    std::vector<bool> literal;                        ///< literal text, which a fix may rewrite
    bool complete = true;                             ///< false: a required value is missing or invalid
    std::map<std::size_t, GivenValue> names;          ///< references that come from Params, by the property's index

    [[nodiscard]] const ResolvedValue* find(std::string_view property) const;
    /// The source range of a property's value, or `otherwise` if it has none.
    [[nodiscard]] SourceRange rangeOf(std::string_view property, SourceRange otherwise) const;
    [[nodiscard]] bool given(std::string_view property) const;
    /// Where a reference is written that a Param brought in from outside of the block's config; not known for others.
    [[nodiscard]] SourceRange givenOutside(std::string_view property) const;
};

/// An object of T with the record's values. The record's kind must have been made by kindOf<T>.
template <class T> [[nodiscard]] T fieldsFrom(const Record& record) {
    T object{};
    const std::vector<FieldInfo>& fields = descriptionOf<T>().fields();
    for (std::size_t i = 0; i < fields.size() && i < record.values.size(); ++i) {
        if (!record.values[i]) continue;
        const PropertyValue& v = record.values[i]->value;
        std::vector<const char*> texts;
        for (const std::string& text : v.texts) texts.push_back(text.c_str());
        const TrundleValue value{v.numbers.data(), texts.data(), static_cast<std::uint32_t>(v.count())};
        if (v.count() >= fields[i].minCount) fields[i].set(&object, value);
    }
    return object;
}

} // namespace trundle
