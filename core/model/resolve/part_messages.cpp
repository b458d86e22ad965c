#include "model/resolve/part_messages.h"

#include <algorithm>

#include "base/spelling.h"
#include "model/param_reference.h"
#include "model/part_depth.h"
#include "schema/value_words.h"

namespace trundle {

void nameMember(const ResolveContext& context, Diagnostic& d, const Part& of, std::size_t member) {
    if (member == 0 && context.texts.slice(d.range).find("index") == std::string_view::npos) return; // it is so in all of them
    d.notes.emplace_back("in its member " + of.name + "_" + std::to_string(member), of.nameRange());
}

void reportMissing(ResolveContext& context, const PartFrame& frame, const OverrideNode* outside, const SourceParam& param) {
    const std::string& name = param.name->text;
    const OverrideNode* other = below(outside, "Config");
    const bool isExchanged = other && other->value;
    Diagnostic& d =
        context.diagnostics.error(Code::MissingRequired, isExchanged ? other->value->range : frame.use->nameRange(),
                                  frame.use->title() + " needs " + name + ": what " + frame.config->title() + " is joined to");
    d.notes.push_back({kUsedHere, param.nameRange()});
    const Property* property = propertyNamedBy(*frame.config, name);
    const auto fits = [&](const Part& p) {
        return p.kind &&
               (property
                    ? std::ranges::any_of(property->choices,
                                          [&](const std::string& c) { return c == p.kind->name || c == roleName(p.kind->role); })
                    : p.is(Role::Body));
    };
    const auto fitting = std::ranges::find_if(frame.outer->config->parts, fits);
    if (!isExchanged && fitting != frame.outer->config->parts.end()) context.fixAdd(d, *frame.use, name, fitting->name);
}

bool isMisspelt(const Part& use, const Part& config, const std::string& param) {
    const std::vector<std::string> meant{param};
    const auto isIn = [&](const Part& part) {
        return std::ranges::any_of(part.assignments.all(), [&](const SourceAssignment& a) {
            return a.path.size() == 1 && !part.kind->find(a.key) && !config.param(a.key) && !nearestWords(a.key, meant).empty();
        });
    };
    const Part* variant = &config;
    while (variant->config && !isIn(*variant)) variant = variant->config;
    return isIn(use) || variant->config;
}

void adviseToDeclare(const ResolveContext& context, Diagnostic& d, const PartFrame& frame) {
    if (d.code != Code::UnknownParam || !d.suggestions.empty()) return;
    const SourceRange &use = d.range, &config = frame.config->range;
    if (use.file != config.file || use.range.begin < config.range.begin || use.range.end > config.range.end) return;
    const std::string name(context.texts.slice(d.range));
    if (frame.use->assignments.find(name))
        d.message = "there is no Param " + name + "; " + frame.config->title() + " declares it with Param " + name + " = ...";
}

const Part* outermostRepeat(const PartFrame& frame) {
    const Part* repeat = nullptr;
    for (const PartFrame* at = &frame; at->use; at = at->outer)
        if (at->use->isRepeat()) repeat = at->use;
    return repeat;
}

void reportCircle(ResolveContext& context, const Part& use, SourceRange place, const std::string& chain) {
    const std::string configs = (use.isPartUse() ? "PartConfig" : use.kind->name) + "s";
    if (chain.empty())
        context.diagnostics.error(Code::TooManyObjects, place,
                                  configs + " are nested more than " + std::to_string(kDeepestParts - 1) + " deep");
    else if (use.isPartUse())
        context.diagnostics.error(Code::WrongPlace, place, configs + " contain each other in a circle: " + chain);
    else context.diagnostics.error(Code::WrongPlace, place, configs + " are variants of each other in a circle: " + chain);
}

void reportPartCircles(ResolveContext& context) {
    for (const Outline::PartCircle& circle : context.outline.partCircles())
        reportCircle(context, *circle.use, circle.use->assignments.find("Config")->valueRange(), circle.chain);
}

} // namespace trundle
