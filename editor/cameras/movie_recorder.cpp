#include "editor/cameras/movie_recorder.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/platform/thread_priority.h"
#include "render/frame_drawer.h"
#include "run/movie_file.h"

namespace trundle {
namespace {

constexpr std::chrono::milliseconds kLastWait(2000);

} // namespace

std::uint64_t MovieJob::frameCount() const {
    return end < begin ? 0 : static_cast<std::uint64_t>(std::floor((end - begin) * framesPerSecond + 1e-6)) + 1;
}

/// What both threads know. It outlives both.
struct MovieRecorder::Work {
    Parts* parts = nullptr;
    RenderService* render = nullptr;
    std::atomic<bool> cancelled = false;

    std::mutex lock;
    std::condition_variable over;
    MovieRecorder* recorder = nullptr; // null once nobody waits for it
    bool done = false;

    template <class Tell> void tell(Tell what) {
        const std::scoped_lock guard(lock);
        if (recorder)
            QMetaObject::invokeMethod(
                recorder, [r = recorder, what] { what(*r); }, Qt::QueuedConnection);
    }
};

MovieRecorder::MovieRecorder(Parts& parts, RenderService& render, QObject* parent)
    : QObject(parent), m_parts(parts), m_render(render) {}

MovieRecorder::~MovieRecorder() {
    if (!m_work) return;
    m_work->cancelled = true;
    std::unique_lock guard(m_work->lock);
    m_work->recorder = nullptr;
    m_work->over.wait_for(guard, kLastWait, [this] { return m_work->done; });
}

void MovieRecorder::cancel() {
    if (m_work) m_work->cancelled = true;
}

void MovieRecorder::start(MovieJob job) {
    if (m_work) return;
    m_work = std::make_shared<Work>();
    m_work->parts = &m_parts;
    m_work->render = &m_render;
    m_work->recorder = this;
    std::thread([work = m_work, job = std::move(job)] {
        letOthersGoFirst();
        record(*work, job);
        const std::scoped_lock guard(work->lock);
        work->done = true;
        work->over.notify_all();
    }).detach();
}

void MovieRecorder::record(Work& work, const MovieJob& job) {
    const Result<bool> whole = film(work, job);
    const bool cancelled = work.cancelled && !(whole && whole.value()); // too late where the movie is whole
    const QString failure = whole || cancelled ? QString() : QString::fromStdString(whole.error().message);
    work.tell([failure, cancelled](MovieRecorder& recorder) {
        recorder.m_work.reset();
        Q_EMIT recorder.finished(failure, cancelled);
    });
}

/// Whether the movie is whole; false where it was cancelled.
Result<bool> MovieRecorder::film(Work& work, const MovieJob& job) {
    Result<std::unique_ptr<MovieFile>> movie = MovieFile::open(job.path, job.framesPerSecond);
    if (!movie) return movie.error();
    Diagnostics problems;
    const std::unique_ptr<Runner> runner = work.parts->makeRunner(*job.loaded, RunOptions{}, problems); // writes no logs
    if (!runner) {
        for (const Diagnostic& problem : problems.all())
            if (problem.severity == Severity::Error) return Error{problem.code, problem.message};
        return Error{Code::Internal, "the experiment cannot be built"};
    }
    const double tick = job.loaded->experiment->settings.tick;
    const std::uint64_t first = ticksFor(job.begin, tick), last = std::max(first, ticksFor(job.end, tick));
    FrameDrawer drawer(job.loaded->experiment, *work.render);
    const PoseReader reader(*job.loaded->experiment, runner->world().layout());
    std::size_t done = 0;
    auto told = std::chrono::steady_clock::now();
    const auto addPicture = [&](double time) -> Status {
        if (!job.camera.empty()) { // what the robot gets of it: with an UpdatePeriod, its newest
            const Result<const Frame*> frame = runner->cameras().capture(job.camera);
            return frame ? movie.value()->add(*frame.value(), time, tick) : Status(frame.error());
        }
        auto poses = std::make_shared<BodyPoses>();
        reader.read(runner->world().block(), *poses);
        PictureRequest request = job.look;
        request.view = job.view(*poses);
        const Result<Frame> frame =
            drawer.picture(std::move(request), {std::move(poses), runner->world().ticks(), runner->world().time()});
        return frame ? movie.value()->add(frame.value(), time, tick) : Status(frame.error());
    };
    while (!work.cancelled) {
        const std::uint64_t now = runner->world().ticks();
        const double time = (static_cast<double>(now) - static_cast<double>(first)) * tick;
        if (now >= first && movie.value()->isDue(time, tick)) {
            if (Status added = addPicture(time); !added) return added.error();
        }
        if (now >= last || runner->finished()) break;
        if (const auto since = std::chrono::steady_clock::now(); since - told > std::chrono::milliseconds(50)) {
            told = since;
            work.tell([pictures = movie.value()->frames(), at = runner->world().time()](MovieRecorder& recorder) {
                Q_EMIT recorder.progressed(pictures, at);
            });
        }
        for (; done < job.commands.size() && job.commands[done].tick <= now; ++done) runner->command(job.commands[done].what);
        if (Status ticked = runner->tick(); !ticked) return ticked.error();
    }
    if (work.cancelled) return false;
    if (Status finished = movie.value()->finish(); !finished) return finished.error();
    return true;
}

} // namespace trundle
