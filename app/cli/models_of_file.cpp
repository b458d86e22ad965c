#include "cli/models_of_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "check/extent.h"
#include "project/edits/plan_targets.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr const char* kModels = ".models_of_check.sim"; ///< a text that is nowhere on the disk
constexpr double kApart = 10;                           // m, between models

/// The text of a file with blanks in place of its experiment: robots, scenery, joints between them, logs.
std::string withoutExperiment(const LoadedProject& loaded) {
    std::string text(loaded.trees[0]->source().bytes());
    for (const Item& item : loaded.trees[0]->items()) {
        const auto* block = item.as<BlockItem>();
        const Kind* kind = block ? loaded.registry->find(block->type.text) : nullptr;
        const NameSpace* space = kind ? loaded.outline->spaceOf(*kind) : nullptr;
        if (!block || (space && space != &loaded.outline->world)) continue;
        for (std::uint32_t i = item.range.begin; i < item.range.end; ++i)
            if (text[i] != '\n' && text[i] != '\r') text[i] = ' ';
    }
    return text;
}

/// Pos and HPR of a model: those of its first robot, above the place that it has on the floor.
std::string placeOf(const ExperimentSpec& experiment, const std::string& config, const Vec3& at, const Vec3& up) {
    const auto isOfIt = [&](const RobotSpec& robot) { return robot.config && robot.config->name == config; };
    const auto robot = std::ranges::find_if(experiment.robots, isOfIt);
    if (robot == experiment.robots.end()) return "Pos=" + positionText(at);
    const Quat& rotation = robot->pose.rotation;
    const double low = extentAlong(*robot->config, {{0, 0, 0}, rotation}, up).low;
    const double height = std::isfinite(low) ? std::min(robot->pose.position.dot(up), std::max(-low, 0.0)) : 0;
    return "Pos=" + positionText(at + height * up) + " HPR=" + headingText(rotation);
}

} // namespace

Result<OpenedModels> openModels(Application& application, const std::string& file, OpenOptions options) {
    namespace fs = std::filesystem;
    const auto opened = application.open(file, options);
    if (!opened) return opened.error();
    if (opened.value()->diagnostics.hasErrors()) return OpenedModels{opened.value()};
    const ExperimentSpec& experiment = *opened.value()->experiment;
    const Vec3& gravity = experiment.settings.gravity;
    const Vec3 up = gravity.norm() > 0 ? Vec3(-gravity.normalized()) : Vec3(Vec3::UnitZ());
    const Quat floor = Quat::FromTwoVectors(Vec3::UnitZ(), up);
    std::error_code ec;
    const fs::path path = fs::weakly_canonical(file, ec);
    std::string text = "#import " + path.filename().string() + "\n#import arenas/open_floor.sim\n" +
                       "Static plain_floor { Config=OpenFloor HPR=" + headingText(floor) + " }\n";
    int count = 0;
    for (const Part* config : opened.value()->outline->configs.all())
        if (config->kind->name == "RobotConfig" && config->file == 0)
            text += "Robot " + config->name + " { Config=" + config->name + " " +
                    placeOf(experiment, config->name, kApart * count++ * (floor * Vec3::UnitX()), up) + " }\n";
    if (count == 0) return OpenedModels{opened.value()};
    const std::string beside = (path.parent_path() / kModels).string();
    options.texts.emplace(beside, std::make_shared<const std::string>(text));
    std::string models = withoutExperiment(*opened.value());
    const bool isWhole = models == opened.value()->trees[0]->source().bytes();
    options.texts.emplace(path.string(), std::make_shared<const std::string>(std::move(models)));
    const auto loaded = application.open(beside, options);
    if (!loaded) return loaded.error();
    const auto& paths = loaded.value()->paths;
    const auto own = std::ranges::find(paths, path.string());
    return OpenedModels{loaded.value(), static_cast<FileId>(isWhole ? own - paths.begin() : paths.end() - paths.begin())};
}

bool isOfModels(const LoadedProject& loaded) { return loaded.paths[0].ends_with(kModels); }

Diagnostics atTheirModels(const LoadedProject& loaded, const Diagnostics& diagnostics) {
    const auto atModel = [&](SourceRange& range) {
        for (const RobotSpec& robot : loaded.experiment->robots)
            if (const Part* config = loaded.outline->configs.find(robot.name);
                config && range.file == 0 && isWithin(range, robot.range))
                range = config->nameRange();
    };
    const auto isOfModelsText = [](const TextEdit& edit) { return edit.range.file == 0; };
    Diagnostics all;
    for (Diagnostic d : diagnostics.all()) {
        std::erase_if(d.fixes, [&](const Fix& fix) { return std::ranges::any_of(fix.edits, isOfModelsText); });
        atModel(d.range);
        for (auto& [text, range] : d.notes) atModel(range);
        std::erase_if(d.notes, [](const auto& note) { return note.second.file == 0; });
        all.append({std::move(d)});
    }
    return all;
}

SourceTable withoutModels(const SourceTable& sources) {
    SourceTable all;
    for (FileId i = 0; i < sources.size(); ++i)
        (void)all.add(sources[i].text, sources[i].importedFrom.file == 0 ? SourceRange() : sources[i].importedFrom);
    return all;
}

} // namespace trundle
