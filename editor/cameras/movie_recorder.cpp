#include "editor/cameras/movie_recorder.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/platform/thread_priority.h"
#include "render/camera_image_renderer.h"
#include "run/logs/movie_file.h"

namespace trundle {
namespace {

constexpr std::chrono::milliseconds kLastWait(2000);

} // namespace

std::uint64_t MovieJob::frameCount() const {
    return end < begin ? 0 : static_cast<std::uint64_t>(std::floor((end - begin) * framesPerSecond + 1e-6)) + 1;
}

/// Shared by both threads; outlives both.
struct MovieRecorder::MovieState {
    Application* application = nullptr;
    RenderService* render = nullptr;
    std::atomic<bool> cancelled = false;

    std::mutex lock;
    std::condition_variable over;
    MovieRecorder* recorder = nullptr; // null once it is destroyed
    bool done = false;

    template <class Report> void post(Report what) {
        const std::scoped_lock guard(lock);
        if (recorder)
            QMetaObject::invokeMethod(
                recorder, [r = recorder, what] { what(*r); }, Qt::QueuedConnection);
    }
};

MovieRecorder::MovieRecorder(Application& application, RenderService& render, QObject* parent)
    : QObject(parent), m_application(application), m_render(render) {}

MovieRecorder::~MovieRecorder() {
    if (!m_state) return;
    m_state->cancelled = true;
    std::unique_lock guard(m_state->lock);
    m_state->recorder = nullptr;
    m_state->over.wait_for(guard, kLastWait, [this] { return m_state->done; });
}

void MovieRecorder::cancel() {
    if (m_state) m_state->cancelled = true;
}

void MovieRecorder::start(MovieJob job) {
    if (m_state) return;
    m_state = std::make_shared<MovieState>();
    m_state->application = &m_application;
    m_state->render = &m_render;
    m_state->recorder = this;
    std::thread([state = m_state, job = std::move(job)] {
        lowerThreadPriority();
        record(*state, job);
        const std::scoped_lock guard(state->lock);
        state->done = true;
        state->over.notify_all();
    }).detach();
}

void MovieRecorder::record(MovieState& state, const MovieJob& job) {
    const Result<bool> whole = film(state, job);
    const bool cancelled = state.cancelled && !(whole && whole.value()); // cancelled too late if the movie is complete
    const QString failure = whole || cancelled ? QString() : QString::fromStdString(whole.error().message);
    state.post([failure, cancelled](MovieRecorder& recorder) {
        recorder.m_state.reset();
        Q_EMIT recorder.finished(failure, cancelled);
    });
}

/// True if the movie is complete; false if it was cancelled.
Result<bool> MovieRecorder::film(MovieState& state, const MovieJob& job) {
    Result<std::unique_ptr<MovieFile>> movie = MovieFile::open(job.path, job.framesPerSecond);
    if (!movie) return movie.error();
    Diagnostics problems;
    const std::unique_ptr<Runner> runner = state.application->makeRunner(*job.loaded, RunOptions{}, problems); // writes no logs
    if (!runner) {
        for (const Diagnostic& problem : problems.all())
            if (problem.severity == Severity::Error) return Error{problem.code, problem.message};
        return Error{Code::PictureFailed, "the experiment cannot be built"};
    }
    const double tick = job.loaded->experiment->settings.tick;
    const std::uint64_t first = ticksFor(job.begin, tick), last = std::max(first, ticksFor(job.end, tick));
    CameraImageRenderer drawer(job.loaded->experiment, *state.render);
    const PoseReader reader(*job.loaded->experiment, runner->world().layout());
    std::size_t done = 0;
    auto reported = std::chrono::steady_clock::now();
    const auto addPicture = [&](double time) -> Status {
        if (!job.camera.empty()) { // the image that the robot has: with an UpdatePeriod, the newest
            const Result<const CameraImage*> frame = runner->cameras().capture(job.camera);
            return frame ? movie.value()->add(*frame.value(), time, tick) : Status(frame.error());
        }
        auto poses = std::make_shared<BodyPoses>();
        reader.read(runner->world().block(), *poses);
        PictureRequest request = job.look;
        request.view = job.view(*poses);
        const Result<CameraImage> frame =
            drawer.picture(std::move(request), {std::move(poses), runner->world().ticks(), runner->world().time()});
        return frame ? movie.value()->add(frame.value(), time, tick) : Status(frame.error());
    };
    while (!state.cancelled) {
        const std::uint64_t now = runner->world().ticks();
        const double time = (static_cast<double>(now) - static_cast<double>(first)) * tick;
        if (now >= first && movie.value()->isDue(time, tick)) {
            if (Status added = addPicture(time); !added) return added.error();
        }
        if (now >= last || runner->finished()) break;
        if (const auto since = std::chrono::steady_clock::now(); since - reported > std::chrono::milliseconds(50)) {
            reported = since;
            state.post([pictures = movie.value()->frames(), at = runner->world().time()](MovieRecorder& recorder) {
                Q_EMIT recorder.progressed(pictures, at);
            });
        }
        for (; done < job.commands.size() && job.commands[done].tick <= now; ++done) runner->command(job.commands[done].what);
        if (Status ticked = runner->tick(); !ticked) return ticked.error();
    }
    if (state.cancelled) return false;
    if (Status finished = movie.value()->finish(); !finished) return finished.error();
    return true;
}

} // namespace trundle
