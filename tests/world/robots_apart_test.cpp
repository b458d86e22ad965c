// Devices of several robots that are called at the same time: on which threads, in which order, and what they may not ask for.
#include <QtTest>

#include <atomic>
#include <set>
#include <string>
#include <thread>

#include "world/probe_device.h"

using namespace fixture;

namespace {

constexpr int kRobots = 64;

/// Probes whose kind says that they are independent of other robots.
const TrundleKind* apartCode(const std::string& kind) {
    static const TrundleKind apart = [] {
        TrundleKind k = *probeKind();
        k.traits = TRUNDLE_INDEPENDENT;
        return k;
    }();
    return kind == "Probe" ? &apart : rowOnly(kind);
}

std::string nameOf(const char* prefix, int robot) { return prefix + std::to_string(robot); }

/// Robots in a square, each with a probe a and a probe b with its number.
Scene crowd(int threads) {
    Scene scene = r0Scene();
    scene.spec->settings.threads = threads;
    scene.scenery({plane("floor", {}, 1), box("wall", {0.2, 20, 1}, at(8.1, 0, 0.5), 3)});
    for (int i = 0; i < kRobots; ++i) {
        auto config = std::make_shared<RobotConfigSpec>(*r0());
        for (const char* prefix : {"a", "b"}) config->devices.push_back(probe(nameOf(prefix, i)));
        scene.robot(nameOf("r", i), at(i % 8, i / 8, 0), config);
    }
    return scene;
}

} // namespace

class RobotsApartTest : public QObject {
    Q_OBJECT

    Bench m_bench;

    /// What `sense` returns of each robot, and its number.
    void senseOfAll(const char* prefix, const std::function<std::int32_t(int robot, const TrundleServices&)>& sense) {
        for (int i = 0; i < kRobots; ++i)
            m_bench.probes[nameOf(prefix, i)].sense = [sense, i](const TrundleServices& s) { return sense(i, s); };
    }
    void inEachProbe() {
        for (int i = 0; i < kRobots; ++i)
            for (const char* prefix : {"a", "b"}) m_bench.probes[nameOf(prefix, i)];
    }
    /// Without a failure of the first sense: empty.
    std::string failureOfStart(int threads) {
        Diagnostics diagnostics;
        Scene scene = crowd(threads);
        if (scene.build(apartCode, diagnostics)) return {};
        return diagnostics.all().at(0).message;
    }

private Q_SLOTS:
    void init() {
        m_bench = {};
        bench = &m_bench;
        inEachProbe();
    }

    /// Each robot's calls in their order, those of another part of the robots on another thread meanwhile.
    void robotsShareThreads() {
        std::vector<std::string> orders(kRobots); // each is written by one thread at a time
        std::atomic<bool> waits = false, lastIsCalled = false;
        std::thread::id ofFirst, ofLast;
        for (const char* prefix : {"a", "b"})
            senseOfAll(prefix, [&, prefix](int robot, const TrundleServices&) {
                orders[robot] += prefix[0];
                if (!waits || prefix[0] == 'b') return 0;
                if (robot == 0) {
                    ofFirst = std::this_thread::get_id();
                    while (!lastIsCalled) std::this_thread::yield(); // it is on a thread that is not this one
                } else if (robot == kRobots - 1) {
                    ofLast = std::this_thread::get_id();
                    lastIsCalled = true;
                }
                return 0;
            });
        for (int i = 0; i < kRobots; ++i) // b drives a, so it senses after a
            m_bench.probes[nameOf("b", i)].setup = [i](const TrundleMount& m) {
                return m.peerSignal(m.context, "", nameOf("a", i).c_str(), "in") ? 0 : -1;
            };
        for (const int threads : {1, 2, 4}) {
            orders.assign(kRobots, {});
            waits = lastIsCalled = false;
            Scene scene = crowd(threads);
            auto world = scene.build(apartCode);
            QVERIFY(world);
            waits = threads > 1;
            QVERIFY(world->tick().ok());
            QVERIFY(std::ranges::all_of(orders, [](const std::string& order) { return order == "abab"; }));
            if (waits) QVERIFY(ofFirst == std::this_thread::get_id() && ofLast != ofFirst);
        }
    }

    /// Of a kind that does not say it, and what senses after one.
    void othersStayOnOneThread() {
        std::set<std::thread::id> threads;
        for (const char* prefix : {"a", "b"})
            senseOfAll(prefix, [&](int, const TrundleServices&) {
                threads.insert(std::this_thread::get_id());
                return 0;
            });
        Scene scene = crowd(4);
        auto world = scene.build(code);
        QVERIFY(world && world->tick().ok());
        QCOMPARE(threads, std::set{std::this_thread::get_id()});
    }

    void textsAndFailuresHaveOneOrder() {
        std::vector<std::string> first;
        for (const int threads : {1, 2, 5}) {
            std::atomic<bool> fails = false;
            std::atomic<int> called = 0;
            senseOfAll("b", [&](int robot, const TrundleServices& s) {
                ++called;
                s.print(s.context, TRUNDLE_INFO, ("I am " + std::to_string(robot)).c_str());
                return fails && (robot == 50 || robot == 21 || robot == 63) ? 1 : 0;
            });
            Scene scene = crowd(threads);
            auto world = scene.build(apartCode);
            QVERIFY(world);
            std::vector<std::string> texts;
            world->setDeviceText(
                [&](const std::string& path, int, const std::string& text) { texts.push_back(path + ": " + text); });
            QCOMPARE(texts.size(), std::size_t{kRobots}); // of the first sense
            QVERIFY(world->tick().ok());
            QCOMPARE(texts.size(), std::size_t{2 * kRobots});
            QCOMPARE(texts.at(kRobots + 7), std::string("r7/b7: I am 7"));
            if (first.empty()) first = texts;
            QVERIFY(texts == first);
            fails = true;
            called = 0;
            const Status done = world->tick();
            QVERIFY(!done.ok());
            QVERIFY2(done.error().message.find("r21/b21") != std::string::npos, done.error().message.c_str());
            QCOMPARE(called.load(), kRobots); // however many threads there are
            QCOMPARE(texts.size(), std::size_t{3 * kRobots});
        }
    }

    /// Contacts, rays and random numbers: the same bits on any number of threads.
    void readingsAreTheSame() {
        std::vector<double> first;
        for (const int threads : {1, 2, 3, 7}) {
            std::vector<std::vector<double>> seen(kRobots);
            std::vector<std::uint32_t> hulls(kRobots);
            for (int i = 0; i < kRobots; ++i)
                m_bench.probes[nameOf("a", i)].setup = [&hulls, i](const TrundleMount& m) {
                    return m.geom(m.context, "chassis.slider", &hulls[i]);
                };
            senseOfAll("a", [&](int robot, const TrundleServices& s) {
                static constexpr double kElevations[] = {0, 0.1};
                const TrundleFan fan{{robot % 8 + 0.1, robot / 8 + 0.3, 0.3}, {1, 0, 0, 0}, 5, -3, 0.2, kElevations, 30, 2, 0, 0};
                double distances[60];
                if (s.rays->castFan(s.context, &fan, distances, nullptr, nullptr) != 0) return 1;
                seen[robot].insert(seen[robot].end(), std::begin(distances), std::end(distances));
                const double from[] = {robot % 8 + 0.2, robot / 8 + 0.5, 0.05}, to[] = {0, -1, 0};
                TrundleHit hit{};
                seen[robot].push_back(s.ray(s.context, from, to, 4, 0, &hit) ? hit.distance : -1);
                TrundleContact contacts[8];
                const std::uint32_t count = s.contacts(s.context, hulls[robot], contacts, 8);
                seen[robot].push_back(count);
                if (count > 0) seen[robot].push_back(contacts[0].force);
                seen[robot].push_back(static_cast<double>(s.random(s.context, 3) >> 12));
                return 0;
            });
            Scene scene = crowd(threads);
            auto world = scene.build(apartCode);
            QVERIFY(world);
            for (int i = 0; i < 20; ++i) QVERIFY(world->tick().ok());
            std::vector<double> all;
            for (const auto& robot : seen) all.insert(all.end(), robot.begin(), robot.end());
            QVERIFY(all.size() > 20 * 64 * std::size_t{kRobots});
            if (first.empty()) first = all;
            QVERIFY(std::ranges::any_of(all, [](double d) { return d > 0.1 && d < 4; }));
            QVERIFY(all == first);
        }
    }

    /// The same with one thread, so that it is not found out with more of them only.
    void whatIsSharedIsRefused() {
        for (const int threads : {1, 3}) {
            senseOfAll("a", [](int, const TrundleServices&) { return 0; });
            for (int i = 0; i < kRobots; ++i)
                m_bench.probes[nameOf("a", i)].act = [](const TrundleServices& s) {
                    const double velocity[] = {1, 0, 0};
                    s.surfaceVelocity(s.context, 0, velocity);
                    return 0;
                };
            Scene scene = crowd(threads);
            auto world = scene.build(apartCode);
            QVERIFY(world);
            const Status done = world->tick();
            QVERIFY(!done.ok());
            QCOMPARE(
                QString::fromStdString(done.error().message),
                QString(
                    "the simulation stopped at t = 0 s: r0/a0: its kind says that it is independent of other robots, and it asks "
                    "for a moving surface"));
        }
    }
};

QTEST_APPLESS_MAIN(RobotsApartTest)
#include "robots_apart_test.moc"
