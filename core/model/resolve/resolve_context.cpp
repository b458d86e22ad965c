#include "model/resolve/resolve_context.h"

#include <algorithm>

#include "base/spelling.h"
#include "lang/tree_edit.h"
#include "model/config_blocks.h"
#include "model/robot_path.h"
#include "schema/foreign_words.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// A help text in brackets for a message: " (full lengths along x, y and z)".
std::string inBrackets(std::string help) {
    if (help.empty()) return help;
    if (help.back() == '.') help.pop_back();
    if (help.size() > 1 && help[1] >= 'a' && help[1] <= 'z')
        help[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(help[0])));
    return " (" + help + ")";
}

/// The range of each of several names of a value.
std::vector<SourceRange> namesIn(const GivenValue& given, std::size_t count) {
    std::vector<SourceRange> names;
    if (count > 1 && count == given.elements.size())
        for (const GivenElement& element : given.elements) names.push_back(element.range);
    return names;
}

/// A Param that is written without its `$`.
void suggestParam(Diagnostic& d, const GivenValue& given, ParamScope& scope) {
    const auto word = std::ranges::find_if(given.elements, [&](const GivenElement& e) {
        return e.kind == GivenElement::Kind::Word && e.range == d.range && scope.has(e.text);
    });
    if (word == given.elements.end() || !d.suggestions.empty()) return;
    d.message += "; the Param of that name is $" + word->text;
    suggestWords(d, {"$" + word->text}, d.range);
}

} // namespace

ComponentSpec componentFrom(const Record& record, const Part& part) {
    ComponentSpec spec;
    spec.kind = part.kind->name;
    spec.name = part.name;
    spec.range = part.range;
    spec.nameRange = part.nameRange();
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        if (record.values[i]) spec.values.emplace(part.kind->properties[i].name, *record.values[i]);
    }
    return spec;
}

void ResolveContext::fixAdd(Diagnostic& d, const Part& part, const std::string& key, const std::string& value) {
    if (manyAlready(diagnostics)) return;
    d.fixes.push_back({key + "=" + value, {editAddAssignment(*texts.trees[part.file], part.block, key, value)}});
    d.suggestions.push_back(key + "=" + value);
}

Record ResolveContext::read(const Part& part, ParamScope& scope, const OverrideNode* overrides, Origin origin,
                            const ExtraKeys& extra) {
    Record record;
    ++reads;
    record.kind = part.kind;
    fill(record, part.assignments, &part, scope, overrides, origin, extra);
    return record;
}

Record ResolveContext::readSettings() {
    Record record;
    record.kind = registry.find("settings");
    if (record.kind) fill(record, outline.settings, nullptr, globals, nullptr, Origin::Config, {});
    return record;
}

std::optional<ResolvedValue> ResolveContext::readGiven(const Property& property, const GivenValue& given, Origin origin) {
    std::optional<PropertyValue> value = readValue(property, given, diagnostics);
    if (!value) return std::nullopt;
    origin = texts.commandLine(given.range.file) ? Origin::CommandLine : given.fromParam ? Origin::Param : origin;
    std::vector<SourceRange> names = namesIn(given, value->texts.size());
    return ResolvedValue{std::move(*value), given.range, origin, std::move(names)};
}

void ResolveContext::fill(Record& record, const AssignmentList& assignments, const Part* part, ParamScope& scope,
                          const OverrideNode* overrides, Origin origin, const ExtraKeys& extra) {
    const std::vector<Property>& properties = record.kind->properties;
    record.values.resize(properties.size());
    record.literal.resize(properties.size(), false);
    std::vector<bool> validated(properties.size(), false);
    UnknownKeys unknown;
    for (const SourceAssignment& a : assignments.all()) {
        const auto it = std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == a.key; });
        if (it == properties.end()) {
            if (extra.take && extra.take(a)) continue;
            if (a.path.size() > 1 && part && part->is(Role::Config) && isBaseMissing(*part)) continue; // it is for what that has
            unknownKey(*record.kind, a, part ? part->title() : std::string(), extra.words, unknown);
            continue;
        }
        const std::size_t i = static_cast<std::size_t>(it - properties.begin());
        validated[i] = true;
        if (const OverrideNode* node = below(overrides, a.key); node && node->value) continue; // the instance overrides it
        const std::optional<GivenValue> given = evaluator.evaluate(*a.value, a.file, scope);
        const std::size_t before = diagnostics.all().size();
        if (given) record.values[i] = readGiven(properties[i], *given, origin);
        if (given && diagnostics.all().size() > before) suggestParam(diagnostics.at(before), *given, scope);
        if (!record.values[i]) record.complete = false;
        else record.literal[i] = !given->fromParam;
        if (given && given->fromParam && properties[i].type == PropertyType::Reference) record.names.emplace(i, *given);
    }
    for (std::size_t i = 0; i < properties.size(); ++i) {
        const Property& p = properties[i];
        if (const OverrideNode* node = below(overrides, p.name); node && node->value) {
            validated[i] = true;
            record.values[i] = readGiven(p, *node->value, node->origin);
            if (!record.values[i]) record.complete = false;
            if (p.type == PropertyType::Reference) record.names.emplace(i, *node->value);
        }
        if (record.values[i]) continue;
        if (p.defaultValue)
            record.values[i] =
                ResolvedValue{*p.defaultValue, {}, Origin::Default}; // also for an invalid value: others are still checked
        if (!p.required || record.values[i]) continue;
        record.complete = false;
        if (!validated[i] && part && !brokenText(part->range)) reportMissing(*part, p, unknown);
    }
    if (part) checkAlternatives(record, *part, validated, unknown.meant);
}

/// A required property: by itself, or as what a key that is unknown was meant to be.
void ResolveContext::reportMissing(const Part& part, const Property& property, UnknownKeys& unknown) {
    if (std::count(unknown.meant.begin(), unknown.meant.end(), property.name)) return;
    const auto isMisplacedInIt = [&](const Diagnostic& d) {
        return d.code == Code::WrongPlace && d.range.file == part.range.file && d.range.range.begin > part.range.range.begin &&
               d.range.range.end <= part.range.range.end;
    };
    // A Static with geoms is meant as a StaticConfig.
    if (property.name == "Config" && std::ranges::any_of(diagnostics.all(), isMisplacedInIt)) return;
    if (!unknown.stranger) {
        diagnostics.error(Code::MissingRequired, part.nameRange(),
                          part.title() + " needs " + property.name + inBrackets(property.help));
        return;
    }
    unknown.missing.push_back(property.name);
    std::string& message = diagnostics.at(*unknown.stranger).message;
    const std::size_t end = message.find(unknown.missing.size() > 1 ? "; it needs " : "; it has ");
    message = message.substr(0, end) + "; it needs " + listText(unknown.missing, "and");
}

void ResolveContext::unknownKey(const Kind& kind, const SourceAssignment& a, const std::string& title,
                                const std::vector<std::string>& more, UnknownKeys& unknown) {
    if (a.path.size() > 1) {
        Diagnostic& d =
            diagnostics.error(Code::NoSuchPath, a.keyRange(),
                              title.empty() ? "a path is set inside its Robot, Static, Grid or Scatter, not at the top level"
                                            : "a path cannot be set in " + title + "; instances set paths into their config");
        const Part* thing = title.empty() ? outline.world.find(a.path[0].text) : nullptr;
        if (thing && !texts.commandLine(a.file)) {
            const std::string rest = a.key.substr(a.path[0].text.size() + 1);
            d.message = "write " + rest + " = ... inside " + thing->title();
        }
        return;
    }
    std::vector<std::string> words = propertyNames(kind);
    words.insert(words.end(), more.begin(), more.end());
    std::string message = title.empty() ? "there is no setting " + a.key : title + " has no property " + a.key;
    std::vector<std::string> near;
    if (!manyAlready(diagnostics)) near = meantWords(a.key, words);
    if (near.empty() && !words.empty()) message += "; it has " + listText(words, "and", 20);
    if (near.empty() && title.empty()) message = "there is no setting " + a.key + "; there are " + listText(words, "and", 20);
    if (!near.empty()) unknown.meant.push_back(near.front());
    const std::size_t at = diagnostics.all().size();
    Diagnostic& d = diagnostics.error(Code::UnknownKey, a.keyRange(), message);
    if (near.empty() && !unknown.stranger && diagnostics.all().size() > at) unknown.stranger = at;
    suggestWords(d, std::move(near), a.keyRange());
}

bool ResolveContext::isFailedRobot(std::string_view path) const {
    return !shortestStart(path, [&](std::string_view name) {
                const Part* part = outline.world.find(name);
                if (!part) part = layoutOfMember(outline, name);
                return part && failedRobots.contains(part);
            }).empty();
}

} // namespace trundle
