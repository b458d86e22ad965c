// Controllers of several robots that are called at the same time: what a run prints and does, on any number of threads.
#include <QtTest>

#include <trundle/controller.h>
#include <trundle/module.h>

#include "base/platform/work_team.h"
#include "control/in_process_backend.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"

using namespace trundle;

namespace {

constexpr int kRobots = 40;

/// What the robots do, by their names.
struct Plan {
    std::set<std::string> fails, finishes, opensLate;
    std::atomic<int> updates = 0;
    std::function<void(const std::string& robot)> inUpdate = [](const std::string&) {};
};
Plan* g_plan = nullptr;

template <bool isApart> struct Walker : Controller {
    static void describe(Describe<Walker>& d) {
        if (isApart) d.independent();
    }
    void setup(RobotPorts& robot) override { m_robot = robot.name(); }
    void update(Seconds) override {
        ++g_plan->updates;
        g_plan->inUpdate(m_robot);
        m_sum += random();
        print("drew ", m_sum);
        if (g_plan->opensLate.contains(m_robot) && !openLog("late.txt").open()) warn("no log");
        if (g_plan->finishes.contains(m_robot)) finish(m_robot + " is done");
        if (g_plan->fails.contains(m_robot)) fail(m_robot + " cannot");
    }
    std::string m_robot;
    double m_sum = 0;
};

const TrundleKind& kindOf(bool isApart) {
    const auto made = []<class T>(std::type_identity<T>) {
        ModuleRegistry r;
        r.controller<T>("Walker");
        return r;
    };
    static const ModuleRegistry plain = made(std::type_identity<Walker<false>>()),
                                apart = made(std::type_identity<Walker<true>>());
    return (isApart ? apart : plain).tables()[0]->kind;
}

/// What can be seen of a run.
struct Seen {
    std::vector<std::string> console;
    std::string finished, failure;
    int updates = 0;
    bool operator==(const Seen&) const = default;
};

} // namespace

class ControllersApartTest : public QObject {
    Q_OBJECT

    Plan m_plan;

    Seen run(unsigned threads, bool isApart, int ticks = 3) {
        Seen seen;
        m_plan.updates = 0;
        std::vector<std::string> names;
        for (int i = 0; i < kRobots; ++i) names.push_back("robot" + std::to_string(i));
        const auto experiment = experimentOf(names);
        for (RobotSpec& robot : experiment->robots)
            robot.controllers = {
                {{"Walker", "brain", {{"UpdatePeriod", numberValue(0)}, {"Budget", numberValue(0)}}, {}, {}}, {}}};
        RunOptions options;
        options.console = [&](double, const std::string& who, int, const std::string& text) {
            seen.console.push_back(who + ": " + text);
        };
        auto world = std::make_unique<FakeWorld>(experiment);
        if (threads > 1) world->team = std::make_unique<WorkTeam>(threads);
        ExperimentRunner runner(std::move(world), std::move(options));
        Diagnostics diagnostics;
        runner.startControllers(
            [&](const ControllerRequest& request) -> Result<std::unique_ptr<ControllerBackend>> {
                return makeInProcessBackend(*request.robot, request.controller, request.settings, kindOf(isApart), "");
            },
            diagnostics);
        for (int i = 0; i < ticks && !diagnostics.hasErrors(); ++i)
            if (const Status done = runner.tick(); !done) {
                seen.failure = done.error().message;
                break;
            }
        if (runner.finished()) seen.finished = runner.finished()->reason;
        seen.updates = m_plan.updates;
        return seen;
    }

private Q_SLOTS:
    void init() {
        m_plan.fails.clear();
        m_plan.finishes.clear();
        m_plan.opensLate.clear();
        m_plan.inUpdate = [](const std::string&) {};
        g_plan = &m_plan;
    }

    void aRunIsTheSameOnAnyNumberOfThreads() {
        m_plan.finishes = {"robot31", "robot7"};
        const Seen plain = run(1, false);
        QCOMPARE(plain.console.size(), std::size_t{3 * kRobots});
        QVERIFY(plain.console.at(1).starts_with("robot1") && plain.console.at(39).starts_with("robot39"));
        QCOMPARE(plain.finished, std::string("robot7 is done"));
        for (const unsigned threads : {1u, 2u, 5u}) QVERIFY(run(threads, true) == plain);
        QVERIFY(run(5, false) == plain);
    }

    /// Two that are at work at the same time; and none of a kind that does not say that it is independent.
    void theyAreCalledAtTheSameTime() {
        std::atomic<bool> isLast = false;
        std::thread::id ofFirst, ofLast;
        m_plan.inUpdate = [&](const std::string& robot) {
            if (robot == "robot39") {
                ofLast = std::this_thread::get_id();
                isLast = true;
            } else if (robot == "robot0") {
                ofFirst = std::this_thread::get_id();
                while (!isLast) std::this_thread::yield();
            }
        };
        QCOMPARE(run(2, true, 1).updates, kRobots);
        QVERIFY(ofFirst == std::this_thread::get_id() && ofLast != ofFirst);
        std::set<std::thread::id> threads;
        m_plan.inUpdate = [&](const std::string&) { threads.insert(std::this_thread::get_id()); };
        QCOMPARE(run(4, false, 2).updates, 2 * kRobots);
        QCOMPARE(threads.size(), std::size_t{1});
    }

    /// The first in their order ends the run; what those before it printed is there, and nothing of those behind it.
    void theFirstFailureEndsTheRun() {
        m_plan.fails = {"robot30", "robot12"};
        const Seen plain = run(1, false);
        QVERIFY2(plain.failure.find("robot12 cannot") != std::string::npos, plain.failure.c_str());
        for (const unsigned threads : {1u, 2u, 5u}) {
            const Seen apart = run(threads, true);
            QCOMPARE(apart.failure, plain.failure);
            QVERIFY(apart.console == plain.console);
            QCOMPARE(apart.updates, threads == 1 ? 13 : kRobots); // those behind it were at work already
        }
    }

    void whatIsSharedIsRefused() {
        m_plan.opensLate = {"robot3"};
        for (const unsigned threads : {1u, 3u}) {
            const Seen seen = run(threads, true, 1);
            const auto said = std::ranges::find_if(
                seen.console, [](const std::string& text) { return text.find("opens its logs in setup") != std::string::npos; });
            QVERIFY(said != seen.console.end() && said->starts_with("robot3"));
            QVERIFY(std::ranges::find(seen.console, "robot3: no log") != seen.console.end());
        }
    }
};

QTEST_APPLESS_MAIN(ControllersApartTest)
#include "controllers_apart_test.moc"
