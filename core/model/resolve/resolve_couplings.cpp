// Springs and gears of a RobotConfig: what couples bodies without joining them.
#include <algorithm>
#include <cmath>

#include "model/gear_line.h"
#include "model/kinds/config_fields.h"
#include "model/resolve/reference_check.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

/// A block with its values; nothing, with a diagnostic, if they are incomplete.
std::optional<Record> recordOf(ResolveContext& context, const ExpandedPart& expanded) {
    ParamScope own(expanded.frame->scope);
    own.declare(expanded.part->params);
    context.evaluator.checkAll(own);
    Record record = context.read(*expanded.part, own, expanded.overrides(), Origin::Config);
    const bool known = checkReferences(context, record, *expanded.frame);
    if (!record.complete || !known) return std::nullopt;
    return record;
}

/// A Gear in a mirrored Part runs as its mirror image does.
double placedRatio(const ExpandedPart& expanded, double ratio, const JointSpec& joint, const JointSpec& other) {
    std::vector<const PartFrame*> frames;
    for (const PartFrame* at = expanded.frame; at->use; at = at->outer) frames.push_back(at);
    Vec3 axis = joint.axis, otherAxis = other.axis;
    for (auto at = frames.rbegin(); at != frames.rend(); ++at)
        if ((*at)->placement.reverses(joint.type, axis) != (*at)->placement.reverses(other.type, otherAxis)) ratio = -ratio;
    return ratio;
}

} // namespace

std::optional<SpringSpec> resolveSpring(ResolveContext& context, const ExpandedPart& expanded,
                                        const std::vector<BodySpec>& bodies, const BodyIndices& places) {
    const Part& part = *expanded.part;
    const std::optional<Record> record = recordOf(context, expanded);
    if (!record) return std::nullopt;
    const auto f = fieldsFrom<SpringFields>(*record);
    if (f.parent == f.child) {
        reportTwo(context, *record, part, "Parent", "Child", "the child of " + part.title() + " is its parent as well");
        return std::nullopt;
    }
    const auto child = places.find(f.child), parent = places.find(f.parent);
    if (child == places.end() || (f.parent != "world" && parent == places.end())) return std::nullopt; // it has errors of its own
    SpringSpec spring;
    spring.child = child->second;
    if (f.parent != "world") spring.parent = parent->second;
    if (f.anchor) spring.anchor = vec3(*f.anchor);
    if (f.anchor2) spring.anchor2 = vec3(*f.anchor2);
    expanded.place(spring);
    const auto originOf = [&](int body) { return bodies[static_cast<std::size_t>(body)].pose.position; };
    if (!f.anchor && spring.parent != kWorldBody) spring.anchor = originOf(spring.parent);
    if (!f.anchor2) spring.anchor2 = originOf(spring.child);
    spring.name = expanded.name();
    spring.length = f.length.value_or((spring.anchor2 - spring.anchor).norm());
    spring.stiffness = f.stiffness;
    spring.damping = f.damping;
    spring.range = part.range;
    spring.nameRange = part.nameRange();
    return spring;
}

std::optional<GearSpec> resolveGear(ResolveContext& context, const ExpandedPart& expanded, const std::vector<JointSpec>& joints) {
    const Part& part = *expanded.part;
    const std::optional<Record> record = recordOf(context, expanded);
    if (!record) return std::nullopt;
    const auto f = fieldsFrom<GearFields>(*record);
    const auto fail = [&](const char* property, const std::string& message) {
        context.diagnostics.error(Code::BadJoint, record->rangeOf(property, part.nameRange()), message);
        return std::nullopt;
    };
    const auto indexOf = [&](const std::string& name) {
        return static_cast<int>(std::ranges::find(joints, name, &JointSpec::name) - joints.begin());
    };
    GearSpec gear{expanded.name(), indexOf(f.joint), indexOf(f.other), f.ratio, part.range, part.nameRange()};
    const int count = static_cast<int>(joints.size());
    if (gear.joint == count || gear.other == count) return std::nullopt; // they have errors of their own
    if (f.joint == f.other) {
        reportTwo(context, *record, part, "Joint", "Other", part.title() + " couples " + f.joint + " with itself");
        return std::nullopt;
    }
    if (!(std::abs(f.ratio) >= 1e-6))
        return fail("Ratio", "the Ratio of " + part.title() + " is zero; a joint that does not move is Fixed");
    const JointSpec &joint = joints[static_cast<std::size_t>(gear.joint)], &other = joints[static_cast<std::size_t>(gear.other)];
    gear.ratio = placedRatio(expanded, f.ratio, joint, other);
    if (const std::optional<std::string> fault = gearFault(joint, other, gear.ratio))
        return fail("Other", part.title() + ": " + *fault);
    return gear;
}

} // namespace trundle
