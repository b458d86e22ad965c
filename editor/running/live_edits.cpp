#include "editor/running/live_edits.h"

#include <algorithm>
#include <map>
#include <span>

#include "model/dotted_path.h"
#include "model/outline.h"
#include "model/provenance.h"
#include "model/robot_path.h"

namespace trundle {
namespace {

// ---- changed properties, found by comparing texts ----

using Texts = std::map<std::string, std::string>; // of values, by dotted path

void noteValue(const Outline& outline, FileId file, const Value* value, const std::string& path, Texts& out) {
    if (value) out.emplace(path, outline.texts().slice(file, value->range));
}

/// Collects the text of every value by its path, and the kind of every object.
void note(const Outline& outline, const Part& part, const std::string& path, Texts& out) {
    out.emplace(path, part.block->type.text);
    for (const SourceAssignment& a : part.assignments.all()) noteValue(outline, a.file, a.value, path + "." + a.key, out);
    for (const SourceParam& p : part.params) noteValue(outline, p.valueFile, p.value, path + "." + p.name->text, out);
    for (const Part& inner : part.parts) note(outline, inner, path + "." + inner.name, out);
}

bool isNamedByKind(const Part& part) {
    return part.is(Role::Material) || part.is(Role::Surface) || part.is(Role::Pattern) || part.is(Role::Config);
}

Texts textsOf(const Outline& outline) {
    Texts out;
    for (const SourceAssignment& a : outline.settings.all()) noteValue(outline, a.file, a.value, a.key, out);
    for (const SourceParam& p : outline.params) noteValue(outline, p.valueFile, p.value, p.name->text, out);
    for (const auto& part : outline.parts)
        note(outline, *part, isNamedByKind(*part) ? part->block->type.text + "." + part->name : part->name, out);
    return out;
}

/// Whether the path leads to a View or into one. The 3D views show Views of the current text; only a FrameLog uses one in the run.
bool isShownView(const Outline& outline, const std::string& path) {
    const std::string name(firstWord(path));
    const Part* view = outline.world.find(name);
    if (!view || view->block->type.text != "View") return false;
    return std::ranges::none_of(outline.parts, [&](const auto& part) {
        const SourceAssignment* used = part->is(Role::Log) ? part->assignments.find("View") : nullptr;
        return used && used->value && outline.texts().slice(used->file, used->value->range) == name;
    });
}

bool isLive(const Outline& outline, const std::string& path) {
    if (isShownView(outline, path)) return true;
    if (path.starts_with("Material.") || path.starts_with("Surface.")) return !withoutFirstWord(withoutFirstWord(path)).empty();
    const auto from = provenanceOf(outline, path);
    return from && from->property && from->property->live;
}

/// Whether an added or removed object that contains the path is already listed.
bool isBelowLast(const std::vector<std::string>& paths, const std::string& path) {
    return !paths.empty() && path.starts_with(paths.back() + ".");
}

/// The text of a setting or of a Param of the top level; nothing if it is not set.
std::optional<std::string_view> settingIn(const Outline& outline, const std::string& key) {
    if (const SourceAssignment* a = outline.settings.find(key)) return outline.texts().slice(a->valueRange());
    for (const SourceParam& p : outline.params)
        if (p.name->text == key) return outline.texts().slice(p.valueFile, p.value->range);
    return std::nullopt;
}

/// The block of a path as declared: "RobotConfig.Rover.chassis"; null if no block has it.
const Part* declaredAt(const Outline& outline, const std::string& path) {
    const DottedPath dotted(path);
    std::span<const std::string> words = dotted.words();
    const Part* part = outline.world.find(words[0]);
    std::size_t used = 1;
    if (!part && words.size() > 1) {
        const Kind* kind = outline.registry().find(words[0]);
        const NameSpace* space = kind ? outline.spaceOf(*kind) : nullptr;
        part = space ? space->find(words[1]) : nullptr;
        used = 2;
    }
    for (; part && used < words.size(); ++used) part = part->find(words[used]);
    return part;
}

/// The path of the block that a robot of the run has in the text: "row.cart" of "row_3.cart", "row.swarm" of "row_3.swarm_12".
std::string blockPathOf(const Outline& outline, std::string_view robot) {
    std::string path = nameOfAll(robot);
    if (!outline.world.find(path) && layoutOfMember(outline, path)) path.resize(memberName(path)->stem.size());
    return path;
}

/// The text of a property or Param of a block; nothing if it is not set.
std::optional<std::string_view> textIn(const Outline& outline, const Part* part, const std::string& key, bool isParam) {
    if (!part) return std::nullopt;
    if (isParam) {
        const SourceParam* param = part->param(key);
        return param ? std::optional(outline.texts().slice(param->valueFile, param->value->range)) : std::nullopt;
    }
    const SourceAssignment* a = part->assignments.find(key);
    return a ? std::optional(outline.texts().slice(a->valueRange())) : std::nullopt;
}

// ---- live properties: commands for the running world ----

/// A changed value of a live property of one component.
struct LiveValue {
    std::string property;
    ResolvedValue value;
};

class LiveComparison {
public:
    /// `changed`: paths of the blocks to look at; none: all.
    LiveComparison(const ExperimentSpec& running, const LoadedProject& now, const std::optional<std::set<std::string>>& changed,
                   const std::set<std::string>& swapped, LiveEdits& out)
        : m_running(running), m_now(*now.experiment), m_outline(*now.outline), m_registry(*now.registry), m_out(out),
          m_swapped(swapped), m_isWhole(!changed) {
        if (changed)
            for (const std::string& path : *changed) addTop(path);
    }

    void go() {
        surfaces();
        materials();
        for (std::size_t i = 0; i < m_running.robots.size(); ++i)
            if (isMeant(m_running.robots[i])) robot(i);
        if (m_changed) m_out.experiment = m_changed;
    }

    [[nodiscard]] std::size_t compared() const { return m_compared; }

private:
    /// "Surface.rubber" of "Surface.rubber", "robot0" of "robot0.brain".
    void addTop(const std::string& path) {
        const Kind* kind = m_registry.find(firstWord(path));
        if (kind && kind->role == Role::Config) m_hasConfig = true;
        const bool isByKind = kind && (kind->role == Role::Material || kind->role == Role::Surface);
        m_tops.insert(isByKind ? pathInside(firstWord(path), firstWord(withoutFirstWord(path))) : std::string(firstWord(path)));
    }

    /// Whether a block of this path is to be looked at.
    bool isMeant(const std::string& path) {
        const bool isMeant = m_isWhole || m_tops.contains(path);
        m_compared += isMeant;
        return isMeant;
    }

    /// A robot is changed by its own block, by the Grid, Scatter or Repeat that it is in, and by any config: its own may be a
    /// variant of that one, or use it in a Part.
    bool isMeant(const RobotSpec& robot) {
        const bool isMeant =
            m_isWhole || m_hasConfig || m_tops.contains(std::string(firstWord(blockPathOf(m_outline, robot.name))));
        m_compared += isMeant;
        return isMeant;
    }

    ExperimentSpec& changed() {
        if (!m_changed) m_changed = std::make_shared<ExperimentSpec>(m_running);
        return *m_changed;
    }

    void surfaces() {
        for (std::size_t i = 0; i < m_running.surfaces.size(); ++i) {
            if (!isMeant("Surface." + m_running.surfaces[i].name)) continue;
            const auto first = std::ranges::find(m_running.surfaces, m_running.surfaces[i].name, &SurfaceSpec::name);
            if (first != m_running.surfaces.begin() + std::ptrdiff_t(i)) continue; // of mirrored parts; follows the first one
            for (const SurfaceSpec& s : m_now.surfaces) {
                const SurfaceSpec& r = m_running.surfaces[i];
                if (s.name != r.name) continue;
                const bool same = s.friction == r.friction && s.friction2 == r.friction2 &&
                                  s.frictionHeading == r.frictionHeading && s.restitution == r.restitution &&
                                  s.rollingFriction == r.rollingFriction && s.softness == r.softness;
                if (same) break;
                m_out.commands.emplace_back(SurfaceCommand{s});
                for (std::size_t k = i; k < m_running.surfaces.size(); ++k) {
                    if (m_running.surfaces[k].name != s.name) continue;
                    changed().surfaces[k] = s;
                    if (k > i) changed().surfaces[k].frictionHeading = -s.frictionHeading;
                }
                break;
            }
        }
    }

    void materials() {
        for (std::size_t i = 0; i < m_running.materials.size(); ++i) {
            if (!isMeant("Material." + m_running.materials[i].name)) continue;
            for (const MaterialSpec& m : m_now.materials) {
                const MaterialSpec& r = m_running.materials[i];
                if (m.name != r.name) continue;
                const bool same = m.colour == r.colour && m.texturePath == r.texturePath && m.textureMap == r.textureMap &&
                                  m.textureScale == r.textureScale && m.shininess == r.shininess && m.opacity == r.opacity &&
                                  m.emission == r.emission;
                if (!same) changed().materials[i] = m;
                break;
            }
        }
    }

    std::vector<LiveValue> differences(const ComponentSpec& running, const ComponentSpec& now) const {
        std::vector<LiveValue> found;
        const Kind* kind = running.kind == now.kind ? m_registry.find(now.kind) : nullptr;
        if (!kind) return found;
        for (const Property& property : kind->properties) {
            if (!property.live) continue;
            const ResolvedValue *was = running.find(property.name), *is = now.find(property.name);
            if (is && (!was || was->value != is->value)) found.push_back({property.name, *is});
        }
        return found;
    }

    void addConsoleLine(const std::string& object, ComponentSpec& spec, const std::vector<LiveValue>& values) {
        for (const LiveValue& v : values) {
            m_out.commands.emplace_back(PropertyCommand{object, v.property, v.value.value});
            spec.values[v.property] = v.value;
        }
    }

    void robot(std::size_t index) {
        if (m_robots.empty())
            for (const RobotSpec& robot : m_now.robots) m_robots.emplace(robot.name, &robot);
        const RobotSpec& running = m_running.robots[index];
        const auto found = m_robots.find(running.name);
        if (found == m_robots.end()) return;
        const RobotSpec& now = *found->second;
        controllers(index, now);
        if (running.config && now.config && running.config != now.config) devices(index, now);
    }

    /// Controllers are compared by name. Of the others each new one takes the place of an old one, in their order; what is left goes or
    /// comes. Those that go are first: their commands are free for others.
    void controllers(std::size_t index, const RobotSpec& now) {
        const RobotSpec& running = m_running.robots[index];
        const auto isNew = [&](const ControllerSpec& is) { return !named(running.controllers, is.name); };
        const auto newOnes = static_cast<std::size_t>(std::ranges::count_if(now.controllers, isNew));
        std::vector<const ControllerSpec*> gone;
        for (const ControllerSpec& was : running.controllers)
            if (!named(now.controllers, was.name)) gone.push_back(&was);
        bool any = !gone.empty();
        for (; gone.size() > newOnes; gone.pop_back()) swap(running, gone.back(), nullptr);
        std::vector<ControllerSpec> result;
        auto next = gone.begin();
        for (const ControllerSpec& is : now.controllers) {
            const ControllerSpec* was = named(running.controllers, is.name);
            if (was && !isReplaced(running.name, *was, is)) {
                const std::vector<LiveValue> values = differences(*was, is);
                addConsoleLine(running.name + "/" + is.name, result.emplace_back(*was), values);
                any = any || !values.empty();
                continue;
            }
            if (!was && next != gone.end()) was = *next++;
            swap(running, was, &is);
            result.push_back(is);
            any = true;
        }
        if (any) changed().robots[index].controllers = std::move(result);
    }

    static const ControllerSpec* named(const std::vector<ControllerSpec>& controllers, const std::string& name) {
        const auto found = std::ranges::find(controllers, name, &ControllerSpec::name);
        return found != controllers.end() ? &*found : nullptr;
    }

    /// Of one that came during the run every value is followed: its next edit replaces it again.
    [[nodiscard]] bool isReplaced(const std::string& robot, const ControllerSpec& from, const ControllerSpec& to) const {
        if (from.kind != to.kind || from.name != to.name) return true;
        const Kind* kind = m_swapped.contains(robot + "." + to.name) ? m_registry.find(to.kind) : nullptr;
        return kind && std::ranges::any_of(kind->properties, [&](const Property& property) {
                   const ResolvedValue *was = from.find(property.name), *is = to.find(property.name);
                   return !property.live && (was ? !is || was->value != is->value : is != nullptr);
               });
    }

    /// The new one's place in messages is the robot's, since the run shows places in the text that it was built from.
    void swap(const RobotSpec& robot, const ControllerSpec* from, const ControllerSpec* to) {
        SwapCommand command{robot.name, from ? from->name : std::string(), {}, {}};
        if (to) {
            command.to = *to;
            command.to->range = robot.range;
            command.to->nameRange = robot.nameRange;
            if (const Kind* kind = m_registry.find(to->kind)) command.library = kind->module;
        }
        m_out.commands.emplace_back(std::move(command));
        for (const std::string& owner : {robot.name, blockPathOf(m_outline, robot.name)}) // the run's and the text's
            for (const ControllerSpec* each : {from, to})
                if (each) m_out.swapped.insert(owner + "." + each->name);
    }

    void devices(std::size_t index, const RobotSpec& now) {
        const RobotSpec& running = m_running.robots[index];
        const auto key = std::pair{running.config.get(), now.config.get()};
        const auto known = m_configs.find(key);
        const bool isNew = known == m_configs.end();
        ConfigChange& change = isNew ? m_configs[key] : known->second;
        if (isNew) change = compared(*running.config, *now.config);
        if (!change.config) return;
        for (const auto& [device, value] : change.values)
            m_out.commands.emplace_back(PropertyCommand{running.name + "/" + device, value.property, value.value.value});
        changed().robots[index].config = change.config;
    }

    /// Robots that share a config share the changed one too.
    struct ConfigChange {
        std::shared_ptr<const RobotConfigSpec> config; // null: no live change
        std::vector<std::pair<std::string, LiveValue>> values;
    };

    ConfigChange compared(const RobotConfigSpec& running, const RobotConfigSpec& now) const {
        ConfigChange change;
        std::shared_ptr<RobotConfigSpec> config;
        for (std::size_t d = 0; d < running.devices.size(); ++d)
            for (const ComponentSpec& device : now.devices) {
                if (device.name != running.devices[d].name) continue;
                for (LiveValue& value : differences(running.devices[d], device)) {
                    if (!config) config = std::make_shared<RobotConfigSpec>(running);
                    config->devices[d].values[value.property] = value.value;
                    change.values.emplace_back(device.name, std::move(value));
                }
                break;
            }
        change.config = config;
        return change;
    }

    const ExperimentSpec& m_running;
    const ExperimentSpec& m_now;
    const Outline& m_outline;
    const Registry& m_registry;
    LiveEdits& m_out;
    const std::set<std::string>& m_swapped;
    const bool m_isWhole;
    std::set<std::string> m_tops;
    bool m_hasConfig = false; ///< a block of a config has changed
    std::size_t m_compared = 0;
    std::shared_ptr<ExperimentSpec> m_changed;
    std::map<std::string, const RobotSpec*> m_robots;
    std::map<std::pair<const RobotConfigSpec*, const RobotConfigSpec*>, ConfigChange> m_configs;
};

} // namespace

void RunComparison::begin(std::shared_ptr<const LoadedProject> built) {
    m_built = m_now = std::move(built);
    m_differing.clear();
    m_swapped.clear();
    m_unsent.emplace();
}

LiveEdits RunComparison::follow(const ChangeSet& changes, const ExperimentSpec& running) {
    LiveEdits edits;
    if (changes.after() != m_now) {
        findDifferences(changes);
        if (changes.before() != m_now || !changes.isLocal()) m_unsent.reset();
        else if (m_unsent)
            for (const PartChange& part : changes.parts()) m_unsent->insert(part.after);
        m_now = changes.after();
    }
    if (!m_now->diagnostics.hasErrors()) {
        LiveComparison comparison(running, *m_now, m_unsent, m_swapped, edits);
        comparison.go();
        m_swapped.insert(edits.swapped.begin(), edits.swapped.end());
        m_compared += comparison.compared();
        m_unsent.emplace();
    }
    edits.waiting = waiting();
    return edits;
}

void RunComparison::findDifferences(const ChangeSet& changes) {
    const Outline &built = *m_built->outline, &now = *changes.after()->outline;
    const bool isKnown = changes.before() == m_now && !changes.changesStructure() &&
                         std::ranges::all_of(changes.parts(), [&](const PartChange& part) {
                             return part.now->usable && part.now->kind && declaredAt(now, part.after) == part.now;
                         });
    if (!isKnown) {
        m_differing.clear();
        const Texts before = textsOf(built), after = textsOf(now);
        m_compared += before.size() + after.size();
        for (const auto& [path, text] : before)
            if (const auto same = after.find(path); same == after.end() || same->second != text) m_differing.insert(path);
        for (const auto& [path, text] : after)
            if (!before.contains(path)) m_differing.insert(path);
        return;
    }
    const auto compare = [this](const std::string& path, std::optional<std::string_view> was,
                                std::optional<std::string_view> is) {
        ++m_compared;
        if (was != is) m_differing.insert(path);
        else m_differing.erase(path);
    };
    for (const std::string& key : changes.settings()) compare(key, settingIn(built, key), settingIn(now, key));
    for (const std::string& name : changes.params()) compare(name, settingIn(built, name), settingIn(now, name));
    for (const PartChange& part : changes.parts()) {
        const Part* was = declaredAt(built, part.after);
        for (const bool isParam : {false, true})
            for (const std::string& key : isParam ? part.params : part.properties)
                compare(pathInside(part.after, key), textIn(built, was, key, isParam), textIn(now, part.now, key, isParam));
    }
}

std::vector<std::string> RunComparison::waiting() const {
    std::vector<std::string> paths;
    const auto isSwapped = [this](const std::string& path) {
        return std::ranges::any_of(m_swapped, [&](const std::string& controller) { return startsWithPath(path, controller); });
    };
    for (const std::string& path : m_differing)
        if (!isBelowLast(paths, path) && !isSwapped(path) && !isLive(*m_now->outline, path) && !isLive(*m_built->outline, path))
            paths.push_back(path);
    return paths;
}

} // namespace trundle
