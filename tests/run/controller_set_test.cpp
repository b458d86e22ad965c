// Controllers during a run: what they keep when they are started again, who holds their robots, which ones a robot has.
#include <QtTest>

#include "run/experiment_runner.h"
#include "run/fake_world.h"

using namespace trundle;

namespace {

/// What the backends of a run have done, and what they are to do.
struct Script {
    std::map<std::string, double> values; ///< of the controller that was started last
    std::set<std::string> refused;        ///< properties
    int starts = 0, updates = 0;
    std::optional<double> updateS;  ///< how long it says that an update takes
    std::vector<std::string> opens; ///< logs that it opens in its setup
    bool breaks = false; ///< once, by a fault of another controller of its process
};

/// A controller in a process of its own. A Speed below 0 is a fault in its update.
class LiveBackend final : public ControllerBackend {
public:
    explicit LiveBackend(Script& script) : m_script(script) {}
    Status start(const SignalLayout&, SignalBlock&, ControllerOutputs outputs) override {
        ++m_script.starts;
        for (const std::string& name : m_script.opens)
            outputs.writeLog(outputs.openLog(name), "start " + std::to_string(m_script.starts) + "\n");
        m_script.values.clear();
        m_fault.reset();
        return {};
    }
    Status tick(std::uint64_t, double, double) override {
        if (std::exchange(m_script.breaks, false)) return fail("another one crashed", false);
        if (m_script.values["Speed"] < 0) return fail("Speed is negative", true);
        ++m_script.updates;
        return {};
    }
    Status set(const std::string& property, const PropertyValue& value) override {
        if (m_fault) return Error{Code::ControllerFailed, "it has stopped"};
        if (m_script.refused.contains(property)) return Error{Code::OutOfRange, property + " is out of range"};
        m_script.values[property] = value.numbers.front();
        return {};
    }
    void stop() override {}
    Status renew(std::uint64_t) override { return {}; }
    const ControllerFault* fault() const override { return m_fault ? &*m_fault : nullptr; }
    std::optional<double> updateS() const override { return m_script.updateS; }
    std::string describe() const override { return "live"; }

private:
    Status fail(const char* reason, bool isOwn) {
        m_fault.emplace();
        m_fault->reason = reason;
        m_fault->isOwn = isOwn;
        return Error{Code::ControllerFailed, reason};
    }

    Script& m_script;
    std::optional<ControllerFault> m_fault;
};

ControllerSpec controller(const char* name) { return {{"Live", name, {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}}; }

} // namespace

class ControllerSetTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    Script m_script;
    std::vector<std::string> m_console;
    std::unique_ptr<ExperimentRunner> m_runner;

    void command(decltype(Command::what) what) {
        m_runner->command(std::move(what));
        QVERIFY(m_runner->tick().ok());
    }
    void set(const char* property, double value) {
        command(PropertyCommand{"robot0/brain", property, {PropertyType::Number, {value}, {}}});
    }
    [[nodiscard]] std::size_t refusals() const {
        const auto isRefusal = [](const std::string& text) { return text.starts_with("command refused"); };
        return std::size_t(std::ranges::count_if(m_console, isRefusal));
    }
    [[nodiscard]] std::string namesOf(const char* robot) const {
        std::string names;
        for (const ControllerSpec* each : m_runner->controllersOf(robot)) names += each->name + " ";
        return names;
    }
    /// Whether its controller is called after this command.
    [[nodiscard]] bool isCalledAfter(bool held, Holder holder) {
        const int before = m_script.updates;
        command(HoldCommand{"robot0", held, holder});
        return m_script.updates > before;
    }

private Q_SLOTS:
    void init() {
        m_script = {};
        m_console.clear();
        const auto experiment = experimentOf({"robot0", "robot1"});
        experiment->robots[0].controllers = {controller("brain")};
        RunOptions options;
        options.console = [this](double, const std::string&, int, const std::string& text) { m_console.push_back(text); };
        options.logFolder = LogLocation(m_folder.filePath("logs").toStdString());
        m_runner = std::make_unique<ExperimentRunner>(std::make_unique<FakeWorld>(experiment), std::move(options));
        Diagnostics diagnostics;
        m_runner->startControllers(
            [this](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                return std::unique_ptr<ControllerBackend>(std::make_unique<LiveBackend>(m_script));
            },
            diagnostics);
        QVERIFY(!diagnostics.hasErrors());
    }
    void cleanup() { m_runner.reset(); }

    void liveValuesStayWhenAControllerIsStartedAgain() {
        set("Speed", 0.4);
        set("Speed", 0.5);
        set("Gain", 2);
        const std::map<std::string, double> values{{"Gain", 2}, {"Speed", 0.5}};
        QVERIFY(m_script.values == values);
        command(RestartCommand{"robot0", "brain"});
        QVERIFY(m_script.starts == 2 && m_script.values == values);
        command(ReloadCommand{});
        QVERIFY(m_script.starts == 3 && m_script.values == values);
        m_script.breaks = true;
        QVERIFY(m_runner->tick().ok());
        QVERIFY(m_script.starts == 4 && m_script.values == values);
        command(SwapCommand{"robot0", "brain", controller("brain"), "live.so"}); // has the values of its own block
        QVERIFY(m_script.starts == 5 && !m_script.values.contains("Gain"));
        command(RestartCommand{"robot0", "brain"});
        QVERIFY(m_script.starts == 6 && !m_script.values.contains("Gain"));
        QCOMPARE(refusals(), std::size_t(0));
    }

    /// Also without a fault of its own. A file belongs to one controller, which opens it once in each start.
    void aControllerThatIsStartedAgainContinuesItsLog() {
        m_script.opens = {"own.csv"};
        command(RestartCommand{"robot0", "brain"});
        m_script.breaks = true;
        QVERIFY(m_runner->tick().ok());
        QCOMPARE(
            std::ranges::count_if(m_console, [](const std::string& text) { return text.find("own.csv") != std::string::npos; }),
            0);
        m_script.opens = {"./own.csv", "own.csv"};
        command(ReloadCommand{});
        const std::string refused = "own.csv is already written by the controller brain of robot0";
        QCOMPARE(std::ranges::count(m_console, refused), 1);
        command(SwapCommand{"robot1", "", controller("brain"), "live.so"});
        QCOMPARE(std::ranges::count(m_console, refused), 3);
        QVERIFY(m_runner->finish().ok());
        QFile log(m_folder.filePath("logs/own.csv"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        QCOMPARE(log.readAll(), QByteArray("start 2\nstart 3\nstart 4\n"));
    }

    void aShortTimeIsShownWithItsDigits() {
        ControllerSpec slow = controller("brain");
        slow.values["Budget"] = numberValue(1e-6);
        m_script.updateS = 2.345e-6;
        command(SwapCommand{"robot0", "brain", slow, "live.so"});
        QCOMPARE(m_console.back(), std::string("an update of the controller brain took 0.0023 ms; its Budget is 0.001 ms"));
    }

    /// The message says whose the file is.
    void aLogOfTheExperimentMayNotBeOneOfAController() {
        m_script.opens = {"path.csv"};
        command(RestartCommand{"robot0", "brain"});
        Diagnostics diagnostics;
        auto& spec = const_cast<ExperimentSpec&>(m_runner->world().experiment());
        spec.logs = {{"PoseLog", "path", {{"Interval", numberValue(0)}}, {}, {}}};
        m_runner->openLogs(diagnostics);
        QCOMPARE(diagnostics.errorCount(), std::size_t(1));
        QCOMPARE(diagnostics.all().front().message, std::string("path.csv is already written by the controller brain of robot0"));
    }

    void aValueThatStoppedAControllerCanBeCorrected() {
        set("Speed", -1);
        QCOMPARE(m_runner->stoppedControllers().size(), std::size_t(1));
        set("Speed", 0.5);
        QVERIFY(m_script.starts == 1 && refusals() == 0);
        command(RestartCommand{"robot0", "brain"});
        QVERIFY(m_runner->stoppedControllers().empty());
        QCOMPARE(m_script.values["Speed"], 0.5);
        command(StopCommand{"robot0", "brain"});
        set("Speed", 0.7);
        command(RestartCommand{"robot0", "brain"});
        QCOMPARE(m_script.values["Speed"], 0.7);
    }

    /// Others of its robot, and those of the same name on other robots, stay stopped.
    void oneControllerIsStartedAgain() {
        command(SwapCommand{"robot0", "", controller("second"), "live.so"});
        command(SwapCommand{"robot1", "", controller("brain"), "live.so"});
        command(StopCommand{"robot0", "brain"});
        command(StopCommand{"robot0", "second"});
        command(StopCommand{"robot1", "brain"});
        const auto stopped = [this] {
            std::string all;
            for (const StoppedController& each : m_runner->stoppedControllers())
                all += std::to_string(each.robot) + " " + each.controller + ", ";
            return all;
        };
        const auto called = [this] {
            const int before = m_script.updates;
            return m_runner->tick().ok() ? m_script.updates - before : -1;
        };
        QCOMPARE(stopped(), std::string("0 brain, 0 second, 1 brain, "));
        QCOMPARE(called(), 0);
        command(RestartCommand{"robot0", "second"});
        QCOMPARE(stopped(), std::string("0 brain, 1 brain, "));
        QCOMPARE(called(), 1);
        command(RestartCommand{"robot1", "brain"});
        QCOMPARE(stopped(), std::string("0 brain, "));
        QCOMPARE(called(), 2);
        command(RestartCommand{"robot0", "brain"});
        QCOMPARE(stopped(), std::string());
        QCOMPARE(called(), 3);
    }

    /// Those of a Grid have one block, and so one place.
    void aFaultBelongsToOneOfTheRobotsOfABlock() {
        command(SwapCommand{"robot1", "", controller("brain"), "live.so"});
        set("Speed", -1); // of both
        const std::vector<Diagnostic>& warnings = m_runner->warnings();
        QCOMPARE(warnings.size(), std::size_t(2));
        QVERIFY(warnings[0].range == warnings[1].range);
        for (const std::size_t robot : {std::size_t(0), std::size_t(1)}) {
            const StoppedController* stopped = stoppedBy(warnings[robot], m_runner->stoppedControllers());
            QVERIFY(stopped && stopped->robot == robot && stopped->controller == "brain");
        }
        auto& world = static_cast<FakeWorld&>(m_runner->world());
        world.faults.ends = {{1, {"robot1/chassis", 0, "too fast", {}}}, {0, {"robot0/chassis", 0, "too fast", {}}}};
        QVERIFY(m_runner->tick().ok());
        QCOMPARE(warnings.size(), std::size_t(4));
        QVERIFY(warnings[2].robot == 1u && warnings[3].robot == 0u);
        QVERIFY(!stoppedBy(warnings[2], m_runner->stoppedControllers()));
    }

    /// Nothing has stopped it.
    void aControllerThatIsStartedAgainHasNoFault() {
        m_script.breaks = true;
        QVERIFY(m_runner->tick().ok());
        QCOMPARE(m_runner->warnings().size(), std::size_t(1));
        QVERIFY(m_runner->warnings()[0].robot == 0u);
        set("Speed", -1);
        QVERIFY(!stoppedBy(m_runner->warnings()[0], m_runner->stoppedControllers()));
        QVERIFY(stoppedBy(m_runner->warnings()[1], m_runner->stoppedControllers()));
    }

    void aValueThatTheNewCodeRefusesIsReported() {
        set("Speed", 0.5);
        set("Gain", 2);
        m_script.refused = {"Gain"};
        command(ReloadCommand{});
        QVERIFY(std::ranges::find(m_console, "command refused: Gain is out of range") != m_console.end());
        QVERIFY(m_script.values["Speed"] == 0.5 && !m_script.values.contains("Gain"));
        command(ReloadCommand{});
        QCOMPARE(refusals(), std::size_t(1));
        set("Gain", 3); // refused at once, so not tried again
        command(RestartCommand{"robot0", "brain"});
        QCOMPARE(refusals(), std::size_t(2));
    }

    void aRobotIsFreeWhenTheLastHolderReleasesIt() {
        QVERIFY(!isCalledAfter(true, Holder::Guest));
        QVERIFY(!isCalledAfter(true, Holder::Window));
        QVERIFY(!isCalledAfter(false, Holder::Window));
        QVERIFY(!isCalledAfter(false, Holder::Window)); // that of the other stays
        command(SwapCommand{"robot0", "brain", controller("brain"), "live.so"});
        QVERIFY(!isCalledAfter(true, Holder::Guest));
        QVERIFY(isCalledAfter(false, Holder::Guest)); // however often it asked
        QVERIFY(!isCalledAfter(true, Holder::Window));
        QVERIFY(isCalledAfter(false, Holder::Window));
    }

    void controllersThatARobotHasNow() {
        QCOMPARE(namesOf("robot0"), std::string("brain "));
        QVERIFY(namesOf("robot1").empty() && namesOf("robot2").empty());
        command(SwapCommand{"robot1", "", controller("mind"), "live.so"});
        command(SwapCommand{"robot0", "", controller("second"), "live.so"});
        QCOMPARE(namesOf("robot0"), std::string("brain second "));
        QCOMPARE(namesOf("robot1"), std::string("mind "));
        command(SwapCommand{"robot0", "brain", controller("first"), "live.so"});
        QCOMPARE(namesOf("robot0"), std::string("first second "));
        command(SwapCommand{"robot0", "first", {}, {}});
        QCOMPARE(namesOf("robot0"), std::string("second "));
    }
};

QTEST_GUILESS_MAIN(ControllerSetTest)
#include "controller_set_test.moc"
