#include <algorithm>

#include "app/module_template.h"
#include "base/clean_text.h"
#include "cli/messages.h"
#include "cli/new_arena.h"
#include "cli/new_robot.h"
#include "cli/standard_streams.h"
#include "cli/subcommands.h"

namespace trundle {
namespace {

struct NewArguments {
    std::string what, kind, parent = ".";
    bool python = false;
    RobotArguments robot;
    ArenaArguments arena;
    std::vector<const CLI::Option*> robotOptions, arenaOptions;
};

/// Those that `add` adds.
template <class Add> std::vector<const CLI::Option*> optionsOf(const CLI::App& command, const Add& add) {
    const std::size_t before = command.get_options().size();
    add();
    const std::vector<const CLI::Option*> all = command.get_options();
    return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

/// What is given for something else than `what` would have no effect.
void refuseOthers(const std::vector<const CLI::Option*>& options, const std::string& owner, const std::string& what) {
    const auto given = std::ranges::find_if(options, [](const CLI::Option* option) { return option->count() > 0; });
    if (owner != what && given != options.end())
        throw CLI::ValidationError((*given)->get_name(), "it is for `new " + owner + "`, not for `new " + what + "`");
}

bool isTaken(const Application& application, const std::string& kind) {
    const std::vector<Kind> fromModules = application.moduleKinds({});
    return application.builtIn()->find(kind) || std::ranges::any_of(fromModules, [&](const Kind& k) { return k.name == kind; });
}

ExitCode makeNew(const Application& application, const NewArguments& arguments) {
    if (isTaken(application, arguments.kind)) {
        printProblem("Trundle has a kind " + arguments.kind + " already: choose another name");
        return kExitUsage;
    }
    const bool isController = arguments.what == "controller";
    const ModuleTemplate from = isController ? arguments.python ? ModuleTemplate::PythonController : ModuleTemplate::Controller
                                : arguments.python ? ModuleTemplate::PythonComponent
                                                   : ModuleTemplate::Component;
    const Result<NewModule> made = makeModule(from, arguments.kind, arguments.parent, application.locations());
    if (!made) {
        printProblem(made.error().message);
        return kExitUsage;
    }
    const NewModule& module = made.value();
    std::string text = "wrote";
    for (const std::string& file : module.files) text += ' ' + cleanLine(module.folder) + '/' + file;
    const std::string use = isController ? "Robot robot0 { Config=SimpleRobot  " + arguments.kind + " brain { } }"
                                         : arguments.kind + " eye { Body=chassis }";
    if (!module.build.empty()) text += "\n\nTo build it:\n  " + module.configure + "\n  " + module.build;
    text += "\n\nIn an experiment of the folder " + cleanLine(arguments.parent) + ":\n  " + module.load + "\n  " + use +
            "\n\nRun that with --trust: code of a module may do anything, so it is trusted only if you say so.\n";
    return writeOut(text) ? kExitDone : kExitText;
}

constexpr const char* kNewExamples = R"(Examples:
  trundle-cli new controller WallFollow
  trundle-cli new controller WallFollow --python
  trundle-cli new component Thermometer --in my_project/modules
  trundle-cli new component Thermometer --python
  trundle-cli new robot Rover --base mecanum --mass 5 --top-speed 0.8
  trundle-cli new arena Office --plan office.png --plan-width 24
  trundle-cli new arena Yard --obstacles 25 --room-length 8 --field-seed 3
  trundle-cli new arena Kitchen --room 5 4 --door south
  trundle-cli new arena Labyrinth --maze 8 10 --cell 0.5 --maze-seed 7
  trundle-cli new arena Hills --heights hills.png --heights-size 20 20 1.5

The new folder holds one C++ file and a CMakeLists.txt, or one Python file. What is printed builds it and uses it.
The folder of a robot holds its description, with motors that reach the top speed and climb 10 degrees, an experiment, and a controller in
Python that drives a square. That of an arena holds its walls as boxes, and an experiment with a robot between them.
Exit codes: 0 done, 1 the output cannot be written, 2 the folder exists or cannot be written, NAME is no name for a kind,
no motor fits the robot, or the picture has no walls.)";

} // namespace

void addNew(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("new", "Start a controller, a component, a robot or an arena of your own");
    auto arguments = std::make_shared<NewArguments>();
    command->add_option("WHAT", arguments->what, "controller, component: a sensor to start from, robot, or arena")
        ->required()
        ->type_name("")
        ->check(CLI::IsMember({"controller", "component", "robot", "arena"}));
    command->add_option("NAME", arguments->kind, "Of the new kind, robot or arena, like WallFollow")->required()->type_name("");
    command->add_option("--in", arguments->parent, "Make its folder in DIR instead of in this one")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory);
    command->add_flag("--python", arguments->python, "A controller or component in Python, not in C++");
    arguments->robotOptions = optionsOf(*command, [&] { addRobotOptions(*command, arguments->robot); });
    arguments->arenaOptions = optionsOf(*command, [&] { addArenaOptions(*command, arguments->arena); });
    command->footer(kNewExamples);
    command->callback([arguments, command, &application, &chosen] {
        if (arguments->python && arguments->what != "controller" && arguments->what != "component")
            throw CLI::ValidationError("--python", "only controllers and components can be in Python");
        refuseOthers(arguments->robotOptions, "robot", arguments->what);
        refuseOthers(arguments->arenaOptions, "arena", arguments->what);
        if (arguments->what == "arena") checkArenaOptions(*command);
        if (arguments->what == "robot") {
            chosen = [arguments] { return makeNewRobot(arguments->robot, arguments->kind, arguments->parent); };
            return;
        }
        if (arguments->what == "arena") {
            chosen = [arguments, &application] {
                return makeNewArena(arguments->arena, arguments->kind, arguments->parent, application().locations());
            };
            return;
        }
        chosen = [arguments, &application] { return makeNew(application(), *arguments); };
    });
}

} // namespace trundle
