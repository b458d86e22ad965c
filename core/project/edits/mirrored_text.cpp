#include "project/edits/mirrored_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

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

} // namespace

Status checkMirrorImage(const LoadedProject& loaded, const std::vector<Chosen>& blocks, char axis) {
    const Chosen* block = blockOfPlane(loaded, blocks);
    const RobotConfigSpec* config = block ? resolvedConfig(loaded, block->place) : nullptr;
    if (!config) return {};
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
