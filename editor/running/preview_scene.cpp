#include "editor/running/preview_scene.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "editor/document/document.h"
#include "project/objects/unplaced_configs.h"
#include "scene/queries/object_index.h"

namespace trundle {
namespace {

constexpr double kGap = 0.3, kBelow = 1e-3; // m: gap between two configs; tolerated depth below the floor

/// A plain floor. Its names are reserved for previews.
constexpr const char* kFloor = "Material trundlePreviewFloor { ColorRGB=0.60,0.59,0.56 }\n"
                               "Surface trundlePreviewFloor { Friction=1 Restitution=0 }\n"
                               "StaticConfig TrundlePreviewFloor { Plane floor { Material=trundlePreviewFloor "
                               "Surface=trundlePreviewFloor } }\n"
                               "Static trundlePreviewFloor { Config=TrundlePreviewFloor }\n";

bool isRobot(const Part& config) { return config.kind && config.kind->name == "RobotConfig"; }

bool hasFloor(const std::vector<const Part*>& configs) {
    return std::ranges::any_of(configs, [](const Part* config) {
        return std::ranges::any_of(
            config->parts, [](const Part& p) { return p.kind && (p.kind->name == "Plane" || p.kind->name == "Heightfield"); });
    });
}

/// The text of a file next to the opened one that imports it and has one instance of each config, in their order.
std::string placing(const std::string& file, const std::vector<const Part*>& configs) {
    std::string text = "#import \"" + std::filesystem::path(file).filename().string() + "\"\n";
    for (std::size_t i = 0; i < configs.size(); ++i)
        text += std::string(isRobot(*configs[i]) ? "Robot" : "Static") + " preview" + std::to_string(i) +
                " { Config=" + configs[i]->name + " }\n";
    const bool robots = std::ranges::any_of(configs, [](const Part* config) { return isRobot(*config); });
    return robots && !hasFloor(configs) ? text + kFloor : text;
}

/// Renames instances to their configs' paths, and places each to the right (-y) of the previous one and above the floor.
std::shared_ptr<const ExperimentSpec> arranged(const ExperimentSpec& placed) {
    const ObjectIndex index(std::make_shared<ExperimentSpec>(placed));
    const BodyPoses poses = startPoses(placed);
    auto shown = std::make_shared<ExperimentSpec>(placed);
    double right = 0; // y (m) of the right edge of what is placed already
    bool first = true;
    for (const ObjectRef& object : index.instances()) {
        const bool robot = object.kind == ObjectKind::Robot;
        if (robot && !placed.robots[object.instance].config) continue;
        RobotSpec* const rover = robot ? &shown->robots[object.instance] : nullptr;
        StaticSpec* const yard = robot ? nullptr : &shown->statics[object.instance];
        if (rover) rover->name = "RobotConfig." + rover->config->name;
        else yard->name = "StaticConfig." + yard->configName;
        const Bounds bounds = index.boundsOf(object, poses);
        if (bounds.empty()) continue; // only a floor
        const double shift = first ? 0 : right - kGap - bounds.high.y();
        (rover ? rover->pose : yard->pose).position.y() += shift;
        if (rover && bounds.low.z() < -kBelow) rover->pose.position.z() -= bounds.low.z();
        right = bounds.low.y() + shift;
        first = false;
    }
    return shown;
}

} // namespace

std::shared_ptr<const LoadedProject> PreviewScene::show(const Document& document) {
    const std::shared_ptr<const LoadedProject>& loaded = document.loaded();
    if (loaded == m_of) return m_shown;
    m_of = m_shown = loaded;
    if (!document.lastValid()) m_good = nullptr; // another document
    const auto before = std::exchange(m_read, nullptr);
    const std::vector<const Part*> configs = loaded ? configsWithoutInstances(*loaded) : std::vector<const Part*>();
    if (configs.empty()) return m_shown;
    OpenOptions options = document.options();
    for (const std::string& file : document.texts().files()) options.texts.emplace(file, document.texts().text(file));
    const std::string root = loaded->paths[0] + ".preview";
    options.texts.insert_or_assign(root, std::make_shared<const std::string>(placing(loaded->paths[0], configs)));
    options.previous = before;
    options.shownFromProject = true;
    options.meshesLater = true; // the document reads them and then changes again
    const auto read = m_application.open(root, options);
    if (!read) return m_shown;
    m_read = read.value();
    auto shown = std::make_shared<LoadedProject>(*m_read);
    shown->experiment = arranged(*m_read->experiment);
    m_shown = std::move(shown);
    if (!loaded->diagnostics.hasErrors()) m_good = m_shown->experiment;
    return m_shown;
}

std::shared_ptr<const ExperimentSpec> PreviewScene::lastValid(const Document& document) const {
    if (m_read) return m_good;
    return document.lastValid() ? document.lastValid()->experiment : nullptr;
}

} // namespace trundle
