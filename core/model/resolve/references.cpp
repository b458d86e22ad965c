// Checks references by name: existence and kind of the target, with suggestions.

#include <algorithm>

#include "base/spelling.h"
#include "model/dotted_path.h"
#include "model/resolve/resolve_context.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr int kMaxFollowUps = 3; ///< number of reports of one unknown name

bool kindFits(const Part& part, const std::vector<std::string>& choices) {
    if (choices.empty() || !part.kind) return true; // an unknown kind was reported already
    return std::any_of(choices.begin(), choices.end(),
                       [&](const std::string& c) { return c == part.kind->name || c == roleName(part.kind->role); });
}

bool wantsGeom(const Registry& registry, const std::vector<std::string>& choices) {
    return std::any_of(choices.begin(), choices.end(), [&](const std::string& c) {
        const Kind* kind = registry.find(c);
        return c == "Geom" || (kind && kind->role == Role::Geom);
    });
}

/// All names that the property accepts, in text order.
std::vector<std::string> fitting(const Property& property, const Part& config, bool geoms) {
    std::vector<std::string> names;
    for (const Part& part : config.parts) {
        if (part.kind && !part.name.empty() && kindFits(part, property.choices)) names.push_back(part.name);
        if (!geoms || !part.is(Role::Body)) continue;
        for (const Part& geom : part.parts) {
            if (geom.kind && kindFits(geom, property.choices)) names.push_back(part.name + "." + geom.name);
        }
    }
    if (std::count(property.choices.begin(), property.choices.end(), "world")) names.push_back("world");
    return names;
}

} // namespace

void ResolveContext::unknownReference(const std::string& property, const std::string& what, const std::string& name,
                                      SourceRange range, bool literal, const std::vector<std::string>& candidates) {
    UnknownName& unknown = m_unknownNames[what + " " + name];
    if (unknown.reports == kMaxFollowUps) {
        if (unknown.last) ++diagnostics.at(unknown.last - 1).followUps;
        return;
    }
    ++unknown.reports;
    Diagnostic& d =
        diagnostics.error(Code::UnknownReference, range, property + " names " + name + ", but there is no such " + what);
    if (&d == &diagnostics.all().back()) unknown.last = diagnostics.all().size();
    if (manyAlready(diagnostics)) return;
    std::vector<std::string> near;
    for (const std::string& candidate : candidates) { // `chassis.bumper` is suggested for `bumper`
        if (candidate.size() > name.size() && candidate.ends_with("." + name)) near.push_back(candidate);
    }
    for (std::string& word : nearestWords(name, candidates)) {
        if (!std::count(near.begin(), near.end(), word)) near.push_back(std::move(word));
    }
    if (candidates.empty()) d.message = property + " names " + name + ", but there is no " + what + " here";
    else if (near.empty())
        d.message += "; there " + std::string(candidates.size() == 1 ? "is " : "are ") + listText(candidates, "and");
    suggestWords(d, std::move(near), literal ? range : SourceRange{});
}

bool ResolveContext::checkReference(const Property& property, const std::string& name, SourceRange range, bool literal,
                                    const Part& config) {
    const std::vector<std::string>& choices = property.choices;
    if (name == "world" && std::count(choices.begin(), choices.end(), "world")) return true;
    if (std::count(choices.begin(), choices.end(), "AntennaPattern")) { // at the top level, or an antenna model
        if (outline.patterns.find(name) || antennaModelNamed(name) || outline.unknown.count(name)) return true;
        unknownReference(property.name, "AntennaPattern", name, range, literal, outline.patterns.names());
        return false;
    }
    const bool geoms = wantsGeom(registry, choices);
    const Part* part = config.find(firstWord(name));
    if (part && firstWord(name) != name) {
        if (!part->kind) return false;
        part = part->find(withoutFirstWord(name));
    }
    std::vector<std::string> kinds = choices;
    std::erase(kinds, "world");
    const std::string what = geoms ? "geom (body.geom)" : kinds.empty() ? "thing" : listText(kinds);
    if (!part) {
        unknownReference(property.name, what, name, range, literal,
                         manyAlready(diagnostics) ? std::vector<std::string>() : fitting(property, config, geoms));
        return false;
    }
    if (!part->kind) return false; // reported at its block
    if (kindFits(*part, choices)) return part->usable;
    Diagnostic& d = diagnostics.error(Code::UnknownReference, range,
                                      property.name + " names " + name + ", " + withArticle(part->kind->name) + "; it takes " +
                                          withArticle(what));
    if (manyAlready(diagnostics)) return false;
    const std::vector<std::string> candidates = fitting(property, config, geoms);
    std::vector<std::string> near;
    for (const std::string& candidate : candidates) {
        if (candidate.starts_with(name + ".")) near.push_back(candidate); // `chassis.bumper` is suggested for `chassis`
    }
    for (const std::string& word : nearestWords(name, candidates)) {
        if (!std::count(near.begin(), near.end(), word)) near.push_back(word);
    }
    if (near.empty() && !candidates.empty()) d.message += ": " + listText(candidates);
    if (near.size() > 3) near.resize(3);
    suggestWords(d, std::move(near), literal ? range : SourceRange{});
    return false;
}

bool ResolveContext::checkReferences(const Record& record, const Part& config) {
    bool good = true;
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        const Property& property = record.kind->properties[i];
        if (property.type != PropertyType::Reference || !record.values[i]) continue;
        const ResolvedValue& value = *record.values[i];
        if (value.origin == Origin::Default) continue; // an empty default means "none"
        const bool literal = record.literal[i] && value.value.texts.size() == 1;
        for (const std::string& name : value.value.texts)
            good = checkReference(property, name, value.range, literal, config) && good;
    }
    return good;
}

void ResolveContext::hintLater(const Part& found, const Part& user, SourceRange range) {
    if (found.order <= user.order || m_reportedLater[found.name]) return;
    m_reportedLater[found.name] = true;
    Diagnostic& d = diagnostics.hint(Code::DefinedLater, range, found.title() + " is defined after its first use");
    d.notes.push_back({"defined here", found.nameRange()});
}

std::uint32_t ResolveContext::lookUp(const Record& record, const Part& user, const char* key, const NameSpace& space,
                                     const std::map<std::string, std::uint32_t>& places) {
    const ResolvedValue* value = record.find(key);
    if (!value || value->value.texts.empty()) return 0;
    const std::string& name = value->value.texts[0];
    const auto it = places.find(name);
    if (it != places.end()) {
        if (const Part* part = space.find(name)) hintLater(*part, user, value->range);
        return it->second;
    }
    if (space.find(name) || outline.unknown.count(name)) return 0; // it exists but has errors of its own
    std::vector<std::string> names = manyAlready(diagnostics) ? std::vector<std::string>() : space.names();
    if (std::find(names.begin(), names.end(), "default") == names.end()) names.push_back("default");
    const bool literal = value->origin != Origin::Param;
    unknownReference(key, key, name, value->range, literal, names);
    return 0;
}

std::uint32_t ResolveContext::materialIndex(const Record& record, const Part& user) {
    return lookUp(record, user, "Material", outline.materials, materialPlaces);
}

std::uint32_t ResolveContext::surfaceIndex(const Record& record, const Part& user) {
    return lookUp(record, user, "Surface", outline.surfaces, surfacePlaces);
}

const Part* ResolveContext::configOf(const Record& record, const Part& user, std::string_view kind) {
    const ResolvedValue* value = record.find("Config");
    if (!value || value->value.texts.empty()) return nullptr;
    const std::string& name = value->value.texts[0];
    const bool literal = value->origin != Origin::Param;
    const auto names = [&] {
        std::vector<std::string> names;
        for (const Part* part : outline.configs.all())
            if (part->kind->name == kind && !manyAlready(diagnostics)) names.push_back(part->name);
        return names;
    };
    const Part* config = outline.configs.find(name);
    if (!config) {
        if (!outline.unknown.count(name)) unknownReference("Config", std::string(kind), name, value->range, literal, names());
        return nullptr;
    }
    if (config->kind->name != kind) {
        Diagnostic& d = diagnostics.error(Code::UnknownReference, value->range,
                                          "Config names " + name + ", " + withArticle(config->kind->name) + "; " +
                                              withArticle(user.kind->name) + " takes " + withArticle(kind));
        suggest(d, name, names(), literal ? value->range : SourceRange{});
        return nullptr;
    }
    hintLater(*config, user, value->range);
    return config;
}

} // namespace trundle
