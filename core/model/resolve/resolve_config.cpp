// Resolves a RobotConfig with one set of Param values and overrides: bodies, then joints, then devices.
#include <algorithm>
#include <set>
#include <utility>

#include "model/body_geom.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/kinds/config_fields.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/reference_check.h"
#include "model/resolve/relative_poses.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// The name of the joint between two bodies.
struct JoinedPairs {
    std::map<std::pair<int, int>, std::string> names;
    std::set<const Part*> reported; ///< once for all members of a Repeat
};

void warnAboutDuplicateJoints(ResolveContext& context, JoinedPairs& pairs, const JointSpec& joint, const Part& part) {
    const auto [it, fresh] = pairs.names.try_emplace(std::minmax({joint.parent, joint.child}), joint.name);
    if (fresh || !pairs.reported.insert(&part).second) return;
    warnAboutTwoJoints(context, part, it->second, joint.name);
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

bool hasMirrorImage(ResolveContext& context, const ExpandedPart& device) {
    for (const PartFrame* at = device.frame; at->use; at = at->outer) {
        if (at->placement.canPlace(device.part->kind->name)) continue;
        context.diagnostics.error(Code::BadGeometry, device.part->nameRange(),
                                  device.part->title() + " has no mirror image; take it out of the Part that is mirrored");
        return false;
    }
    return true;
}

/// Whether the geoms that a device names are there: of a Repeat in a Body only its members are.
bool hasGeoms(ResolveContext& context, const Record& record, const std::vector<BodySpec>& bodies) {
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        const Property& property = record.kind->properties[i];
        if (property.type != PropertyType::Reference || !record.values[i] || !std::ranges::count(property.choices, "Geom"))
            continue;
        for (const std::string& name : record.values[i]->value.texts) {
            const BodyGeom at = geomAt(bodies, name);
            const bool isBody = std::ranges::find(bodies, name, &BodySpec::name) != bodies.end();
            if (at.body < 0 || at.geom >= 0 || isBody) continue;
            const BodySpec& body = bodies[static_cast<std::size_t>(at.body)];
            std::vector<std::string> names;
            for (const GeomSpec& geom : body.geoms) names.push_back(body.name + "." + geom.name);
            context.unknownReference(property.name, "geom (body.geom)", name, record.values[i]->range,
                                     record.values[i]->value.texts.size() == 1, names);
            return false;
        }
    }
    return true;
}

/// What its antennas send to the left they send to the right.
void mirrorAntennas(ResolveContext& context, ComponentSpec& device, const Kind& kind) {
    for (const Property& property : kind.properties) {
        const auto value = device.values.find(property.name);
        if (value == device.values.end() || !std::ranges::count(property.choices, "AntennaPattern")) continue;
        for (std::string& name : value->second.value.texts) name = mirroredAntenna(context, name);
    }
}

std::optional<ComponentSpec> resolveDevice(ResolveContext& context, const ExpandedPart& expanded,
                                           const std::vector<BodySpec>& bodies) {
    const Part& part = *expanded.part;
    ParamScope own(expanded.frame->scope);
    own.declare(part.params);
    context.evaluator.checkAll(own);
    Record record = context.read(part, own, expanded.overrides(), Origin::Config);
    const bool known = checkReferences(context, record, *expanded.frame) && hasGeoms(context, record, bodies);
    if (!record.complete || !known || !checkOrder(context, record, part) || !hasMirrorImage(context, expanded)) return std::nullopt;
    ComponentSpec device = componentFrom(record, part);
    expanded.place(device);
    if (expanded.isMirrored()) mirrorAntennas(context, device, *record.kind);
    device.name = expanded.name();
    return device;
}

/// Behind those that the spec already has. Then all frames of the expansion are placed.
BodyIndices resolveBodies(ResolveContext& context, PartExpansion& expansion, RobotConfigSpec& spec) {
    BodyIndices places;
    RelativePoses poses(context);
    std::map<const Part*, std::map<const PartFrame*, BodySpec>> described;
    expansion.each(Role::Body, [&](const ExpandedPart& part) {
        std::string in;
        SourceRange place;
        std::optional<BodySpec> body = resolveBody(context, part, in, place);
        if (!body) return;
        poses.add(part, body->pose, in, place);
        described[part.part].emplace(part.frame, std::move(*body));
    });
    expansion.each(Role::Body, [&](const ExpandedPart& part) { // a pose may count from a body further down
        const auto bodies = described.find(part.part);
        if (bodies == described.end()) return;
        const auto it = bodies->second.find(part.frame);
        if (it == bodies->second.end()) return;
        BodySpec& body = it->second;
        body.name = part.name();
        const std::optional<Pose> pose = poses.of(body.name);
        if (!pose) return;
        body.pose = *pose;
        (void)part.place(body);
        places.emplace(body.name, static_cast<int>(spec.bodies.size()));
        spec.bodies.push_back(std::move(body));
    });
    for (const Role role : {Role::Geom, Role::Joint, Role::Device})
        expansion.each(role, [&](const ExpandedPart& part) { poses.completeFrames(*part.frame); });
    return places;
}

void resolveJointsAndDevices(ResolveContext& context, PartExpansion& expansion, const BodyIndices& places,
                             RobotConfigSpec& spec) {
    JoinedPairs pairs;
    const auto isKind = [](const ExpandedPart& part, std::string_view kind) { return part.part->kind->name == kind; };
    expansion.each(Role::Joint, [&](const ExpandedPart& part) {
        if (isKind(part, "Gear")) return;
        if (isKind(part, "Spring")) {
            if (auto spring = resolveSpring(context, part, spec.bodies, places)) spec.springs.push_back(std::move(*spring));
            return;
        }
        std::optional<JointSpec> joint = resolveJoint(context, part, spec.bodies, places);
        if (!joint) return;
        warnAboutDuplicateJoints(context, pairs, *joint, *part.part);
        spec.joints.push_back(std::move(*joint));
    });
    expansion.each(Role::Joint, [&](const ExpandedPart& part) {
        if (!isKind(part, "Gear")) return;
        if (auto gear = resolveGear(context, part, spec.joints)) spec.gears.push_back(std::move(*gear));
    });
    expansion.each(Role::Device, [&](const ExpandedPart& part) {
        if (auto device = resolveDevice(context, part, spec.bodies)) spec.devices.push_back(std::move(*device));
    });
}

void resolveParts(ResolveContext& context, PartExpansion& expansion, RobotConfigSpec& spec) {
    resolveJointsAndDevices(context, expansion, resolveBodies(context, expansion, spec), spec);
}

/// Whether a name is that of a body or of what it is in: of a Repeat q, "q_1.d" is in "q_1.d", "q_1", "q.d" and "q".
bool isIn(const PartFrame& frame, std::string_view body, std::string_view name) {
    const PartFrame* at = &frame; // that the words so far lead to
    for (; !name.empty(); name = withoutFirstWord(name), body = withoutFirstWord(body)) {
        const std::string_view word = firstWord(body);
        if (word != firstWord(name) && !isMemberOf(word, firstWord(name))) return false;
        const auto inner = at->inner.find(word);
        const bool isInner = inner != at->inner.end();
        if (word != firstWord(name) && !(isInner && inner->second->member)) return false; // `q_1` may be no member of a q
        if (isInner) at = inner->second;
    }
    return true;
}

void resolveNoContact(ResolveContext& context, const PartFrame& frame, const Record& own, RobotConfigSpec& spec) {
    const Part& config = *frame.config;
    const ResolvedValue* value = own.find("NoContact");
    // Of a Part, a Repeat or one of its members all bodies in it.
    const auto bodiesOf = [&](const std::string& name) {
        std::vector<int> bodies;
        for (std::size_t i = 0; i < spec.bodies.size(); ++i)
            if (isIn(frame, spec.bodies[i].name, name)) bodies.push_back(static_cast<int>(i));
        return bodies;
    };
    std::size_t at = 0; // of the name in the list
    for (const auto& [first, second] : namePairs(context, own, config.nameRange())) {
        const std::vector<int> ofFirst = bodiesOf(first), ofSecond = bodiesOf(second);
        for (const auto& [name, bodies] : {std::pair(&first, &ofFirst), std::pair(&second, &ofSecond)}) {
            const Part* part = config.findPath(*name);
            const std::size_t k = at++;
            const bool isFaulty = frame.isUnfinished(*name) || // it has errors of its own
                                  (part && part->is(Role::Body) && !memberName(firstWord(*name)));
            if (!bodies->empty() || isFaulty) continue;
            std::vector<std::string> names;
            for (const BodySpec& body : spec.bodies) {
                const std::string_view first = firstWord(body.name); // a Part, or a member of a Repeat
                const auto member = first == body.name ? std::nullopt : memberName(first);
                std::string holder(member ? member->stem : first);
                if (std::ranges::find(names, holder) == names.end()) names.push_back(std::move(holder));
            }
            for (const BodySpec& body : spec.bodies)
                if (body.name.find('.') != std::string::npos) names.push_back(body.name);
            context.unknownReference("NoContact", "Body", *name, value->rangeOf(k),
                                     !value->names.empty() && value->origin != Origin::Param, names);
        }
        for (const int a : ofFirst)
            for (const int b : ofSecond)
                if (a != b) spec.noContact.push_back(std::minmax(a, b));
    }
    std::ranges::sort(spec.noContact);
    spec.noContact.erase(std::unique(spec.noContact.begin(), spec.noContact.end()), spec.noContact.end());
    if (!spec.noContact.empty() && !spec.selfCollision)
        context.diagnostics.hint(Code::Conflict, value->range,
                                 "NoContact has no effect: bodies of " + config.title() +
                                     " touch each other with SelfCollision=true only");
}

/// Reports bodies of scenery that no joint, or chain of joints, holds to the world: they would be loose.
void reportLooseBodies(ResolveContext& context, const RobotConfigSpec& spec) {
    std::vector<bool> held(spec.bodies.size(), false);
    for (std::size_t i = 0; i < spec.bodies.size(); ++i) held[i] = spec.bodies[i].isFixed;
    for (bool more = true; std::exchange(more, false);)
        for (const JointSpec& joint : spec.joints) {
            const auto child = static_cast<std::size_t>(joint.child);
            const bool parentHeld = joint.parent == kWorldBody || held[static_cast<std::size_t>(joint.parent)];
            if (parentHeld == held[child]) continue;
            held[parentHeld ? child : static_cast<std::size_t>(joint.parent)] = more = true;
        }
    std::set<SourceRange> reported; // the members of a Repeat have one block
    for (std::size_t i = 0; i < spec.bodies.size(); ++i)
        if (!held[i] && reported.insert(spec.bodies[i].nameRange).second)
            context.diagnostics.error(
                Code::WrongPlace, spec.bodies[i].nameRange,
                "no joint holds Body " + spec.bodies[i].name +
                    " to the world: a StaticConfig holds its geoms directly, without a Body, and bodies that "
                    "move on joints; what is loose is a Robot");
}

} // namespace

std::shared_ptr<const StaticConfigSpec> resolveStaticConfig(ResolveContext& context, const Part& config, ParamScope& scope,
                                                            const OverrideNode* overrides) {
    auto spec = std::make_shared<StaticConfigSpec>();
    (void)readConfig(context, config, scope, overrides);
    PartExpansion expansion(context, config, scope, overrides);
    RobotConfigSpec moving;
    moving.name = config.name;
    moving.range = config.range;
    BodySpec& frame = moving.bodies.emplace_back();
    frame.name = kFixedBody;
    frame.isFixed = true;
    frame.mass = {0, Vec3::Zero(), Mat3::Zero()};
    frame.range = config.range;
    frame.nameRange = config.nameRange();
    std::size_t errors = context.diagnostics.errorCount();
    const BodyIndices places = resolveBodies(context, expansion, moving);
    const std::size_t ofBodies = context.diagnostics.errorCount() - errors;
    expansion.each(Role::Geom, [&](const ExpandedPart& part) { // they may count from a body
        std::optional<GeomSpec> geom = resolveGeom(context, *part.part, *part.frame->scope, part.overrides(), false);
        if (!geom || !part.place(*geom, context)) return;
        geom->name = part.name();
        spec->geoms.push_back(std::move(*geom));
    });
    errors = context.diagnostics.errorCount() - ofBodies;
    resolveJointsAndDevices(context, expansion, places, moving);
    std::size_t joints = 0;
    expansion.each(Role::Joint, [&](const ExpandedPart&) { ++joints; });
    // A joint with an error that was reported before does not count as a further one.
    if (context.diagnostics.errorCount() == errors && joints == moving.joints.size()) reportLooseBodies(context, moving);
    if (moving.bodies.size() > 1 || !moving.devices.empty())
        spec->moving = std::make_shared<const RobotConfigSpec>(std::move(moving));
    return spec;
}

std::shared_ptr<const RobotConfigSpec> resolveRobotConfig(ResolveContext& context, const Part& config, ParamScope& scope,
                                                          const OverrideNode* overrides) {
    auto spec = std::make_shared<RobotConfigSpec>();
    spec->name = config.name;
    spec->range = config.range;
    const Record own = readConfig(context, config, scope, overrides);
    spec->selfCollision = fieldsFrom<RobotConfigFields>(own).selfCollision;
    PartExpansion expansion(context, config, scope, overrides);
    const bool bodies = std::ranges::any_of(expansion.parts(), [](const ExpandedPart& part) {
        return part.part->is(Role::Body) || part.part->is(Role::Geom) || !part.part->kind;
    });
    const bool hasUses =
        std::ranges::any_of(config.parts, [](const Part& part) { return part.isRepeat() || (part.isPartUse() && !part.config); });
    if (!bodies && !hasUses && !isBaseMissing(config) && !context.brokenText(config.range)) {
        context.diagnostics.error(Code::MissingRequired, config.nameRange(),
                                  config.title() + " needs a Body: the first one carries the robot's pose");
    }
    resolveParts(context, expansion, *spec);
    resolveNoContact(context, expansion.root(), own, *spec);
    return spec;
}

void checkPartConfig(ResolveContext& context, const Part& config) {
    ParamScope scope(&context.globals);
    scope.declare(config.params);
    context.evaluator.checkAll(scope);
    (void)readConfig(context, config, scope, nullptr);
    RobotConfigSpec discarded;
    PartExpansion expansion(context, config, scope, nullptr);
    resolveParts(context, expansion, discarded);
    expansion.each(Role::Geom,
                   [&](const ExpandedPart& part) { (void)resolveGeom(context, *part.part, *part.frame->scope, nullptr, false); });
}

} // namespace trundle
