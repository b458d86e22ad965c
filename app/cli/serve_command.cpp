#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fcntl.h>
#include <unistd.h>

#include "app/render_library.h"
#include "base/clean_text.h"
#include "check/model_check.h"
#include "cli/console.h"
#include "cli/messages.h"
#include "cli/open_arguments.h"
#include "cli/run_guard.h"
#include "cli/run_report.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"
#include "lang/diagnostic_text.h"
#include "project/loading/modules.h"
#include "remote/server.h"

namespace trundle {
namespace {

constexpr std::chrono::milliseconds kLongestWait(100); ///< until a request to end the program is seen
constexpr std::size_t kShortestToken = 8;
constexpr const char* kTokenVariable = "TRUNDLE_TOKEN";

struct ServeArguments {
    OpenOptions open;
    std::string file, logDir, host = "127.0.0.1", token, tokenFile;
    std::uint16_t port = 0;
    bool freeRun = false;
    double speed = 1; ///< 0: as fast as possible
    int descriptor = -1;
};

/// A file that only its owner can read. Fails if it exists.
Status writeSecretFile(const std::string& path, const std::string& text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (file < 0) return Error{Code::FileUnwritable, "cannot create " + path + ": " + std::strerror(errno)};
    const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    return ::close(file) == 0 && written ? Status() : Error{Code::FileUnwritable, "cannot write " + path};
}

class ServeCommand {
public:
    explicit ServeCommand(ServeArguments arguments)
        : m_application(makeApplication(findLocations(), Isolation::Module)), m_arguments(std::move(arguments)) {}
    ~ServeCommand();
    ExitCode go();

private:
    ServedExperiment build(std::optional<std::uint64_t> seed);
    bool load(const OpenOptions& options, ServedExperiment& built);
    RunOptions runOptions();
    bool openSockets();
    bool announce();
    void reportFailedStart();
    void printLine(double time, const std::string& who, int severity, const std::string& text);
    void printWarnings();

    std::unique_ptr<Application> m_application;
    ServeArguments m_arguments;
    std::shared_ptr<CallMonitor> m_calls = std::make_shared<CallMonitor>();
    std::optional<RunGuard> m_guard; // declared before the run, whose destructor runs module code
    std::shared_ptr<const LoadedProject> m_loaded;
    std::optional<std::uint64_t> m_seed;
    std::optional<RemoteServer> m_server; // before the run, which prints to its clients until the end
    ServedRun m_run{[this](std::optional<std::uint64_t> seed) { return build(seed); }};
    bool m_wroteToken = false;
    std::size_t m_warned = 0;
};

ServeCommand::~ServeCommand() {
    if (m_wroteToken) ::unlink(m_arguments.tokenFile.c_str());
}

bool ServeCommand::load(const OpenOptions& options, ServedExperiment& built) {
    Result<std::shared_ptr<const LoadedProject>> opened = m_application->open(m_arguments.file, options);
    if (!opened) {
        built.problems.push_back({Severity::Error, opened.error().code, opened.error().message, {}, {}, {}, {}});
        return false;
    }
    const auto loaded = std::move(opened).value();
    built.sources = loaded->sources;
    built.problems = loaded->diagnostics.all();
    for (Diagnostic& diagnostic : built.problems) // a warning to other commands
        if (isUnavailableModule(diagnostic.code)) diagnostic.severity = Severity::Error;
    if (std::ranges::count(built.problems, Severity::Error, &Diagnostic::severity) > 0) return false;
    Diagnostics found;
    checkModel(*loaded, found);
    found.summarize();
    built.problems.insert(built.problems.end(), found.all().begin(), found.all().end());
    if (found.hasErrors()) return false;
    m_loaded = loaded;
    return true;
}

/// Reads the files only for the first time and for another seed: a Scatter depends on it.
ServedExperiment ServeCommand::build(std::optional<std::uint64_t> seed) {
    ServedExperiment built;
    if (!m_loaded || (seed && seed != m_seed)) {
        OpenOptions options = m_arguments.open;
        if (seed) options.sets.push_back("Seed=" + std::to_string(*seed));
        if (m_loaded)
            for (std::size_t i = 0; i < m_loaded->paths.size(); ++i) // as they were, even if they have changed since
                if (!m_loaded->paths[i].empty()) options.texts[m_loaded->paths[i]] = m_loaded->sources[static_cast<FileId>(i)].text->sharedBytes();
        if (!load(options, built)) return built;
        m_seed = seed;
    }
    built.sources = m_loaded->sources;
    Diagnostics problems;
    m_warned = 0;
    built.runner = m_application->makeRunner(*m_loaded, runOptions(), problems);
    m_guard->restoreProcess();
    built.problems.insert(built.problems.end(), problems.all().begin(), problems.all().end());
    return built;
}

RunOptions ServeCommand::runOptions() {
    RunOptions options;
    if (!m_arguments.logDir.empty()) options.logFolder = LogLocation(std::filesystem::absolute(m_arguments.logDir).string());
    options.calls = m_calls;
    options.keepsCommands = false; // nothing asks for them, and a run may last for days
    options.console = [this](double time, const std::string& who, int severity, const std::string& text) {
        printLine(time, who, severity, text);
    };
    options.pictures = [this](const ExperimentSpec& experiment, const SignalLayout& layout) {
        return openImageSource(m_application->locations().modules, experiment, layout, {LookChoice::Automatic, printProblem});
    };
    return options;
}

void ServeCommand::printLine(double time, const std::string& who, int severity, const std::string& text) {
    if (m_arguments.descriptor < 0) writeMessage(consoleLines(time, who, severity, text)); // else the client prints it
    if (m_server) m_server->addLine(time, who, severity, cleanText(text));
}

void ServeCommand::printWarnings() {
    if (!m_run.exists()) return;
    const std::vector<Diagnostic>& warnings = m_run.runner().warnings();
    for (; m_warned < warnings.size(); ++m_warned) {
        if (m_arguments.descriptor < 0) printDiagnostics({warnings[m_warned]}, m_run.built().sources);
        m_server->addLine(m_run.world().time(), {}, 2, warnings[m_warned].message);
    }
}

bool ServeCommand::openSockets() {
    ServerOptions options;
    options.experiment = experimentName(m_arguments.file);
    options.token = m_arguments.token.empty() ? randomToken() : m_arguments.token;
    m_arguments.token = options.token;
    m_server.emplace(m_run, std::move(options));
    if (m_arguments.descriptor >= 0) {
        Result<Socket> socket = Socket::adopt(m_arguments.descriptor);
        if (socket) m_server->adopt(std::move(socket).value());
        else printProblem(socket.error().message);
        return socket.ok();
    }
    Result<Socket> socket = Socket::listen(m_arguments.host, m_arguments.port);
    if (!socket) {
        printProblem(socket.error().message);
        return false;
    }
    m_arguments.port = socket.value().port();
    m_server->listen(std::move(socket).value());
    return true;
}

bool ServeCommand::announce() {
    if (m_arguments.descriptor >= 0) return true;
    const std::string port = std::to_string(m_arguments.port);
    if (!isLoopback(m_arguments.host))
        writeMessage("trundle-cli: warning: other machines can reach " + m_arguments.host + ":" + port +
                     "; what is sent there is not encrypted, the token neither\n");
    std::string text = "serving " + cleanLine(m_arguments.file) + " at " + m_arguments.host + ":" + port + "\n";
    if (m_arguments.tokenFile.empty()) text += "token " + m_arguments.token + "\n";
    else if (const Status written = writeSecretFile(m_arguments.tokenFile, m_arguments.token + "\n"); written) m_wroteToken = true;
    else {
        printProblem(written.error().message);
        return false;
    }
    return writeOut(text);
}

/// Why there is nothing to serve, in text or, for a client that is connected already, as an event.
void ServeCommand::reportFailedStart() {
    if (m_arguments.descriptor < 0) {
        printDiagnostics(m_run.built().problems, m_run.built().sources);
        writeMessage(cleanLine(m_arguments.file) + ": not served\n");
        return;
    }
    m_server->fail();
}

ExitCode ServeCommand::go() {
    ::unsetenv(kTokenVariable); // host processes need not have it
    if (!openSockets()) return kExitUsage;
    m_guard.emplace(GuardOptions{m_calls, "run", true, false}); // module code runs from here on
    if (!m_run.reset()) {
        reportFailedStart();
        for (const Diagnostic& problem : m_run.built().problems)
            if (problem.severity == Severity::Error) return m_loaded || problem.range.known() ? exitCodeFor(problem.code) : kExitUsage;
        return kExitText;
    }
    if (m_arguments.descriptor < 0) printDiagnostics(m_run.built().problems, m_run.built().sources);
    if (!announce()) return kExitUsage;
    if (m_arguments.freeRun) m_run.run(m_arguments.speed);
    auto maintained = std::chrono::steady_clock::now();
    while (!interrupted() && !m_server->isOver()) {
        if (isForkedCopy()) endForkedCopy();
        m_server->serve(kLongestWait);
        printWarnings();
        if (const auto now = std::chrono::steady_clock::now(); now - maintained > std::chrono::seconds(1)) {
            if (m_run.exists()) m_run.runner().flushLogs();
            m_guard->restoreProcess();
            maintained = now;
        }
    }
    if (m_run.exists()) (void)m_run.runner().finish();
    return kExitDone; // it is ended by a signal, or by the client that started it
}

std::string tokenProblem(const std::string& token) {
    return token.size() >= kShortestToken ? std::string() : "a token has at least " + std::to_string(kShortestToken) + " characters";
}

constexpr const char* kServeExamples = R"(Examples:
  trundle-cli serve configs/experiments/linear_motion.sim
  trundle-cli serve my.sim --port 5555 --token-file my.token
  trundle-cli serve my.sim --free-run --log-dir results

It prints where it listens and a random token, which a client must give: in Python, trundle.connect(port, token). The token can be
given in the variable TRUNDLE_TOKEN too; in --token it can be seen in the list of processes. Without --free-run the run is paused until
a client steps or runs it. Ctrl+C ends it. The guide's page remote.md describes client and protocol.)";

} // namespace

void addServe(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("serve", "Serve an experiment to other programs over TCP");
    auto arguments = std::make_shared<ServeArguments>();
    ServeArguments& a = *arguments;
    command->add_option("FILE", a.file, "The experiment")->required()->type_name("");
    CLI::Option* port = command->add_option("--port", a.port, "Port; by default a free one, which is printed")->type_name("N");
    CLI::Option* host = command->add_option("--host", a.host, "Numeric address to listen at; others than loopback reach the network")
                            ->type_name("ADDRESS")
                            ->check(&emptyProblem)
                            ->capture_default_str();
    command->add_option("--token", a.token, "What clients must give; by default a random one, which is printed")
        ->type_name("TOKEN")
        ->envname(kTokenVariable)
        ->check(&tokenProblem);
    command->add_option("--token-file", a.tokenFile, "Write the token into this new file, which only you can read, and do not print it")
        ->type_name("FILE")
        ->check(&emptyProblem);
    CLI::Option* freeRun = command->add_flag("--free-run", a.freeRun, "Run at once, in real time; else it is paused");
    command->add_option("--speed", a.speed, "Simulated seconds per second of a free run, up to 1000; 0 is as fast as possible")
        ->type_name("N")
        ->check(&finiteProblem)
        ->check(CLI::Range(0.0, 1000.0).description(""))
        ->needs(freeRun)
        ->capture_default_str();
    command->add_option("--log-dir", a.logDir, "Folder for the logs; by default there are none")->type_name("DIR")->check(&emptyProblem);
    command->add_option("--socket", a.descriptor, "Serve only this inherited, connected socket, without a token, and end with it")
        ->type_name("DESCRIPTOR")
        ->check(CLI::Range(3, 1 << 20).description(""))
        ->excludes(port)
        ->excludes(host);
    addSetOption(*command, a.open);
    addOpenOptions(*command, a.open);
    command->footer(kServeExamples);
    command->callback([arguments, &chosen] { chosen = [arguments] { return ServeCommand(*arguments).go(); }; });
}

} // namespace trundle
