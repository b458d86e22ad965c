#include "project/loading/members.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "model/dotted_path.h"
#include "model/repeat.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// Rounded to 1e-6 (m or degrees).
std::string rounded(double value) { return numberText(std::round(value * 1e6) / 1e6); }

std::string triple(const Vec3& v) { return rounded(v.x()) + "," + rounded(v.y()) + "," + rounded(v.z()); }

/// Where `index` and `index2` are in the items of a Grid or Scatter.
class NumberedText {
public:
    explicit NumberedText(const std::vector<Item>& items) { search(items); }

    /// A piece of the text with the numbers of a member in their place. `counts`: those of the layout.
    [[nodiscard]] std::string of(TextRange piece, std::string_view written, std::size_t member,
                                 const std::vector<double>& counts) const {
        const std::size_t first = counts.size() > 1 ? static_cast<std::size_t>(counts[0]) : member + 1;
        std::string text;
        std::uint32_t done = piece.begin;
        for (const auto& [range, isSecond] : m_places) {
            if (range.begin < done || range.end > piece.end) continue;
            text += written.substr(done - piece.begin, range.begin - done);
            text += std::to_string(isSecond ? member / first : member % first);
            done = range.end;
        }
        return text + std::string(written.substr(done - piece.begin));
    }

private:
    void search(const std::vector<Item>& items) {
        const auto isOther = [](const Item& item) { // a Param of that name hides the number
            const auto* param = item.as<ParamItem>();
            return param && (param->name.text == "index" || param->name.text == "index2");
        };
        if (std::ranges::any_of(items, isOther)) return;
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) search(block->items);
            if (const auto* param = item.as<ParamItem>()) search(param->value);
            if (const auto* assignment = item.as<AssignmentItem>()) search(assignment->value);
        }
    }
    void search(const Value& value) {
        for (const Element& e : value.elements) {
            if (e.kind == Element::Kind::ParamRef) add(e.text, e.range);
            else if (e.kind == Element::Kind::Expression && e.expression) search(*e.expression);
        }
    }
    void search(const Expression& e) {
        if (e.op == Expression::Op::Name) add(e.name, e.range);
        for (const Expression& argument : e.arguments) search(argument);
    }
    void add(std::string_view name, TextRange range) {
        if (name == "index" || name == "index2") m_places.emplace_back(range, name == "index2");
    }

    std::vector<std::pair<TextRange, bool>> m_places; ///< in text order; whether it is index2
};

std::vector<double> layoutCounts(const Part& layout, const Outline& outline) {
    Diagnostics silent;
    Evaluator evaluator(outline.texts(), silent);
    ParamScope globals, own(&globals);
    globals.declare(outline.params);
    own.declare(layout.params);
    return countsOf(layout, evaluator, own, nullptr, silent);
}

std::string singles(const Part& layout, const Outline& outline, const ExperimentSpec& experiment) {
    const TextSet& texts = outline.texts();
    static const std::set<std::string> own{"Pos", "HPR", "Count", "Spacing", "Area", "MinDistance", "Heading", "Seed"};
    const NumberedText numbered(layout.block->items);
    const std::vector<double> counts = layoutCounts(layout, outline);
    const auto restOf = [&](std::size_t member) { // what all members share, as written
        std::string rest;
        for (const Item& item : layout.block->items) {
            const auto* a = item.as<AssignmentItem>();
            if (a && a->path.size() == 1 && own.count(a->path[0].text)) continue;
            rest += " " + numbered.of(item.range, texts.slice(layout.file, item.range), member, counts);
            if (item.as<ImportItem>() || item.as<ModuleItem>()) rest += "\n"; // a directive needs a line of its own
        }
        return rest;
    };
    std::string out;
    const auto add = [&](const char* kind, const auto& one) {
        if (one.range != layout.range || !one.name.starts_with(layout.name + "_")) return;
        const Vec3 hpr = hprFromRotation(one.pose.rotation) * (180 / std::numbers::pi);
        out += (out.empty() ? "" : "\n") + std::string(kind) + " " + one.name + " { Pos=" + triple(one.pose.position) +
               " HPR=" + triple(hpr) + restOf(memberName(one.name)->index) + " }";
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
    const std::string text = singles(layout, outline, experiment);
    if (!text.empty()) d.fixes.push_back({"replace by single instances", {{layout.range, text}}});
}

} // namespace trundle
