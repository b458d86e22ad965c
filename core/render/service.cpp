#include "render/service.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "base/platform/thread_priority.h"
#include "render/render_thread_state.h"

namespace trundle {
namespace {

enum class Rank { Scene, Capture, View };

/// A queued request. `refuse` is called instead of `work` if the request is not served any more.
struct Job {
    std::function<void(RenderThreadState&)> work;
    std::function<void(const Error&)> refuse;
    std::uint64_t stream = 0;
    Rank rank = Rank::View;
    bool yields = false;
};

template <class T, class Work> Job jobFor(Work work, std::function<void(Result<T>)> done) {
    auto answer = std::make_shared<std::function<void(Result<T>)>>(std::move(done));
    Job job;
    job.refuse = [answer](const Error& why) { (*answer)(why); };
    job.work = [answer, work = std::move(work)](RenderThreadState& state) {
        // Running out of memory in OSG or in an image buffer fails this request only.
        Result<T> result = Error{Code::PictureFailed, "it failed"};
        try {
            result = work(state);
        } catch (const std::exception& e) { result = Error{Code::PictureFailed, e.what()}; }
        (*answer)(std::move(result));
    };
    return job;
}

/// A callback and the future that it fulfils.
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
    bool yielding = false;       // the current image is cancelled by a newer request
    bool enough = false;         // cancels the current image; also read by OSG, therefore not a std::atomic
    std::optional<Error> failed; // no context: every request fails with this
    std::uint64_t lastScene = 0;
    std::string renderer;
    std::atomic<LookChoice> look = LookChoice::Automatic;
    std::string notice; // a warning that has not been taken yet
    std::promise<Status> promise;
    std::shared_future<Status> opened = promise.get_future().share();
    std::thread thread;

    /// Queue position of a job: captures go before all views at the end of the queue, but behind scenes they may need.
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

    [[nodiscard]] Result<Image> draw(RenderThreadState& state, const PictureRequest& request) {
        Result<Image> image = state.draw(request, request.capture ? LookChoice::Automatic : look.load());
        if (std::string warning = state.takeWarning(); !warning.empty()) {
            const std::lock_guard lock(mutex);
            notice = std::move(warning);
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
        Result<std::unique_ptr<RenderThreadState>> state = RenderThreadState::open();
        if (!state) {
            {
                const std::lock_guard lock(mutex);
                failed = state.error();
            }
            promise.set_value(state.error());
            refuseAll(state.error());
            return;
        }
        state.value()->endEarlyOn(enough);
        renderer = state.value()->context().renderer();
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
            job.work(*state.value());
            job = {};
            lock.lock();
        }
    }
};

RenderService::RenderService(std::unique_ptr<Thread> thread) : m_thread(std::move(thread)) {}

std::unique_ptr<RenderService> RenderService::startInBackground(bool belowWindow) {
    auto thread = std::make_unique<Thread>();
    thread->thread = std::thread([t = thread.get(), belowWindow] {
        if (belowWindow) lowerThreadPriority();
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
    m_thread->post({[id, experiment = std::move(experiment), ghosts = std::move(ghosts)](RenderThreadState& state) {
                        // A scene too large for memory is not added; requests for it report that.
                        try {
                            state.add(id, experiment, ghosts);
                        } catch (const std::exception&) { state.remove(id); }
                    },
                    nullptr, 0, Rank::Scene});
    return id;
}

void RenderService::removeScene(SceneId scene) {
    m_thread->post({[scene](RenderThreadState& state) { state.remove(scene); }, nullptr, 0, Rank::Scene});
}

void RenderService::draw(PictureRequest request, ImageDone done) {
    const std::uint64_t stream = request.stream;
    const Rank rank = request.capture ? Rank::Capture : Rank::View;
    const bool yields = request.yields;
    Job job = jobFor<Image>(
        [request = std::move(request), t = m_thread.get()](RenderThreadState& state) { return t->draw(state, request); },
        std::move(done));
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

std::future<Result<DataImage>> RenderService::measure(PictureRequest request) {
    auto [done, future] = promised<DataImage>();
    const Rank rank = request.capture ? Rank::Capture : Rank::View;
    Job job = jobFor<DataImage>([request = std::move(request)](RenderThreadState& state) { return state.measure(request); },
                                std::move(done));
    job.rank = rank;
    m_thread->post(std::move(job));
    return std::move(future);
}

void RenderService::pickAll(PickRequest request, PickDone done) {
    m_thread->post(jobFor<std::vector<PickResult>>(
        [request = std::move(request)](RenderThreadState& state) { return state.pick(request); }, std::move(done)));
}

std::future<Result<PickResult>> RenderService::pick(PickRequest request) {
    auto [done, future] = promised<PickResult>();
    pickAll(std::move(request), [done = std::move(done)](Result<std::vector<PickResult>> all) {
        if (!all) done(all.error());
        else done(all.value().empty() ? PickResult{} : all.value().front());
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

std::string RenderService::takeWarning() {
    const std::lock_guard lock(m_thread->mutex);
    return std::exchange(m_thread->notice, {});
}

} // namespace trundle
