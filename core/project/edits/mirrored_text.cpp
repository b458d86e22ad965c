#include "project/edits/mirrored_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "project/edits/moved_block.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// The same value with the other sign; empty if it is not a number.
std::string negated(const Element& e, std::string_view written) {
    switch (e.kind) {
    case Element::Kind::Number:
        if (e.number == 0) return std::string(written);
        if (written.starts_with("-")) return std::string(written.substr(1));
        return "-" + std::string(written.substr(written.starts_with("+") ? 1 : 0));
    case Element::Kind::ParamRef: return "$(-" + e.text + ")";
    case Element::Kind::Expression: // `$(...)`
        if (e.expression && e.expression->op == Expression::Op::Negate && e.expression->arguments[0].op == Expression::Op::Name)
            return "$" + e.expression->arguments[0].name;
        return "$(-(" + std::string(written.substr(2, written.size() - 3)) + "))";
    default: return {};
    }
}

/// The text of three numbers of which those marked change their sign; nothing if they are not given one by one.
std::optional<std::string> withSigns(const AssignmentItem& a, std::string_view source, const std::array<bool, 3>& changes) {
    if (a.value.elements.size() != 3) return std::nullopt;
    std::string text;
    std::uint32_t done = a.value.range.begin;
    for (std::size_t i = 0; i < 3; ++i) {
        const Element& e = a.value.elements[i];
        const std::string_view written = source.substr(e.range.begin, e.range.size());
        const std::string now = changes[i] ? negated(e, written) : std::string(written);
        if (now.empty()) return std::nullopt;
        text += std::string(source.substr(done, e.range.begin - done)) + now;
        done = e.range.end;
    }
    return text;
}

} // namespace

Result<std::string> mirroredPart(const std::string& text, const std::string& name, char axis) {
    MovedBlock part(text);
    const std::string by(1, axis);
    std::string mirror = by;
    if (const AssignmentItem* now = part.find("Mirror")) {
        const bool isWord = now->value.elements.size() == 1 && now->value.elements[0].kind == Element::Kind::Word;
        const std::string was = isWord ? now->value.elements[0].text : std::string();
        if (was != "none" && was != by)
            return Error{Code::Conflict, "it is mirrored already, along " + (isWord ? was : "an axis given by a Param") +
                                             "; it can be mirrored along that axis only"};
        if (was == by) mirror = "none";
    }
    const std::size_t index = axis == 'x' ? 0 : axis == 'y' ? 1 : 2;
    // The mirror image of a rotation turns the other way, except about the mirrored axis. HPR is about z, y and x.
    const std::array<bool, 3> ofPos{index == 0, index == 1, index == 2}, ofHpr{index != 2, index != 1, index != 0};
    for (const auto& [key, changes] : {std::pair{"Pos", ofPos}, std::pair{"HPR", ofHpr}}) {
        const AssignmentItem* a = part.find(key);
        if (!a) continue;
        const std::optional<std::string> value = withSigns(*a, part.text(), changes);
        if (!value)
            return Error{Code::ExpressionValue,
                         std::string(key) + " of it is not three numbers, so its sign cannot be changed in the text"};
        part.set(key, *value);
    }
    if (mirror == "none") part.remove("Mirror");
    else part.set("Mirror", mirror);
    part.rename(name);
    return part.text();
}

namespace {

/// The block whose frame the mirror plane is in; nullptr: none has a pose.
const Chosen* blockOfPlane(const LoadedProject& loaded, const std::vector<Chosen>& blocks) {
    const auto countsFromOthers = [&](const Chosen& c) {
        const std::optional<PropertyValue> in = valueAt(loaded, c.place, "In");
        return in && !in->texts.empty() && std::ranges::any_of(blocks, [&](const Chosen& other) {
                   return other.place.part->name == firstWord(in->texts[0]);
               });
    };
    const auto found = std::ranges::find_if(
        blocks, [&](const Chosen& c) { return c.place.part->kind && c.place.part->kind->find("In") && !countsFromOthers(c); });
    return found == blocks.end() ? nullptr : &*found;
}

/// The path of the first use of a PartConfig in a robot, "rover.module"; empty without one.
std::string pathOfUse(const LoadedProject& loaded, const Part& wanted) {
    std::set<const Part*> seen;
    const auto within = [&](const auto& self, const Part& holder, const std::string& path) -> std::string {
        for (const Part& part : holder.parts) {
            std::string at = path + "." + part.name;
            if (part.isPartUse() && part.config == &wanted) return at;
            const Part* inner = part.isRepeat() ? &part : part.isPartUse() ? part.config : nullptr;
            if (!inner || !seen.insert(inner).second) continue;
            at = self(self, *inner, part.isRepeat() ? at + "_0" : at);
            if (!at.empty()) return at;
        }
        const bool hasBase = isVariant(holder) && holder.config && seen.insert(holder.config).second;
        return hasBase ? self(self, *holder.config, path) : std::string();
    };
    for (const RobotSpec& robot : loaded.experiment->robots) {
        const auto place = placeOf(loaded, robot.name);
        const Part* config = place && place->part ? configOf(loaded, *place->part) : nullptr;
        if (!config || !seen.insert(config).second) continue;
        if (std::string path = within(within, *config, robot.name); !path.empty()) return path;
    }
    return {};
}

/// Blocks of a PartConfig where a robot has them, so that they have poses; others as they are.
std::vector<Chosen> inRobot(const LoadedProject& loaded, const std::vector<Chosen>& blocks) {
    const Part* config = blocks.empty() || blocks.front().place.above.empty() ? nullptr : blocks.front().place.above.front();
    if (!config || !config->kind || config->kind->name != "PartConfig") return blocks;
    const std::string use = pathOfUse(loaded, *config), own = pathOfConfig(*config);
    std::vector<Chosen> all = blocks;
    for (Chosen& c : all) {
        const auto place =
            use.empty() || !c.path.starts_with(own + ".") ? std::nullopt : placeOf(loaded, use + c.path.substr(own.size()));
        if (!place || !place->part) return blocks;
        c.place = *place;
    }
    return all;
}

/// The same without a robot: another Part of the same Config beside it, at the mirrored pose and with the other Mirror.
Status checkImageInText(const LoadedProject& loaded, const Chosen& block, char axis) {
    const Part& part = *block.place.part;
    if (!part.isPartUse() || !part.config || block.place.above.empty()) return {};
    const auto wordAt = [&](const ObjectLocation& place, const char* key) {
        const std::optional<PropertyValue> value = valueAt(loaded, place, key);
        return value && !value->texts.empty() ? value->texts[0] : std::string("none");
    };
    DescribedFrame plane;
    plane.signs[axis - 'x'] = -1;
    const Pose image = plane.mirrored(poseAt(loaded, block.place));
    const std::string by(1, axis), mirror = wordAt(block.place, "Mirror") == by ? "none" : by;
    for (const Part& other : block.place.above.back()->parts) {
        if (&other == &part || !other.isPartUse() || other.config != part.config) continue;
        const auto there = placeOf(loaded, pathInside(withoutLastWord(block.path), other.name));
        if (!there || wordAt(*there, "Mirror") != mirror || wordAt(*there, "In") != wordAt(block.place, "In")) continue;
        const Pose pose = poseAt(loaded, *there);
        if ((pose.position - image.position).norm() < 1e-6 && pose.rotation.angularDistance(image.rotation) < 1e-6)
            return Error{Code::Conflict, part.name + "'s mirror image is there already: " + other.name};
    }
    return {};
}

} // namespace

Status checkMirrorImage(const LoadedProject& loaded, const std::vector<Chosen>& selected, char axis) {
    const std::vector<Chosen> blocks = inRobot(loaded, selected);
    const Chosen* block = blockOfPlane(loaded, blocks);
    const RobotConfigSpec* config = block ? resolvedConfig(loaded, block->place) : nullptr;
    if (!config) return selected.size() == 1 ? checkImageInText(loaded, selected.front(), axis) : Status();
    const std::string prefix = resolvedPrefix(block->place);
    const Pose frame = describedFrame(loaded, block->place).pose;
    const auto imageOf = [&](Vec3 position) {
        position = frame.inverse() * position;
        position[axis - 'x'] *= -1;
        return frame * position;
    };
    const auto isImage = [&](const BodySpec& body, const BodySpec& other) {
        return !body.geoms.empty() && body.geoms.size() == other.geoms.size() &&
               std::ranges::all_of(body.geoms, [&](const GeomSpec& geom) {
                   const Vec3 image = imageOf(body.pose * geom.pose.position);
                   return std::ranges::any_of(other.geoms, [&](const GeomSpec& there) {
                       return there.shape == geom.shape && (other.pose * there.pose.position - image).norm() < 1e-6;
                   });
               });
    };
    // The name of the selected block that has a body; "" for other bodies.
    const auto blockOf = [&](const BodySpec& body) -> std::string {
        if (!body.name.starts_with(prefix)) return {};
        const std::string_view first = firstWord(std::string_view(body.name).substr(prefix.size()));
        const auto member = memberName(first);
        const auto has = [&](const Chosen& c) {
            const Part& part = *c.place.part;
            return part.name == (part.isRepeat() && member ? member->stem : first);
        };
        const auto found = std::ranges::find_if(blocks, has);
        return found == blocks.end() ? std::string() : found->place.part->name;
    };
    std::string refusal;
    for (const BodySpec& body : config->bodies) {
        const std::string name = blockOf(body);
        if (name.empty()) continue;
        const auto isThere = [&](const BodySpec& other) { return isImage(body, other); };
        const auto other = std::ranges::find_if(config->bodies, isThere);
        if (other == config->bodies.end()) return {};
        if (!refusal.empty()) continue;
        std::string_view there = other->name;
        if (there.starts_with(prefix)) there = firstWord(there.substr(prefix.size()));
        refusal = isImage(body, body) ? name + " lies on the mirror plane and would be its own mirror image"
                                      : name + "'s mirror image is there already: " + std::string(there);
    }
    return refusal.empty() ? Status() : Error{Code::Conflict, refusal};
}

std::string mirroredName(const std::string& name) {
    static constexpr std::array<std::array<const char*, 2>, 3> kPairs{{{"left", "right"}, {"front", "rear"}, {"upper", "lower"}}};
    for (const auto& pair : kPairs) {
        for (const std::size_t side : {0, 1}) {
            for (const bool isUpper : {false, true}) {
                std::string word = pair[side], other = pair[1 - side];
                if (isUpper)
                    word[0] = static_cast<char>(std::toupper(word[0])), other[0] = static_cast<char>(std::toupper(other[0]));
                const std::size_t at = name.find(word);
                if (at == std::string::npos || (!isUpper && at > 0 && std::isalpha(static_cast<unsigned char>(name[at - 1]))))
                    continue;
                return name.substr(0, at) + other + name.substr(at + word.size());
            }
        }
    }
    return name;
}

} // namespace trundle
