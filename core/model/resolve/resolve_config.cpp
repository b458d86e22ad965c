// Resolves a RobotConfig with one set of Param values and overrides: bodies, then joints, then devices.
#include "model/kinds/config_fields.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// The name of the joint between two bodies.
using JoinedPairs = std::map<std::pair<int, int>, std::string>;

void warnAboutDuplicateJoints(ResolveContext& context, JoinedPairs& pairs, const JointSpec& joint, const Part& part) {
    const auto [it, fresh] = pairs.try_emplace(std::minmax({joint.parent, joint.child}), joint.name);
    if (fresh) return;
    context.diagnostics.warning(Code::BadJoint, part.nameRange(),
                                "two joints join the same bodies: " + it->second + " and " + joint.name);
}

/// Pairs of properties of shipped kinds of which the first must be smaller than the second.
constexpr struct { const char *kind, *low, *high; } kAscending[] = {{"Camera", "Near", "Far"}};

bool checkOrder(ResolveContext& context, const Record& record, const Part& part) {
    for (const auto& pair : kAscending) {
        if (record.kind->name != pair.kind) continue;
        const ResolvedValue *low = record.find(pair.low), *high = record.find(pair.high);
        if (!low || !high || low->value.numbers.empty() || high->value.numbers.empty()) continue;
        if (low->value.numbers[0] < high->value.numbers[0]) continue;
        // If one of them is a default, report the other.
        const char* written = low->origin == Origin::Default ? pair.high : pair.low;
        context.diagnostics.error(Code::Conflict, record.rangeOf(written, part.nameRange()),
                                  std::string(pair.low) + " of " + part.title() + " is " + numberText(low->value.numbers[0]) +
                                      " m, " + pair.high + " is " + numberText(high->value.numbers[0]) + " m: " + pair.low +
                                      " must be the smaller one");
        return false;
    }
    return true;
}

std::optional<ComponentSpec> resolveDevice(ResolveContext& context, const Part& part, ParamScope& scope,
                                           const OverrideNode* overrides, const Part& config) {
    ParamScope own(&scope);
    own.declare(part.params);
    context.evaluator.checkAll(own);
    const Record record = context.read(part, own, overrides, Origin::Config);
    const bool known = context.checkReferences(record, config);
    if (!record.complete || !known || !checkOrder(context, record, part)) return std::nullopt;
    return componentFrom(record, part);
}

} // namespace

std::shared_ptr<const RobotConfigSpec> resolveRobotConfig(ResolveContext& context, const Part& config, ParamScope& scope,
                                                          const OverrideNode* overrides) {
    auto spec = std::make_shared<RobotConfigSpec>();
    spec->name = config.name;
    spec->range = config.range;
    spec->selfCollision = fieldsFrom<RobotConfigFields>(context.read(config, scope, overrides, Origin::Config)).selfCollision;
    BodyIndices places;
    JoinedPairs pairs;
    bool bodies = false;
    for (const Part& part : config.parts) {
        bodies = bodies || part.is(Role::Body) || part.is(Role::Geom) || !part.kind;
        if (!part.usable || !part.is(Role::Body)) continue;
        if (std::optional<BodySpec> body = resolveBody(context, part, scope, below(overrides, part.name))) {
            places.emplace(part.name, static_cast<int>(spec->bodies.size()));
            spec->bodies.push_back(std::move(*body));
        }
    }
    if (!bodies && !context.brokenText(config.range)) {
        context.diagnostics.error(Code::MissingRequired, config.nameRange(),
                                  config.title() + " needs a Body: the first one carries the robot's pose");
    }
    for (const Part& part : config.parts) {
        if (!part.usable || !part.is(Role::Joint)) continue;
        std::optional<JointSpec> joint =
            resolveJoint(context, part, scope, below(overrides, part.name), config, spec->bodies, places);
        if (!joint) continue;
        warnAboutDuplicateJoints(context, pairs, *joint, part);
        spec->joints.push_back(std::move(*joint));
    }
    for (const Part& part : config.parts) {
        if (!part.usable || !part.is(Role::Device)) continue;
        if (auto device = resolveDevice(context, part, scope, below(overrides, part.name), config))
            spec->devices.push_back(std::move(*device));
    }
    return spec;
}

} // namespace trundle
