#include "cli/movie.h"

namespace trundle {

Result<std::unique_ptr<Movie>> Movie::open(MovieOptions movieOptions) {
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
