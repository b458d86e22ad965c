#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <numbers>

#include <unistd.h>

#include "app/locations.h"
#include "base/platform/dynamic_library.h"
#include "cli/messages.h"
#include "cli/open_arguments.h"
#include "cli/run_guard.h"
#include "cli/subcommands.h"
#include "render/render_entry.h"

namespace trundle {
namespace {

struct RenderArguments {
    OpenOptions open;
    std::string file, output, camera, view, size = "1280x720";
    double at = 0;
    std::vector<double> eye, target;
    LookChoice look = LookChoice::Automatic;
    double fieldOfView = 50; // degrees
};

void setView(const RenderArguments& arguments, RenderJob& job) {
    if (arguments.eye.empty()) return;
    job.hasView = true;
    job.fieldOfView = arguments.fieldOfView * std::numbers::pi / 180;
    for (std::size_t k = 0; k < 3; ++k) {
        job.eye[k] = arguments.eye[k];
        job.target[k] = arguments.target.empty() ? 0 : arguments.target[k];
    }
}

/// The render library is loaded only here, so that runs without images start without it.
ExitCode draw(RenderJob& job) {
    const Result<DynamicLibrary> library = DynamicLibrary::open(findLocations().modules + "/" TRUNDLE_RENDER_LIBRARY);
    if (!library) {
        printProblem("pictures cannot be drawn: " + library.error().message);
        return kExitText;
    }
    auto* const render = library.value().function<int(const RenderJob*)>("trundle_render_experiment");
    if (!render) {
        printProblem("pictures cannot be drawn: " + library.value().path() + " is not the picture library");
        return kExitText;
    }
    std::array<char, 512> error{};
    job.error = error.data();
    job.errorSize = error.size();
    if (render(&job) == 0) return kExitDone;
    printProblem(error.data());
    return kExitText;
}

/// Checks the output path before a simulation that may take minutes.
ExitCode checkBeforeRun(RenderJob job) {
    namespace fs = std::filesystem;
    std::error_code fault;
    const fs::path file = fs::weakly_canonical(fs::absolute(job.outputPath, fault), fault); // writing follows links
    std::string why;
    if (fs::is_directory(file, fault)) why = "it is a folder";
    else if (::access(file.parent_path().c_str(), W_OK | X_OK) != 0) why = std::strerror(errno);
    if (!why.empty()) {
        printProblem(std::string("cannot write ") + job.outputPath + ": " + why);
        return kExitText;
    }
    job.onlyCheck = true;
    return draw(job);
}

bool hasWrongSet(const LoadedProject& loaded) {
    return std::ranges::any_of(loaded.diagnostics.all(), [&](const Diagnostic& d) {
        return d.severity == Severity::Error && loaded.outline->texts().commandLine(d.range.file);
    });
}

/// Runs the experiment up to a simulated time, and draws the state then.
ExitCode drawAfterRun(Application& application, const LoadedProject& loaded, double seconds, RenderJob& job) {
    const auto calls = std::make_shared<CallMonitor>();
    RunGuard guard({calls, "run", true, false}); // module code runs from here on
    Diagnostics problems;
    RunOptions options;
    options.calls = calls;
    const std::unique_ptr<Runner> runner = application.makeRunner(loaded, std::move(options), problems);
    guard.restoreProcess();
    printDiagnostics(problems.all(), loaded.sources);
    if (!runner) return kExitText;
    const std::uint64_t ticks = ticksFor(seconds, loaded.experiment->settings.tick);
    while (!runner->finished() && runner->world().ticks() < ticks && !interrupted() && runner->tick().ok()) {}
    if (isForkedCopy()) endForkedCopy();
    guard.restoreProcess();
    if (interrupted()) {
        if (const std::string signal = unusualRequest(); !signal.empty()) printProblem("the signal " + signal + " ended the run");
        return kExitInterrupted;
    }
    guard.endOnRequest();
    if (const Diagnostic* failure = runner->failure()) { // report it together with the state reached
        printDiagnostics({*failure}, loaded.sources);
        return exitCodeFor(failure->code);
    }
    job.layout = &runner->world().layout();
    job.block = &runner->world().block();
    return draw(job);
}

ExitCode renderFile(Application& application, const RenderArguments& arguments) {
    RenderJob job;
    if (const auto size = pictureSize(arguments.size)) {
        job.width = size->width;
        job.height = size->height;
    }
    const Result<std::shared_ptr<const LoadedProject>> opened = application.open(arguments.file, arguments.open);
    if (!opened) {
        printProblem(opened.error().message);
        return kExitUsage;
    }
    const LoadedProject& loaded = *opened.value();
    printDiagnostics(loaded.diagnostics.all(), loaded.sources);
    job.experiment = loaded.experiment.get();
    job.outputPath = arguments.output.c_str();
    job.look = arguments.look;
    const std::function<void(const std::string&)> warn = printProblem;
    job.warn = &warn;
    if (!arguments.camera.empty()) job.camera = arguments.camera.c_str();
    if (!arguments.view.empty()) job.view = arguments.view.c_str();
    setView(arguments, job);
    if (hasWrongSet(loaded)) return kExitText;
    if (!(arguments.at > 0)) return draw(job); // the valid parts of a text with errors are rendered too
    if (loaded.diagnostics.hasErrors()) return kExitText;
    if (const ExitCode wrong = checkBeforeRun(job); wrong != kExitDone) return wrong;

    return drawAfterRun(application, loaded, arguments.at, job);
}

/// Checks the ending of the picture's name.
std::string pictureProblem(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    const bool good = ending == ".png" || ending == ".jpg" || ending == ".jpeg";
    return good ? emptyProblem(path) : "a picture's name ends in .png, .jpg or .jpeg";
}

constexpr const char* kRenderExamples = R"(Examples:
  trundle-cli render configs/experiments/swarm.sim -o swarm.png
  trundle-cli render my.sim --at 2 --camera robot0/eye -o what_it_sees.png
  trundle-cli render my.sim --at 5 --size 1920x1080 --eye 2,-2,1.5 --target 0,0,0.1 -o after_five_seconds.jpg)";

void addViewOptions(CLI::App& command, RenderArguments& a, CLI::Option& camera, CLI::Option& view) {
    CLI::Option* eye = command.add_option("--eye", a.eye, "Where the picture is taken from, m; else everything is framed")
                           ->type_name("X,Y,Z")
                           ->delimiter(',')
                           ->expected(3)
                           ->check(&finiteProblem)
                           ->excludes(&camera)
                           ->excludes(&view);
    command.add_option("--target", a.target, "What is in the middle of it, m")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->check(&finiteProblem)
        ->needs(eye);
    command.add_option("--fov", a.fieldOfView, "Horizontal field of view, deg")
        ->type_name("DEG")
        ->check(CLI::Range(1.0, 179.0))
        ->check(&finiteProblem)
        ->needs(eye)
        ->capture_default_str();
}

} // namespace

void addRender(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("render", "Draw a picture of an experiment, with no display");
    auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    command->add_option("FILE", a.file, "The experiment")->required()->type_name("");
    command->add_option("-o,--output", a.output, "The picture: .png or .jpg")
        ->required()
        ->type_name("OUT")
        ->check(&pictureProblem);
    command->add_option("--at", a.at, "Run for that many simulated seconds first")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e9))
        ->check(&finiteProblem);
    CLI::Option* camera =
        command
            ->add_option("--camera", a.camera,
                         "What a robot's camera, as robot0/eye, sees at that moment, whatever its UpdatePeriod; "
                         "in its own size")
            ->type_name("PATH")
            ->check(&emptyProblem);
    CLI::Option* view =
        command->add_option("--view", a.view, "A View of the text")->type_name("NAME")->check(&emptyProblem)->excludes(camera);
    CLI::Option* size = command->add_option("--size", a.size, "Width and height in pixels, up to 4096x4096")
                            ->type_name("WxH")
                            ->check(&sizeProblem)
                            ->capture_default_str();
    addViewOptions(*command, a, *camera, *view);
    addLookOption(*command, a.look);
    addSetOption(*command, a.open);
    addOpenOptions(*command, a.open);
    command->footer(kRenderExamples);
    command->callback([arguments, &application, &chosen, camera, size] {
        refuseSizeOfCamera(*camera, *size);
        chosen = [arguments, &application] { return renderFile(application(), *arguments); };
    });
}

} // namespace trundle
