#include "cli/movie.h"

namespace trundle {

Result<std::unique_ptr<Movie>> Movie::open(MovieWish wish) {
    Result<std::unique_ptr<MovieFile>> file = MovieFile::open(wish.path, wish.framesPerSecond);
    if (!file) return file.error();
    return std::unique_ptr<Movie>(new Movie(std::move(wish), std::move(file).value()));
}

Status Movie::follow(Runner& runner) {
    const double time = runner.world().time(), tick = runner.world().experiment().settings.tick;
    if (!m_file->isDue(time, tick)) return {};
    if (!m_wish.camera.empty()) {
        const Result<const Frame*> drawn = runner.cameras().capture(m_wish.camera);
        return drawn ? m_file->add(*drawn.value(), time, tick) : Status(drawn.error());
    }
    const Result<Frame> drawn = runner.cameras().view(m_wish.view, m_wish.width, m_wish.height);
    return drawn ? m_file->add(drawn.value(), time, tick) : Status(drawn.error());
}

} // namespace trundle
