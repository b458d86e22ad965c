#include "editor/running/live_edits.h"

#include <algorithm>
#include <map>
#include <set>

#include "model/outline.h"
#include "model/provenance.h"

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
    const std::string name = path.substr(0, path.find('.'));
    const Part* view = outline.world.find(name);
    if (!view || view->block->type.text != "View") return false;
    return std::ranges::none_of(outline.parts, [&](const auto& part) {
        const SourceAssignment* used = part->is(Role::Log) ? part->assignments.find("View") : nullptr;
        return used && used->value && outline.texts().slice(used->file, used->value->range) == name;
    });
}

bool isLive(const Outline& outline, const std::string& path) {
    if (isShownView(outline, path)) return true;
    if (path.starts_with("Material.") || path.starts_with("Surface.")) return path.find('.', path.find('.') + 1) != path.npos;
    const auto from = provenanceOf(outline, path);
    return from && from->property && from->property->live;
}

/// Whether an added or removed object that contains the path is already listed.
bool isBelowLast(const std::vector<std::string>& paths, const std::string& path) {
    return !paths.empty() && path.starts_with(paths.back() + ".");
}

std::vector<std::string> waitingPaths(const LoadedProject& built, const LoadedProject& now) {
    const Texts before = textsOf(*built.outline), after = textsOf(*now.outline);
    std::vector<std::string> paths;
    const auto differ = [&](const std::string& path) {
        if (!isBelowLast(paths, path) && !isLive(*now.outline, path) && !isLive(*built.outline, path)) paths.push_back(path);
    };
    auto a = before.begin(), b = after.begin();
    while (a != before.end() || b != after.end()) {
        if (b == after.end() || (a != before.end() && a->first < b->first)) differ((a++)->first);
        else if (a == before.end() || b->first < a->first) differ((b++)->first);
        else {
            if (a->second != b->second) differ(a->first);
            ++a;
            ++b;
        }
    }
    return paths;
}

// ---- live properties: commands for the running world ----

/// A changed value of a live property of one component.
struct LiveValue {
    std::string property;
    ResolvedValue value;
};

class LiveComparison {
public:
    LiveComparison(const ExperimentSpec& running, const LoadedProject& now, LiveEdits& out)
        : m_running(running), m_now(*now.experiment), m_registry(*now.registry), m_out(out) {}

    void go() {
        surfaces();
        materials();
        for (const RobotSpec& robot : m_now.robots) m_robots.emplace(robot.name, &robot);
        for (std::size_t i = 0; i < m_running.robots.size(); ++i) robot(i);
        if (m_changed) m_out.experiment = m_changed;
    }

private:
    ExperimentSpec& changed() {
        if (!m_changed) m_changed = std::make_shared<ExperimentSpec>(m_running);
        return *m_changed;
    }

    void surfaces() {
        for (std::size_t i = 0; i < m_running.surfaces.size(); ++i)
            for (const SurfaceSpec& s : m_now.surfaces) {
                const SurfaceSpec& r = m_running.surfaces[i];
                if (s.name != r.name) continue;
                const bool same = s.friction == r.friction && s.friction2 == r.friction2 &&
                                  s.frictionHeading == r.frictionHeading && s.restitution == r.restitution &&
                                  s.rollingFriction == r.rollingFriction && s.softness == r.softness;
                if (same) break;
                m_out.commands.emplace_back(SurfaceCommand{s});
                changed().surfaces[i] = s;
                break;
            }
    }

    void materials() {
        for (std::size_t i = 0; i < m_running.materials.size(); ++i)
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
        const RobotSpec& running = m_running.robots[index];
        const auto found = m_robots.find(running.name);
        if (found == m_robots.end()) return;
        const RobotSpec& now = *found->second;
        if (running.controller && now.controller && running.controller->name == now.controller->name)
            if (const auto values = differences(*running.controller, *now.controller); !values.empty())
                addConsoleLine(running.name + "/" + running.controller->name, *changed().robots[index].controller, values);
        if (running.config && now.config && running.config != now.config) devices(index, now);
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
    const Registry& m_registry;
    LiveEdits& m_out;
    std::shared_ptr<ExperimentSpec> m_changed;
    std::map<std::string, const RobotSpec*> m_robots;
    std::map<std::pair<const RobotConfigSpec*, const RobotConfigSpec*>, ConfigChange> m_configs;
};

} // namespace

LiveEdits liveEdits(const LoadedProject& built, const ExperimentSpec& running, const LoadedProject& now) {
    LiveEdits edits;
    if (!now.diagnostics.hasErrors()) LiveComparison(running, now, edits).go(); // a text with errors changes nothing in the run
    edits.waiting = waitingPaths(built, now);
    return edits;
}

} // namespace trundle
