#include "editor/viewport/tools/robot_part.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <vector>

#include "lang/tree.h"
#include "lang/tree_edit.h"
#include "model/shortest_turn.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr double kAlong = 1e-6; ///< smaller components of a direction are 0

std::shared_ptr<const Tree> partTreeOf(const std::string& text) {
    return parse(std::make_shared<const SourceText>("part", text), 0);
}

std::vector<const BlockItem*> namedBlocksOf(const Tree& tree) {
    std::vector<const BlockItem*> blocks;
    for (const Item& item : tree.items())
        if (const auto* block = item.as<BlockItem>(); block && block->name) blocks.push_back(block);
    return blocks;
}

const AssignmentItem* assignmentIn(const BlockItem& block, std::string_view key) {
    for (const Item& item : block.items)
        if (const auto* a = item.as<AssignmentItem>(); a && a->path.size() == 1 && a->path[0].text == key) return a;
    return nullptr;
}

std::string_view textOfValue(const Tree& tree, const BlockItem& block, std::string_view key) {
    const AssignmentItem* a = assignmentIn(block, key);
    return a ? tree.source().slice(a->value.range) : std::string_view();
}

/// Three plain numbers; those of `otherwise` if there are others.
Vec3 vectorOf(const Tree& tree, const BlockItem& block, std::string_view key, const Vec3& otherwise) {
    std::string text(textOfValue(tree, block, key));
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream numbers(text);
    Vec3 all = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        if (!(numbers >> all[k])) return otherwise;
    return all;
}

/// The block that joins a body to the robot; nullptr if no block does.
const BlockItem* jointOf(const Tree& tree, const std::vector<const BlockItem*>& blocks, const std::string& body) {
    const auto joint =
        std::ranges::find_if(blocks, [&](const BlockItem* block) { return textOfValue(tree, *block, "Child") == body; });
    return joint == blocks.end() ? nullptr : *joint;
}

std::string withSide(const std::string& side, std::string name) {
    if (side.empty() || name.empty()) return name;
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return side + name;
}

/// Multiples of `grain`, without rounding errors of directions along an axis.
Vec3 roundedTo(Vec3 numbers, double grain) {
    for (int k = 0; k < 3; ++k) numbers[k] = grain * std::round(numbers[k] / grain) + 0.0; // + 0.0: no "-0"
    return numbers;
}

/// Three angles in degrees, to a thousandth.
std::string headingOf(const Quat& rotation) {
    return positionText(roundedTo(hprFromRotation(rotation) * (180 / std::numbers::pi), 1e-3));
}

/// Sets values of one block, and adds those that it has not.
class BlockEdits {
public:
    BlockEdits(const Tree& tree, const BlockItem& block, std::vector<TextEdit>& edits)
        : m_tree(tree), m_block(block), m_edits(edits) {}

    void set(std::string_view key, const std::string& text) {
        const AssignmentItem* a = assignmentIn(m_block, key);
        m_edits.push_back(a ? editSetValue(m_tree, a->value, text) : editAddAssignment(m_tree, &m_block, key, text));
    }

private:
    const Tree& m_tree;
    const BlockItem& m_block;
    std::vector<TextEdit>& m_edits;
};

} // namespace

std::optional<RobotPart> RobotPart::of(const std::string& text) {
    const auto tree = partTreeOf(text);
    const std::vector<const BlockItem*> blocks = namedBlocksOf(*tree);
    if (blocks.empty() || blocks.front()->type.text != "Body") return std::nullopt;
    const BlockItem* joint = jointOf(*tree, blocks, blocks.front()->name->text);
    if (!joint) return std::nullopt;
    RobotPart part;
    part.position = vectorOf(*tree, *blocks.front(), "Pos", Vec3::Zero());
    const bool isAcross = std::abs(part.position.y()) > std::abs(part.position.x());
    part.side = isAcross ? Vec3(0, part.position.y() < 0 ? -1 : 1, 0) : Vec3(part.position.x() < 0 ? -1 : 1, 0, 0);
    part.axis = vectorOf(*tree, *joint, "Axis", Vec3::UnitZ());
    part.isWheel = joint->type.text == "Hinge" && part.axis.cross(part.side).norm() < kAlong;
    return part;
}

Quat RobotPart::rotationTo(const Vec3& normal) const {
    const bool isOpposite = isWheel && normal.dot(side) < -kAlong;
    const Vec3 to = isOpposite ? Vec3(-normal) : normal;
    if (std::abs(to.z()) > kAlong) return shortestTurn(side, to);
    return Quat(Eigen::AngleAxisd(std::atan2(to.y(), to.x()) - std::atan2(side.y(), side.x()), Vec3::UnitZ()));
}

std::string deviceTextAt(const std::string& text, const std::string& body, const Pose& X_BD) {
    const auto tree = partTreeOf(text);
    const std::vector<const BlockItem*> blocks = namedBlocksOf(*tree);
    if (blocks.empty()) return text;
    std::vector<TextEdit> edits;
    BlockEdits device(*tree, *blocks.back(), edits);
    device.set("Body", body);
    const bool isTurned = X_BD.rotation.angularDistance(Quat::Identity()) > kAlong;
    std::string place = positionText(roundedTo(X_BD.position, 1e-3));
    if (isTurned) place += " HPR=" + headingOf(X_BD.rotation); // one edit: both are added at the same offset
    device.set("Pos", place);
    const Result<std::string> changed = applyEdits(text, edits);
    return changed ? changed.value() : text;
}

std::string textAt(const std::string& text, const RobotPart& part, const PartLocation& location) {
    const auto tree = partTreeOf(text);
    const std::vector<const BlockItem*> blocks = namedBlocksOf(*tree);
    const BlockItem* joint = jointOf(*tree, blocks, blocks.front()->name->text);
    std::vector<TextEdit> edits;
    std::map<std::string, std::string> names;
    for (const BlockItem* block : blocks) {
        const std::string name = withSide(location.side, block->name->text);
        if (name == block->name->text) continue;
        names.emplace(block->name->text, name);
        edits.push_back(editReplace(*tree, block->name->range, name));
    }
    for (const BlockItem* block : blocks) {
        BlockEdits values(*tree, *block, edits);
        for (const char* key : {"Child", "Joint", "Body"})
            if (const auto renamed = names.find(std::string(textOfValue(*tree, *block, key))); renamed != names.end())
                values.set(key, renamed->second);
    }
    const bool isTurned = location.X_CB.rotation.angularDistance(Quat::Identity()) > kAlong;
    BlockEdits body(*tree, *blocks.front(), edits);
    std::string place = positionText(location.X_CB.position);
    const bool hasHeading = assignmentIn(*blocks.front(), "HPR");
    if (isTurned && hasHeading) body.set("HPR", headingOf(location.X_CB.rotation));
    if (isTurned && !hasHeading) place += " HPR=" + headingOf(location.X_CB.rotation); // on the line of Pos
    body.set("Pos", place);
    BlockEdits hold(*tree, *joint, edits);
    hold.set("Parent", location.parent);
    if (isTurned && assignmentIn(*joint, "Axis"))
        hold.set("Axis", positionText(roundedTo(location.X_CB.rotation * part.axis, 1e-6)));
    const Result<std::string> changed = applyEdits(text, edits);
    return changed ? changed.value() : text;
}

} // namespace trundle
