#include "editor/viewport/radio/radio_worker.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace trundle {
namespace {

constexpr std::uint32_t kCoarseCells = 48;

CoverageMap mapOf(Coverage coverage) {
    CoverageMap map{std::move(coverage), {}, nullptr};
    map.scale = scaleOf(map.coverage);
    map.picture = pictureOf(map.coverage, map.scale);
    return map;
}

} // namespace

struct RadioWorker::Thread {
    struct LinkRequest {
        std::uint64_t number;
        RadioPoses places;
        std::vector<bool> selected;
    };
    struct NumberedCoverage {
        std::uint64_t number;
        CoverageRequest request;
    };

    Answers answers;
    std::mutex mutex;
    std::condition_variable wake;
    std::optional<LinkRequest> links;
    std::optional<NumberedCoverage> coverage;
    std::uint64_t forgotten = 0; // number of calls of forget()
    bool stopping = false;
    std::thread thread;

    explicit Thread(Answers what) : answers(std::move(what)) {}

    void run() {
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [&] { return stopping || links || coverage; });
            if (stopping) return;
            if (links) {
                computeLinks(lock);
                continue;
            }
            const NumberedCoverage next = *std::exchange(coverage, std::nullopt);
            const std::uint64_t before = forgotten;
            lock.unlock();
            compute(next, before);
            lock.lock();
        }
    }

    /// `lock` is held before and after, and released while computing.
    void computeLinks(std::unique_lock<std::mutex>& lock) {
        const LinkRequest next = *std::exchange(links, std::nullopt);
        lock.unlock();
        answers.links(next.number, linksOf(next.places, next.selected));
        lock.lock();
    }

    enum class WorkerStep { Continue, Newer, Over };
    /// Checks for newer requests; links are computed in between, so that they do not wait for a coverage map.
    WorkerStep nextStep(std::uint64_t before) {
        std::unique_lock lock(mutex);
        if (!stopping && links) computeLinks(lock);
        return stopping || forgotten != before ? WorkerStep::Over : coverage ? WorkerStep::Newer : WorkerStep::Continue;
    }

    void compute(const NumberedCoverage& next, std::uint64_t before) {
        const MediumSettings& medium = next.request.places.objects->experiment().medium;
        const bool slow = medium.wallLoss > 0;
        if (slow) {
            CoverageRequest coarse = next.request;
            coarse.cells = std::min(coarse.cells, kCoarseCells);
            auto made = coverageOf(coarse, [&] { return nextStep(before) != WorkerStep::Over; });
            if (!made) return answers.coverageGivenUp(next.number);
            // While the scene changes, frequent coarse maps are more useful than a late fine one.
            const bool last = nextStep(before) == WorkerStep::Newer;
            answers.coverage(next.number, mapOf(std::move(*made)), last);
            if (last) return;
        }
        auto made = coverageOf(next.request, [&] {
            const WorkerStep now = nextStep(before);
            return now == WorkerStep::Continue || (now == WorkerStep::Newer && !slow);
        });
        if (made) answers.coverage(next.number, mapOf(std::move(*made)), true);
        else if (nextStep(before) == WorkerStep::Over) answers.coverageGivenUp(next.number);
    }
};

RadioWorker::RadioWorker(Answers answers) : m_thread(std::make_unique<Thread>(std::move(answers))) {
    m_thread->thread = std::thread([t = m_thread.get()] { t->run(); });
}

RadioWorker::~RadioWorker() {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->stopping = true;
    }
    m_thread->wake.notify_one();
    m_thread->thread.join();
}

void RadioWorker::requestLinks(std::uint64_t number, RadioPoses places, std::vector<bool> selected) {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->links = {number, std::move(places), std::move(selected)};
    }
    m_thread->wake.notify_one();
}

void RadioWorker::requestCoverage(std::uint64_t number, CoverageRequest request) {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->coverage = {number, std::move(request)};
    }
    m_thread->wake.notify_one();
}

void RadioWorker::forget() {
    const std::lock_guard lock(m_thread->mutex);
    m_thread->links.reset();
    m_thread->coverage.reset();
    ++m_thread->forgotten;
}

} // namespace trundle
