#include "cli/movie.h"

#include <algorithm>

#include "schema/value_words.h"

namespace trundle {
namespace {

Status notThere(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
    if (std::ranges::find(names, name) != names.end()) return {};
    const std::string others = names.empty() ? "; the experiment has none" : "; there is " + listText(names, "and");
    return Error{Code::PictureFailed, "there is no " + what + " " + name + others};
}

/// The view or camera that is filmed.
Status checkFilmed(const ExperimentSpec& experiment, const MovieOptions& options) {
    std::vector<std::string> views, cameras;
    for (const ComponentSpec& look : experiment.looks)
        if (look.kind == "View") views.push_back(look.name);
    for (const RobotSpec& robot : experiment.robots) // of a text without errors: each has its config
        for (const ComponentSpec& device : robot.config->devices)
            if (device.kind == "Camera") cameras.push_back(robot.name + "/" + device.name);
    if (!options.camera.empty()) return notThere("camera", options.camera, cameras);
    return options.view.empty() ? Status() : notThere("view", options.view, views);
}

} // namespace

Result<std::unique_ptr<Movie>> Movie::open(MovieOptions movieOptions, const ExperimentSpec& experiment) {
    if (Status there = checkFilmed(experiment, movieOptions); !there) return there.error();
    Result<std::unique_ptr<MovieFile>> file = MovieFile::open(movieOptions.path, movieOptions.framesPerSecond);
    if (!file) return file.error();
    return std::unique_ptr<Movie>(new Movie(std::move(movieOptions), std::move(file).value()));
}

Status Movie::follow(Runner& runner) {
    const double time = runner.world().time(), tick = runner.world().experiment().settings.tick;
    if (!m_file->isDue(time, tick)) return {};
    if (!m_movieOptions.camera.empty()) {
        const Result<const CameraImage*> drawn = runner.cameras().capture(m_movieOptions.camera);
        return drawn ? m_file->add(*drawn.value(), time, tick) : Status(drawn.error());
    }
    const Result<CameraImage> drawn = runner.cameras().view(m_movieOptions.view, m_movieOptions.width, m_movieOptions.height);
    return drawn ? m_file->add(drawn.value(), time, tick) : Status(drawn.error());
}

} // namespace trundle
