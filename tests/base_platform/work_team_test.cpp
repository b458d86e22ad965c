// Teams of threads: all work is done, by each once, round after round, also when threads sleep between rounds.
#include <QTest>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/platform/work_team.h"

using trundle::WorkTeam;

class WorkTeamTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachOfThemWorksOnce_data() {
        QTest::addColumn<unsigned>("size");
        for (const unsigned size : {1u, 2u, 3u, 7u}) QTest::addRow("%u", size) << size;
    }
    void eachOfThemWorksOnce() {
        QFETCH(unsigned, size);
        WorkTeam team(size);
        QCOMPARE(team.size(), size);
        std::vector<std::uint64_t> counts(size); // each written by its thread alone, read after the round
        for (std::uint64_t round = 1; round <= 3000; ++round) {
            const unsigned workers = 1 + static_cast<unsigned>(round % size);
            const std::vector<std::uint64_t> before = counts;
            team.run(workers, [&](unsigned worker) { ++counts[worker]; });
            for (unsigned i = 0; i < size; ++i) QCOMPARE(counts[i], before[i] + (i < workers ? 1 : 0));
        }
    }

    void allWakeThatSleep() {
        WorkTeam team(4);
        std::vector<int> done(4);
        for (int round = 1; round <= 30; ++round) {
            const auto until =
                std::chrono::steady_clock::now() + std::chrono::milliseconds(round % 3); // longer than it polls, and shorter
            while (std::chrono::steady_clock::now() < until) {}
            team.run(4, [&](unsigned worker) { ++done[worker]; });
            QCOMPARE(done, std::vector<int>(4, round));
        }
    }

    /// A worker has the same part again; parts that are too small are not made.
    void splitsIntoOnePartForEachWorker() {
        for (const unsigned size : {1u, 2u, 5u})
            for (const std::size_t count : {0, 1, 7, 8, 9, 1000})
                for (const std::size_t least : {1, 8, 5000}) {
                    WorkTeam team(size);
                    using Parts = std::vector<std::pair<std::size_t, std::size_t>>;
                    const auto split = [&] {
                        Parts parts(size);
                        team.split(count, least, [&](unsigned worker, std::size_t begin, std::size_t end) {
                            parts[worker] = {begin, end};
                        });
                        return parts;
                    };
                    const Parts parts = split();
                    QVERIFY(split() == parts);
                    std::size_t next = 0;
                    for (const auto& [begin, end] : parts) {
                        if (begin == end) continue;
                        QCOMPARE(begin, next);
                        QVERIFY(end - begin >= std::min(count, least));
                        next = end;
                    }
                    QCOMPARE(next, count);
                }
    }

    /// A piece that its thread has not begun when the caller is ready is done by the caller: threads that wake late hold up nothing.
    void theCallerDoesWhatIsNotBegun() {
        WorkTeam team(3);
        const auto caller = std::this_thread::get_id();
        int byCaller = 0, rounds = 0; // written by the caller alone
        while (byCaller == 0 && ++rounds < 100'000)
            team.run(3, [&](unsigned worker) {
                if (worker > 0 && std::this_thread::get_id() == caller) ++byCaller;
            });
        QVERIFY(byCaller > 0);
    }

    void whatOneRoundWroteTheNextReads() {
        WorkTeam team(3);
        std::vector<std::uint64_t> values(600, 1), next(600);
        for (int round = 0; round < 500; ++round) {
            team.split(values.size(), 16, [&](unsigned, std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) next[i] = 3 * values[i] + 2 * values[(i + 1) % values.size()];
            });
            std::swap(values, next);
        }
        std::uint64_t one = 1;
        for (int round = 0; round < 500; ++round) one *= 5; // all are equal
        QVERIFY(std::ranges::all_of(values, [&](std::uint64_t value) { return value == one; }));
    }
};

QTEST_GUILESS_MAIN(WorkTeamTest)
#include "work_team_test.moc"
