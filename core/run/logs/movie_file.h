#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "base/platform/folder_handle.h"
#include "base/result.h"
#include "signals/camera_image.h"

namespace trundle {

class PipedProcess;

/// A movie, encoded by the program ffmpeg while images arrive. Frames have equal distances in simulated time, whatever the tick:
/// an image is repeated for every frame that it covers. The movie is written to a temporary file, opened here so that links in
/// the folder are not followed, and replaces an existing file only when it is complete.
class MovieFile {
public:
    /// `path`: .mp4 or .webm. Fails with a message for the user if ffmpeg is not installed or the file cannot be written.
    [[nodiscard]] static Result<std::unique_ptr<MovieFile>> open(std::string path, double framesPerSecond);
    /// Without finish(), removes the temporary file.
    ~MovieFile();

    /// Whether a frame is due at this time (s, from the movie's start; a multiple of `tick`).
    [[nodiscard]] bool isDue(double time, double tick) const;
    /// Adds an image for every frame up to this time. All images must have the same size.
    [[nodiscard]] Status add(const CameraImage& frame, double time, double tick);
    /// Waits for ffmpeg and completes the file. A failure contains ffmpeg's last error output.
    [[nodiscard]] Status finish();
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }

private:
    MovieFile(std::string path, double framesPerSecond);
    [[nodiscard]] Status createTemporaryFile();
    void removePart();
    [[nodiscard]] Status start(std::uint32_t width, std::uint32_t height);
    [[nodiscard]] Status failure();

    std::string m_path, m_part; // m_part: name of the temporary file in the same folder
    std::optional<FolderHandle> m_folder;
    std::FILE* m_file = nullptr; // the temporary file while it is written
    double m_framesPerSecond;
    std::uint64_t m_frames = 0;
    std::unique_ptr<PipedProcess> m_ffmpeg;
};

} // namespace trundle
