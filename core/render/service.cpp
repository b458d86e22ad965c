#include "render/service.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "base/platform/thread_priority.h"
#include "render/studio.h"

namespace trundle {
namespace {

enum class Rank { Scene, Capture, View };

/// A request that waits. `refuse` is called instead of `work` where it is not to be served any more.
struct Job {
    std::function<void(Studio&)> work;
    std::function<void(const Error&)> refuse;
    std::uint64_t stream = 0;
    Rank rank = Rank::View;
    bool yields = false;
};

template <class T, class Work> Job jobFor(Work work, std::function<void(Result<T>)> done) {
    auto answer = std::make_shared<std::function<void(Result<T>)>>(std::move(done));
    Job job;
    job.refuse = [answer](const Error& why) { (*answer)(why); };
    job.work = [answer, work = std::move(work)](Studio& studio) {
        // Memory that runs out in OSG or in a picture's buffer ends this request only.
        Result<T> result = Error{Code::PictureFailed, "it failed"};
        try {
            result = work(studio);
        } catch (const std::exception& e) { result = Error{Code::PictureFailed, e.what()}; }
        (*answer)(std::move(result));
    };
    return job;
}

/// A future for what a callback gets.
template <class T> std::pair<std::function<void(Result<T>)>, std::future<Result<T>>> promised() {
    auto promise = std::make_shared<std::promise<Result<T>>>();
    std::future<Result<T>> future = promise->get_future();
    return {[promise](Result<T> result) { promise->set_value(std::move(result)); }, std::move(future)};
}

} // namespace

struct RenderService::Thread {
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Job> jobs;
    bool stopping = false;
    bool yielding = false;       // what is drawn now yields
    bool enough = false;         // and is not to be drawn to its end; OSG looks here too, so it is no std::atomic
    std::optional<Error> failed; // no context: nothing will ever be drawn
    std::uint64_t lastScene = 0;
    std::string renderer;
    std::atomic<LookChoice> look = LookChoice::Automatic;
    std::string notice; // nobody has been told yet
    std::promise<Status> promise;
    std::shared_future<Status> opened = promise.get_future().share();
    std::thread thread;

    /// Where a capture goes: before the views that wait at the end, behind the scenes it may need.
    [[nodiscard]] std::deque<Job>::iterator placeFor(const Job& job) {
        auto place = jobs.end();
        if (job.rank == Rank::Capture)
            while (place != jobs.begin() && std::prev(place)->rank == Rank::View) --place;
        return place;
    }

    void post(Job job) {
        std::optional<Job> replaced;
        std::optional<Error> why;
        {
            const std::lock_guard lock(mutex);
            const auto same =
                std::find_if(jobs.begin(), jobs.end(), [&](const Job& j) { return job.stream != 0 && j.stream == job.stream; });
            if (failed || stopping) {
                why = failed ? *failed : Error{Code::PictureFailed, "the render service has ended"};
                replaced = std::move(job);
            } else {
                if (yielding && !job.yields) std::atomic_ref(enough).store(true);
                if (same != jobs.end()) {
                    why = Error{Code::PictureFailed, "a newer picture took its place"};
                    replaced = std::exchange(*same, std::move(job));
                } else {
                    jobs.insert(placeFor(job), std::move(job));
                }
            }
        }
        wake.notify_one();
        if (replaced && replaced->refuse) replaced->refuse(*why);
    }

    [[nodiscard]] Result<Image> draw(Studio& studio, const PictureRequest& request) {
        Result<Image> image = studio.draw(request, request.capture ? LookChoice::Automatic : look.load());
        if (std::string told = studio.takeNotice(); !told.empty()) {
            const std::lock_guard lock(mutex);
            notice = std::move(told);
        }
        return image;
    }

    void refuseAll(const Error& why) {
        std::deque<Job> left;
        {
            const std::lock_guard lock(mutex);
            left.swap(jobs);
        }
        for (Job& job : left)
            if (job.refuse) job.refuse(why);
    }

    void run() {
        Result<std::unique_ptr<Studio>> studio = Studio::open();
        if (!studio) {
            {
                const std::lock_guard lock(mutex);
                failed = studio.error();
            }
            promise.set_value(studio.error());
            refuseAll(studio.error());
            return;
        }
        studio.value()->endEarlyOn(enough);
        renderer = studio.value()->context().renderer();
        promise.set_value({});
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [&] { return stopping || !jobs.empty(); });
            if (stopping) break;
            Job job = std::move(jobs.front());
            jobs.pop_front();
            yielding = job.yields;
            enough = yielding && std::any_of(jobs.begin(), jobs.end(), [](const Job& other) { return !other.yields; });
            lock.unlock();
            job.work(*studio.value());
            job = {};
            lock.lock();
        }
    }
};

RenderService::RenderService(std::unique_ptr<Thread> thread) : m_thread(std::move(thread)) {}

std::unique_ptr<RenderService> RenderService::startInBackground() {
    auto thread = std::make_unique<Thread>();
    thread->thread = std::thread([t = thread.get()] {
        letOthersGoFirst(); // with no graphics card pictures take all the processors that there are: a window's own work goes first
        t->run();
    });
    return std::unique_ptr<RenderService>(new RenderService(std::move(thread)));
}

Result<std::unique_ptr<RenderService>> RenderService::start() {
    auto thread = std::make_unique<Thread>();
    thread->thread = std::thread([t = thread.get()] { t->run(); });
    std::unique_ptr<RenderService> service(new RenderService(std::move(thread)));
    const Status status = service->m_thread->opened.get();
    if (!status) return status.error();
    return service;
}

RenderService::~RenderService() {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->stopping = true;
    }
    m_thread->wake.notify_one();
    m_thread->thread.join();
    m_thread->refuseAll({Code::PictureFailed, "the render service has ended"});
}

SceneId RenderService::addScene(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<const ExperimentSpec> ghosts) {
    SceneId id;
    {
        const std::lock_guard lock(m_thread->mutex);
        id = SceneId(++m_thread->lastScene);
    }
    if (!experiment) return id;
    m_thread->post({[id, experiment = std::move(experiment), ghosts = std::move(ghosts)](Studio& studio) {
                        // A scene too large for memory is no scene; drawing it says so.
                        try {
                            studio.add(id, experiment, ghosts);
                        } catch (const std::exception&) { studio.remove(id); }
                    },
                    nullptr, 0, Rank::Scene});
    return id;
}

void RenderService::removeScene(SceneId scene) {
    m_thread->post({[scene](Studio& studio) { studio.remove(scene); }, nullptr, 0, Rank::Scene});
}

void RenderService::draw(PictureRequest request, ImageDone done) {
    const std::uint64_t stream = request.stream;
    const Rank rank = request.capture ? Rank::Capture : Rank::View;
    const bool yields = request.yields;
    Job job = jobFor<Image>(
        [request = std::move(request), t = m_thread.get()](Studio& studio) { return t->draw(studio, request); }, std::move(done));
    job.stream = stream;
    job.rank = rank;
    job.yields = yields;
    m_thread->post(std::move(job));
}

std::future<Result<Image>> RenderService::draw(PictureRequest request) {
    auto [done, future] = promised<Image>();
    draw(std::move(request), std::move(done));
    return std::move(future);
}

std::future<Result<Measured>> RenderService::measure(PictureRequest request) {
    auto [done, future] = promised<Measured>();
    const Rank rank = request.capture ? Rank::Capture : Rank::View;
    Job job =
        jobFor<Measured>([request = std::move(request)](Studio& studio) { return studio.measure(request); }, std::move(done));
    job.rank = rank;
    m_thread->post(std::move(job));
    return std::move(future);
}

void RenderService::pickAll(PickRequest request, PickDone done) {
    m_thread->post(jobFor<std::vector<Picked>>([request = std::move(request)](Studio& studio) { return studio.pick(request); },
                                               std::move(done)));
}

std::future<Result<Picked>> RenderService::pick(PickRequest request) {
    auto [done, future] = promised<Picked>();
    pickAll(std::move(request), [done = std::move(done)](Result<std::vector<Picked>> all) {
        if (!all) done(all.error());
        else done(all.value().empty() ? Picked{} : all.value().front());
    });
    return std::move(future);
}

const std::string& RenderService::renderer() const {
    m_thread->opened.wait();
    return m_thread->renderer;
}

bool RenderService::isSoftware() const {
    m_thread->opened.wait();
    return isSoftwareRenderer(m_thread->renderer);
}

void RenderService::setLook(LookChoice look) { m_thread->look = look; }

std::string RenderService::takeNotice() {
    const std::lock_guard lock(m_thread->mutex);
    return std::exchange(m_thread->notice, {});
}

} // namespace trundle
