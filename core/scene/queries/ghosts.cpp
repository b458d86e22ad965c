#include "scene/queries/ghosts.h"

#include <unordered_map>

namespace trundle {
namespace {

template <class T> const T* named(const std::vector<T>& parts, const std::string& name) {
    const auto it = std::find_if(parts.begin(), parts.end(), [&](const T& part) { return part.name == name; });
    return it == parts.end() ? nullptr : &*it;
}

/// Geoms of `before` that are missing in `now`.
std::vector<GeomSpec> lost(const std::vector<GeomSpec>* now, const std::vector<GeomSpec>& before, const std::string& owner,
                           const std::function<bool(const std::string&)>& isWritten) {
    std::vector<GeomSpec> geoms;
    for (const GeomSpec& geom : before)
        if ((!now || !named(*now, geom.name)) && geom.shape != GeomShape::Plane && isWritten(owner + "." + geom.name))
            geoms.push_back(geom);
    return geoms;
}

template <class T> std::unordered_map<std::string, const T*> byName(const std::vector<T>& parts) {
    std::unordered_map<std::string, const T*> all;
    for (const T& part : parts) all.try_emplace(part.name, &part);
    return all;
}

} // namespace

std::shared_ptr<const ExperimentSpec> ghostsOf(const ExperimentSpec& now, const ExperimentSpec& before,
                                               const std::function<bool(const std::string&)>& isWritten) {
    auto ghosts = std::make_shared<ExperimentSpec>();
    ghosts->materials = before.materials;
    const auto robots = byName(now.robots);
    for (const RobotSpec& old : before.robots) {
        if (!old.config || !isWritten(old.name)) continue;
        const auto it = robots.find(old.name);
        const RobotConfigSpec* config = it == robots.end() ? nullptr : it->second->config.get();
        RobotSpec ghost = old;
        if (config) {
            if (config == old.config.get()) continue;
            ghost.pose = it->second->pose;
            auto rest = std::make_shared<RobotConfigSpec>();
            for (const BodySpec& body : old.config->bodies) {
                const BodySpec* same = named(config->bodies, body.name);
                BodySpec left = body;
                left.geoms = lost(same ? &same->geoms : nullptr, body.geoms, old.name + "." + body.name, isWritten);
                if (!left.geoms.empty()) rest->bodies.push_back(std::move(left));
            }
            if (rest->bodies.empty()) continue;
            ghost.config = std::move(rest);
        }
        ghosts->robots.push_back(std::move(ghost));
    }
    const auto statics = byName(now.statics);
    for (const StaticSpec& old : before.statics) {
        if (!old.geoms || !isWritten(old.name)) continue;
        const auto it = statics.find(old.name);
        StaticSpec ghost = old;
        const auto* geoms = it == statics.end() ? nullptr : it->second->geoms.get();
        if (it != statics.end()) ghost.pose = it->second->pose;
        // If a whole static is missing, the paths of its geoms cannot be resolved (its config's name may be misspelt), so all of
        // them are kept.
        std::vector<GeomSpec> rest = geoms ? lost(geoms, *old.geoms, old.name, isWritten)
                                           : lost(nullptr, *old.geoms, old.name, [](const auto&) { return true; });
        if (rest.empty()) continue;
        ghost.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(rest));
        ghosts->statics.push_back(std::move(ghost));
    }
    if (ghosts->robots.empty() && ghosts->statics.empty()) return nullptr;
    return ghosts;
}

} // namespace trundle
