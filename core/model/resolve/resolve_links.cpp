// What is between robots: joints and springs at the top level, regions, pairs that do not touch each other.
#include <algorithm>

#include "model/dotted_path.h"
#include "model/kinds/config_fields.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

constexpr std::size_t kMostNames = 500; // that a message chooses from

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

    void readJoint(const Part& part) {
        std::optional<Record> record = recordOf(part);
        if (!record) return;
        const std::optional<LinkEnd> parent = endOf(*record, "Parent"), child = endOf(*record, "Child");
        if (!parent || !child) return;
        if (part.kind->name == "Spring") return readSpring(part, *record, *parent, *child);
        std::optional<JointSpec> joint = trundle::readJoint(m_context, part, *record);
        if (!joint) return;
        joint->parent = parent->body;
        joint->child = child->body;
        if (!record->given("Anchor")) joint->anchor = originOf(*child);
        warnAboutDuplicates(part, *parent, *child);
        m_context.out.joints.push_back({std::move(*joint), parent->robot, child->robot});
    }

private:
    std::optional<Record> recordOf(const Part& part) {
        ParamScope scope(&m_context.globals);
        scope.declare(part.params);
        m_context.evaluator.checkAll(scope);
        Record record = m_context.read(part, scope, nullptr, Origin::Config);
        if (!record.complete) return std::nullopt;
        return record;
    }

    void readSpring(const Part& part, const Record& record, const LinkEnd& parent, const LinkEnd& child) {
        const auto f = fieldsFrom<SpringFields>(record);
        if (f.parent == f.child) {
            m_context.diagnostics.error(Code::BadJoint, record.rangeOf("Child", part.nameRange()),
                                        "the child of " + part.title() + " is its parent as well");
            return;
        }
        SpringSpec spring;
        spring.name = part.name;
        spring.parent = parent.body;
        spring.child = child.body;
        spring.anchor = f.anchor ? vec3(*f.anchor) : originOf(parent);
        spring.anchor2 = f.anchor2 ? vec3(*f.anchor2) : originOf(child);
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
    std::optional<LinkEnd> endOf(const Record& record, const char* property) {
        const ResolvedValue& value = *record.find(property);
        const std::string &name = value.value.texts[0], first(firstWord(name)), body(withoutFirstWord(name));
        if (name == "world" && std::string_view(property) == "Parent") return LinkEnd{kWorldBody, kWorldBody};
        const auto robot = m_robots.find(first);
        if (robot == m_robots.end()) return unknownRobot(property, name, value), std::nullopt;
        const std::vector<BodySpec>& bodies = m_context.out.robots[static_cast<std::size_t>(robot->second)].config->bodies;
        const auto found = std::ranges::find(bodies, body, &BodySpec::name);
        if (found != bodies.end() && found->isFixed) return LinkEnd{kWorldBody, kWorldBody};
        if (found != bodies.end()) return LinkEnd{robot->second, static_cast<int>(found - bodies.begin())};
        unknown(property, name, value, robot->second);
        return std::nullopt;
    }

    /// A robot of the text that is not in the world has errors of its own.
    void unknownRobot(const char* property, const std::string& name, const ResolvedValue& value) {
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
        if (!hasErrors) unknown(property, name, value, kWorldBody);
    }

    /// `robot`: the one whose bodies are meant; kWorldBody: all.
    void unknown(const char* property, const std::string& name, const ResolvedValue& value, int robot) {
        std::vector<std::string> names;
        for (const RobotSpec& spec : m_context.out.robots) {
            if (robot != kWorldBody && &spec != &m_context.out.robots[static_cast<std::size_t>(robot)]) continue;
            for (const BodySpec& body : spec.config->bodies)
                if (!body.isFixed && names.size() < kMostNames) names.push_back(spec.name + "." + body.name);
        }
        m_context.unknownReference(property, "body of a robot (robot.body)", name, value.range, value.origin != Origin::Param,
                                   names);
    }

    void warnAboutDuplicates(const Part& part, const LinkEnd& parent, const LinkEnd& child) {
        for (const Link<JointSpec>& other : m_context.out.joints) {
            const LinkEnd otherParent{other.parentRobot, other.spec.parent}, otherChild{other.childRobot, other.spec.child};
            if ((otherParent != parent || otherChild != child) && (otherParent != child || otherChild != parent)) continue;
            m_context.diagnostics.warning(Code::BadJoint, part.nameRange(),
                                          "two joints join the same bodies: " + other.spec.name + " and " + part.name);
            return;
        }
    }

    ResolveContext& m_context;
    std::map<std::string, int, std::less<>> m_robots; ///< indices by name
};

/// The indices of robots that a property lists.
std::vector<std::size_t> robotsOf(const ResolveContext& context, const std::vector<std::string>& names) {
    std::vector<std::size_t> robots;
    for (std::size_t i = 0; i < context.out.robots.size(); ++i)
        if (std::ranges::find(names, context.out.robots[i].name) != names.end()) robots.push_back(i);
    return robots;
}

void resolveRegion(ResolveContext& context, const Part& part) {
    ParamScope scope(&context.globals);
    scope.declare(part.params);
    context.evaluator.checkAll(scope);
    Record record = context.read(part, scope, nullptr, Origin::Config);
    for (std::size_t i = 0; i < record.values.size(); ++i)
        if (record.kind->properties[i].name == "Robots" && record.values[i])
            record.complete = checkRobots(context, record.kind->properties[i], *record.values[i]) && record.complete;
    if (!record.complete) return;
    const auto f = fieldsFrom<RegionFields>(record);
    RegionSpec region{part.name, poseOf(f.pos, f.hpr), vec3(f.size), {}, part.range, part.nameRange()};
    if (f.robots) region.robots = robotsOf(context, *f.robots);
    for (std::size_t i = 0; !f.robots && i < context.out.robots.size(); ++i)
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
        std::vector<std::size_t> members = robotsOf(context, {name});
        const Part* layout = context.outline.world.find(name);
        for (std::size_t i = 0; layout && layout->is(Role::Layout) && i < context.out.robots.size(); ++i)
            if (context.out.robots[i].range == layout->range) members.push_back(i);
        return members;
    };
    const auto pairs = namePairs(context, record, {});
    for (const auto& [first, second] : pairs) {
        for (const std::string& name : {first, second}) {
            const Property* property = record.kind->find("NoContact");
            ResolvedValue one = *record.find("NoContact");
            one.value.texts = {name};
            one.origin = Origin::Param; // its range is that of the list, which no fix may replace
            if (!checkRobots(context, *property, one)) return;
        }
        for (const std::size_t a : membersOf(first))
            for (const std::size_t b : membersOf(second))
                if (a != b) context.out.noContact.emplace_back(std::min(a, b), std::max(a, b));
    }
    auto& all = context.out.noContact;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
}

} // namespace

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

void resolveLinks(ResolveContext& context) {
    LinkReader links(context);
    for (const Part* part : context.outline.world.all()) {
        if (part->is(Role::Joint)) links.readJoint(*part);
        if (part->is(Role::Region)) resolveRegion(context, *part);
    }
    resolveApartRobots(context);
}

} // namespace trundle
