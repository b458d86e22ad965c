#include "project/edits/plan_targets.h"

#include "model/dotted_path.h"
#include "schema/allowed_parents.h"
#include "schema/value_words.h"

namespace trundle {

Result<ObjectLocation> requireChangeable(const LoadedProject& loaded, const std::string& path) {
    std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place) return Error{Code::NoSuchPath, "there is no " + path};
    if (!place->part) return Error{Code::WrongPlace, "the experiment itself is no block"};
    if (place->member && place->within.empty())
        return Error{Code::ReplaceBySingles, path + " is a member of " + place->part->title() +
                                                 " and has no text of its own; replace that by single robots first"};
    return std::move(*place);
}

bool isWithin(const SourceRange& inner, const SourceRange& outer) {
    return inner.file == outer.file && outer.range.begin <= inner.range.begin && inner.range.end <= outer.range.end;
}

Result<std::vector<Chosen>> chosen(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    std::vector<Chosen> all;
    for (const std::string& path : paths) {
        Result<ObjectLocation> place = requireChangeable(loaded, path);
        if (!place.ok()) return place.error();
        all.push_back({std::move(place).value(), path});
    }
    std::stable_sort(all.begin(), all.end(), [](const Chosen& a, const Chosen& b) {
        const SourceRange &x = a.place.part->range, &y = b.place.part->range;
        return std::tuple(x.file, x.range.begin, y.range.end) < std::tuple(y.file, y.range.begin, x.range.end);
    });
    std::vector<Chosen> kept; // outer blocks come before the blocks inside them
    for (Chosen& c : all) {
        const bool inside = std::any_of(kept.begin(), kept.end(), [&](const Chosen& k) {
            const auto& above = c.place.above;
            return isWithin(c.place.part->range, k.place.part->range) ||
                   std::find(above.begin(), above.end(), k.place.part) != above.end();
        });
        if (!inside) kept.push_back(std::move(c));
    }
    if (kept.empty()) return Error{Code::NoSuchPath, "nothing is selected"};
    return kept;
}

namespace {

/// Geoms directly in a PartConfig or Repeat are scenery; it then has no bodies, joints and devices.
bool mixesScenery(const Kind& kind, const Part& config) {
    const auto isOfRobot = [](Role role) { return role == Role::Body || role == Role::Joint || role == Role::Device; };
    return std::ranges::any_of(config.parts, [&](const Part& part) {
        if (part.isRepeat()) return mixesScenery(kind, part);
        return part.kind &&
               (kind.role == Role::Geom ? isOfRobot(part.kind->role) : isOfRobot(kind.role) && part.kind->role == Role::Geom);
    });
}

} // namespace

bool isAllowedIn(const Kind& kind, const Part* parent) {
    const bool canBeScenery = parent && (parent->block->type.text == "PartConfig" || parent->isRepeat());
    if (canBeScenery && mixesScenery(kind, *parent)) return false;
    return isAllowedInside(kind, parent ? std::string_view(parent->block->type.text) : std::string_view());
}

std::string allowedPlaces(const Kind& kind) {
    std::vector<std::string> places = allowedParents(kind);
    std::erase_if(places, [](const std::string& place) { return place == "Repeat" || place == "Ring"; }); // in the same configs
    for (std::string& place : places) place = place.empty() ? "the top level" : withArticle(place);
    const bool top = places.size() == 1 && places[0] == "the top level";
    return withArticle(kind.name) + " is allowed " + (top ? "at " : "in ") + listText(places);
}

} // namespace trundle
