#include "editor/viewport/stage.h"

#include <filesystem>
#include <utility>

#include "editor/document/described.h"
#include "editor/document/document.h"
#include "scene/object_index.h"

namespace trundle {
namespace {

constexpr double kGap = 0.3; // m

/// A text beside the opened file that imports it and places each config once, in their order.
std::string placing(const std::string& file, const std::vector<const Part*>& configs) {
    std::string text = "#import \"" + std::filesystem::path(file).filename().string() + "\"\n";
    for (std::size_t i = 0; i < configs.size(); ++i)
        text += std::string(configs[i]->kind->name == "RobotConfig" ? "Robot" : "Static") + " stage" + std::to_string(i) +
                " { Config=" + configs[i]->name + " }\n";
    return text;
}

/// Under the paths that their texts have, those behind the first one to its right.
std::shared_ptr<const ExperimentSpec> arranged(const ExperimentSpec& placed) {
    const ObjectIndex index(std::make_shared<ExperimentSpec>(placed));
    const BodyPoses poses = startPoses(placed);
    auto shown = std::make_shared<ExperimentSpec>(placed);
    double right = 0; // y, to which there is something already
    bool first = true;
    for (const ObjectRef& object : index.instances()) {
        const bool robot = object.kind == ObjectKind::Robot;
        if (robot && !placed.robots[object.instance].config) continue;
        RobotSpec* const rover = robot ? &shown->robots[object.instance] : nullptr;
        StaticSpec* const yard = robot ? nullptr : &shown->statics[object.instance];
        if (rover) rover->name = "RobotConfig." + rover->config->name;
        else yard->name = "StaticConfig." + yard->configName;
        const Bounds bounds = index.boundsOf(object, poses);
        if (bounds.empty()) continue; // a floor alone
        const double shift = first ? 0 : right - kGap - bounds.high.y();
        (rover ? rover->pose : yard->pose).position.y() += shift;
        right = bounds.low.y() + shift;
        first = false;
    }
    return shown;
}

} // namespace

std::shared_ptr<const ExperimentSpec> Stage::show(const Document& document) {
    const std::shared_ptr<const Loaded>& loaded = document.loaded();
    if (loaded == m_of) return m_shown;
    m_of = loaded;
    m_shown = loaded ? loaded->experiment : nullptr;
    if (!document.lastGood()) m_good = nullptr; // another document
    const auto before = std::exchange(m_staged, nullptr);
    const std::vector<const Part*> configs = loaded ? describedAlone(*loaded) : std::vector<const Part*>();
    if (configs.empty()) return m_shown;
    OpenOptions options = document.options();
    for (const std::string& file : document.files()) options.texts.emplace(file, document.text(file));
    const std::string root = loaded->paths[0] + ".stage";
    options.texts.insert_or_assign(root, std::make_shared<const std::string>(placing(loaded->paths[0], configs)));
    options.previous = before;
    options.meshesLater = true; // the document reads them, and is another one then
    const auto staged = m_parts.open(root, options);
    if (!staged) return m_shown;
    m_staged = staged.value();
    m_shown = arranged(*m_staged->experiment);
    if (!loaded->diagnostics.hasErrors()) m_good = m_shown;
    return m_shown;
}

std::shared_ptr<const ExperimentSpec> Stage::lastGood(const Document& document) const {
    if (m_staged) return m_good;
    return document.lastGood() ? document.lastGood()->experiment : nullptr;
}

} // namespace trundle
