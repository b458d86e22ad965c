// Overrides of instances: reset, move into the config, copy from the config.

#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "model/provenance.h"
#include "project/edits/edit_builder.h"
#include "project/edits/plan_targets.h"
#include "project/objects/name_scope.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// A property, or a Param that an instance may set.
struct OverrideTarget {
    ObjectLocation place;               ///< of the object that has the property
    std::string key;                    ///< "Resistance"
    const Property* property = nullptr; ///< nullptr: it is a Param
    const SourceParam* param = nullptr; ///< of the instance's config, or of what a Part in that uses
    bool isOfPart = false;              ///< `param`: the Part gives it its value
    std::string within;                 ///< path in the instance, "leftMotor.Resistance"; empty: not reached through an instance

    /// The instance's own assignment; nullptr if it does not override the value.
    [[nodiscard]] const SourceAssignment* override() const {
        return within.empty() || !place.instance ? nullptr : place.instance->assignments.find(within);
    }
    [[nodiscard]] const SourceAssignment* own() const { return place.part ? place.part->assignments.find(key) : nullptr; }
};

/// The override of all members of a Repeat that gives one of them its value; nullptr without one.
const SourceAssignment* overrideOfAll(const LoadedProject& loaded, const OverrideTarget& t) {
    if (t.within.empty() || t.place.members.empty() || t.override()) return nullptr;
    return overrideAt(loaded, t.place, t.key);
}

Error setForAll(const OverrideTarget& t, const SourceAssignment& a, const std::string& change) {
    return {Code::EditRefused, t.key + " of " + t.place.part->title() + " is set for all members, by " + a.key + " in " +
                                   t.place.instance->title() + "; " + change +
                                   " it there, or give this member a value of its own"};
}

std::optional<OverrideTarget> targetOf(const LoadedProject& loaded, const std::string& path) {
    OverrideTarget t;
    t.key = lastWord(path);
    if (t.key == path) {
        const Kind* settings = loaded.registry->find("settings");
        t.property = settings ? settings->find(t.key) : nullptr;
        return t.property ? std::optional(t) : std::nullopt;
    }
    const std::optional<ObjectLocation> place = placeOf(loaded, withoutLastWord(path));
    if (!place || !place->part) return std::nullopt;
    t.place = *place;
    t.property = place->part->kind ? place->part->kind->find(t.key) : nullptr;
    const Part* config = place->instance ? configOf(loaded, *place->instance) : nullptr;
    const bool self = place->part == place->instance;
    if (self && !t.property && config) {
        t.param = config->param(t.key);
        if (!t.param) t.property = config->kind->find(t.key);
        if (!t.param && !t.property) return std::nullopt;
        t.within = t.key;
        t.place.part = config;
    } else if (place->instance && !self && std::ranges::find(place->above, config) != place->above.end()) {
        t.within = place->within + "." + t.key;
    }
    if (!self && !t.property && place->part->isPartUse() && place->part->config) {
        t.param = place->part->config->param(t.key);
        t.isOfPart = t.param != nullptr;
        if (!t.param) t.property = place->part->config->kind->find(t.key);
    }
    return t.property || t.param ? std::optional(t) : std::nullopt;
}

/// Whether every Param that a value uses means the same at the top level, so that the value can be moved anywhere.
bool isInScope(const LoadedProject& loaded, const Part& instance, const Part& config, const Value& value) {
    const NameScope globals(loaded.outline->texts(), loaded.trees[0]->items(), 0, nullptr);
    const auto same = [&](const std::string& name) {
        const bool here = instance.param(name) || config.param(name);
        return !here && globals.find(name).item;
    };
    const auto inside = [&](const auto& self, const Expression& e) -> bool {
        if (e.op == Expression::Op::Name && e.name != "pi" && !same(e.name)) return false;
        return std::all_of(e.arguments.begin(), e.arguments.end(), [&](const Expression& a) { return self(self, a); });
    };
    return std::all_of(value.elements.begin(), value.elements.end(), [&](const Element& e) {
        if (e.kind == Element::Kind::ParamRef) return same(e.text);
        return !e.expression || inside(inside, *e.expression);
    });
}

/// The value as text for another block: as written if it means the same there, else evaluated.
Result<std::string> textElsewhere(const LoadedProject& loaded, const OverrideTarget& t, const SourceAssignment& a) {
    const Part* config = configOf(loaded, *t.place.instance);
    if (config && isInScope(loaded, *t.place.instance, *config, *a.value))
        return std::string(loaded.outline->texts().slice(a.valueRange()));
    const bool isInPart = t.place.instance->isPartUse() || std::ranges::any_of(t.place.above, &Part::isPartUse);
    if (isInPart && t.property && t.property->type == PropertyType::Reference) // what a Param names may be outside of the Part
        return Error{Code::UnknownParam, t.key + " is worked out from other Params; set it by hand"};
    const std::optional<PropertyValue> value = t.property ? valueAt(loaded, t.place, t.key) : std::nullopt;
    if (!value) return Error{Code::UnknownParam, t.key + " uses Params that are not known there"};
    return valueText(*t.property, *value);
}

/// The text with the line ends of the target file.
std::string inFile(const LoadedProject& loaded, FileId file, const std::string& text) {
    const std::string lineEnd = editStyle(*loaded.trees[file]).lineEnd;
    std::string out;
    for (const char c : dedented(text, 0)) out += c == '\n' ? lineEnd : std::string(1, c);
    return out;
}

SourceRange itemRange(const SourceAssignment& a) { return {a.file, {a.path.front().range.begin, a.value->range.end}}; }

bool fromCommandLine(const LoadedProject& loaded, const SourceAssignment& a) {
    return loaded.outline->texts().commandLine(a.file);
}

/// Whether the property is required, by itself or as the last of its alternatives.
bool isRequired(const OverrideTarget& t) {
    const bool isOwn = t.isOfPart ? !t.override() : t.param != nullptr; // the value of a Part, not one above it
    if (t.param && t.param->required && t.param->value->elements.empty()) return isOwn;
    if (!t.property || t.override()) return false;
    const Kind* kind = t.place.part ? t.place.part->kind : nullptr;
    if (t.property->required || !kind) return t.property->required;
    return std::any_of(kind->alternatives.begin(), kind->alternatives.end(), [&](const Alternatives& choice) {
        const auto given = [&](const std::string& name) { return t.place.part->assignments.find(name) != nullptr; };
        return std::count(choice.names.begin(), choice.names.end(), t.key) &&
               std::count_if(choice.names.begin(), choice.names.end(), given) == 1;
    });
}

} // namespace

Result<EditPlan> planReset(const LoadedProject& loaded, const std::vector<std::string>& propertyPaths) {
    EditBuilder sheet(loaded);
    bool any = false;
    Error reason{Code::NoSuchPath, "nothing is set here"};
    for (const std::string& path : propertyPaths) {
        const std::optional<OverrideTarget> t = targetOf(loaded, path);
        if (!t) return Error{Code::NoSuchPath, "there is no property " + path};
        const SourceAssignment* a = !t->within.empty() ? t->override()
                                    : t->place.part    ? t->own()
                                                       : loaded.outline->settings.find(t->key);
        if (!a || fromCommandLine(loaded, *a)) {
            const SourceAssignment* all = overrideOfAll(loaded, *t);
            const std::string none = t->within.empty() ? t->key + " has its default already"
                                                       : t->key + " has no value of its own in " + t->place.instance->title();
            reason = all ? setForAll(*t, *all, "reset") : Error{Code::NoSuchPath, none};
            continue;
        }
        if (isRequired(*t)) {
            reason = {Code::MissingRequired, t->key + " of " + (t->place.part ? t->place.part->title() : "the experiment") +
                                                 " must be given, it has no default"};
            continue;
        }
        sheet.removeItem(itemRange(*a));
        any = true;
    }
    if (!any) return reason;
    return sheet.plan({});
}

Result<EditPlan> planPushOverride(const LoadedProject& loaded, const std::string& propertyPath) {
    const std::optional<OverrideTarget> t = targetOf(loaded, propertyPath);
    if (!t) return Error{Code::NoSuchPath, "there is no property " + propertyPath};
    if (const SourceAssignment* all = overrideOfAll(loaded, *t)) return setForAll(*t, *all, "push");
    const SourceAssignment* a = t->override();
    if (!a || fromCommandLine(loaded, *a))
        return Error{Code::NoSuchPath, propertyPath + " is no override: there is nothing to be moved into a config"};
    const Result<std::string> text = textElsewhere(loaded, *t, *a);
    if (!text.ok()) return text.error();
    EditBuilder sheet(loaded);
    const auto set = [&](FileId file, const Value& value) {
        sheet.add(editSetValue(*loaded.trees[file], value, inFile(loaded, file, text.value())));
    };
    if (t->param && !t->isOfPart && t->param->required)
        sheet.add(editAddParam(*loaded.trees[t->place.part->file], *t->place.part->block, t->key,
                               inFile(loaded, t->place.part->file, text.value())));
    else if (t->param && !t->isOfPart) set(t->param->valueFile, *t->param->value);
    else if (const SourceAssignment* own = t->own()) set(own->file, *own->value);
    else
        sheet.addAssignment(t->place.part->file, t->place.part->block, t->key, inFile(loaded, t->place.part->file, text.value()));
    sheet.removeItem(itemRange(*a));
    return sheet.plan({});
}

Result<EditPlan> planPullOverride(const LoadedProject& loaded, const std::string& propertyPath) {
    const std::optional<OverrideTarget> t = targetOf(loaded, propertyPath);
    if (!t) return Error{Code::NoSuchPath, "there is no property " + propertyPath};
    if (t->within.empty()) return Error{Code::NoSuchPath, propertyPath + " comes from no config"};
    const Part& instance = *t->place.instance;
    if (t->override()) return Error{Code::DuplicateKey, t->key + " is set in " + instance.title() + " already"};
    std::string text;
    const SourceAssignment* own = t->own();
    if (t->param && !(t->isOfPart && own)) {
        const Value& value = *t->param->value;
        const bool plain = std::all_of(value.elements.begin(), value.elements.end(), [](const Element& e) {
            return e.kind != Element::Kind::ParamRef && e.kind != Element::Kind::Expression;
        });
        if (!plain) return Error{Code::UnknownParam, t->key + " is worked out from other Params; set it by hand"};
        if (value.elements.empty()) return Error{Code::MissingValue, t->key + " has no value that could be copied"};
        text = loaded.outline->texts().slice({t->param->valueFile, value.range});
    } else if (own) {
        const Result<std::string> there = textElsewhere(loaded, *t, *own);
        if (!there.ok()) return there.error();
        text = there.value();
    } else if (t->property->defaultValue && t->property->defaultValue->count() > 0) {
        text = valueText(*t->property, *t->property->defaultValue);
    } else {
        return Error{Code::MissingValue, t->key + " has no value that could be copied"};
    }
    EditBuilder sheet(loaded);
    sheet.addAssignment(instance.file, instance.block, t->within, inFile(loaded, instance.file, text));
    return sheet.plan({});
}

} // namespace trundle
