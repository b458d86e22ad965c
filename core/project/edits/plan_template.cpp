// Writes the smallest valid text of a kind at a given position: required properties have values, references use existing names,
// and missing prerequisites are written before it.

#include <array>
#include <set>

#include "model/config_blocks.h"
#include "project/edits/plan_targets.h"
#include "project/edits/plans.h"
#include "project/edits/template_position.h"
#include "project/edits/template_values.h"
#include "project/edits/template_wheels.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"
#include "project/objects/reference_space.h"

namespace trundle {

namespace {

constexpr int kMaxDeep = 4; ///< depth of prerequisites: a motor needs a joint, which needs a body ...

class Template {
public:
    Template(const LoadedProject& loaded, const std::string& parent) : m_loaded(loaded), m_parent(parent) {
        const std::optional<ObjectLocation> place = placeOf(loaded, parent);
        if (!place || !place->part) return;
        m_chain = place->above;
        m_chain.push_back(place->part);
        const bool isReached = place->instance && !place->instance->isPartUse() && m_chain.front() != place->instance;
        if (isReached) m_chain.insert(m_chain.begin(), place->instance);
        if (place->part == place->instance && !place->part->isPartUse())
            if (const Part* config = configOf(loaded, *place->part)) m_chain.push_back(config);
        for (std::size_t i = 1; i < m_chain.size();) { // what is added to a variant is written in it
            const bool isBase = isVariant(*m_chain[i - 1]) && m_chain[i - 1]->config == m_chain[i];
            if (isBase) m_chain.erase(m_chain.begin() + static_cast<std::ptrdiff_t>(i));
            else ++i;
        }
        bool isInBody = false; // a Repeat there is one of geoms
        for (const Part* part : m_chain) {
            if (part->is(Role::Config)) m_config = part, m_repeats.clear();
            isInBody = isInBody || part->is(Role::Body);
            if (part->isRepeat() && m_config && !isInBody) m_repeats.push_back(part);
        }
    }

    std::string write(const Kind& kind) {
        if (kind.role == Role::Settings) return {};
        block(kind, 0);
        std::string all;
        for (const std::string& text : m_texts) all += (all.empty() ? "" : "\n") + text;
        return all;
    }

    /// A Robot of one body with one geom, resting on the ground.
    std::string writeObject(const Kind& geom) {
        const Kind *config = m_loaded.registry->find("RobotConfig"), *robot = m_loaded.registry->find("Robot");
        if (geom.role != Role::Geom || std::find(geom.parents.begin(), geom.parents.end(), "Body") == geom.parents.end())
            return {};
        const std::string title = geom.name == "Sphere" ? "Ball" : geom.name;
        const std::string configName = UsedNames(m_loaded, nullptr, config).take(title + "Object");
        const std::string name = UsedNames(m_loaded, nullptr, robot).take(lowerFirst(title));
        std::string size;
        for (const Property& p : geom.properties)
            if (p.required) size += " " + p.name + "=" + (p.name == "Radius" ? "0.1" : repeated(p, "0.2"));
        return "RobotConfig " + configName + " {\n  Body body { " + geom.name + " " + lowerFirst(title) + " {" + size +
               " Pos=0,0,0.1" + looks(geom, nullptr) + " Mass=0.5 } }\n}\nRobot " + name + " { Config=" + configName +
               " Pos=0,0,0 }";
    }

private:
    /// Writes a block, after the blocks that it needs; returns its name.
    std::string block(const Kind& kind, int depth) {
        const Part* target = holder(kind);
        const NameSpace* space = target ? nullptr : m_loaded.outline->spaceOf(kind);
        UsedNames& names = m_names.try_emplace({target, space}, m_loaded, target, &kind).first->second;
        const std::string name = names.take(preferred(kind));
        std::string text = kind.name + " " + name + " {";
        if (kind.role == Role::Joint && kind.find("Child")) text += ends(depth);
        else
            for (const Property& p : kind.properties)
                if (p.required) text += " " + p.name + "=" + value(kind, p, name, depth);
        for (const Alternatives& choice : kind.alternatives) text += alternative(kind, choice, name, depth);
        if (kind.name == "Part") text += outside(text);
        if (kind.role == Role::Geom) text += position(kind, target) + looks(kind, target) + mass(kind, target);
        if (kind.role == Role::Instance || kind.role == Role::Layout) text += " Pos=0,0,0";
        if (kind.role == Role::Body)
            text += position(*m_loaded.registry->find("Box"), target) + " Box box { Size=0.1,0.1,0.1" +
                    looks(*m_loaded.registry->find("Box"), nullptr) + " Mass=0.1 }";
        const bool isInWorld = kind.role == Role::Repeat && (!target || target->isInWorld);
        if (kind.name == "Repeat") text += isInWorld ? " Pos=$index,0,0" : " Pos=$(0.2*index),0,0";
        if (kind.name == "RobotConfig")
            text += "\n  Body chassis { Box hull { Size=0.2,0.2,0.1 Pos=0,0,0.05" + looks(kind, nullptr) + " Mass=1 } }\n";
        else if (isInWorld) {
            const Kind& robot = *m_loaded.registry->find("Robot");
            text += "\n  Robot robot { Config=" + value(robot, *robot.find("Config"), "robot", depth) + " }\n";
        } else if (kind.role == Role::Repeat && (bodyAround(target) || !holdsScenery())) {
            text += members(kind, target);
        } else if (kind.name == "PartConfig" && !isScenery())
            text += "\n  Body body { Box box { Size=0.1,0.1,0.1" + looks(kind, nullptr) + " Mass=0.1 } }\n";
        else if (kind.name == "StaticConfig" || kind.name == "PartConfig" || kind.role == Role::Repeat)
            text += "\n  Box box { Size=0.2,0.2,0.2 Pos=0,0,0.1" + looks(kind, nullptr) + " }\n";
        else text += " ";
        m_texts.push_back(text + "}");
        m_made.emplace_back(&kind, name);
        if (kind.role == Role::Body && isScenery() && depth == 0) hold(name);
        return name;
    }

    /// The place and the contents of a Repeat or Ring in a robot: geoms in a body, else bodies, on top of what is there.
    std::string members(const Kind& kind, const Part* target) const {
        const Kind& box = *m_loaded.registry->find("Box");
        const Part* body = bodyAround(target);
        const std::string place = position(box, body ? body : target), ofRing = kind.name == "Ring" ? place : "";
        const std::string ofMember = ofRing.empty() ? place : "";
        if (body)
            return ofRing + "\n  Box box { Size=0.05,0.05,0.05" + ofMember + looks(box, target) + mass(box, target) + " }\n";
        return ofRing + "\n  Body body {" + ofMember + " Box box { Size=0.1,0.1,0.1" + looks(kind, nullptr) + " Mass=0.1 } }\n";
    }

    /// A body of scenery needs a joint: one that holds it.
    void hold(const std::string& body) {
        const Kind& fixed = *m_loaded.registry->find("Fixed");
        UsedNames& names = m_names.try_emplace({holder(fixed), nullptr}, m_loaded, holder(fixed), &fixed).first->second;
        m_texts.push_back("Fixed " + names.take("hold") + " { Parent=world Child=" + body + " }");
    }

    std::string preferred(const Kind& kind) const {
        if (kind.role == Role::Controller) return "brain";
        if (kind.name == "DifferentialDrive") return "base"; // the name that controllers look for
        if (kind.name == "Robot") return "robot0";
        if (kind.name == "Grid" || kind.name == "Scatter") return "swarm";
        if (kind.role == Role::Config)
            return kind.name == "RobotConfig" ? "MyRobot" : kind.name == "PartConfig" ? "MyPart" : "MyArena";
        return lowerFirst(kind.name);
    }

    /// The block of the parent's chain that can contain the kind.
    const Part* holder(const Kind& kind) const {
        for (auto it = m_chain.rbegin(); it != m_chain.rend(); ++it)
            if (isAllowedIn(kind, *it)) return *it;
        return nullptr;
    }

    std::string value(const Kind& kind, const Property& p, const std::string& name, int depth) {
        if (kind.name == "Scatter" && p.name == "Area") return "-2,-2,2,2";
        if ((kind.role == Role::Layout || kind.role == Role::Repeat) && p.name == "Count") return "3";
        if (kind.role == Role::Layout && p.name == "Spacing") return "1";
        if (inConfig() && (p.name == "WheelRadius" || p.name == "WheelSeparation"))
            if (const auto wheels = wheelsOf(*inConfig(), m_motors[0], m_motors[1]))
                return shortNumber(p.name == "WheelRadius" ? wheels->radius : wheels->separation);
        switch (p.type) {
        case PropertyType::Reference: return reference(kind, p, depth);
        case PropertyType::Boolean: return repeated(p, "false");
        case PropertyType::Choice: return repeated(p, p.choices.empty() ? "none" : p.choices.front());
        case PropertyType::File: return repeated(p, likelyFile(m_loaded, p, name));
        case PropertyType::Text: return repeated(p, kind.role == Role::Log && p.name.starts_with("Signal") ? signals() : name);
        default: return repeated(p, shortNumber(likelyNumber(p)));
        }
    }
    static std::string repeated(const Property& p, const std::string& element) {
        std::string all = element;
        for (std::uint32_t i = 1; i < p.minCount && i < 1000; ++i) all += "," + element;
        return all;
    }

    /// Writes one of several alternative properties; its value is that of `choice.likely` if that property is required.
    std::string alternative(const Kind& kind, const Alternatives& choice, const std::string& name, int depth) {
        if (choice.names.empty()) return {};
        for (const std::string& each : choice.names)
            if (const Property* p = kind.find(each); p && p->required) return {};
        const Property* p = kind.find(choice.names.back());
        const Property* likely = kind.find(choice.likely);
        if (!p) return {};
        return " " + p->name + "=" +
               value(kind, likely && likely->required && likely->type == p->type ? *likely : *p, name, depth);
    }

    std::string signals() const {
        for (const RobotSpec& robot : m_loaded.experiment->robots) return "\"" + robot.name + "/*\"";
        return "\"*\"";
    }

    // --- references ---

    /// Names of objects that `choice` allows: existing ones, then those of this text.
    std::vector<std::string> candidates(const std::string& choice) const {
        std::vector<std::string> names;
        const Kind* kind = m_loaded.registry->find(choice);
        if (const NameSpace* space = kind ? referenceSpace(*m_loaded.outline, *kind) : nullptr) {
            for (const Part* part : space->all())
                if (part->kind == kind && part->usable && sound(*part)) names.push_back(part->name);
        } else if (inConfig()) {
            names = inConfig()->fitting(choice);
        }
        for (const auto& [made, name] : m_made) {
            if (made->name == choice || (!kind && choice == roleName(made->role))) names.push_back(name);
            if (made->role == Role::Body && (choice == "Geom" || choice == "Box")) names.push_back(name + ".box");
        }
        return names;
    }

    /// nullptr: the parent is in no config.
    const TemplateNames* inConfig() const {
        if (m_config && !m_inConfig) m_inConfig.emplace(m_loaded, *m_config, m_repeats);
        return m_inConfig ? &*m_inConfig : nullptr;
    }

    /// Whether a Repeat in the config is for geoms without a body.
    bool holdsScenery() const { return isScenery() || (m_config && !isAllowedIn(*m_loaded.registry->find("Body"), m_config)); }

    bool isScenery() const { return m_config && m_config->kind->name == "StaticConfig"; }

    /// Values for the Params by which a PartConfig is joined to what is outside of it: the first body of the config.
    std::string outside(const std::string& block) const {
        const std::size_t at = block.find("Config=");
        const std::string name = at == std::string::npos ? std::string() : block.substr(at + 7, block.find(' ', at) - at - 7);
        const Part* used = m_loaded.outline->configs.find(name);
        std::string text;
        for (const SourceParam& param : used ? used->params : std::vector<SourceParam>()) {
            if (!param.required) continue;
            const std::vector<std::string> bodies = candidates("Body");
            text += " " + param.name->text + "=" + (bodies.empty() ? "$" + param.name->text : bodies.front());
        }
        return text;
    }

    /// Whether a Part in the config can use a PartConfig: not itself in it, and geoms without a body in scenery only.
    bool fitsPart(const Part& part) const {
        const auto contains = [&](const auto& self, const Part& config) -> bool {
            bool isFound = &config == m_config;
            eachPartUse(config, [&](const Part& use) { isFound = isFound || (use.config && self(self, *use.config)); });
            return isFound;
        };
        const auto fits = [&](const auto& self, const Part& p) -> bool {
            if (p.isRepeat()) return std::ranges::all_of(p.parts, [&](const Part& inner) { return self(self, inner); });
            return p.usable && (isScenery() || !p.is(Role::Geom));
        };
        return !contains(contains, part) && !part.parts.empty() &&
               std::ranges::all_of(part.parts, [&](const Part& p) { return fits(fits, p); });
    }

    /// A RobotConfig needs a body to be usable.
    bool sound(const Part& part) const {
        if (part.kind->name == "PartConfig") return fitsPart(part);
        return part.kind->name != "RobotConfig" || !firstBody(part).empty();
    }

    std::string firstBody(const Part& config) const {
        const auto own = std::ranges::find_if(config.parts, [](const Part& p) { return p.usable && p.is(Role::Body); });
        if (own != config.parts.end()) return own->name;
        const std::vector<std::string> bodies = TemplateNames(m_loaded, config, {}).fitting("Body");
        return bodies.empty() ? std::string() : bodies.front();
    }

    std::string reference(const Kind& kind, const Property& p, int depth) {
        std::vector<std::string> all;
        for (const std::string& choice : p.choices)
            for (std::string& name : candidates(choice)) all.push_back(std::move(name));
        const TemplateNames* names = inConfig();
        std::map<std::string, int> misfits;
        for (const std::string& n : all) misfits.emplace(n, sideMisfit(names, p.name, n));
        std::ranges::stable_sort(all, {}, [&](const std::string& n) { return misfits[n]; });
        const auto isFree = [&](const std::string& n) { return !names || !names->isUsed(kind, p.name, n); };
        const auto used = std::stable_partition(all.begin(), all.end(), isFree);
        const bool isOfJoint = std::ranges::any_of(p.choices, [&](const std::string& choice) {
            const Kind* chosen = m_loaded.registry->find(choice);
            return chosen && chosen->role == Role::Joint;
        });
        if (depth > 0 && isOfJoint) all.erase(used, all.end()); // a second motor of a drive has a joint of its own
        std::erase_if(all, [&](const std::string& n) { return m_used.count({&kind, n}) > 0; });
        std::string text;
        for (std::uint32_t i = 0; i < std::max(p.minCount, 1u) && i < 1000; ++i) {
            std::string name = i < all.size() ? all[i] : make(p, depth);
            if (name.empty()) name = all.empty() ? "world" : all.back();
            m_used.emplace(&kind, name);
            text += (text.empty() ? "" : ",") + name;
        }
        if (std::ranges::count(p.choices, "RotaryMotor") > 0)
            for (const std::size_t side : {0, 1})
                if (m_motors[side].empty() && p.name.find(side == 0 ? "Left" : "Right") != std::string::npos)
                    m_motors[side] = text.substr(0, text.find(','));
        return text;
    }

    /// Writes a block that the property can refer to; returns its name.
    std::string make(const Property& p, int depth) {
        if (depth >= kMaxDeep) return {};
        for (const std::string& choice : p.choices) {
            const Kind* kind = m_loaded.registry->find(choice);
            if (choice == "Joint") kind = m_loaded.registry->find("Hinge");
            if (choice == "Geom" || (kind && kind->role == Role::Geom))
                return block(*m_loaded.registry->find("Body"), depth + 1) + ".box";
            if (!kind || kind->role == Role::Settings) continue;
            const std::string name = block(*kind, depth + 1);
            if (p.name == "Other" && kind->find("Anchor")) // the two joints of a Gear are not on one line
                m_texts.back().insert(m_texts.back().size() - 2, " Anchor=0.2,0,0");
            return name;
        }
        for (const std::string& choice : p.choices) // choices that are roles
            for (const Kind* kind : m_loaded.registry->all())
                if (choice == roleName(kind->role) && kind->role != Role::Settings) return block(*kind, depth + 1);
        return {};
    }

    /// Parent and Child of a joint: Child is a body that is not yet the child of a joint, Parent another body, or the world if
    /// there is none.
    std::string ends(int depth) {
        if (!m_config) return endsBetweenRobots(depth);
        std::vector<std::string> bodies = candidates("Body");
        if (bodies.empty()) bodies.push_back(block(*m_loaded.registry->find("Body"), depth + 1));
        const bool isAlone = bodies.size() == 1 && !isChild(bodies.front()) && m_repeats.empty();
        const bool mayPin = depth == 0 || isScenery(); // a robot is not pinned to the world for a motor that it lacks
        std::string child = freeBody(bodies);
        if (child.empty()) child = isAlone && mayPin ? bodies.front() : block(*m_loaded.registry->find("Body"), depth + 1);
        m_children.push_back(child);
        std::string parent = "world";
        for (const std::string& body : bodies)
            if (body != child && (parent == "world" || (isInside(parent) && !isInside(body)))) parent = body;
        return " Parent=" + parent + " Child=" + child;
    }
    /// The last body that is no child of a joint, in as few Parts as there is one: not the first one of a config, which carries its
    /// pose, and in a Repeat one of a member, since it can be the child of one joint only.
    std::string freeBody(const std::vector<std::string>& bodies) const {
        std::string found;
        int least = 0;
        for (std::size_t i = bodies.size(); i-- > (m_repeats.empty() ? 1 : 0);) {
            const NamedBlock* block = inConfig()->find(bodies[i]);
            const int depth = block ? block->depth : 0;
            if (isChild(bodies[i]) || !isInside(bodies[i]) || (!found.empty() && depth >= least)) continue;
            found = bodies[i];
            least = depth;
        }
        return found;
    }
    bool isInside(const std::string& body) const {
        const NamedBlock* block = inConfig()->find(body);
        return !block || inConfig()->isInside(*block);
    }
    /// The same at the top level: bodies of the last two robots.
    std::string endsBetweenRobots(int depth) {
        std::vector<std::string> bodies;
        for (const Part* part : m_loaded.outline->world.all()) {
            const Part* config =
                isPlaced(*part) && part->usable && part->kind->name != "Static" ? configOf(m_loaded, *part) : nullptr;
            const std::string first = config ? firstBody(*config) : std::string();
            if (!first.empty()) bodies.push_back(part->name + (part->is(Role::Layout) ? "_0." : ".") + first);
        }
        if (bodies.empty()) bodies.push_back(block(*m_loaded.registry->find("Robot"), depth + 1) + ".chassis");
        const std::string child = bodies.back();
        return " Parent=" + (bodies.size() > 1 ? bodies[bodies.size() - 2] : std::string("world")) + " Child=" + child;
    }
    /// Of a joint of the config, or of this template.
    bool isChild(const std::string& body) const {
        return std::ranges::count(m_children, body) > 0 || (inConfig() && inConfig()->isChild(body));
    }

    // --- geoms ---

    /// Pos of a geom, or of a body with that geom: on what is there already, above the floor.
    std::string position(const Kind& geom, const Part* target) const {
        const std::optional<GeomSpec> shape = target ? templateShape(geom) : std::nullopt;
        if (!shape) return {};
        const Vec3 p = templatePosition(m_loaded, m_parent, *target, *shape);
        return p.isZero() ? std::string() : " Pos=" + positionText(p);
    }

    /// Material and Surface as used by the sibling geoms, else the first ones defined.
    std::string looks(const Kind& kind, const Part* target) const {
        (void)kind;
        std::string text;
        for (const char* key : {"Material", "Surface"}) {
            std::string name;
            const NameSpace& space =
                std::string_view(key) == "Material" ? m_loaded.outline->materials : m_loaded.outline->surfaces;
            for (const Part& part : target ? target->parts : std::vector<Part>()) {
                const SourceAssignment* a = part.assignments.find(key);
                if (name.empty() && a && a->value->elements.size() == 1 && space.find(a->value->elements[0].text))
                    name = a->value->elements[0].text;
            }
            for (const Part* part : space.all())
                if (name.empty() && part->usable) name = part->name;
            if (!name.empty()) text += std::string(" ") + key + "=" + name;
        }
        return text;
    }

    std::string mass(const Kind& kind, const Part* target) const {
        const Part* body = bodyAround(target);
        return body && kind.find("Mass") && !body->assignments.find("Mass") ? " Mass=0.1" : "";
    }

    /// The Body that a block of the chain is or is in; nullptr: none.
    const Part* bodyAround(const Part* target) const {
        const Part* body = nullptr;
        for (const Part* part : m_chain) {
            if (part->is(Role::Body)) body = part;
            if (part == target) return body;
        }
        return nullptr;
    }

    const LoadedProject& m_loaded;
    const std::string m_parent;
    std::vector<const Part*> m_chain; ///< from the outermost block to the parent
    const Part* m_config = nullptr;
    std::vector<const Part*> m_repeats;              ///< of the config, in which the parent is
    mutable std::optional<TemplateNames> m_inConfig; ///< read when it is asked for
    std::vector<std::string> m_texts;
    std::vector<std::pair<const Kind*, std::string>> m_made; ///< blocks of this text
    std::vector<std::string> m_children;                     ///< bodies that its joints carry
    std::set<std::pair<const Kind*, std::string>> m_used;    ///< names already used by references of blocks of that kind
    std::array<std::string, 2> m_motors;                     ///< LeftMotor and RightMotor of the drive that is written
    std::map<std::pair<const Part*, const NameSpace*>, UsedNames> m_names;
};

} // namespace

std::string templateOf(const LoadedProject& loaded, const Kind& kind, const std::string& parent) {
    return Template(loaded, parent).write(kind);
}

std::string objectTemplateOf(const LoadedProject& loaded, const Kind& geom) { return Template(loaded, {}).writeObject(geom); }

} // namespace trundle
