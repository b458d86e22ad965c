#include "project/loading/members.h"

#include <algorithm>
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
    const auto add = [&](const char* kind, const auto& one) {
        if (one.range != layout.range || !one.name.starts_with(layout.name + "_")) return;
        const Vec3 hpr = hprFromRotation(one.pose.rotation) * (180 / std::numbers::pi);
        out += (out.empty() ? "" : "\n") + std::string(kind) + " " + one.name + " { Pos=" + triple(one.pose.position) +
               " HPR=" + triple(hpr) + rest + " }";
    };
    const auto isScenery = [&](const StaticSpec& fixed) { return fixed.range == layout.range; };
    if (std::ranges::any_of(experiment.statics, isScenery))
        for (const StaticSpec& fixed : experiment.statics) add("Static", fixed);
    else
        for (const RobotSpec& robot : experiment.robots) add("Robot", robot);
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
