// needs: Statics, or Robots, Grids and Scatters of robots without joints, devices and controllers, all in the opened file.
// assumes: only the pose of a geom or body depends on the grouping; it is rewritten, all other properties are kept.
// method: each geom of each object becomes a geom of the new config, with its pose relative to the common centre; literal values
// are copied as written, others are evaluated. Names used by the values are imported from their files, or moved along if they are
// defined in the opened file, which cannot be imported.
// data: the text of the new file; edits of the opened one.
#include "project/edits/plan_group.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "lang/characters.h"
#include "lang/tree_edit.h"
#include "model/config_blocks.h"
#include "model/passive_objects.h"
#include "project/edits/edit_builder.h"
#include "project/edits/plan_dependents.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/loading/search.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxItems = 500;
constexpr double kDigits = 1e6; // 1/m; the group's own Pos is rounded to 1e-6 m

/// The file name for a config: "red_wall" for "RedWall".
std::string fileNameFor(const std::string& name) {
    std::string file;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        if (std::isupper(c) && i > 0 && name[i - 1] != '_' && !std::isupper(static_cast<unsigned char>(name[i - 1]))) file += '_';
        file += static_cast<char>(std::tolower(c));
    }
    return file;
}

std::string lowerFirstOf(std::string name) {
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

bool isPlainName(const std::string& name) {
    return !name.empty() && isIdentStart(name[0]) && std::all_of(name.begin(), name.end(), isIdent);
}

/// The path of the new file, relative to the project's folder or the folder of shipped configs.
std::string pieceFile(const std::string& folder, const std::string& name) {
    return (fs::path(folder) / "objects" / (fileNameFor(name) + ".sim")).string();
}

bool isFree(const LoadedProject& loaded, const std::string& shippedConfigs, const std::string& name) {
    std::error_code none;
    return !loaded.outline->configs.find(name) && !fs::exists(pieceFile(loaded.projectFolder, name), none) &&
           (shippedConfigs.empty() || !fs::exists(pieceFile(shippedConfigs, name), none));
}

bool isLiteral(const Value& value) {
    return std::all_of(value.elements.begin(), value.elements.end(),
                       [](const Element& e) { return e.kind != Element::Kind::ParamRef && e.kind != Element::Kind::Expression; });
}

/// The blocks of a config, with those of what it is a variant of.
std::vector<const Part*> blocksOf(const Part& config) {
    std::vector<const Part*> blocks;
    eachBlock(config, [&](const Part& block) { blocks.push_back(&block); });
    return blocks;
}

/// The first block of a config that is no shape, nor, of what moves, a body of shapes; nullptr: none.
const Part* unfitIn(const Part& config, bool scenery) {
    const auto isShape = [](const Part& block) { return block.is(Role::Geom) && block.usable; };
    for (const Part* block : blocksOf(config)) {
        if (scenery ? isShape(*block) : block->is(Role::Body) && block->usable && std::ranges::all_of(block->parts, isShape))
            continue;
        const auto inner = std::ranges::find_if_not(block->parts, isShape);
        return !scenery && block->is(Role::Body) && inner != block->parts.end() ? &*inner : block;
    }
    return nullptr;
}

/// What becomes parts of the new config.
struct GroupedObject {
    const Part* part = nullptr; ///< the Static, Robot, Grid or Scatter
    Pose pose;                  ///< of its config in the world
    std::string name;           ///< of the object, or of the member
};

class GroupPlanner {
public:
    GroupPlanner(const LoadedProject& loaded, std::string name) : m_loaded(loaded), m_name(std::move(name)), m_sheet(loaded) {}

    Result<GroupPlan> of(const std::vector<std::string>& paths) {
        if (Status status = take(paths); !status.ok()) return status.error();
        findMiddle();
        std::string parts;
        for (const GroupedObject& item : m_items) {
            const std::vector<const Part*> blocks = blocksOf(*configOf(m_loaded, *item.part));
            Result<std::string> text = m_scenery
                                           ? geomsOf(item, blocks, {}, m_inverse * item.pose, m_items.size() > 1 ? item.name : "")
                                           : bodiesOf(item, blocks);
            if (!text.ok()) return text.error();
            parts += text.value();
        }
        Result<std::string> head = imports();
        if (!head.ok()) return head.error();
        GroupPlan group;
        group.file = pieceFile(m_loaded.projectFolder, m_name);
        group.text = "// " + m_name + ": " + std::to_string(m_items.size()) + (m_scenery ? " pieces of scenery" : " objects") +
                     " grouped. Its origin is the middle of its base.\n" + head.value() + m_moved + "\n" +
                     (m_scenery ? "StaticConfig " : "RobotConfig ") + m_name + " {\n" +
                     (m_scenery || m_items.size() < 2 ? "" : "  SelfCollision=true\n") + parts + "}\n";
        const std::string instance =
            UsedNames(m_loaded, nullptr, m_loaded.registry->find(m_scenery ? "Static" : "Robot")).take(lowerFirstOf(m_name));
        for (const Part* part : m_objects) m_sheet.removeItem(part->range);
        m_sheet.addItem(0, nullptr,
                        std::string(m_scenery ? "Static " : "Robot ") + instance + " { Config=" + m_name +
                            " Pos=" + positionText(m_middle) + " HPR=0,0,0 }");
        Result<std::vector<TextEdit>> directives = editsForImports(m_loaded, 0, {group.file});
        if (!directives.ok()) return directives.error();
        for (TextEdit& edit : directives.value()) m_sheet.addFirst(std::move(edit));
        Result<EditPlan> plan = m_sheet.plan({instance});
        if (!plan.ok()) return plan.error();
        group.plan = std::move(plan).value();
        return group;
    }

private:
    Status take(const std::vector<std::string>& paths) {
        for (const std::string& path : paths) {
            const auto place = placeOf(m_loaded, path);
            const Part* part = place ? place->part : nullptr;
            if (place && place->member)
                return Error{Code::ReplaceBySingles, path + " is one of many; select " + place->instance->name +
                                                         " to group all of them, or replace it by single robots first"};
            const Part* config = part && part == place->instance && !part->isPartUse() ? configOf(m_loaded, *part) : nullptr;
            const bool scenery = part && part->kind && part->kind->name == "Static";
            if (!config || !isPlaced(*part) || (!scenery && !isPassive(*part, config)))
                return Error{Code::WrongPlace, (part ? part->title() : path) +
                                                   " cannot be part of a piece: select scenery, or robots "
                                                   "without joints, devices and controller"};
            if (!place->around.empty())
                return Error{Code::WrongPlace, part->title() + " is in " + place->around.back()->title() +
                                                   ", which repeats it; it cannot be part of a piece"};
            if (const Part* unfit = unfitIn(*config, scenery))
                return Error{Code::WrongPlace, part->title() + " cannot be part of a piece: its " + config->title() + " has " +
                                                   unfit->title() + ", and a piece has shapes" +
                                                   (scenery ? " only" : ", and bodies of shapes, only")};
            if (part->file != 0)
                return Error{Code::WrongPlace, part->title() + " is in " +
                                                   shownInProject(m_loaded.paths[part->file], m_loaded.projectFolder) +
                                                   ", not in the opened file; open that to group it"};
            if (!m_objects.empty() && scenery != m_scenery)
                return Error{Code::WrongPlace, "scenery and movable objects cannot be one piece: " + m_objects.front()->title() +
                                                   " and " + part->title()};
            m_scenery = scenery;
            if (std::find(m_objects.begin(), m_objects.end(), part) == m_objects.end()) m_objects.push_back(part);
        }
        if (m_objects.empty()) return Error{Code::WrongPlace, "select what is to be one piece"};
        std::sort(m_objects.begin(), m_objects.end(),
                  [](const Part* a, const Part* b) { return a->range.range.begin < b->range.range.begin; });
        if (Status status = addItems(); !status.ok()) return status;
        for (const NameReference& reference : referencesIn(m_loaded))
            for (const Part* part : m_objects)
                if (reference.target == part->block && reference.user)
                    return Error{Code::UnknownReference, part->title() + " is named by " + reference.user->title() +
                                                             "; it cannot become part of a piece"};
        return {};
    }

    /// One for each object, and for each member of a Grid or Scatter.
    Status addItems() {
        for (const Part* part : m_objects) {
            if (!part->is(Role::Layout)) {
                m_items.push_back({part, poseAt(m_loaded, *placeOf(m_loaded, part->name)), part->name});
                continue;
            }
            for (const RobotSpec& robot : m_loaded.experiment->robots)
                if (robot.range == part->range && !robot.scenery) m_items.push_back({part, robot.pose, robot.name});
            for (const StaticSpec& fixed : m_loaded.experiment->statics)
                if (fixed.range == part->range) m_items.push_back({part, fixed.pose, fixed.name});
        }
        if (m_items.size() <= kMaxItems) return {};
        return Error{Code::WrongPlace, "a piece has at most " + std::to_string(kMaxItems) + " objects, these are " +
                                           std::to_string(m_items.size())};
    }

    /// The centre of the objects, at the height of the lowest one, rounded.
    void findMiddle() {
        m_middle = Vec3::Zero();
        double low = HUGE_VAL;
        for (const GroupedObject& item : m_items) {
            m_middle += item.pose.position / double(m_items.size());
            low = std::min(low, item.pose.position.z());
        }
        m_middle.z() = low;
        for (int k = 0; k < 3; ++k) m_middle[k] = std::round(m_middle[k] * kDigits) / kDigits;
        m_inverse = Pose{m_middle, Quat::Identity()}.inverse();
    }

    [[nodiscard]] std::string free(std::set<std::string>& taken, const std::string& preferred) const {
        std::string name = preferred;
        for (int n = 2; !taken.insert(name).second; ++n) name = preferred + std::to_string(n);
        return name;
    }

    /// The geoms of a config or body as lines of text. `within`: "hull." of a body; `at`: pose of their frame in the new config.
    Result<std::string> geomsOf(const GroupedObject& item, const std::vector<const Part*>& geoms, const std::string& within,
                                const Pose& at, const std::string& prefix) {
        std::string text;
        std::set<std::string>& taken = m_scenery ? m_names : m_geomNames;
        for (const Part* part : geoms) {
            const std::string name = prefix.empty() ? part->name : geoms.size() == 1 ? prefix : prefix + "_" + part->name;
            Result<std::string> values = valuesOf(item, *part, within + part->name);
            if (!values.ok()) return values.error();
            const auto place = placeOf(m_loaded, item.name + "." + within + part->name);
            if (!place) return Error{Code::NoSuchPath, "there is no " + item.name + "." + within + part->name};
            text += (m_scenery ? "  " : "    ") + part->block->type.text + " " + free(taken, name) + " { " +
                    placeText(at * poseAt(m_loaded, *place)) + values.value() + " }\n";
        }
        return text;
    }

    Result<std::string> bodiesOf(const GroupedObject& item, const std::vector<const Part*>& bodies) {
        std::string text;
        for (const Part* body : bodies) {
            const auto place = placeOf(m_loaded, item.name + "." + body->name);
            if (!place) return Error{Code::NoSuchPath, "there is no " + item.name + "." + body->name};
            const std::optional<PropertyValue> in = valueAt(m_loaded, *place, "In");
            if (in && !in->texts.empty() && !in->texts.front().empty())
                return Error{Code::WrongPlace, item.name + "." + body->name + " has its place In " + in->texts.front() +
                                                   "; give it one in the robot before it is part of a piece"};
            Result<std::string> values = valuesOf(item, *body, body->name);
            if (!values.ok()) return values.error();
            m_geomNames.clear();
            std::vector<const Part*> shapes;
            for (const Part& shape : body->parts) shapes.push_back(&shape);
            Result<std::string> geoms = geomsOf(item, shapes, body->name + ".", Pose{}, "");
            if (!geoms.ok()) return geoms.error();
            text += "  Body " + free(m_names, bodies.size() == 1 ? item.name : item.name + "_" + body->name) + " { " +
                    placeText(m_inverse * item.pose * poseAt(m_loaded, *place)) + values.value() + "\n" + geoms.value() + "  }\n";
        }
        return text;
    }

    static std::string placeText(const Pose& pose) {
        const std::string turn = headingText(pose.rotation);
        return "Pos=" + positionText(pose.position) + (turn == "0,0,0" ? "" : " HPR=" + turn);
    }

    /// By the instance, by a variant, or in its own block; nullptr: it has its default.
    [[nodiscard]] const SourceAssignment* givenTo(const GroupedObject& item, const Part& part, const std::string& within,
                                                  const std::string& key) const {
        if (const SourceAssignment* a = item.part->assignments.find(within + "." + key)) return a;
        for (const Part* config = configOf(m_loaded, *item.part); config; config = config->config)
            if (const SourceAssignment* a = config->assignments.find(within + "." + key)) return a;
        return part.assignments.find(key);
    }

    /// All given properties except the pose: " Size=1,2,3 Material=red".
    Result<std::string> valuesOf(const GroupedObject& item, const Part& part, const std::string& within) {
        std::string text;
        const auto place = placeOf(m_loaded, item.name + "." + within);
        for (const Property& property : part.kind->properties) {
            if (property.name == "Pos" || property.name == "HPR") continue;
            const SourceAssignment* a = givenTo(item, part, within, property.name);
            if (!a || !place) continue;
            const std::optional<PropertyValue> value = valueAt(m_loaded, *place, property.name);
            if (!value) return Error{Code::MissingValue, property.name + " of " + item.name + "." + within + " cannot be read"};
            std::string written = isLiteral(*a->value) ? std::string(m_loaded.outline->texts().slice(a->valueRange()))
                                                       : valueText(property, *value);
            if (property.type == PropertyType::File && !value->texts.empty())
                written = fileText(*a, value->texts.front(), written);
            text += " " + property.name + "=" + written;
            if (property.type == PropertyType::Reference)
                for (const std::string& name : value->texts) m_used.insert({property.name, name});
        }
        return text;
    }

    /// The path of a file, rewritten so that it is found from the folder of the new config too.
    std::string fileText(const SourceAssignment& a, const std::string& name, const std::string& written) const {
        const auto named = m_loaded.named.find({a.file, name});
        if (named == m_loaded.named.end() || named->second.path.empty()) return written;
        const std::string shown = shownInProject(named->second.path, m_loaded.projectFolder);
        return fs::path(shown).is_absolute() ? written : "\"" + shown + "\"";
    }

    /// The text of a block that is moved from the opened file to the new one, with Params replaced by their values.
    Result<std::string> movedText(const Part& part) const {
        const auto place = placeOf(m_loaded, part.kind->name + "." + part.name);
        std::vector<TextEdit> edits;
        for (const SourceAssignment& a : part.assignments.all()) {
            if (isLiteral(*a.value) || a.file != part.range.file) continue;
            const Property* property = part.kind->find(a.key);
            const std::optional<PropertyValue> value = place ? valueAt(m_loaded, *place, a.key) : std::nullopt;
            if (!property || !value)
                return Error{Code::UnknownParam, a.key + " of " + part.title() +
                                                     " cannot be worked out; write its value out before it is part of a piece"};
            TextRange range = a.value->range;
            range.begin -= part.range.range.begin;
            range.end -= part.range.range.begin;
            edits.push_back({{part.range.file, range}, valueText(*property, *value)});
        }
        return applyEdits(blockText(m_loaded, part.range), edits);
    }

    /// The import lines for everything used; definitions in the opened file are removed there and moved along.
    Result<std::string> imports() {
        std::set<std::string> files;
        std::set<const Part*> moved;
        for (const auto& [property, name] : m_used) {
            const Part* part = property == "Material"  ? m_loaded.outline->materials.find(name)
                               : property == "Surface" ? m_loaded.outline->surfaces.find(name)
                                                       : nullptr;
            if (!part) continue; // built in
            if (part->file != 0) files.insert(shownInProject(m_loaded.paths[part->file], m_loaded.projectFolder));
            else if (moved.insert(part).second) {
                Result<std::string> text = movedText(*part);
                if (!text.ok()) return text.error();
                m_moved += text.value() + "\n";
                m_sheet.removeItem(part->range);
            }
        }
        std::string text;
        for (const std::string& file : files) text += "#import " + file + "\n";
        return text;
    }

    const LoadedProject& m_loaded;
    const std::string m_name;
    EditBuilder m_sheet;
    std::vector<const Part*> m_objects; // in text order
    std::vector<GroupedObject> m_items;
    bool m_scenery = false;
    Vec3 m_middle = Vec3::Zero();
    Pose m_inverse;
    std::set<std::string> m_names, m_geomNames;
    std::set<std::pair<std::string, std::string>> m_used; // (property, name)
    std::string m_moved;
};

} // namespace

std::string freeGroupName(const LoadedProject& loaded, const std::string& shippedConfigs) {
    std::string name = "Piece";
    for (int n = 2; !isFree(loaded, shippedConfigs, name); ++n) name = "Piece" + std::to_string(n);
    return name;
}

Result<GroupPlan> planGroup(const LoadedProject& loaded, const std::vector<std::string>& paths, const std::string& name,
                            const std::string& shippedConfigs) {
    if (!isPlainName(name))
        return Error{Code::WrongPlace, "`" + name + "` is no name: it takes letters, digits and _, and begins with no digit"};
    if (!isFree(loaded, shippedConfigs, name))
        return Error{Code::DuplicateName,
                     "there is a config " + name + ", or a file objects/" + fileNameFor(name) + ".sim, already"};
    return GroupPlanner(loaded, name).of(paths);
}

} // namespace trundle
