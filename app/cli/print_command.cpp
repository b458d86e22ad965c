#include "base/platform/read_file.h"
#include "cli/messages.h"
#include "cli/subcommands.h"
#include "lang/tree.h"

namespace trundle {
namespace {

ExitCode printTree(const std::string& file) {
    Result<std::string> bytes = readRegularFile(file);
    if (!bytes) {
        printProblem(bytes.error().message);
        return kExitUsage;
    }
    const auto source = std::make_shared<const SourceText>(file, std::move(bytes).value());
    return writeOut(print(*parse(source, 0))) ? kExitDone : kExitText;
}

constexpr const char* kPrintExamples = R"(Example:
  trundle-cli print configs/robots/simple_robot.sim)";

} // namespace

void addPrint(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command =
        app.add_subcommand("print", "Read a file into its tree and print the tree: the same bytes, whatever they are");
    auto file = std::make_shared<std::string>();
    command->add_option("FILE", *file, "The file")->required()->type_name("");
    command->footer(kPrintExamples);
    command->callback([file, &chosen] { chosen = [file] { return printTree(*file); }; });
}

} // namespace trundle
