#include "run/logs/movie_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/platform/atomic_file.h"
#include "base/platform/piped_process.h"

namespace trundle {
namespace {

constexpr double kSlack = 1e-6; // of a tick

Error failedMovie(const std::string& path, const std::string& why) {
    return {Code::FileUnwritable, "the movie " + path + " cannot be made: " + why};
}

bool isWebm(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending == ".webm";
}

} // namespace

MovieFile::MovieFile(std::string path, double framesPerSecond)
    : m_path(std::move(path)), m_part(temporaryName()), m_framesPerSecond(framesPerSecond) {}

MovieFile::~MovieFile() {
    m_ffmpeg.reset(); // it has the temporary file open
    removePart();
}

void MovieFile::removePart() {
    if (!m_file) return;
    std::fclose(std::exchange(m_file, nullptr));
    m_folder->removeFile(m_part);
}

Result<std::unique_ptr<MovieFile>> MovieFile::open(std::string path, double framesPerSecond) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none)) return failedMovie(path, "it is a folder");
    if (!isInstalled("ffmpeg")) {
        const Error failed = failedMovie(path, "the program ffmpeg is not installed (sudo apt-get install ffmpeg)");
        return Error{Code::SystemRefused, failed.message};
    }
    std::unique_ptr<MovieFile> movie(new MovieFile(std::move(path), framesPerSecond));
    if (Status made = movie->createTemporaryFile(); !made) return made.error();
    return movie;
}

Status MovieFile::createTemporaryFile() {
    const std::filesystem::path folder = std::filesystem::path(m_path).parent_path();
    Result<FolderHandle> opened = FolderHandle::open(folder.empty() ? "." : folder.string());
    if (!opened) return failedMovie(m_path, opened.error().message);
    m_folder = std::move(opened).value();
    const Result<std::FILE*> file = m_folder->makeFile(m_part);
    if (!file) return failedMovie(m_path, m_part + " beside it: " + file.error().message);
    m_file = file.value();
    lockTemporaryFile(::fileno(m_file));
    removeAbandonedFiles(folder.empty() ? "." : folder.string());
    return {};
}

Status MovieFile::start(std::uint32_t width, std::uint32_t height) {
    // Pads to even sizes, which the common formats need. The "file:" prefix keeps names from being read as options.
    std::vector<std::string> words{"-nostdin",  "-hide_banner",
                                   "-loglevel", "error",
                                   "-xerror",   "-y",
                                   "-f",        "rawvideo",
                                   "-pix_fmt",  "rgb24",
                                   "-s",        std::to_string(width) + "x" + std::to_string(height),
                                   "-r",        std::to_string(m_framesPerSecond),
                                   "-i",        "pipe:0",
                                   "-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                   "-pix_fmt",  "yuv420p"};
    // The default settings of the WebM encoder take seconds per image.
    if (isWebm(m_path)) words.insert(words.end(), {"-cpu-used", "5", "-row-mt", "1"});
    words.insert(words.end(), {"-f", isWebm(m_path) ? "webm" : "mp4", std::string("file:") + PipedProcess::kGivenFile});
    Result<std::unique_ptr<PipedProcess>> ffmpeg = PipedProcess::start("ffmpeg", words, ::fileno(m_file));
    if (!ffmpeg) return failedMovie(m_path, ffmpeg.error().message);
    m_ffmpeg = std::move(ffmpeg).value();
    return {};
}

Status MovieFile::failure() {
    (void)m_ffmpeg->finish();
    std::string words = m_ffmpeg->lastErrorOutput();
    const std::string_view given = PipedProcess::kGivenFile;
    if (const std::size_t at = words.find(given); at != std::string::npos) words.replace(at, given.size(), m_path);
    return failedMovie(m_path, words.empty() ? "ffmpeg failed without a message" : words);
}

bool MovieFile::isDue(double time, double tick) const {
    return time + kSlack * tick >= static_cast<double>(m_frames) / m_framesPerSecond;
}

Status MovieFile::add(const CameraImage& frame, double time, double tick) {
    if (!m_ffmpeg)
        if (Status started = start(frame.width, frame.height); !started) return started;
    for (; isDue(time, tick); ++m_frames)
        if (!m_ffmpeg->feed(frame.pixels.data(), frame.pixels.size())) return failure();
    return {};
}

Status MovieFile::finish() {
    if (!m_ffmpeg) return {};
    // If the disk is full at the very end, ffmpeg prints an error but exits with status 0.
    if (!m_ffmpeg->finish() || !m_ffmpeg->lastErrorOutput().empty()) return failure();
    const Status renamed = m_folder->rename(m_part, std::filesystem::path(m_path).filename().string());
    if (!renamed) return failedMovie(m_path, renamed.error().message);
    std::fclose(std::exchange(m_file, nullptr));
    m_ffmpeg.reset();
    return {};
}

} // namespace trundle
