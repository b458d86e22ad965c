// What is between robots: joints and springs at the top level, regions, pairs that do not touch each other.
#include <algorithm>
#include <set>

#include "model/kinds/config_fields.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"
#include "model/robot_path.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr std::size_t kMostNames = 500; // that a message chooses from

/// A name of the world as it is written in a frame: in a member of a Repeat without the name of the member. Empty for what another
/// member has.
std::string nameWithin(const PartFrame& frame, std::string_view name) {
    for (const PartFrame* at = &frame; at && at->member; at = at->outer) {
        if (name.starts_with(at->prefix)) return std::string(name.substr(at->prefix.size()));
        const std::string& around = at->outer->prefix;
        if (name.starts_with(around) && isMemberOf(firstWord(name.substr(around.size())), at->config->name)) return {};
    }
    return std::string(name);
}

/// The robots that can be named in a member of a Repeat.
std::vector<std::string> robotNamesIn(const ResolveContext& context, const PartFrame& frame) {
    std::vector<std::string> names;
    const auto add = [&](const Part& part) {
        if (part.kind && (part.kind->name == "Robot" || part.is(Role::Layout))) names.push_back(part.name);
    };
    for (const PartFrame* at = &frame; at && at->member; at = at->outer) std::ranges::for_each(at->config->parts, add);
    for (const Part* part : context.outline.world.all()) add(*part);
    return names;
}

/// One end of a joint: a body of a robot, or the world.
struct LinkEnd {
    int robot = kWorldBody, body = 0;
    bool operator==(const LinkEnd&) const = default;
};

class LinkReader {
public:
    explicit LinkReader(ResolveContext& context) : m_context(context) {
        for (std::size_t i = 0; i < context.out.robots.size(); ++i)
            m_robots.emplace(context.out.robots[i].name, static_cast<int>(i));
    }

    void readJoint(const ExpandedPart& expanded) {
        const Part& part = *expanded.part;
        std::optional<Record> record = recordOf(expanded);
        if (!record) return;
        const PartFrame& frame = *expanded.frame;
        const std::optional<LinkEnd> parent = endOf(*record, "Parent", frame), child = endOf(*record, "Child", frame);
        if (!parent || !child) return;
        if (*parent == *child) { // by different names: row_0.a.b in the member of row that has it
            m_context.diagnostics.error(Code::BadJoint, record->rangeOf("Child", part.nameRange()),
                                        "the child of " + part.title() + " is its parent as well");
            return;
        }
        if (part.kind->name == "Spring") return readSpring(expanded, *record, *parent, *child);
        std::optional<JointSpec> joint = trundle::readJoint(m_context, part, *record);
        if (!joint) return;
        joint->parent = parent->body;
        joint->child = child->body;
        joint->name = expanded.name();
        (void)expanded.place(*joint);
        if (!record->given("Anchor")) joint->anchor = originOf(*child);
        warnAboutDuplicates(part, joint->name, *parent, *child);
        m_context.out.joints.push_back({std::move(*joint), parent->robot, child->robot});
    }

private:
    std::optional<Record> recordOf(const ExpandedPart& expanded) {
        const Part& part = *expanded.part;
        ParamScope scope(expanded.frame->scope);
        scope.declare(part.params);
        m_context.evaluator.checkAll(scope);
        Record record = m_context.read(part, scope, nullptr, Origin::Config);
        if (!record.complete) return std::nullopt;
        return record;
    }

    void readSpring(const ExpandedPart& expanded, const Record& record, const LinkEnd& parent, const LinkEnd& child) {
        const Part& part = *expanded.part;
        const auto f = fieldsFrom<SpringFields>(record);
        SpringSpec spring;
        spring.name = expanded.name();
        spring.parent = parent.body;
        spring.child = child.body;
        if (f.anchor) spring.anchor = vec3(*f.anchor);
        if (f.anchor2) spring.anchor2 = vec3(*f.anchor2);
        (void)expanded.place(spring);
        if (!f.anchor) spring.anchor = originOf(parent);
        if (!f.anchor2) spring.anchor2 = originOf(child);
        spring.length = f.length.value_or((spring.anchor2 - spring.anchor).norm());
        spring.stiffness = f.stiffness;
        spring.damping = f.damping;
        spring.range = part.range;
        spring.nameRange = part.nameRange();
        m_context.out.springs.push_back({std::move(spring), parent.robot, child.robot});
    }

    const RobotSpec& robotOf(const LinkEnd& end) const { return m_context.out.robots[static_cast<std::size_t>(end.robot)]; }
    Vec3 originOf(const LinkEnd& end) const {
        if (end.robot == kWorldBody) return Vec3::Zero();
        const RobotSpec& robot = robotOf(end);
        return robot.pose * robot.config->bodies[static_cast<std::size_t>(end.body)].pose.position;
    }

    /// Nothing if it names nothing, with a diagnostic, or something with errors of its own.
    std::optional<LinkEnd> endOf(const Record& record, const char* property, const PartFrame& frame) {
        const ResolvedValue& value = *record.find(property);
        const std::string& name = value.value.texts[0];
        if (name == "world" && std::string_view(property) == "Parent") return LinkEnd{kWorldBody, kWorldBody};
        const auto [robot, body] = robotAt(name, frame);
        if (robot == m_robots.end()) {
            if (!m_context.isFailedRobot(nameMeant(name, frame)) && !frame.isUnfinished(name))
                unknownRobot(record, property, frame);
            return std::nullopt;
        }
        const std::vector<BodySpec>& bodies = m_context.out.robots[static_cast<std::size_t>(robot->second)].config->bodies;
        const auto found = std::ranges::find(bodies, body, &BodySpec::name);
        if (found != bodies.end() && found->isFixed) return LinkEnd{kWorldBody, kWorldBody};
        if (found != bodies.end()) return LinkEnd{robot->second, static_cast<int>(found - bodies.begin())};
        unknown(record, property, robot->second, frame);
        return std::nullopt;
    }

    using Robots = std::map<std::string, int, std::less<>>;

    /// The robot that a path begins with, in a member of a Repeat first its own one, and what follows.
    std::pair<Robots::const_iterator, std::string> robotAt(const std::string& path, const PartFrame& frame) const {
        for (const PartFrame* at = &frame; at; at = at->outer) {
            std::string name = at->prefix;
            for (std::string_view rest = path; !rest.empty(); name += '.') {
                name += firstWord(rest);
                rest = withoutFirstWord(rest);
                if (const auto it = m_robots.find(name); it != m_robots.end()) return {it, std::string(rest)};
            }
        }
        return {m_robots.end(), {}};
    }

    /// A robot of the text that is not in the world has errors of its own.
    void unknownRobot(const Record& record, const char* property, const PartFrame& frame) {
        const ResolvedValue& value = *record.find(property);
        const std::string& name = value.value.texts[0];
        const std::string first(firstWord(name));
        const Part* part = m_context.outline.world.find(first);
        if (part && part->is(Role::Layout) && m_robots.contains(first + "_0")) {
            m_context.diagnostics.error(Code::UnknownReference, value.range,
                                        std::string(property) + " names " + name + ", but " + first + " is a " +
                                            part->kind->name + ": name one of its members, " + first + "_0." +
                                            std::string(withoutFirstWord(name)));
            return;
        }
        if (part && part->is(Role::Instance) && part->kind->name == "Static") {
            m_context.diagnostics.error(Code::UnknownReference, value.range,
                                        std::string(property) + " names " + name + ", but " + part->title() +
                                            " has no bodies; a joint with scenery that does not move has Parent=world");
            return;
        }
        const bool hasErrors = m_context.outline.unknown.contains(first) ||
                               (part && (part->is(Role::Instance) || part->is(Role::Layout))) ||
                               (layoutOfMember(m_context.outline, first) && m_robots.empty());
        if (!hasErrors) unknown(record, property, kWorldBody, frame);
    }

    /// `robot`: the one whose bodies are meant; kWorldBody: all.
    void unknown(const Record& record, const char* property, int robot, const PartFrame& frame) {
        const ResolvedValue& value = *record.find(property);
        const std::string& name = value.value.texts[0];
        std::vector<std::string> names;
        for (const RobotSpec& spec : m_context.out.robots) {
            if (robot != kWorldBody && &spec != &m_context.out.robots[static_cast<std::size_t>(robot)]) continue;
            const std::string own = nameWithin(frame, spec.name);
            for (const BodySpec& body : spec.config->bodies)
                if (!own.empty() && !body.isFixed && names.size() < kMostNames) names.push_back(own + "." + body.name);
        }
        std::erase(names, otherEnd(record, property));
        const std::size_t before = m_context.diagnostics.all().size();
        m_context.unknownReference(property, "body of a robot (robot.body)", name, value.range, value.origin != Origin::Param,
                                   names);
        if (m_context.diagnostics.all().size() == before || robot == kWorldBody || !isRobot(name, robot, frame)) return;
        Diagnostic& d = m_context.diagnostics.at(before);
        d.message = std::string(property) + " names " + name + ", a robot; it takes one of its bodies";
        if (d.suggestions.empty()) suggestWords(d, std::move(names), value.origin == Origin::Param ? SourceRange{} : value.range);
    }

    /// Whether a name is that of the robot itself.
    bool isRobot(const std::string& name, int robot, const PartFrame& frame) const {
        return isNamedBy(m_context.out.robots[static_cast<std::size_t>(robot)].name, nameMeant(name, frame));
    }

    void warnAboutDuplicates(const Part& part, const std::string& name, const LinkEnd& parent, const LinkEnd& child) {
        if (parent.robot == child.robot && parent.robot != kWorldBody)
            for (const JointSpec& own : robotOf(parent).config->joints)
                if (std::minmax({own.parent, own.child}) == std::minmax({parent.body, child.body}))
                    return warnAboutTwo(part, robotOf(parent).name + "." + own.name, name);
        for (const Link<JointSpec>& other : m_context.out.joints) {
            const LinkEnd otherParent{other.parentRobot, other.spec.parent}, otherChild{other.childRobot, other.spec.child};
            if ((otherParent != parent || otherChild != child) && (otherParent != child || otherChild != parent)) continue;
            return warnAboutTwo(part, other.spec.name, name);
        }
    }

    void warnAboutTwo(const Part& part, const std::string& one, const std::string& other) {
        if (m_reported.insert(&part).second) // of a Repeat of one member
            warnAboutTwoJoints(m_context, part, one, other);
    }

    ResolveContext& m_context;
    std::set<const Part*> m_reported;
    Robots m_robots; ///< indices by name
};

/// The indices of robots that a property lists.
std::vector<std::size_t> robotsOf(const ResolveContext& context, const std::vector<std::string>& names) {
    std::vector<std::size_t> robots;
    for (std::size_t i = 0; i < context.out.robots.size(); ++i)
        if (std::ranges::find(names, context.out.robots[i].name) != names.end()) robots.push_back(i);
    return robots;
}

/// False, with a diagnostic, if there is no such robot in a member of a Repeat or around it.
bool knowsRobot(ResolveContext& context, const Property& property, const ResolvedValue& value, std::size_t k,
                const PartFrame& frame) {
    const std::string& name = value.value.texts[k];
    const std::string meant = nameMeant(name, frame);
    const Outline& outline = context.outline;
    if (!frame.member || outline.world.find(meant) || layoutOfMember(outline, meant) || outline.unknown.contains(meant))
        return true;
    const bool isLiteral = value.origin != Origin::Param && (value.value.texts.size() == 1 || !value.names.empty());
    context.unknownReference(property.name, "robot", name, value.rangeOf(k), isLiteral, robotNamesIn(context, frame));
    return false;
}

void resolveRegion(ResolveContext& context, const ExpandedPart& expanded) {
    const Part& part = *expanded.part;
    ParamScope scope(expanded.frame->scope);
    scope.declare(part.params);
    context.evaluator.checkAll(scope);
    Record record = context.read(part, scope, nullptr, Origin::Config);
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        if (record.kind->properties[i].name != "Robots" || !record.values[i]) continue;
        const Property& property = record.kind->properties[i];
        ResolvedValue& value = *record.values[i];
        for (std::size_t k = 0; k < value.value.texts.size(); ++k)
            if (!knowsRobot(context, property, value, k, *expanded.frame)) return;
        for (std::string& name : value.value.texts) name = nameMeant(name, *expanded.frame);
        record.complete = checkRobots(context, property, value) && record.complete;
    }
    if (!record.complete) return;
    const auto f = fieldsFrom<RegionFields>(record);
    RegionSpec region{expanded.name(), expanded.placed(poseOf(f.pos, f.hpr)), vec3(f.size), {}, part.range, part.nameRange()};
    const bool isGiven = record.given("Robots"); // possibly all of them are robots with errors of their own
    if (isGiven) region.robots = robotsOf(context, record.find("Robots")->value.texts);
    for (std::size_t i = 0; !isGiven && i < context.out.robots.size(); ++i)
        if (!context.out.robots[i].scenery) region.robots.push_back(i);
    context.out.regions.push_back(std::move(region));
}

/// The settings were read before the robots that they name.
void resolveApartRobots(ResolveContext& context) {
    Diagnostics silent;
    ExperimentSpec nothing;
    ResolveContext quiet(context.outline, context.assets, silent, nothing);
    Record record = quiet.readSettings();
    const auto membersOf = [&](const std::string& name) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < context.out.robots.size(); ++i)
            if (isNamedBy(context.out.robots[i].name, name, IsOwnName{context.outline})) members.push_back(i);
        return members;
    };
    const auto pairs = namePairs(context, record, {});
    if (pairs.empty()) return;
    ResolvedValue all = *record.find("NoContact"); // a copy, in which members replace what names them
    if (!checkRobots(context, *record.kind->find("NoContact"), all)) return;
    for (const auto& [first, second] : pairs) {
        for (const std::size_t a : membersOf(first))
            for (const std::size_t b : membersOf(second))
                if (a != b) context.out.noContact.emplace_back(std::min(a, b), std::max(a, b));
    }
    auto& apart = context.out.noContact;
    std::ranges::sort(apart);
    apart.erase(std::unique(apart.begin(), apart.end()), apart.end());
}

} // namespace

std::string nameMeant(const std::string& name, const PartFrame& frame) {
    for (const PartFrame* at = &frame; at && at->member; at = at->outer)
        if (inRepeat(*at->config, firstWord(name))) return at->prefix + name;
    return name;
}

std::vector<std::pair<std::string, std::string>> namePairs(ResolveContext& context, const Record& record, SourceRange otherwise) {
    std::vector<std::pair<std::string, std::string>> pairs;
    const ResolvedValue* value = record.find("NoContact");
    if (!value) return pairs;
    const std::vector<std::string>& names = value->value.texts;
    if (names.size() % 2 != 0) {
        context.diagnostics.error(Code::WrongCount, value->range.known() ? value->range : otherwise,
                                  "NoContact takes pairs of names, a,b or a,b, c,d; " + names.back() + " has no second one");
        return pairs;
    }
    for (std::size_t i = 0; i + 1 < names.size(); i += 2) pairs.emplace_back(names[i], names[i + 1]);
    return pairs;
}

void resolveLinks(ResolveContext& context, PartExpansion& world) {
    LinkReader links(context);
    world.each(Role::Joint, [&](const ExpandedPart& part) { links.readJoint(part); });
    world.each(Role::Region, [&](const ExpandedPart& part) { resolveRegion(context, part); });
    resolveApartRobots(context);
}

} // namespace trundle
