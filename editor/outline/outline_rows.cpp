#include "editor/outline/outline_rows.h"

#include <algorithm>
#include <cctype>
#include <unordered_set>

#include "editor/outline/row_blocks.h"
#include "editor/outline/row_members.h"
#include "model/config_blocks.h"
#include "model/passive_objects.h"
#include "project/loading/search.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool contains(std::string_view text, std::string_view word) {
    return std::search(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) { return small(a) == b; }) !=
           text.end();
}

std::vector<std::string> wordsOf(const std::string& filter) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : filter + ' ') {
        if (!std::isspace(static_cast<unsigned char>(c))) word += small(c);
        else if (!word.empty()) words.push_back(std::move(word)), word.clear();
    }
    return words;
}

bool holdsScenery(const Part& layout, const Part* config) {
    return layout.is(Role::Layout) && config && config->kind->name == "StaticConfig";
}

OutlineGroup plainGroupOf(const Part& part) {
    if (!part.usable || !part.kind) return OutlineGroup::Misplaced;
    switch (part.kind->role) {
    case Role::Instance: return part.kind->name == "Static" ? OutlineGroup::Scenery : OutlineGroup::Robots;
    case Role::Repeat: // without blocks
    case Role::Layout: return OutlineGroup::Robots;
    case Role::Joint: return OutlineGroup::Joints;
    case Role::Region: return OutlineGroup::Regions;
    case Role::Look: return OutlineGroup::Looks;
    case Role::Medium:
    case Role::Pattern: return OutlineGroup::Radio;
    case Role::Log: return OutlineGroup::Logs;
    case Role::Config:
        return part.kind->name == "StaticConfig" ? OutlineGroup::StaticConfigs
               : part.kind->name == "PartConfig" ? OutlineGroup::PartConfigs
                                                 : OutlineGroup::RobotConfigs;
    case Role::Material: return OutlineGroup::Materials;
    case Role::Surface: return OutlineGroup::Surfaces;
    default: return OutlineGroup::Misplaced;
    }
}

constexpr std::array<const char*, kOutlineGroups> kGroupNames{
    "Robots",  "Objects",       "Scenery",         "Joints",       "Regions",   "Light and views", "Radio",    "Logs",
    "Modules", "Robot configs", "Scenery configs", "Part configs", "Materials", "Surfaces",        "Misplaced"};
constexpr std::size_t kMaxBeside = 100; // members below one row; more are split into ranges

/// "10×10" from `Count = 10, 10`.
std::string countOf(const LoadedProject& loaded, const Part& layout) {
    const SourceAssignment* a = layout.assignments.find("Count");
    if (!a) return {};
    std::string text;
    for (const char c : loaded.sources.slice(a->valueRange())) {
        if (c == ',') text += "×";
        else if (!std::isspace(static_cast<unsigned char>(c))) text += c;
    }
    return text.size() < 24 ? text + " " : std::string();
}

/// What an instance names as its config, as written; its kind if it names none.
std::string configText(const LoadedProject& loaded, const Part& instance) {
    const SourceAssignment* a = instance.assignments.find("Config");
    return a ? std::string(loaded.sources.slice(a->valueRange())) : instance.kind->name;
}

std::string fileName(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

/// Adds the blocks inside that are from another file than the block around them.
void gather(const std::vector<Part>& parts, FileId around, std::unordered_map<FileId, std::vector<const Part*>>& blocks) {
    for (const Part& part : parts) {
        if (part.file != around) blocks[part.file].push_back(&part);
        gather(part.parts, part.file, blocks);
    }
}

void nameRow(OutlineRow& row, const Part& part, const OutlineRow& above, const Outline& outline) {
    const std::string& type = part.block->type.text;
    row.name = part.name.empty() ? type : part.name;
    row.detail = part.name.empty() ? "" : type;
    row.key = row.name + (part.name.empty() ? "{}" : "");
    if (part.name.empty() || !part.usable) return;
    if (above.type == OutlineRow::Type::Object && above.selectable) {
        row.path = above.path + "." + part.name;
        row.selectable = true;
    } else if (above.type != OutlineRow::Type::Object && part.kind && outline.spaceOf(*part.kind)) {
        const bool world = outline.spaceOf(*part.kind) == &outline.world;
        row.path = (world ? std::string() : part.kind->name + ".") + part.name;
        row.key = row.path;
        row.selectable = true;
    }
}

} // namespace

OutlineRows::OutlineRows(std::shared_ptr<const LoadedProject> loaded, OutlineMode mode, const std::string& filter,
                         std::string model)
    : m_loaded(std::move(loaded)), m_mode(mode), m_model(std::move(model)), m_words(wordsOf(filter)), m_problems(*m_loaded) {
    for (const auto& part : m_loaded->outline->parts) {
        m_groups[std::size_t(groupOf(*part))].push_back(part.get());
        m_blocks[part->file].push_back(part.get());
        gather(part->parts, part->file, m_blocks);
    }
    m_members = membersOf(*m_loaded);
    for (const MaterialSpec& material : m_loaded->experiment->materials) m_materials.emplace(material.name, &material);
}

OutlineGroup OutlineRows::groupOf(const Part& part) const {
    if (part.isRepeat() && !part.parts.empty()) return groupOf(part.parts.front());
    const Part* config = configOf(*m_loaded, part);
    const OutlineGroup group = holdsScenery(part, config) ? OutlineGroup::Scenery : plainGroupOf(part);
    return group == OutlineGroup::Robots && isPassive(part, config) ? OutlineGroup::Objects : group;
}

std::vector<OutlineRow> OutlineRows::top() const {
    Rows rows;
    const OutlineRow none;
    if (!m_model.empty()) {
        const auto place = placeOf(*m_loaded, m_model);
        if (place && place->part) keep(rows, partRow(*place->part, groupRow(groupOf(*place->part))), none);
        return rows;
    }
    if (m_mode == OutlineMode::ByFile) {
        for (FileId file = 0; file < m_loaded->trees.size(); ++file)
            if (!m_loaded->paths[file].empty()) keep(rows, fileRow(file), none);
        return rows;
    }
    keep(rows, experimentRow(), none);
    for (std::size_t group = 0; group < kOutlineGroups; ++group)
        if (const OutlineRow row = groupRow(static_cast<OutlineGroup>(group)); row.hasRows) keep(rows, row, none);
    return rows;
}

std::vector<OutlineRow> OutlineRows::below(const OutlineRow& row) const {
    Rows rows;
    switch (row.type) {
    default: break;
    case OutlineRow::Type::File: rows = fileBlocks(row); break;
    case OutlineRow::Type::Group:
        for (const Part* part : m_groups[std::size_t(row.group)]) keep(rows, partRow(*part, row), row);
        if (row.group == OutlineGroup::Modules) addModules(rows, row);
        break;
    case OutlineRow::Type::Members: addMembers(rows, row, row.first, row.last); break;
    case OutlineRow::Type::Object:
        if (const auto members = m_members.find(row.part); members != m_members.end() && !row.member && !row.reached)
            keep(rows, membersRow(row, members->second.first, members->second.second, true), row);
        addParts(rows, row);
    }
    std::unordered_set<std::string> keys; // duplicate names in an invalid text still get separate rows
    for (OutlineRow& r : rows)
        for (int n = 2; !keys.insert(r.key).second; ++n) r.key += "#" + std::to_string(n);
    return rows;
}

bool OutlineRows::relink(OutlineRow& row, const OutlineRow& above, std::size_t index) const {
    const auto& modules = m_loaded->experiment->modules;
    const auto linkTo = [&](const Part* part) {
        if (!part || row.name != (part->name.empty() ? part->block->type.text : part->name)) return false;
        row.part = part;
        row.range = part->range;
        if (row.config) row.config = configOf(*m_loaded, *part);
        return true;
    };
    const auto link = [&](const std::vector<const Part*>& parts, std::size_t at) {
        return linkTo(at < parts.size() ? parts[at] : nullptr);
    };
    switch (above.type) {
    case OutlineRow::Type::Experiment:
    case OutlineRow::Type::Module: return true;
    case OutlineRow::Type::Group:
        if (row.type != OutlineRow::Type::Module) return link(m_groups[std::size_t(above.group)], index);
        if (index >= modules.size()) return false;
        row.range = modules[index].range;
        return true;
    case OutlineRow::Type::File: {
        for (const ModuleSpec& module : modules) { // their rows come first
            if (module.range.file != above.file) continue;
            if (index-- > 0) continue;
            row.range = module.range;
            return true;
        }
        return m_blocks.contains(above.file) && link(m_blocks.at(above.file), index);
    }
    case OutlineRow::Type::Object:
        if (row.type != OutlineRow::Type::Members) {
            if (m_members.contains(above.part) && !above.member && !above.reached) --index; // the row of its members
            const auto blocks = blocksBelow(*above.part, above.config, above.reached);
            return linkTo(index < blocks.size() ? blocks[index].first : nullptr);
        }
        [[fallthrough]];
    case OutlineRow::Type::Members: row.part = above.part, row.config = above.config, row.range = above.range; return true;
    }
    return false;
}

OutlineRow OutlineRows::renewed(const OutlineRow& row, const OutlineRow& above) const {
    OutlineRow now = partRow(*row.part, above);
    now.key = row.key;
    if (above.type == OutlineRow::Type::Object) now.reached = row.reached, now.markable = row.markable;
    return now;
}

void OutlineRows::addParts(Rows& rows, const OutlineRow& above) const {
    for (const auto& [inner, isReached] : blocksBelow(*above.part, above.config, above.reached)) {
        OutlineRow row = partRow(*inner, above);
        row.reached = isReached;
        row.markable = above.markable && row.selectable && (inner->is(Role::Body) || inner->is(Role::Geom));
        keep(rows, std::move(row), above);
    }
}

/// Adds at most a hundred rows: members, or ranges of members if there are more.
void OutlineRows::addMembers(Rows& rows, const OutlineRow& above, std::size_t first, std::size_t last) const {
    std::size_t stretch = 1;
    while ((last - first + stretch - 1) / stretch > kMaxBeside) stretch *= kMaxBeside;
    for (std::size_t i = first; i < last; i += stretch)
        keep(rows, stretch == 1 ? memberRow(above, i) : membersRow(above, i, std::min(last, i + stretch), false), above);
}

OutlineRow OutlineRows::membersRow(const OutlineRow& above, std::size_t first, std::size_t last, bool all) const {
    const ExperimentSpec& e = *m_loaded->experiment;
    OutlineRow row;
    row.type = OutlineRow::Type::Members;
    row.part = above.part;
    row.config = above.config;
    row.passive = above.passive;
    row.markable = above.markable;
    row.range = above.range;
    row.first = first;
    row.last = last;
    row.hasRows = last > first;
    row.name = all ? "Members" : nameOfMember(e, first) + " … " + nameOfMember(e, last - 1);
    row.key = all ? "members" : "members " + std::to_string(first - m_members.at(above.part).first);
    row.detail = std::to_string(last - first);
    row.tip = "They have no text of their own: replace the " + (above.part->kind ? above.part->kind->name : "Grid") +
              " by single instances to change one of them.";
    return row;
}

OutlineRow OutlineRows::memberRow(const OutlineRow& above, std::size_t member) const {
    OutlineRow row;
    row.name = row.key = row.path = nameOfMember(*m_loaded->experiment, member);
    row.member = row.selectable = true;
    row.passive = above.passive;
    row.markable = above.markable;
    row.part = above.part;
    row.config = above.config;
    row.range = above.range;
    row.detail = row.config ? row.config->name : "";
    row.hasRows = row.config && (isVariant(*row.config) || !row.config->parts.empty());
    row.tip = row.name + ", a member of " + above.part->title();
    return row;
}

OutlineRow OutlineRows::experimentRow() const {
    OutlineRow row;
    row.type = OutlineRow::Type::Experiment;
    row.key = "experiment";
    row.selectable = true;
    const std::string& title = m_loaded->experiment->settings.title;
    row.name = title.empty() ? fileName(m_loaded->sources[0].text->path()) : title;
    row.detail = "settings";
    row.range = {0, {0, 0}};
    row.problems = m_problems.outside(*m_loaded);
    row.tip = "Settings of the experiment: tick, duration, gravity ...";
    return row;
}

OutlineRow OutlineRows::groupRow(OutlineGroup group) const {
    OutlineRow row;
    row.type = OutlineRow::Type::Group;
    row.group = group;
    row.key = row.name = kGroupNames[std::size_t(group)];
    const bool modules = group == OutlineGroup::Modules;
    const std::size_t count = modules ? m_loaded->experiment->modules.size() : m_groups[std::size_t(group)].size();
    row.hasRows = count > 0;
    row.detail = std::to_string(count);
    for (const Part* part : m_groups[std::size_t(group)]) row.problems.add(m_problems.of(*part));
    for (const ModuleSpec& module : m_loaded->experiment->modules)
        if (modules) row.problems.add(m_problems.at(module.range));
    return row;
}

OutlineRow OutlineRows::fileRow(FileId file) const {
    OutlineRow row;
    row.type = OutlineRow::Type::File;
    row.file = file;
    row.key = m_loaded->paths[file];
    const std::string shown = row.key.empty() ? m_loaded->sources[file].text->path()
                                              : shownInProject(row.key, m_loaded->projectFolder); // "robots/amr.sim"
    row.name = fileName(shown);
    row.detail = shown.substr(0, shown.size() - row.name.size());
    if (!row.detail.empty()) row.detail.pop_back();
    row.range = {file, {0, 0}};
    row.tip = row.key;
    row.problems = m_problems.ofFile(file);
    const auto blocks = m_blocks.find(file);
    row.hasRows = blocks != m_blocks.end();
    for (const ModuleSpec& module : m_loaded->experiment->modules) row.hasRows |= module.range.file == file;
    return row;
}

std::vector<OutlineRow> OutlineRows::fileBlocks(const OutlineRow& above) const {
    Rows rows;
    addModules(rows, above);
    if (const auto blocks = m_blocks.find(above.file); blocks != m_blocks.end())
        for (const Part* part : blocks->second) keep(rows, partRow(*part, above), above);
    return rows;
}

void OutlineRows::addModules(Rows& rows, const OutlineRow& above) const {
    for (const ModuleSpec& module : m_loaded->experiment->modules) {
        if (above.type == OutlineRow::Type::File && module.range.file != above.file) continue;
        OutlineRow row;
        row.type = OutlineRow::Type::Module;
        row.key = module.written;
        row.name = fileName(module.written);
        row.detail = module.library.empty() ? "not loaded" : "";
        row.range = module.range;
        row.tip = module.library.empty() ? module.written : module.library;
        row.problems = m_problems.at(module.range);
        keep(rows, std::move(row), above);
    }
}

OutlineRow OutlineRows::partRow(const Part& part, const OutlineRow& above) const {
    OutlineRow row;
    row.part = &part;
    row.range = part.range;
    row.problems = m_problems.of(part);
    nameRow(row, part, above, *m_loaded->outline);
    const bool instance = isPlaced(part);
    row.hasRows = !part.parts.empty() || isVariant(part);
    row.markable = instance && part.usable;
    if (!part.kind) return row;
    row.tip = part.kind->name + ": " + part.kind->help;
    if (instance) {
        const Part* config = configOf(*m_loaded, part);
        row.detail =
            (part.is(Role::Layout) ? countOf(*m_loaded, part) : "") + (config ? config->name : configText(*m_loaded, part));
        // A config that contains an instance of itself (an error) would recurse without end.
        const bool isEndless = above.type == OutlineRow::Type::Object && !part.isPartUse() && !above.part->isInWorld;
        if (m_mode == OutlineMode::ByOwner && !isEndless) row.config = config;
        row.hasRows |= row.config && (isVariant(*row.config) || !row.config->parts.empty());
        row.hasRows |= m_members.contains(&part);
        row.passive = isPassive(part, config);
        if (row.passive) row.tip = part.kind->name + " of a movable object: it has no joints, no devices and no controller.";
    } else if (part.isRepeat()) row.detail = countOf(*m_loaded, part);
    else if (part.is(Role::Material))
        if (const auto it = m_materials.find(part.name); it != m_materials.end()) row.colour = it->second->colour;
    return row;
}

void OutlineRows::keep(Rows& rows, OutlineRow row, const OutlineRow& above) const {
    if (filtered()) {
        const bool grouped = row.type == OutlineRow::Type::Group || row.type == OutlineRow::Type::Members;
        const bool says =
            !grouped && this->says(row.name, row.detail, row.part ? std::string_view(row.part->block->type.text) : "");
        row.matches = above.matches || says;
        row.leadsToMatch = leads(row);
        if (!row.matches && !row.leadsToMatch) return;
    }
    rows.push_back(std::move(row));
}

bool OutlineRows::says(std::string_view name, std::string_view detail, std::string_view kind) const {
    return std::all_of(m_words.begin(), m_words.end(), [&](const std::string& word) {
        return contains(name, word) || contains(detail, word) || contains(kind, word);
    });
}

bool OutlineRows::leads(const OutlineRow& row) const {
    switch (row.type) {
    case OutlineRow::Type::Object: {
        const auto members = row.member ? m_members.end() : m_members.find(row.part);
        if (members != m_members.end() && leads(membersRow(row, members->second.first, members->second.second, true)))
            return true;
        return leads(*row.part) || (row.config && leads(*row.config));
    }
    case OutlineRow::Type::Members: {
        bool isAny = false;
        for (std::size_t i = row.first; i < row.last && !isAny; ++i)
            isAny = says(nameOfMember(*m_loaded->experiment, i), row.config ? row.config->name : row.part->name, "");
        return isAny;
    }
    case OutlineRow::Type::Group: {
        const auto& parts = m_groups[std::size_t(row.group)];
        if (std::any_of(parts.begin(), parts.end(), [&](const Part* part) {
                const OutlineRow inner = partRow(*part, row);
                return says(inner.name, inner.detail, part->block->type.text) || leads(inner);
            }))
            return true;
        if (row.group != OutlineGroup::Modules) return false;
        Rows rows;
        addModules(rows, row);
        return !rows.empty();
    }
    case OutlineRow::Type::File: return !fileBlocks(row).empty();
    default: return false;
    }
}

bool OutlineRows::leads(const Part& part) const {
    const auto [it, fresh] = m_leads.try_emplace(&part, false);
    if (!fresh) return it->second;
    const bool isInBase = isVariant(part) && leads(*part.config);
    const bool any = isInBase || std::any_of(part.parts.begin(), part.parts.end(), [&](const Part& inner) {
                         const std::string& type = inner.block->type.text;
                         if (inner.config && leads(*inner.config)) return true;
                         return says(inner.name.empty() ? type : inner.name, "", type) || leads(inner);
                     });
    return m_leads[&part] = any; // leads(inner) may have rehashed the map, so `it` may be invalid
}

} // namespace trundle
