#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "base/platform/folder_handle.h"
#include "base/result.h"
#include "signals/frame.h"

namespace trundle {

class FedProcess;

/// A movie, made by the program ffmpeg while its pictures come. They are equally far apart in simulated time, whatever the ticks
/// are: one that stands for several moments is shown for as long. The file is there only once the movie is whole; until then what
/// was there stays. It is written into a file that is opened here, so that no link in its folder leads the program elsewhere.
class MovieFile {
public:
    /// `path`: .mp4 or .webm. Fails with words for the user where there is no ffmpeg.
    [[nodiscard]] static Result<std::unique_ptr<MovieFile>> open(std::string path, double framesPerSecond);
    /// Without finish() nothing is left of it.
    ~MovieFile();

    /// Whether a picture of this time (s, from the movie's start; a multiple of `tick`) is wanted.
    [[nodiscard]] bool isDue(double time, double tick) const;
    /// Puts in the picture for every moment up to that time. All pictures are of one size.
    [[nodiscard]] Status add(const Frame& frame, double time, double tick);
    /// Waits for ffmpeg. Fails with its own last words.
    [[nodiscard]] Status finish();
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }

private:
    MovieFile(std::string path, double framesPerSecond);
    [[nodiscard]] Status makePart();
    void removePart();
    [[nodiscard]] Status start(std::uint32_t width, std::uint32_t height);
    [[nodiscard]] Status failure();

    std::string m_path, m_part; // the name of what it grows in, beside it
    std::optional<FolderHandle> m_folder;
    std::FILE* m_file = nullptr; // the part, while it is written
    double m_framesPerSecond;
    std::uint64_t m_frames = 0;
    std::unique_ptr<FedProcess> m_ffmpeg;
};

} // namespace trundle
