#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "run/runner.h"

namespace trundle {

struct MovieWish {
    std::string path;                         ///< .mp4, .webm, whatever ffmpeg writes by its ending; empty: none is wanted
    std::string camera;                       ///< "robot0/eye", or empty for a view
    std::string view;                         ///< its name, or empty for one of everything
    std::uint32_t width = 1280, height = 720; ///< of a view
    double framesPerSecond = 30;              ///< of simulated time
};

/// A movie of a run, made by the program ffmpeg while the run goes on.
class Movie {
public:
    /// Fails with words for the user where there is no ffmpeg.
    [[nodiscard]] static Result<std::unique_ptr<Movie>> open(MovieWish wish);
    ~Movie();
    Movie(const Movie&) = delete;
    Movie& operator=(const Movie&) = delete;

    /// At the start and after each tick: writes the pictures that have come due.
    [[nodiscard]] Status follow(Runner& runner);
    /// Waits for ffmpeg. Fails with its own last words.
    [[nodiscard]] Status finish();
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }

private:
    explicit Movie(MovieWish wish) : m_wish(std::move(wish)) {}
    [[nodiscard]] Status start(std::uint32_t width, std::uint32_t height);
    [[nodiscard]] Status write(const Frame& frame);
    [[nodiscard]] std::string lastWords() const;

    MovieWish m_wish;
    std::uint64_t m_frames = 0;
    int m_pipe = -1, m_words = -1; ///< to its input; a file that has what it says
    int m_process = 0;
};

} // namespace trundle
