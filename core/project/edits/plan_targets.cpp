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

std::vector<SourceRange> rangesOf(const std::vector<Chosen>& chosen) {
    std::vector<SourceRange> ranges;
    for (const Chosen& c : chosen) ranges.push_back(c.place.part->range);
    return ranges;
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

void HeldBlocks::add(const Kind& kind) {
    m_scenery = m_scenery || kind.role == Role::Geom;
    m_robot = m_robot || kind.role == Role::Body || kind.role == Role::Joint || kind.role == Role::Device;
}

void HeldBlocks::add(const Part& block) {
    m_hasPart = m_hasPart || block.isPartUse();
    if (block.isRepeat() || block.isPartUse()) visit(block);
    else if (block.is(Role::Config)) visit(block);
    else if (block.kind) add(*block.kind);
}

void HeldBlocks::visit(const Part& holder) {
    if (!m_reached.insert(&holder).second) return;
    m_scenery = m_scenery || (holder.kind && holder.kind->name == "StaticConfig");
    m_isRobot = m_isRobot || (holder.kind && holder.kind->name == "RobotConfig");
    m_robot = m_robot || m_isRobot;
    if (holder.config) visit(*holder.config);
    for (const Part& part : holder.parts) add(part);
}

void HeldBlocks::add(const LoadedProject& loaded, const BlockItem& block, const std::vector<const BlockItem*>& others) {
    const Kind* kind = loaded.registry->find(block.type.text);
    if (!kind) return;
    const bool isPart = kind->name == "Part";
    m_hasPart = m_hasPart || isPart;
    if (!isPart && kind->role != Role::Repeat && kind->role != Role::Config) return add(*kind);
    for (const Item& item : block.items) {
        if (const auto* inner = item.as<BlockItem>()) add(loaded, *inner, others);
        const auto* a = item.as<AssignmentItem>();
        if (!a || !isPart || a->path.size() != 1 || a->path[0].text != "Config" || a->value.elements.empty()) continue;
        const std::string& name = a->value.elements[0].text;
        const auto given = std::ranges::find_if(
            others, [&](const BlockItem* b) { return b->type.text == "PartConfig" && b->name && b->name->text == name; });
        std::vector<const BlockItem*> rest = others; // each is visited once on the way down
        if (given != others.end()) {
            std::erase(rest, *given);
            add(loaded, **given, rest);
        } else if (const Part* config = loaded.outline->configs.find(name)) {
            visit(*config);
        }
    }
}

bool HeldBlocks::mixesWith(const HeldBlocks& other) const {
    return (m_scenery && other.m_robot) || (m_robot && other.m_scenery);
}

Status HeldBlocks::fitsIn(const LoadedProject& loaded, const Part& config, const std::string& title) const {
    if (m_reached.contains(&config))
        return Error{Code::WrongPlace, title + " uses " + config.title() + ", which cannot contain itself"};
    for (const Part* user : loaded.outline->configs.all()) {
        HeldBlocks there;
        there.add(*user);
        if (!there.m_reached.contains(&config) || !m_scenery || !there.m_isRobot) continue;
        const std::string where = " cannot be in " + config.title() + (user == &config ? "" : ", used by " + user->title());
        return Error{Code::WrongPlace, title + where + ": its geoms have no Body, which scenery only can do without"};
    }
    return {};
}

bool HeldBlocks::fitInBody(const Kind& kind) const {
    return isAllowedInside(kind, "Body") && !m_robot && !m_hasPart;
}

bool isAllowedIn(const Kind& kind, const Part* parent) {
    if (parent && parent->isRepeat()) {
        const bool isOfConfig = isAllowedInside(kind, "RobotConfig") || isAllowedInside(kind, "StaticConfig");
        if (parent->isInWorld ? !isAllowedInside(kind, {}) : !isOfConfig) return false;
    }
    const bool canBeScenery = parent && !parent->isInWorld && (parent->block->type.text == "PartConfig" || parent->isRepeat());
    if (canBeScenery) {
        HeldBlocks here, added;
        here.add(*parent);
        added.add(kind);
        if (here.mixesWith(added)) return false;
    }
    return isAllowedInside(kind, parent ? std::string_view(parent->block->type.text) : std::string_view());
}

std::string allowedPlaces(const Kind& kind) {
    std::vector<std::string> places = allowedParents(kind);
    std::erase_if(places, [](const std::string& place) { return place == "Repeat" || place == "Ring"; }); // in the same configs
    for (std::string& place : places) place = place.empty() ? "the top level" : withArticle(place);
    const bool top = places.size() == 1 && places[0] == "the top level"; // or in a Repeat there
    return withArticle(kind.name) + " is allowed " + (top ? "at " : "in ") + listText(places);
}

} // namespace trundle
