#include "project/loading/members.h"

#include <cmath>
#include <numbers>
#include <set>

#include "schema/value_words.h"

namespace trundle {

namespace {

/// Rounded to 1e-6 (m or degrees).
std::string rounded(double value) { return numberText(std::round(value * 1e6) / 1e6); }

std::string triple(const Vec3& v) { return rounded(v.x()) + "," + rounded(v.y()) + "," + rounded(v.z()); }

std::string singles(const Part& layout, const TextSet& texts, const ExperimentSpec& experiment) {
    static const std::set<std::string> own{"Pos", "HPR", "Count", "Spacing", "Area", "MinDistance", "Heading", "Seed"};
    std::string rest; // properties shared by all members, as written
    for (const Item& item : layout.block->items) {
        const auto* a = item.as<AssignmentItem>();
        if (a && a->path.size() == 1 && own.count(a->path[0].text)) continue;
        rest += " " + std::string(texts.slice(layout.file, item.range));
        if (item.as<ImportItem>() || item.as<ModuleItem>()) rest += "\n"; // a directive needs a line of its own
    }
    std::string out;
    for (const RobotSpec& robot : experiment.robots) {
        if (robot.range != layout.range || !robot.name.starts_with(layout.name + "_")) continue;
        const Vec3 hpr = hprFromRotation(robot.pose.rotation) * (180 / std::numbers::pi);
        out += (out.empty() ? "Robot " : "\nRobot ") + robot.name + " { Pos=" + triple(robot.pose.position) +
               " HPR=" + triple(hpr) + rest + " }";
    }
    return out;
}

} // namespace

void reportReplaceBySingles(const MemberPath& member, const Outline& outline, const ExperimentSpec& experiment,
                            Diagnostics& diagnostics) {
    const Part& layout = *member.layout;
    Diagnostic& d = diagnostics.error(Code::ReplaceBySingles, member.range,
                                      member.name + " is a member of " + layout.title() + " and has no text of its own");
    const std::string text = singles(layout, outline.texts(), experiment);
    if (!text.empty()) d.fixes.push_back({"replace by single instances", {{layout.range, text}}});
}

} // namespace trundle
