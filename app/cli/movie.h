#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "run/movie_file.h"
#include "run/runner.h"

namespace trundle {

struct MovieWish {
    std::string path;                         ///< .mp4 or .webm; empty: none is wanted
    std::string camera;                       ///< "robot0/eye", or empty for a view
    std::string view;                         ///< its name, or empty for one of everything
    std::uint32_t width = 1280, height = 720; ///< of a view
    double framesPerSecond = 30;              ///< of simulated time
};

/// A movie of a run, made while the run goes on.
class Movie {
public:
    /// Fails with words for the user where there is no ffmpeg.
    [[nodiscard]] static Result<std::unique_ptr<Movie>> open(MovieWish wish);

    /// At the start and after each tick: writes the pictures that have come due.
    [[nodiscard]] Status follow(Runner& runner);
    /// Waits for ffmpeg. Fails with its own last words.
    [[nodiscard]] Status finish() { return m_file->finish(); }

private:
    Movie(MovieWish wish, std::unique_ptr<MovieFile> file) : m_wish(std::move(wish)), m_file(std::move(file)) {}

    MovieWish m_wish;
    std::unique_ptr<MovieFile> m_file;
};

} // namespace trundle
