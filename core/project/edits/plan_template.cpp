// Writes the smallest valid text of a kind at a given position: required properties have values, references use existing names,
// and missing prerequisites are written before it.

#include <array>
#include <filesystem>
#include <set>

#include "base/units.h"
#include "project/edits/plan_targets.h"
#include "project/edits/plans.h"
#include "project/edits/template_position.h"
#include "project/edits/template_wheels.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"
#include "project/objects/reference_space.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxDeep = 4;       ///< depth of prerequisites: a motor needs a joint, which needs a body ...
constexpr int kMaxEntries = 5000; ///< entries of folders searched for a file

bool fitsChoice(const Part& part, const std::string& choice) {
    return part.usable && part.kind && (choice == part.kind->name || choice == roleName(part.kind->role));
}

/// A number within the limits, of a typical size for its unit.
double likelyNumber(const Property& p) {
    double value = p.unit == "m" ? 0.1 : p.unit == "V" ? 12 : p.unit == "N m/A" || p.unit == "Nm/A" ? 0.05 : 1;
    if (p.name.find("Separation") != std::string::npos) value = 0.3;
    const auto low = [&](double v) { return v > p.minimum || (v == p.minimum && !p.minExclusive); };
    const auto high = [&](double v) { return v < p.maximum || (v == p.maximum && !p.maxExclusive); };
    if (low(value) && high(value)) return value;
    const bool below = std::isfinite(p.minimum), above = std::isfinite(p.maximum);
    if (below && above) value = p.minExclusive || p.maxExclusive ? (p.minimum + p.maximum) / 2 : p.minimum;
    else if (below) value = p.minExclusive ? p.minimum + 1 : p.minimum;
    else value = p.maxExclusive ? p.maximum - 1 : p.maximum;
    return p.type == PropertyType::Integer ? std::floor(value) : value;
}

class Template {
public:
    Template(const LoadedProject& loaded, const std::string& parent) : m_loaded(loaded), m_parent(parent) {
        const std::optional<ObjectLocation> place = placeOf(loaded, parent);
        if (!place || !place->part) return;
        m_chain = place->above;
        m_chain.push_back(place->part);
        const bool isReached = place->instance && !place->instance->isPartUse() && m_chain.front() != place->instance;
        if (isReached) m_chain.insert(m_chain.begin(), place->instance);
        if (place->part == place->instance)
            if (const Part* config = configOf(loaded, *place->part)) m_chain.push_back(config);
        for (const Part* part : m_chain)
            if (part->is(Role::Config)) m_config = part;
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
        } else if (kind.role == Role::Repeat && bodyAround(target)) {
            const Kind& box = *m_loaded.registry->find("Box");
            const std::string place = position(box, bodyAround(target));
            text += kind.name == "Ring" ? place : "";
            text += "\n  Box box { Size=0.05,0.05,0.05" + (kind.name == "Ring" ? "" : place) + looks(box, target) + mass(box, target) + " }\n";
        } else if ((kind.name == "PartConfig" && !isScenery()) || (kind.role == Role::Repeat && !holdsScenery()))
            text += "\n  Body body { Box box { Size=0.1,0.1,0.1" + looks(kind, nullptr) + " Mass=0.1 } }\n";
        else if (kind.name == "StaticConfig" || kind.name == "PartConfig" || kind.role == Role::Repeat)
            text += "\n  Box box { Size=0.2,0.2,0.2 Pos=0,0,0.1" + looks(kind, nullptr) + " }\n";
        else text += " ";
        m_texts.push_back(text + "}");
        m_made.emplace_back(&kind, name);
        if (kind.role == Role::Body && isScenery() && depth == 0) hold(name);
        return name;
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
        if (kind.name == "Scatter" && p.name == "Area") return "-1,-1,1,1";
        if ((kind.role == Role::Layout || kind.role == Role::Repeat) && p.name == "Count") return "3";
        if (kind.role == Role::Layout && p.name == "Spacing") return "1";
        if (kind.name == "DifferentialDrive" && p.type == PropertyType::Number)
            if (const auto wheels = m_config ? wheelsOf(m_loaded, *m_config, m_motors[0], m_motors[1]) : std::nullopt)
                return shortNumber(p.name == "WheelRadius" ? wheels->radius : wheels->separation);
        switch (p.type) {
        case PropertyType::Reference: return reference(kind, p, depth);
        case PropertyType::Boolean: return repeated(p, "false");
        case PropertyType::Choice: return repeated(p, p.choices.empty() ? "none" : p.choices.front());
        case PropertyType::File: return repeated(p, file(p, name));
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
        } else if (m_config) {
            for (const Part& part : m_config->parts) {
                if (fitsChoice(part, choice)) names.push_back(part.name);
                for (const Part& geom : part.parts)
                    if (part.is(Role::Body) && fitsChoice(geom, choice)) names.push_back(part.name + "." + geom.name);
            }
        }
        for (const auto& [made, name] : m_made) {
            if (made->name == choice || (!kind && choice == roleName(made->role))) names.push_back(name);
            if (made->role == Role::Body && (choice == "Geom" || choice == "Box")) names.push_back(name + ".box");
        }
        return names;
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
        return part.kind->name != "RobotConfig" ||
               std::any_of(part.parts.begin(), part.parts.end(), [](const Part& p) { return p.usable && p.is(Role::Body); });
    }

    /// Whether a device of the same kind already uses the name.
    bool usedBySame(const Kind& kind, const Property& p, const std::string& name) const {
        if (!m_config) return false;
        return std::any_of(m_config->parts.begin(), m_config->parts.end(), [&](const Part& part) {
            const SourceAssignment* a = part.kind == &kind ? part.assignments.find(p.name) : nullptr;
            return a && std::any_of(a->value->elements.begin(), a->value->elements.end(),
                                    [&](const Element& e) { return e.text == name; });
        });
    }

    std::string reference(const Kind& kind, const Property& p, int depth) {
        std::vector<std::string> all;
        for (const std::string& choice : p.choices)
            for (std::string& name : candidates(choice)) all.push_back(std::move(name));
        const std::string side = p.name == "LeftMotor" ? "left" : p.name == "RightMotor" ? "right" : "";
        std::stable_partition(all.begin(), all.end(), [&](const std::string& n) { return n.starts_with(side); });
        std::stable_partition(all.begin(), all.end(), [&](const std::string& n) { return !usedBySame(kind, p, n); });
        std::erase_if(all, [&](const std::string& n) { return m_used.count({&kind, n}) > 0; });
        std::string text;
        for (std::uint32_t i = 0; i < std::max(p.minCount, 1u) && i < 1000; ++i) {
            std::string name = i < all.size() ? all[i] : make(p, depth);
            if (name.empty()) name = all.empty() ? "world" : all.back();
            m_used.emplace(&kind, name);
            text += (text.empty() ? "" : ",") + name;
        }
        if (p.name == "LeftMotor") m_motors[0] = text;
        if (p.name == "RightMotor") m_motors[1] = text;
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
        std::string child, parent = "world";
        if (bodies.empty()) bodies.push_back(block(*m_loaded.registry->find("Body"), depth + 1));
        for (std::size_t i = bodies.size(); i-- > 0 && child.empty();)
            if (i > 0 && !isChild(bodies[i])) child = bodies[i];
        if (child.empty() && !m_made.empty() && m_made.back().first->role == Role::Body) child = m_made.back().second;
        if (child.empty() && (bodies.size() > 1 || isChild(bodies.front())))
            child = block(*m_loaded.registry->find("Body"), depth + 1);
        if (child.empty()) child = bodies.front();
        m_children.push_back(child);
        for (const std::string& body : bodies)
            if (body != child && parent == "world") parent = body;
        return " Parent=" + parent + " Child=" + child;
    }
    /// The same at the top level: bodies of the last two robots.
    std::string endsBetweenRobots(int depth) {
        std::vector<std::string> bodies;
        for (const Part* part : m_loaded.outline->world.all()) {
            const Part* config =
                isPlaced(*part) && part->usable && part->kind->name != "Static" ? configOf(m_loaded, *part) : nullptr;
            const auto first =
                config ? std::ranges::find_if(config->parts, [](const Part& p) { return p.usable && p.is(Role::Body); })
                       : std::vector<Part>::const_iterator();
            if (config && first != config->parts.end())
                bodies.push_back(part->name + (part->is(Role::Layout) ? "_0." : ".") + first->name);
        }
        if (bodies.empty()) bodies.push_back(block(*m_loaded.registry->find("Robot"), depth + 1) + ".chassis");
        const std::string child = bodies.back();
        return " Parent=" + (bodies.size() > 1 ? bodies[bodies.size() - 2] : std::string("world")) + " Child=" + child;
    }
    /// Of a joint of the config, or of this template.
    bool isChild(const std::string& body) const {
        if (std::find(m_children.begin(), m_children.end(), body) != m_children.end()) return true;
        return m_config && std::any_of(m_config->parts.begin(), m_config->parts.end(), [&](const Part& part) {
                   const SourceAssignment* a = part.is(Role::Joint) ? part.assignments.find("Child") : nullptr;
                   return a && a->value->elements.size() == 1 && a->value->elements[0].text == body;
               });
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

    // --- files ---

    /// A file of a suitable type: one in the project, else one shipped with the program.
    std::string file(const Property& p, const std::string& name) const {
        std::string found;
        const auto fits = [&](const std::string& path) {
            return std::any_of(p.choices.begin(), p.choices.end(), [&](const std::string& e) { return path.ends_with("." + e); });
        };
        std::error_code ec;
        int looked = 0;
        fs::recursive_directory_iterator it(m_loaded.projectFolder, fs::directory_options::skip_permission_denied, ec), end;
        for (; !ec && it != end && ++looked < kMaxEntries; it.increment(ec)) {
            if (it.depth() > 4) it.disable_recursion_pending();
            std::error_code status;
            if (!it->is_regular_file(status) || !fits(it->path().filename().string())) continue;
            const std::string path = it->path().lexically_relative(m_loaded.projectFolder).generic_string();
            if (found.empty() || path < found) found = path;
        }
        if (found.empty())
            found = fits("block.obj")   ? "block.obj"
                    : fits("hills.png") ? "hills.png"
                                        : name + "." + (p.choices.empty() ? "txt" : p.choices[0]);
        return "\"" + found + "\"";
    }

    const LoadedProject& m_loaded;
    const std::string m_parent;
    std::vector<const Part*> m_chain; ///< from the outermost block to the parent
    const Part* m_config = nullptr;
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
