#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/render_library.h"
#include "base/clean_text.h"
#include "base/platform/read_file.h"
#include "cli/console.h"
#include "cli/messages.h"
#include "cli/numbers.h"
#include "cli/open_arguments.h"
#include "cli/progress.h"
#include "cli/run_guard.h"
#include "cli/run_loop.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"
#include "lang/diagnostic_text.h"
#include "project/loading/modules.h"
#include "remote/remote_devices.h"
#include "remote/remote_world.h"
#include "run/logs/log_kinds.h"

namespace trundle {
namespace {

constexpr const char* kTokenName = "TRUNDLE_TOKEN";
constexpr double kTickTolerance = 1e-9; // s

struct DriveArguments {
    OpenOptions open;
    std::string file, robot, at, token, tokenFile, logDir;
    std::optional<double> duration;
    double timeout = 10;
    bool quiet = false;
};

struct RobotAddress {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;
};

/// "4021", "10.0.0.7:4021" or "[::1]:4021".
std::optional<RobotAddress> addressFrom(const std::string& text) {
    RobotAddress address;
    const std::size_t colon = text.rfind(':');
    const std::string port = colon == std::string::npos ? text : text.substr(colon + 1);
    if (colon != std::string::npos) address.host = text.substr(0, colon);
    if (address.host.starts_with('[') && address.host.ends_with(']'))
        address.host = address.host.substr(1, address.host.size() - 2);
    const auto [end, fault] = std::from_chars(port.data(), port.data() + port.size(), address.port);
    if (fault != std::errc() || end != port.data() + port.size() || address.port == 0 || address.host.empty())
        return std::nullopt;
    return address;
}

/// The experiment with that robot alone, and with the logs that need nothing else; `left` has the names of the others.
std::shared_ptr<const ExperimentSpec> experimentOf(const LoadedProject& loaded, const RobotSpec& robot, std::string& left) {
    auto alone = std::make_shared<ExperimentSpec>(*loaded.experiment);
    alone->robots = {robot};
    alone->statics.clear();
    alone->joints.clear(); // these name robots by number
    alone->springs.clear();
    alone->regions.clear();
    alone->noContact.clear();
    alone->settings.engine = EngineChoice::General;
    alone->logs.clear();
    for (const ComponentSpec& log : loaded.experiment->logs) {
        ExperimentSpec one = *alone;
        one.logs = {log};
        Diagnostics problems;
        checkLogs(one, *loaded.registry, true, problems);
        if (problems.hasErrors() || needsSimulation(log)) left += (left.empty() ? "" : ", ") + log.name;
        else alone->logs.push_back(log);
    }
    return alone;
}

class DriveCommand {
public:
    explicit DriveCommand(DriveArguments arguments)
        : m_application(makeApplication(findLocations(), Isolation::Module)), m_arguments(std::move(arguments)) {}
    ExitCode go();

private:
    ExitCode problem(const std::string& text, ExitCode code = kExitUsage) const;
    bool load();
    const RobotSpec* chooseRobot();
    bool readToken();
    RunOptions runOptions();
    std::unique_ptr<World> connect(std::unique_ptr<World> described, Diagnostics& diagnostics);
    void warnOfMissing(const std::vector<std::string>& missing, double time);
    ExitCode drive();
    ExitCode report(const LoopOutcome& outcome);

    std::unique_ptr<Application> m_application;
    DriveArguments m_arguments;
    std::shared_ptr<CallMonitor> m_calls = std::make_shared<CallMonitor>();
    RemoteWorld* m_world = nullptr; ///< of the runner
    std::shared_ptr<RemoteRadios> m_radios;
    std::optional<RunGuard> m_guard; // declared before the runner, whose destructor runs module code
    LoadedProject m_loaded;
    std::unique_ptr<Progress> m_progress;
    std::unique_ptr<Runner> m_runner;
};

ExitCode DriveCommand::problem(const std::string& text, ExitCode code) const {
    printProblem(text);
    return code;
}

bool DriveCommand::load() {
    Result<std::shared_ptr<const LoadedProject>> opened = m_application->open(m_arguments.file, m_arguments.open);
    if (!opened) {
        printProblem(opened.error().message);
        return false;
    }
    m_loaded = *opened.value();
    std::vector<Diagnostic> all = m_loaded.diagnostics.all();
    bool good = true;
    for (Diagnostic& diagnostic : all) {
        if (isUnavailableModule(diagnostic.code)) diagnostic.severity = Severity::Error;
        good = good && diagnostic.severity != Severity::Error;
    }
    printDiagnostics(all, m_loaded.sources);
    return good;
}

/// The one that is asked for, or the only one with a controller.
const RobotSpec* DriveCommand::chooseRobot() {
    std::string names;
    const RobotSpec* found = nullptr;
    std::size_t count = 0;
    for (const RobotSpec& robot : m_loaded.experiment->robots) {
        if (robot.controllers.empty() || (!m_arguments.robot.empty() && robot.name != m_arguments.robot)) continue;
        found = &robot;
        if (++count <= 10) names += (names.empty() ? "" : ", ") + robot.name;
    }
    if (count == 1) return found;
    if (count > 1)
        printProblem("several robots have a controller: " + names + (count > 10 ? " ..." : "") + "; choose one with --robot");
    else if (m_arguments.robot.empty()) printProblem("no robot in " + cleanLine(m_arguments.file) + " has a controller");
    else
        printProblem("there is no robot " + cleanLine(m_arguments.robot) + " with a controller in " +
                     cleanLine(m_arguments.file));
    return nullptr;
}

bool DriveCommand::readToken() {
    ::unsetenv(kTokenName); // host processes need not have it
    if (m_arguments.tokenFile.empty()) return true;
    const Result<std::string> text = readRegularFile(m_arguments.tokenFile, 4096);
    if (!text) return printProblem(text.error().message), false;
    m_arguments.token = text.value().substr(0, text.value().find_first_of("\r\n"));
    return true;
}

RunOptions DriveCommand::runOptions() {
    RunOptions options;
    options.logFolder = logsOf(m_loaded.projectFolder, m_arguments.file, m_arguments.logDir);
    options.calls = m_calls;
    options.console = [this](double time, const std::string& who, int severity, const std::string& text) {
        const std::string lines = consoleLines(time, who, severity, text);
        if (m_progress) m_progress->line(lines);
        else writeMessage(lines);
    };
    options.pictures = [this](const ExperimentSpec& experiment,
                              const SignalLayout& layout) -> Result<std::unique_ptr<ImageSource>> {
        const std::string& folder = m_application->locations().modules;
        return std::unique_ptr<ImageSource>(std::make_unique<RemoteImages>(
            m_world->link(), [&experiment, &layout, folder] { return openImageSource(folder, experiment, layout); }));
    };
    options.replaceOutputs = [this](ControllerOutputs& outputs) {
        outputs.radios = m_radios;
        outputs.objectName = [this](std::uint32_t number) { return m_world->link().objectName(number); };
    };
    options.replaceWorld = [this](std::unique_ptr<World> world, Diagnostics& diagnostics) {
        return connect(std::move(world), diagnostics);
    };
    return options;
}

std::unique_ptr<World> DriveCommand::connect(std::unique_ptr<World> described, Diagnostics& diagnostics) {
    const RobotSpec& robot = described->experiment().robots[0];
    const double tick = described->experiment().settings.tick;
    const RobotAddress at = *addressFrom(m_arguments.at);
    Result<Socket> socket = Socket::connect(at.host, at.port);
    if (!socket) return diagnostics.error(socket.error().code, robot.nameRange, socket.error().message), nullptr;
    Result<std::unique_ptr<RobotLink>> link = RobotLink::open(
        std::move(socket).value(), {m_arguments.token, robot.name, m_arguments.timeout, [] { return interrupted(); }});
    if (!link) return diagnostics.error(link.error().code, robot.nameRange, link.error().message), nullptr;
    if (std::abs(link.value()->tick() - tick) > kTickTolerance) {
        diagnostics.error(Code::SystemRefused, robot.nameRange,
                          robot.name + " at the other end has a tick of " + exactText(link.value()->tick()) +
                              " s, the text one of " + exactText(tick) + " s; try --set Tick=" + exactText(link.value()->tick()));
        return nullptr;
    }
    auto world = std::make_unique<RemoteWorld>(std::move(described), std::move(link).value());
    warnOfMissing(world->missing(), world->time());
    m_world = world.get();
    m_radios = std::make_shared<RemoteRadios>(*world);
    return world;
}

void DriveCommand::warnOfMissing(const std::vector<std::string>& missing, double time) {
    constexpr std::size_t kShown = 8;
    std::string names;
    for (std::size_t i = 0; i < std::min(missing.size(), kShown); ++i) names += (i > 0 ? ", " : "") + missing[i];
    if (missing.size() > kShown) names += " and " + std::to_string(missing.size() - kShown) + " more";
    if (!missing.empty())
        writeMessage(consoleLines(time, {}, TRUNDLE_WARNING, "the robot at the other end does not have " + names));
}

ExitCode DriveCommand::report(const LoopOutcome& outcome) {
    const RunFinish* finish = m_runner->finished();
    if (!m_arguments.quiet) {
        std::string text = "drove " + m_runner->world().experiment().robots[0].name + " for " +
                           exactText(m_runner->world().time()) + " s, " + std::to_string(m_runner->world().ticks()) + " ticks\n";
        if (finish) text += "the controller " + finish->controller + " finished: " + cleanLine(finish->reason) + "\n";
        for (const std::string& file : m_runner->logFiles()) text += "log " + file + "\n";
        if (!writeOut(cleanText(text))) return kExitText;
    }
    if (const Diagnostic* failure = m_runner->failure()) {
        printDiagnostics({*failure}, m_loaded.sources);
        return exitCodeFor(failure->code);
    }
    return outcome.interrupted ? kExitInterrupted : m_runner->stoppedControllers().empty() ? kExitDone : kExitController;
}

ExitCode DriveCommand::drive() {
    const SettingsSpec& settings = m_loaded.experiment->settings;
    const double duration = m_arguments.duration.value_or(settings.duration);
    const std::uint64_t ticks = duration > 0 ? ticksFor(duration, settings.tick) : 0;
    m_guard.emplace(GuardOptions{m_calls, "run", true, false}); // module code runs from here on
    Diagnostics problems;
    m_runner = m_application->makeRunner(m_loaded, runOptions(), problems);
    m_guard->restoreProcess();
    printDiagnostics(problems.all(), m_loaded.sources);
    if (!m_runner) {
        for (const Diagnostic& found : problems.all())
            if (found.severity == Severity::Error) return exitCodeFor(found.code);
        return kExitText;
    }
    m_progress = std::make_unique<Progress>(ticks, settings.tick, m_arguments.quiet);
    LoopPlan plan{ticks, ticks == 0, false};
    plan.everySecond = [this] {
        m_runner->flushLogs();
        m_guard->restoreProcess();
    };
    plan.warn = [this](const Diagnostic& warning) { m_progress->line(render(warning, m_loaded.sources)); };
    const LoopOutcome outcome = runTicks(*m_runner, plan, *m_progress, nullptr);
    (void)m_runner->finish(); // a failure is stored in failure()
    m_progress->finish(m_runner->world().ticks());
    return report(outcome);
}

ExitCode DriveCommand::go() {
    if (!readToken()) return kExitUsage;
    if (!load()) return m_loaded.experiment ? kExitText : kExitUsage;
    const RobotSpec* robot = chooseRobot();
    if (!robot) return kExitUsage;
    std::string left;
    m_loaded.experiment = experimentOf(m_loaded, RobotSpec(*robot), left);
    if (!left.empty() && !m_arguments.quiet)
        writeMessage("trundle-cli: note: logs of other things, or of what only a simulation has, are not written: " +
                     cleanLine(left) + "\n");
    return drive();
}

std::string addressProblem(const std::string& text) {
    return addressFrom(text) ? std::string() : "give a port, or a numeric address and a port: 4021, 10.0.0.7:4021";
}

constexpr const char* kDriveExamples = R"(Examples:
  trundle-cli serve my.sim --port 4021 --token-file robot.token      (in another terminal)
  trundle-cli drive my.sim --at 4021 --token-file robot.token
  trundle-cli drive my.sim --at 4021 --robot rover --duration 20

The robot's controller in FILE, the same library or Python file as in simulation, drives a robot at the other end of a connection: that of
`trundle-cli serve`, or a driver of a real robot. FILE says which devices it has. Everything else in FILE is left out.
The token can be given in the variable TRUNDLE_TOKEN too. The guide's page remote.md describes drivers and the protocol.)";

} // namespace

void addDrive(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("drive", "Let a controller drive a robot that is elsewhere");
    auto arguments = std::make_shared<DriveArguments>();
    DriveArguments& a = *arguments;
    command->add_option("FILE", a.file, "The experiment")->required()->type_name("");
    command->add_option("--at", a.at, "Where the robot is served: a port of this machine, or a numeric address and a port")
        ->required()
        ->type_name("[ADDRESS:]PORT")
        ->check(&addressProblem);
    command
        ->add_option("--robot", a.robot,
                     "Its name, the same in FILE and at the other end; by default the only one with a controller")
        ->type_name("NAME")
        ->check(&emptyProblem);
    CLI::Option* token =
        command->add_option("--token", a.token, "The token of the other end")->type_name("TOKEN")->envname(kTokenName);
    command->add_option("--token-file", a.tokenFile, "A file with the token")
        ->type_name("FILE")
        ->check(&emptyProblem)
        ->excludes(token);
    command->add_option("--duration", a.duration, "Seconds to drive, instead of the text's Duration")
        ->type_name("S")
        ->check(&finiteProblem)
        ->check(CLI::Range(0.0, 1e9).description(""));
    command->add_option("--timeout", a.timeout, "Seconds without an answer after which the connection has failed")
        ->type_name("S")
        ->check(&finiteProblem)
        ->check(CLI::Range(0.1, 3600.0).description(""))
        ->capture_default_str();
    command->add_option("--log-dir", a.logDir, "Folder for the logs; by default logs/<experiment> in the project folder")
        ->type_name("DIR")
        ->check(&emptyProblem);
    command->add_flag("--quiet", a.quiet, "No progress and no summary");
    addSetOption(*command, a.open);
    addOpenOptions(*command, a.open);
    command->footer(kDriveExamples);
    command->callback([arguments, &chosen] { chosen = [arguments] { return DriveCommand(*arguments).go(); }; });
}

} // namespace trundle
