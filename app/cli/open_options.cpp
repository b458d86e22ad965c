#include "cli/open_options.h"

namespace trundle {
namespace {

/// Empty where all is well.
std::string setProblem(const std::string& text) {
    const std::size_t equals = text.find('=');
    return equals != std::string::npos && equals > 0 ? std::string() : "give PATH=VALUE, as in robot0.leftMotor.Resistance=3";
}

} // namespace

void addOpenOptions(CLI::App& command, OpenOptions& options) {
    command.add_option("-I", options.includes, "Also look for imported files in DIR (may be repeated)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    command.add_option("--modules", options.modules, "Also look for modules in DIR, and trust those there (may be repeated)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    command.add_flag("--trust", options.trust, "Trust the modules that lie beside the experiment's files");
}

CLI::Option* addSetOption(CLI::App& command, OpenOptions& options) {
    return command.add_option("--set", options.sets, "Set one value: robot0.leftMotor.Resistance=3 (may be repeated)")
        ->type_name("PATH=VALUE")
        ->check(&setProblem)
        ->allow_extra_args(false);
}

void addLookOption(CLI::App& command, LookChoice& look) {
    command
        .add_option_function<std::string>(
            "--look",
            [&look](const std::string& name) {
                look = name == "rich" ? LookChoice::Rich : name == "fast" ? LookChoice::Fast : LookChoice::Automatic;
            },
            "How pictures look: fast, rich (shadows on things too, dark corners, smooth edges) or automatic, which is rich on a "
            "graphics card. What a robot's camera sees is automatic, whatever is said here")
        ->type_name("LOOK")
        ->check(CLI::IsMember({"automatic", "fast", "rich"}).description(""));
}

} // namespace trundle
