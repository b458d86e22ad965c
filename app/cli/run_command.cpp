#include <algorithm>
#include <cctype>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <optional>

#include <unistd.h>

#include "app/render_library.h"
#include "base/clean_text.h"
#include "base/platform/memory.h"
#include "check/model_check.h"
#include "cli/console.h"
#include "cli/diagnostic_json.h"
#include "cli/messages.h"
#include "cli/movie.h"
#include "cli/open_arguments.h"
#include "cli/progress.h"
#include "cli/run_guard.h"
#include "cli/run_loop.h"
#include "cli/run_report.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"
#include "lang/diagnostic_text.h"
#include "project/loading/modules.h"
#include "project/objects/unplaced_configs.h"

namespace trundle {
namespace {

constexpr std::size_t kBytesPerRobot = 40'000; // of memory, about
constexpr double kLongestDurationS = 1e9;
constexpr std::uint64_t kLargestSeed = 1ull << 53; // largest seed that a number in the text represents exactly

struct RunArguments {
    OpenOptions open;
    std::string file, logDir, movieSize = "1280x720";
    MovieOptions movie;
    LookChoice look = LookChoice::Automatic;
    std::optional<double> duration;
    std::optional<std::uint64_t> seed;
    bool realtime = false, hash = false, json = false, quiet = false;
};

class RunCommand {
public:
    RunCommand(Application& application, RunArguments arguments)
        : m_application(application), m_arguments(std::move(arguments)) {}
    ExitCode go();

private:
    bool load();
    bool planTicks();
    bool openMovie();
    bool film();
    bool endMovie();
    bool movieProblem(const Status& status);
    ExitCode runLoaded();
    LoopOutcome runTicksOfPlan();
    void report(const Diagnostic& diagnostic);
    void keepResults();
    void maintain();
    void keepPoses();
    ExitCode printResults(ExitCode code);
    RunOptions runOptions();
    void warn(const Diagnostic& warning);
    void showBacktrace(const StoppedController& stopped);
    void reportNothingPlaced() const;
    bool checkStart();

    Application& m_application;
    RunArguments m_arguments;
    std::shared_ptr<CallMonitor> m_calls = std::make_shared<CallMonitor>();
    std::optional<RunGuard> m_guard; // declared before the runner, whose destructor runs module code
    std::shared_ptr<const LoadedProject> m_loaded;
    std::unique_ptr<Progress> m_progress;
    std::unique_ptr<Movie> m_movie;
    std::unique_ptr<Runner> m_runner;
    RunReport m_report;
    std::uint64_t m_ticks = 0;
    bool m_endless = false;
};

ExitCode RunCommand::go() {
    std::signal(SIGPIPE, [](int) {}); // whoever reads the messages may end: the run does not
    m_report.name = experimentName(m_arguments.file);
    // A seed is an ordinary setting; it must be set before a Scatter places its objects.
    if (m_arguments.seed) m_arguments.open.sets.push_back("Seed=" + std::to_string(*m_arguments.seed));
    if (!load()) return printResults(kExitUsage);
    printDiagnostics(m_report.diagnostics, m_report.sources);
    if (std::ranges::count(m_report.diagnostics, Severity::Error, &Diagnostic::severity) > 0) {
        const std::string counts = countText(m_report.diagnostics);
        writeMessage(cleanLine(m_arguments.file) + ": not run, the text has " + counts + "\n");
        return printResults(kExitText);
    }
    if (!m_arguments.quiet) reportNothingPlaced();
    if (!planTicks()) return printResults(kExitUsage);
    if (!openMovie()) {
        const bool hasFfmpeg = m_report.diagnostics.back().code != Code::SystemRefused;
        return printResults(hasFfmpeg ? kExitText : kExitUsage);
    }
    if (!checkStart()) return printResults(exitCodeFor(m_report.diagnostics.back().code));
    return runLoaded();
}

/// A file that only defines a robot runs as an empty world.
void RunCommand::reportNothingPlaced() const {
    std::string names;
    for (const Part* config : configsWithoutInstances(*m_loaded)) names += (names.empty() ? "" : ", ") + config->name;
    if (names.empty()) return;
    const std::string file = cleanLine(m_arguments.file);
    writeMessage(
        file + ": note: this file describes " + cleanLine(names) +
        " and places nothing, so the world that runs is empty; import it in an experiment and add a Robot or Static with "
        "that Config\n");
}

bool RunCommand::load() {
    Result<std::shared_ptr<const LoadedProject>> opened = m_application.open(m_arguments.file, m_arguments.open);
    if (!opened) {
        printProblem(opened.error().message);
        m_report.diagnostics.push_back({Severity::Error, opened.error().code, opened.error().message, {}, {}, {}, {}});
        m_report.unreadable = m_arguments.file;
        return false;
    }
    m_loaded = std::move(opened).value();
    if (m_loaded->experiment) useLargePages(m_loaded->experiment->robots.size() * kBytesPerRobot);
    m_report.sources = m_loaded->sources;
    m_report.diagnostics = m_loaded->diagnostics.all();
    for (Diagnostic& diagnostic : m_report.diagnostics) // a warning to other commands
        if (isUnavailableModule(diagnostic.code)) diagnostic.severity = Severity::Error;
    return true;
}

/// Reports problems of the start state before the run, like `check`. False if one is an error, which the run would refuse.
bool RunCommand::checkStart() {
    Diagnostics found;
    checkModel(*m_loaded, found);
    found.summarize();
    std::vector<Diagnostic> all = found.all();
    std::stable_partition(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity != Severity::Error; });
    printDiagnostics(all, m_report.sources);
    m_report.diagnostics.insert(m_report.diagnostics.end(), all.begin(), all.end());
    if (!found.hasErrors()) return true; // the last error is the reason why the run ended
    writeMessage(cleanLine(m_arguments.file) + ": not run, the check before it found " + countText(all) + "\n");
    return false;
}

bool RunCommand::planTicks() {
    const SettingsSpec& settings = m_loaded->experiment->settings;
    m_endless = !m_arguments.duration && settings.duration <= 0;
    if (m_endless && isatty(messagesFile()) != 1) {
        const std::string message = "the experiment has no Duration: give --duration S";
        printProblem(message);
        m_report.diagnostics.push_back({Severity::Error, Code::NoDuration, message, {}, {}, {}, {}});
        return false;
    }
    if (!m_endless) m_ticks = ticksFor(m_arguments.duration.value_or(settings.duration), settings.tick);
    return true;
}

/// Reports problems with the movie before the run instead of after it.
bool RunCommand::openMovie() {
    MovieOptions& movieOptions = m_arguments.movie;
    if (movieOptions.path.empty()) return true;
    if (const auto size = pictureSize(m_arguments.movieSize)) {
        movieOptions.width = size->width;
        movieOptions.height = size->height;
    }
    Result<std::unique_ptr<Movie>> movie = Movie::open(movieOptions, *m_loaded->experiment);
    if (!movie) return movieProblem(movie.error());
    m_movie = std::move(movie).value();
    return true;
}

bool RunCommand::movieProblem(const Status& status) {
    if (status) return true;
    const std::string message = cleanLine(status.error().message);
    if (m_progress) m_progress->line("error: " + message + "\n");
    else printProblem(message);
    m_report.diagnostics.push_back({Severity::Error, status.error().code, status.error().message, {}, {}, {}, {}});
    return false;
}

bool RunCommand::film() {
    if (!m_movie || movieProblem(m_movie->follow(*m_runner))) return true;
    m_movie.reset();
    return false;
}

bool RunCommand::endMovie() { return !m_movie || movieProblem(m_movie->finish()); }

RunOptions RunCommand::runOptions() {
    RunOptions options;
    // A log folder given by the user may be a link; the default one inside the project may not. Absolute, since a module may
    // change the working folder.
    options.logFolder = logsOf(m_loaded->projectFolder, m_arguments.file, m_arguments.logDir);
    options.calls = m_calls;
    options.console = [this](double time, const std::string& who, int severity, const std::string& text) {
        const std::string lines = consoleLines(time, who, severity, text);
        if (m_progress) m_progress->line(lines);
        else writeMessage(lines);
    };
    options.pictures = [this](const ExperimentSpec& experiment, const SignalLayout& layout) {
        return openImageSource(m_application.locations().modules, experiment, layout,
                               {m_arguments.look, [this](const std::string& line) {
                                    if (m_progress) m_progress->line("warning: " + cleanLine(line) + "\n");
                                    else printProblem(line);
                                }});
    };
    return options;
}

void RunCommand::report(const Diagnostic& diagnostic) {
    m_report.diagnostics.push_back(diagnostic);
    if (m_guard) m_guard->setDiagnostics(diagnosticEntries(m_report.diagnostics, m_report.sources));
}

void RunCommand::warn(const Diagnostic& warning) {
    m_progress->line(render(warning, m_report.sources));
    if (const StoppedController* stopped = stoppedBy(warning, m_runner->stoppedControllers())) showBacktrace(*stopped);
    report(warning);
}

void RunCommand::showBacktrace(const StoppedController& stopped) {
    const RobotSpec& robot = m_loaded->experiment->robots[stopped.robot];
    for (const std::string& line : stopped.fault.backtrace)
        m_progress->line(consoleLines(stopped.time, robot.name, TRUNDLE_ERROR, "  " + line));
}

/// Saves what would be lost in a crash, and restores process state that modules may have changed.
void RunCommand::maintain() {
    m_runner->flushLogs();
    m_guard->restoreProcess();
    keepPoses();
}

/// For the --json object after a crash, when the world can no longer be read.
void RunCommand::keepPoses() {
    if (m_arguments.json) m_guard->setRobots(posesJsonMembers(m_runner->world()), m_runner->world().time());
}

LoopOutcome RunCommand::runTicksOfPlan() {
    keepPoses();
    const bool filming = film(); // also the start state
    DriveStatistics meter(m_runner->world());
    const bool metered = !m_arguments.quiet && !m_arguments.json;
    LoopPlan plan{filming ? m_ticks : 0, m_endless && filming, m_arguments.realtime};
    plan.everySecond = [this] { maintain(); };
    if (m_movie) plan.afterTick = [this] { return film(); };
    plan.warn = [this](const Diagnostic& warning) { warn(warning); };
    const LoopOutcome outcome = runTicks(*m_runner, plan, *m_progress, metered ? &meter : nullptr);
    m_report.drives = meter.totals();
    return outcome;
}

/// From here on the results are printed even if the program crashes.
void RunCommand::keepResults() {
    if (!m_arguments.json) return;
    std::string object = runJson(m_report);
    object.erase(object.find_last_of('}'));
    object.erase(object.find_last_not_of('\n') + 1);
    m_guard->setResults(std::move(object));
}

ExitCode RunCommand::runLoaded() {
    m_guard.emplace(GuardOptions{m_calls, "run", true, m_arguments.json}); // module code runs from here on
    m_guard->setDiagnostics(diagnosticEntries(m_report.diagnostics, m_report.sources));
    Diagnostics problems;
    m_runner = m_application.makeRunner(*m_loaded, runOptions(), problems);
    m_guard->restoreProcess();
    printDiagnostics(problems.all(), m_report.sources);
    for (const Diagnostic& problem : problems.all()) report(problem);
    if (!m_runner) {
        for (const Diagnostic& problem : problems.all())
            if (problem.severity == Severity::Error) return printResults(exitCodeFor(problem.code));
        return printResults(kExitText);
    }
    m_report.runner = m_runner.get();
    m_progress = std::make_unique<Progress>(m_ticks, m_loaded->experiment->settings.tick, m_arguments.quiet);
    const LoopOutcome outcome = runTicksOfPlan();
    m_report.wallS = outcome.wallS;
    m_report.interrupted = outcome.interrupted;
    if (const std::string signal = unusualRequest(); !signal.empty())
        warn({Severity::Warning,
              Code::Interrupted,
              "the signal " + signal + " ended the run; code of a module, a limit of the shell or another program sent it",
              {},
              {},
              {},
              {}});
    keepResults();
    const bool filmed = endMovie() && (m_movie || m_arguments.movie.path.empty());
    const std::size_t warned = m_runner->warnings().size();
    (void)m_runner->finish(); // a failure is stored in failure()
    for (std::size_t i = warned; i < m_runner->warnings().size(); ++i) warn(m_runner->warnings()[i]);
    m_guard->restoreProcess();
    m_progress->finish(m_runner->world().ticks());

    const bool stopped = !m_runner->stoppedControllers().empty();
    const Diagnostic* failure = m_runner->failure();
    if (failure) {
        printDiagnostics({*failure}, m_report.sources);
        report(*failure);
    }
    return printResults(failure               ? exitCodeFor(failure->code)
                        : outcome.interrupted ? kExitInterrupted
                        : stopped             ? kExitController
                        : filmed              ? kExitDone
                                              : kExitText);
}

/// Checks the range of the settings Duration and Seed. Empty if valid.
std::string durationProblem(const std::string& text) {
    double seconds = 0;
    const char* const end = text.data() + text.size();
    const auto [read, fault] = std::from_chars(text.data(), end, seconds);
    const bool good = fault == std::errc() && read == end && seconds >= 0 && seconds <= kLongestDurationS;
    return good ? std::string() : "the duration must be a number of seconds from 0 to 1e9";
}

std::string seedProblem(const std::string& text) {
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [read, fault] = std::from_chars(text.data(), end, seed);
    const bool good = fault == std::errc() && read == end && seed <= kLargestSeed;
    return good ? std::string() : "the seed must be a whole number from 0 to " + std::to_string(kLargestSeed);
}

/// Checks the movie's file name before the run: ffmpeg would report an unsupported one only after the start.
std::string endingProblem(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending == ".mp4" || ending == ".webm" ? std::string() : "a movie's name ends in .mp4 or .webm";
}

/// Prints the results on standard output, however the run ended.
ExitCode RunCommand::printResults(ExitCode code) {
    std::string text;
    if (m_arguments.json) {
        text = runJson(m_report);
    } else if (m_runner) {
        if (!m_arguments.quiet) text = cleanText(runSummary(m_report));
        if (m_arguments.hash)
            text += "state-hash " + hashText(m_runner->world().stateHash()) + " tick " +
                    std::to_string(m_runner->world().ticks()) + "\n";
    }
    const bool written = text.empty() || writeOut(text);
    if (m_guard) m_guard->resultsPrinted();
    return !written && code == kExitDone ? kExitText : code;
}

constexpr const char* kRunExamples = R"(Examples:
  trundle-cli run configs/experiments/linear_motion.sim
  trundle-cli run my.sim --duration 60 --seed 7 --log-dir results
  trundle-cli run my.sim --set robot0.brain.Distance=2 --set Tick=0.02
  trundle-cli run my.sim --movie my.mp4 --camera robot0/eye --fps 30
  trundle-cli run my.sim --json --quiet > result.json

Results go to standard output; progress, messages and what controllers print go to standard error.
Exit codes: 0 done (at the end of the duration, or finished by a controller), 1 errors in the text or a module that does not
load, 2 wrong usage or unreadable FILE, 3 the simulation blew up, 4 a controller failed, or code of a module crashed, ended the
program or did not return, 130 interrupted (Ctrl+C, SIGTERM, SIGHUP or the like: logs and summary are complete; a step of the
solver that takes more than 3 s is cut off).
Logs are written out each second and when a module crashes. After a crash --json still prints its object, with "crashed".
What modules print to standard output goes to standard error.)";

struct SizeOptions {
    CLI::Option *camera, *size;
};

SizeOptions addMovieOptions(CLI::App& command, RunArguments& a) {
    CLI::Option* movie = command.add_option("--movie", a.movie.path, "A movie of the run, made by ffmpeg: .mp4 or .webm")
                             ->type_name("OUT")
                             ->check(&endingProblem);
    CLI::Option* view = command.add_option("--view", a.movie.view, "Which View of the text it shows; else everything")
                            ->type_name("NAME")
                            ->check(&emptyProblem)
                            ->needs(movie);
    CLI::Option* camera =
        command.add_option("--camera", a.movie.camera, "Which robot's camera it shows, as robot0/eye, in its own size")
            ->type_name("PATH")
            ->check(&emptyProblem)
            ->needs(movie)
            ->excludes(view);
    CLI::Option* size = command.add_option("--size", a.movieSize, "Width and height of the movie in pixels, up to 4096x4096")
                            ->type_name("WxH")
                            ->check(&sizeProblem)
                            ->needs(movie)
                            ->capture_default_str();
    command.add_option("--fps", a.movie.framesPerSecond, "Pictures for each simulated second")
        ->type_name("N")
        ->check(CLI::Range(0.01, 1000.0))
        ->check(&finiteProblem)
        ->needs(movie)
        ->capture_default_str();
    return {camera, size};
}

} // namespace

void addRun(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("run", "Run an experiment");
    auto arguments = std::make_shared<RunArguments>();
    RunArguments& a = *arguments;
    command->add_option("FILE", a.file, "The experiment")->required()->type_name("");
    command->add_option("--duration", a.duration, "Simulated seconds to run, instead of the text's Duration")
        ->type_name("S")
        ->check(&durationProblem);
    command->add_option("--seed", a.seed, "Seed of all random numbers, instead of the text's Seed")
        ->type_name("N")
        ->check(&seedProblem);
    addSetOption(*command, a.open);
    command
        ->add_option("--log-dir", a.logDir,
                     "Folder for the logs, may be a link; by default logs/<experiment> in the project folder, which may not")
        ->type_name("DIR")
        ->check(&emptyProblem);
    const SizeOptions movie = addMovieOptions(*command, a);
    addLookOption(*command, a.look);
    command->add_flag("--realtime", a.realtime, "No faster than real time");
    command->add_flag("--hash", a.hash, "End with `state-hash <16 hex digits> tick <n>`");
    command->add_flag("--json", a.json, "One JSON object instead of the summary");
    command->add_flag("--quiet", a.quiet, "No progress and no summary");
    addOpenOptions(*command, a.open);
    command->footer(kRunExamples);
    command->callback([arguments, &application, &chosen, movie] {
        refuseSizeOfCamera(*movie.camera, *movie.size);
        chosen = [arguments, &application] { return RunCommand(application(), *arguments).go(); };
    });
}

} // namespace trundle
