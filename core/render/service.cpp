#include "render/service.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "render/studio.h"

namespace trundle {
namespace {

/// A request that waits. `refuse` is called instead of `work` where it is not to be served any more.
struct Job {
    std::function<void(Studio&)> work;
    std::function<void(const Error&)> refuse;
    std::uint64_t stream = 0;
};

template <class T, class Work>
std::pair<Job, std::future<Result<T>>> jobFor(Work work, std::uint64_t stream = 0) {
    auto promise = std::make_shared<std::promise<Result<T>>>();
    std::future<Result<T>> future = promise->get_future();
    Job job;
    job.stream = stream;
    job.refuse = [promise](const Error& why) { promise->set_value(why); };
    job.work = [promise, work = std::move(work)](Studio& studio) {
        // Memory that runs out in OSG or in a picture's buffer ends this request only.
        Result<T> result = Error{Code::PictureFailed, "it failed"};
        try { result = work(studio); } catch (const std::exception& e) { result = Error{Code::PictureFailed, e.what()}; }
        promise->set_value(std::move(result));
    };
    return {std::move(job), std::move(future)};
}

} // namespace

struct RenderService::Thread {
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Job> jobs;
    bool stopping = false;
    std::uint64_t lastScene = 0;
    std::string renderer;
    bool software = false;
    std::thread thread;

    void post(Job job) {
        std::optional<Job> replaced;
        {
            const std::lock_guard lock(mutex);
            const auto same =
                std::find_if(jobs.begin(), jobs.end(), [&](const Job& j) { return job.stream != 0 && j.stream == job.stream; });
            if (same != jobs.end()) {
                replaced = std::exchange(*same, std::move(job));
            } else {
                jobs.push_back(std::move(job));
            }
        }
        wake.notify_one();
        if (replaced) replaced->refuse({Code::PictureFailed, "a newer picture took its place"});
    }

    void run(std::promise<Status> started) {
        Result<std::unique_ptr<Studio>> opened = Studio::open();
        if (!opened) {
            started.set_value(opened.error());
            return;
        }
        std::unique_ptr<Studio> studio = std::move(opened).value();
        renderer = studio->context().renderer();
        software = studio->context().isSoftware();
        started.set_value({});
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [&] { return stopping || !jobs.empty(); });
            if (stopping) break;
            Job job = std::move(jobs.front());
            jobs.pop_front();
            lock.unlock();
            job.work(*studio);
            job = {};
            lock.lock();
        }
    }
};

RenderService::RenderService(std::unique_ptr<Thread> thread) : m_thread(std::move(thread)) {}

Result<std::unique_ptr<RenderService>> RenderService::start() {
    auto thread = std::make_unique<Thread>();
    std::promise<Status> promise;
    std::future<Status> started = promise.get_future();
    thread->thread = std::thread([t = thread.get(), p = std::move(promise)]() mutable { t->run(std::move(p)); });
    const Status status = started.get();
    if (!status) {
        thread->thread.join();
        return status.error();
    }
    return std::unique_ptr<RenderService>(new RenderService(std::move(thread)));
}

RenderService::~RenderService() {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->stopping = true;
    }
    m_thread->wake.notify_one();
    m_thread->thread.join();
    for (Job& job : m_thread->jobs) if (job.refuse) job.refuse({Code::PictureFailed, "the render service has ended"});
}

SceneId RenderService::addScene(std::shared_ptr<const ExperimentSpec> experiment) {
    SceneId id;
    {
        const std::lock_guard lock(m_thread->mutex);
        id = SceneId(++m_thread->lastScene);
    }
    if (!experiment) return id;
    m_thread->post({[id, experiment = std::move(experiment)](Studio& studio) {
        // A scene too large for memory is no scene; drawing it says so.
        try { studio.add(id, experiment); } catch (const std::exception&) { studio.remove(id); }
    }, nullptr, 0});
    return id;
}

void RenderService::removeScene(SceneId scene) {
    m_thread->post({[scene](Studio& studio) { studio.remove(scene); }, nullptr, 0});
}

std::future<Result<Image>> RenderService::draw(PictureRequest request) {
    const std::uint64_t stream = request.stream;
    auto [job, future] = jobFor<Image>([request = std::move(request)](Studio& studio) { return studio.draw(request); }, stream);
    m_thread->post(std::move(job));
    return std::move(future);
}

std::future<Result<Picked>> RenderService::pick(PickRequest request) {
    auto [job, future] = jobFor<Picked>([request = std::move(request)](Studio& studio) { return studio.pick(request); });
    m_thread->post(std::move(job));
    return std::move(future);
}

const std::string& RenderService::renderer() const { return m_thread->renderer; }
bool RenderService::isSoftware() const { return m_thread->software; }

} // namespace trundle
