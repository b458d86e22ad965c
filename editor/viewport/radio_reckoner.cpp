#include "editor/viewport/radio_reckoner.h"

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

struct RadioReckoner::Thread {
    struct LinkWish {
        std::uint64_t number;
        RadioPlaces places;
        std::vector<bool> selected;
    };
    struct NumberedCoverage {
        std::uint64_t number;
        CoverageWish wish;
    };

    Answers answers;
    std::mutex mutex;
    std::condition_variable wake;
    std::optional<LinkWish> links;
    std::optional<NumberedCoverage> coverage;
    std::uint64_t forgotten = 0; // how often
    bool stopping = false;
    std::thread thread;

    explicit Thread(Answers what) : answers(std::move(what)) {}

    void run() {
        std::unique_lock lock(mutex);
        while (true) {
            wake.wait(lock, [&] { return stopping || links || coverage; });
            if (stopping) return;
            if (links) {
                reckonLinks(lock);
                continue;
            }
            const NumberedCoverage next = *std::exchange(coverage, std::nullopt);
            const std::uint64_t before = forgotten;
            lock.unlock();
            reckon(next, before);
            lock.lock();
        }
    }

    /// Locked before and after.
    void reckonLinks(std::unique_lock<std::mutex>& lock) {
        const LinkWish next = *std::exchange(links, std::nullopt);
        lock.unlock();
        answers.links(next.number, linksOf(next.places, next.selected));
        lock.lock();
    }

    enum class Turn { GoOn, Newer, Over };
    /// Links do not wait for the end of a map.
    Turn turn(std::uint64_t before) {
        std::unique_lock lock(mutex);
        if (!stopping && links) reckonLinks(lock);
        return stopping || forgotten != before ? Turn::Over : coverage ? Turn::Newer : Turn::GoOn;
    }

    void reckon(const NumberedCoverage& next, std::uint64_t before) {
        const MediumSettings& medium = next.wish.places.objects->experiment().medium;
        const bool slow = medium.wallLoss > 0;
        if (slow) {
            CoverageWish coarse = next.wish;
            coarse.cells = std::min(coarse.cells, kCoarseCells);
            auto made = coverageOf(coarse, [&] { return turn(before) != Turn::Over; });
            if (!made) return answers.coverageGivenUp(next.number);
            // Things move on: coarse maps that follow are better than a fine one that comes too late.
            const bool last = turn(before) == Turn::Newer;
            answers.coverage(next.number, mapOf(std::move(*made)), last);
            if (last) return;
        }
        auto made = coverageOf(next.wish, [&] {
            const Turn now = turn(before);
            return now == Turn::GoOn || (now == Turn::Newer && !slow);
        });
        if (made) answers.coverage(next.number, mapOf(std::move(*made)), true);
        else if (turn(before) == Turn::Over) answers.coverageGivenUp(next.number);
    }
};

RadioReckoner::RadioReckoner(Answers answers) : m_thread(std::make_unique<Thread>(std::move(answers))) {
    m_thread->thread = std::thread([t = m_thread.get()] { t->run(); });
}

RadioReckoner::~RadioReckoner() {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->stopping = true;
    }
    m_thread->wake.notify_one();
    m_thread->thread.join();
}

void RadioReckoner::wantLinks(std::uint64_t number, RadioPlaces places, std::vector<bool> selected) {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->links = {number, std::move(places), std::move(selected)};
    }
    m_thread->wake.notify_one();
}

void RadioReckoner::wantCoverage(std::uint64_t number, CoverageWish wish) {
    {
        const std::lock_guard lock(m_thread->mutex);
        m_thread->coverage = {number, std::move(wish)};
    }
    m_thread->wake.notify_one();
}

void RadioReckoner::forget() {
    const std::lock_guard lock(m_thread->mutex);
    m_thread->links.reset();
    m_thread->coverage.reset();
    ++m_thread->forgotten;
}

} // namespace trundle
