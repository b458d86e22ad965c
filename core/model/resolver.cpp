#include "model/resolver.h"


#include "base/spelling.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

std::vector<std::string> robotNames(const ResolveContext& context) {
    std::vector<std::string> names;
    for (const Part* part : context.outline.world.all()) {
        if (part->kind->name == "Robot" || part->is(Role::Layout)) names.push_back(part->name);
    }
    return names;
}

} // namespace

bool checkRobots(ResolveContext& context, const Property& property, ResolvedValue& value) {
    std::vector<std::string> names;
    for (const std::string& name : value.value.texts) {
        const Part* part = context.outline.world.find(name);
        if (!part && layoutOfMember(context.outline, name)) {
            bool there = false;
            for (const RobotSpec& robot : context.out.robots) there = there || robot.name == name;
            if (!there && !context.out.robots.empty()) {
                context.unknownReference(property.name, "robot", name, value.range, false, robotNames(context));
                return false;
            }
        } else if (!part && !context.outline.unknown.count(name)) {
            context.unknownReference(property.name, "robot", name, value.range,
                                     value.value.texts.size() == 1 && value.origin != Origin::Param, robotNames(context));
            return false;
        } else if (part && part->kind->name != "Robot" && !part->is(Role::Layout)) {
            Diagnostic& d = context.diagnostics.error(Code::UnknownReference, value.range,
                                                      property.name + " names " + name + ", " + withArticle(part->kind->name) +
                                                          "; it takes a robot");
            suggest(d, name, robotNames(context), value.range);
            return false;
        }
        if (part && part->is(Role::Layout) && property.maxCount > 1) {
            for (const RobotSpec& robot : context.out.robots) {
                if (robot.range == part->range) names.push_back(robot.name);
            }
        } else {
            names.push_back(name);
        }
    }
    value.value.texts = std::move(names);
    return true;
}

namespace {

void reportDefaults(ResolveContext& context) {
    if (context.defaulted.empty()) return;
    const auto& [part, missing] = context.defaulted.front();
    std::string text = part->title() + " names no " + missing + ": the built-in default is used";
    if (const std::size_t others = context.defaulted.size() - 1)
        text += " (here and for " + std::to_string(others) + (others == 1 ? " other geom)" : " other geoms)");
    context.diagnostics.hint(Code::DefaultUsed, part->nameRange(), text);
}

} // namespace

void resolveLogs(ResolveContext& context) {
    AppearanceChecker looks(context);
    for (const Part* part : context.outline.world.all()) {
        if (!part->is(Role::Log) && !part->is(Role::Look)) continue;
        ParamScope scope(&context.globals);
        scope.declare(part->params);
        Record record = context.read(*part, scope, nullptr, Origin::Config);
        bool good = record.complete;
        for (std::size_t i = 0; i < record.values.size(); ++i) {
            const Property& property = record.kind->properties[i];
            const bool robots =
                property.type == PropertyType::Reference && std::count(property.choices.begin(), property.choices.end(), "Robot");
            if (!robots || !record.values[i] || record.values[i]->origin == Origin::Default) continue;
            good = checkRobots(context, property, *record.values[i]) && good;
        }
        looks.check(record, *part);
        if (good) (part->is(Role::Log) ? context.out.logs : context.out.looks).push_back(componentFrom(record, *part));
    }
}

std::shared_ptr<ExperimentSpec> resolve(const Outline& outline, const AssetLookup& assets, Diagnostics& diagnostics) {
    auto experiment = std::make_shared<ExperimentSpec>();
    ResolveContext context(outline, assets, diagnostics, *experiment);
    context.evaluator.checkAll(context.globals);
    experiment->settings = resolveSettings(context);
    resolveMaterials(context);
    resolveSurfaces(context);
    resolveRadio(context);
    resolveInstances(context);
    resolveLinks(context);
    checkRadios(context);
    resolveLogs(context);
    checkFrameLogs(context);
    reportDefaults(context);
    return experiment;
}

} // namespace trundle
