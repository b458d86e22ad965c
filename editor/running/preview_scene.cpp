#include "editor/running/preview_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "editor/document/document.h"
#include "project/objects/object_location.h"
#include "project/objects/part_values.h"
#include "project/objects/unplaced_configs.h"
#include "scene/queries/object_index.h"

namespace trundle {
namespace {

constexpr const char* kInstance = "trundlePreview"; // reserved names of the instances: "trundlePreview0"
constexpr double kGap = 0.3, kBelow = 1e-3;         // m: gap between two configs; tolerated depth below the floor

/// A plain floor. Its names are reserved for previews.
constexpr const char* kFloor = "Material trundlePreviewFloor { ColorRGB=0.60,0.59,0.56 }\n"
                               "Surface trundlePreviewFloor { Friction=1 Restitution=0 }\n"
                               "StaticConfig TrundlePreviewFloor { Plane floor { Material=trundlePreviewFloor "
                               "Surface=trundlePreviewFloor } }\n"
                               "Static trundlePreviewFloor { Config=TrundlePreviewFloor }\n";

/// A board that rises along x from the origin, a deck, and a board down again, for a robot 1 m long and wide.
std::string rampText(double slope) {
    constexpr double kLength = 4, kWidth = 3, kThickness = 0.06, kDeck = 2; // m
    const double angle = slope * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const Vec3 up{kLength / 2 * c + kThickness / 2 * s, 0, kLength / 2 * s - kThickness / 2 * c};
    const double across = 2 * kLength * c + kDeck; // from its beginning to its end
    const auto box = [&](const char* name, const Vec3& size, const Vec3& place, double pitch) {
        return std::string(" Box ") + name + " { Size=" + positionText(size) + " Pos=" + positionText(place) + " HPR=0," +
               shortNumber(pitch) + ",0 Material=trundlePreviewRamp Surface=trundlePreviewFloor }";
    };
    const Vec3 board{kLength, kWidth, kThickness};
    return "Material trundlePreviewRamp { ColorRGB=0.55,0.40,0.26 }\nStaticConfig TrundlePreviewRamp {" +
           box("rise", board, up, -slope) +
           box("deck", {kDeck, kWidth, kThickness}, {across / 2, 0, kLength * s - kThickness / 2}, 0) +
           box("fall", board, {across - up.x(), 0, up.z()}, slope) +
           " }\nStatic trundlePreviewRamp { Config=TrundlePreviewRamp }\n";
}

bool isRobot(const Part& config) { return config.kind && config.kind->name == "RobotConfig"; }

bool hasFloor(const std::vector<const Part*>& configs) {
    return std::ranges::any_of(configs, [](const Part* config) {
        return std::ranges::any_of(
            config->parts, [](const Part& p) { return p.kind && (p.kind->name == "Plane" || p.kind->name == "Heightfield"); });
    });
}

/// The text of a file next to the opened one that imports it and has one instance of each config, in their order.
std::string placing(const std::string& file, const std::vector<const Part*>& configs, double slope) {
    std::string text = "#import \"" + std::filesystem::path(file).filename().string() + "\"\n";
    for (std::size_t i = 0; i < configs.size(); ++i)
        text += std::string(isRobot(*configs[i]) ? "Robot" : "Static") + " " + kInstance + std::to_string(i) +
                " { Config=" + configs[i]->name + " }\n";
    const bool robots = std::ranges::any_of(configs, [](const Part* config) { return isRobot(*config); });
    if (!robots || hasFloor(configs)) return text;
    return text + kFloor + (slope > 0 ? rampText(slope) : std::string());
}

/// What the preview has of the opened file and its imports: what is placed, joined, logged or lit there is left out.
std::shared_ptr<ExperimentSpec> previewedOf(const ExperimentSpec& loaded) {
    auto preview = std::make_shared<ExperimentSpec>(loaded);
    const auto isOther = [](const auto& object) { return !object.name.starts_with(kInstance); };
    std::erase_if(preview->robots, isOther);
    std::erase_if(preview->statics, isOther);
    preview->logs.clear();
    preview->looks.clear();
    preview->joints.clear(); // between robots, by their places in the list
    preview->springs.clear();
    preview->regions.clear();
    preview->noContact.clear();
    preview->settings.duration = 0;
    return preview;
}

/// Puts the ramp ahead of the robot and makes it as large as the robot needs it.
void placeRamp(StaticSpec& ramp, const Bounds& robot) {
    const Vec3 size = robot.high - robot.low;
    const double scale = std::max(size.x(), size.y());
    auto geoms = std::make_shared<std::vector<GeomSpec>>(*ramp.geoms);
    for (GeomSpec& geom : *geoms) geom.size *= scale, geom.pose.position *= scale;
    ramp.geoms = std::move(geoms);
    ramp.pose.position.x() = robot.high.x() + 0.4 * scale; // in view at the start
}

/// Renames instances to their configs' paths, and places each to the right (-y) of the previous one and above the floor.
std::shared_ptr<const ExperimentSpec> arranged(const ExperimentSpec& placed) {
    const ObjectIndex index(std::make_shared<ExperimentSpec>(placed));
    const BodyPoses poses = startPoses(placed);
    auto shown = std::make_shared<ExperimentSpec>(placed);
    double right = 0; // y (m) of the right edge of what is placed already
    bool first = true;
    Bounds robots; // of the first one
    StaticSpec* ramp = nullptr;
    for (const ObjectRef& object : index.instances()) {
        const bool robot = object.kind == ObjectKind::Robot;
        if (robot && !placed.robots[object.instance].config) continue;
        RobotSpec* const rover = robot ? &shown->robots[object.instance] : nullptr;
        StaticSpec* const yard = robot ? nullptr : &shown->statics[object.instance];
        const auto bodies = robot ? std::nullopt : index.bodiesOf(object);
        RobotSpec* const moving = bodies ? &shown->robots[*bodies] : nullptr; // of the yard
        if (rover) rover->name = "RobotConfig." + rover->config->name;
        else yard->name = "StaticConfig." + yard->configName;
        if (moving) moving->name = yard->name;
        if (yard && yard->configName == kPreviewRamp) {
            ramp = yard;
            continue;
        }
        const Bounds bounds = index.boundsOf(object, poses);
        if (bounds.empty()) continue; // only a floor
        const double shift = first ? 0 : right - kGap - bounds.high.y();
        (rover ? rover->pose : yard->pose).position.y() += shift;
        if (moving) moving->pose = yard->pose;
        if (rover && bounds.low.z() < -kBelow) rover->pose.position.z() -= bounds.low.z();
        right = bounds.low.y() + shift;
        if (first) robots = bounds;
        first = false;
    }
    if (ramp && !robots.empty()) placeRamp(*ramp, robots);
    return shown;
}

} // namespace

std::shared_ptr<const LoadedProject> PreviewScene::show(const Document& document) {
    const std::shared_ptr<const LoadedProject>& loaded = document.loaded();
    const EditedModel& model = document.editedModel();
    if (loaded == m_of && model.path() == m_model) return m_shown;
    const bool isAlone = model.isOpen();
    if (isAlone && m_shown && model.path() == m_model && !model.config()) return m_shown; // an error in the text hides it
    m_of = m_shown = loaded;
    if (model.path() != m_model) m_good = nullptr;
    m_model = model.path();
    if (!document.lastValid()) m_good = nullptr; // another document
    const auto before = std::exchange(m_read, nullptr);
    std::vector<const Part*> configs;
    if (isAlone && model.config()) configs = {model.config()};
    else if (loaded && !isAlone) configs = configsWithoutInstances(*loaded);
    if (configs.empty()) return m_shown;
    OpenOptions options = document.options();
    for (const std::string& file : document.texts().files()) options.texts.emplace(file, document.texts().text(file));
    const std::string root = loaded->paths[0] + ".preview";
    options.texts.insert_or_assign(root,
                                   std::make_shared<const std::string>(placing(loaded->paths[0], configs, isAlone ? m_ramp : 0)));
    options.previous = before;
    options.shownFromProject = true;
    options.meshesLater = true; // the document reads them and then changes again
    const auto read = m_application.open(root, options);
    if (!read) return m_shown;
    m_read = read.value();
    auto shown = std::make_shared<LoadedProject>(*m_read);
    shown->experiment = arranged(isAlone ? *previewedOf(*m_read->experiment) : *m_read->experiment);
    m_shown = std::move(shown);
    if (!loaded->diagnostics.hasErrors()) m_good = m_shown->experiment;
    return m_shown;
}

void PreviewScene::setRamp(double slope) {
    if (slope != std::exchange(m_ramp, slope)) m_of = nullptr;
}

std::shared_ptr<const ExperimentSpec> PreviewScene::lastValid(const Document& document) const {
    if (m_read) return m_good;
    return document.lastValid() ? document.lastValid()->experiment : nullptr;
}

} // namespace trundle
