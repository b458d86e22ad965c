#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "run/logs/movie_file.h"
#include "run/runner.h"

namespace trundle {

struct MovieOptions {
    std::string path;                         ///< .mp4 or .webm; empty: no movie
    std::string camera;                       ///< "robot0/eye"; empty: a view
    std::string view;                         ///< name of a view; empty: the whole scene
    std::uint32_t width = 1280, height = 720; ///< size of a view, px
    double framesPerSecond = 30;              ///< per second of simulated time
};

/// Records a movie of a run while it runs.
class Movie {
public:
    /// Fails with a message for the user if ffmpeg is missing, the file cannot be written, or there is no such view or camera.
    [[nodiscard]] static Result<std::unique_ptr<Movie>> open(MovieOptions movieOptions, const ExperimentSpec& experiment);

    /// Writes the frames that are due. Call at the start and after each tick.
    [[nodiscard]] Status follow(Runner& runner);
    /// Waits for ffmpeg. Fails with ffmpeg's last error line.
    [[nodiscard]] Status finish() { return m_file->finish(); }

private:
    Movie(MovieOptions movieOptions, std::unique_ptr<MovieFile> file)
        : m_movieOptions(std::move(movieOptions)), m_file(std::move(file)) {}

    MovieOptions m_movieOptions;
    std::unique_ptr<MovieFile> m_file;
};

} // namespace trundle
