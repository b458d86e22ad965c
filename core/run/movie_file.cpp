#include "run/movie_file.h"

#include <filesystem>

#include "base/platform/fed_process.h"

namespace trundle {
namespace {

constexpr double kSlack = 1e-6; // of a tick

Error unmade(const std::string& path, const std::string& why) {
    return {Code::FileUnwritable, "the movie " + path + " cannot be made: " + why};
}

/// Beside the movie, with its ending, by which ffmpeg knows what to write.
std::string partOf(const std::string& path) {
    const std::filesystem::path whole(path);
    return (whole.parent_path() / ("." + whole.stem().string() + ".part" + whole.extension().string())).string();
}

} // namespace

MovieFile::MovieFile(std::string path, double framesPerSecond)
    : m_path(std::move(path)), m_part(partOf(m_path)), m_framesPerSecond(framesPerSecond) {}

MovieFile::~MovieFile() {
    if (!m_ffmpeg) return;
    m_ffmpeg.reset(); // it has the part open
    std::error_code none;
    std::filesystem::remove(m_part, none);
}

Result<std::unique_ptr<MovieFile>> MovieFile::open(std::string path, double framesPerSecond) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none)) return unmade(path, "it is a folder");
    if (!isInstalled("ffmpeg")) return unmade(path, "the program ffmpeg is not installed (sudo apt-get install ffmpeg)");
    return std::unique_ptr<MovieFile>(new MovieFile(std::move(path), framesPerSecond));
}

Status MovieFile::start(std::uint32_t width, std::uint32_t height) {
    // Even sides, which the common formats need; a name is never taken for an option.
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
    // Left alone the encoder of WebM takes seconds for a picture.
    if (m_path.ends_with(".webm")) words.insert(words.end(), {"-cpu-used", "5", "-row-mt", "1"});
    words.push_back("file:" + m_part);
    Result<std::unique_ptr<FedProcess>> ffmpeg = FedProcess::start("ffmpeg", words);
    if (!ffmpeg) return unmade(m_path, ffmpeg.error().message);
    m_ffmpeg = std::move(ffmpeg).value();
    return {};
}

Status MovieFile::failure() {
    (void)m_ffmpeg->finish();
    std::string words = m_ffmpeg->lastWords();
    if (const std::size_t at = words.find(m_part); at != std::string::npos) words.replace(at, m_part.size(), m_path);
    return unmade(m_path, words.empty() ? "ffmpeg gave up without a word" : words);
}

bool MovieFile::isDue(double time, double tick) const {
    return time + kSlack * tick >= static_cast<double>(m_frames) / m_framesPerSecond;
}

Status MovieFile::add(const Frame& frame, double time, double tick) {
    if (!m_ffmpeg)
        if (Status started = start(frame.width, frame.height); !started) return started;
    for (; isDue(time, tick); ++m_frames)
        if (!m_ffmpeg->feed(frame.pixels.data(), frame.pixels.size())) return failure();
    return {};
}

Status MovieFile::finish() {
    if (!m_ffmpeg) return {};
    // Of a disk that is full at the very end it tells, and leaves as if all were well.
    if (!m_ffmpeg->finish() || !m_ffmpeg->lastWords().empty()) return failure();
    std::error_code fault;
    std::filesystem::rename(m_part, m_path, fault);
    if (fault) return unmade(m_path, fault.message());
    m_ffmpeg.reset();
    return {};
}

} // namespace trundle
