#include "cli/movie.h"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace trundle {
namespace {

Error unmade(const std::string& path, const std::string& why) {
    return {Code::FileUnwritable, "the movie " + path + " cannot be made: " + why};
}

bool hasFfmpeg() {
    const char* path = std::getenv("PATH");
    std::string rest = path ? path : "/usr/local/bin:/usr/bin:/bin";
    for (rest += ':'; !rest.empty();) {
        const std::size_t end = rest.find(':');
        const std::string folder = rest.substr(0, end);
        if (!folder.empty() && ::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
        rest.erase(0, end + 1);
    }
    return false;
}

} // namespace

Result<std::unique_ptr<Movie>> Movie::open(MovieWish wish) {
    if (!hasFfmpeg()) return unmade(wish.path, "the program ffmpeg is not installed (sudo apt-get install ffmpeg)");
    return std::unique_ptr<Movie>(new Movie(std::move(wish)));
}

Movie::~Movie() {
    if (m_pipe >= 0) ::close(m_pipe);
    if (m_words >= 0) ::close(m_words);
    if (m_process > 0) {
        ::kill(m_process, SIGTERM);
        ::waitpid(m_process, nullptr, 0);
    }
}

Status Movie::start(std::uint32_t width, std::uint32_t height) {
    std::signal(SIGPIPE, SIG_IGN); // an ffmpeg that gives up is told from what write() says
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return unmade(m_wish.path, std::strerror(errno));
    m_pipe = ends[1];
    m_words = ::memfd_create("ffmpeg", MFD_CLOEXEC);

    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const std::string rate = std::to_string(m_wish.framesPerSecond);
    // Even sides, which the common formats need; a name is never taken for an option.
    std::vector<std::string> words{"ffmpeg",    "-nostdin", "-hide_banner",
                                   "-loglevel", "error",    "-y",
                                   "-f",        "rawvideo", "-pix_fmt",
                                   "rgb24",     "-s",       size,
                                   "-r",        rate,       "-i",
                                   "pipe:0",    "-vf",      "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                   "-pix_fmt",  "yuv420p",  "file:" + m_wish.path};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (m_words >= 0) posix_spawn_file_actions_adddup2(&files, m_words, STDERR_FILENO);
    // Ctrl+C ends the run, which then ends the movie in order.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = ::posix_spawnp(&m_process, "ffmpeg", &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    ::close(ends[0]);
    if (failed) {
        m_process = 0;
        return unmade(m_wish.path, std::strerror(failed));
    }
    return {};
}

std::string Movie::lastWords() const {
    char text[2000];
    const ssize_t size = m_words >= 0 ? ::pread(m_words, text, sizeof text, 0) : 0;
    std::string words(text, size > 0 ? static_cast<std::size_t>(size) : 0);
    while (!words.empty() && words.back() == '\n') words.pop_back();
    return words.empty() ? "ffmpeg gave up without a word" : words.substr(words.rfind('\n') + 1);
}

Status Movie::write(const Frame& frame) {
    if (m_pipe < 0)
        if (Status started = start(frame.width, frame.height); !started) return started;
    const auto* bytes = reinterpret_cast<const char*>(frame.pixels.data());
    for (std::size_t left = frame.pixels.size(); left > 0;) {
        const ssize_t written = ::write(m_pipe, bytes, left);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) {
            ::waitpid(m_process, nullptr, 0);
            m_process = 0;
            return unmade(m_wish.path, lastWords());
        }
        bytes += written;
        left -= static_cast<std::size_t>(written);
    }
    ++m_frames;
    return {};
}

Status Movie::follow(Runner& runner) {
    const double time = runner.world().time(), slack = 1e-6 * runner.world().experiment().settings.tick;
    if (time + slack < static_cast<double>(m_frames) / m_wish.framesPerSecond) return {};
    Frame own;
    const Frame* frame = &own;
    if (m_wish.camera.empty()) {
        Result<Frame> drawn = runner.cameras().view(m_wish.view, m_wish.width, m_wish.height);
        if (!drawn) return drawn.error();
        own = std::move(drawn).value();
    } else {
        const Result<const Frame*> drawn = runner.cameras().capture(m_wish.camera);
        if (!drawn) return drawn.error();
        frame = drawn.value();
    }
    while (time + slack >= static_cast<double>(m_frames) / m_wish.framesPerSecond)
        if (Status written = write(*frame); !written) return written;
    return {};
}

Status Movie::finish() {
    if (m_pipe >= 0) ::close(m_pipe);
    m_pipe = -1;
    if (m_process <= 0) return {};
    int status = 0;
    while (::waitpid(m_process, &status, 0) < 0 && errno == EINTR) {}
    m_process = 0;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    return unmade(m_wish.path, lastWords());
}

} // namespace trundle
