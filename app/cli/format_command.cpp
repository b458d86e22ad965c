#include "base/clean_text.h"
#include "base/platform/atomic_file.h"
#include "base/platform/file_lock.h"
#include "base/platform/read_file.h"
#include "cli/messages.h"
#include "cli/subcommands.h"
#include "lang/formatter.h"
#include "lang/tree.h"

namespace trundle {
namespace {

struct FormatArguments {
    std::vector<std::string> files;
    bool check = false, write = false;
};

ExitCode formatFile(const std::string& file, const FormatArguments& arguments) {
    const Result<std::vector<FileLock>> lock =
        FileLock::takeAll(arguments.write ? std::vector{file} : std::vector<std::string>{}, std::chrono::seconds(30));
    if (!lock) {
        printProblem(lock.error().message);
        return kExitText;
    }
    Result<std::string> bytes = readRegularFile(file);
    if (!bytes) {
        printProblem(bytes.error().message);
        return kExitUsage;
    }
    const auto source = std::make_shared<const SourceText>(file, std::move(bytes).value());
    const std::shared_ptr<const Tree> tree = parse(source, 0);
    Diagnostics diagnostics;
    diagnostics.append(tree->diagnostics());
    if (diagnostics.hasErrors()) {
        SourceTable sources;
        sources.add(source);
        printDiagnostics(diagnostics.all(), sources);
        if (!arguments.check && !arguments.write) writeOut(print(*tree));
        return kExitText;
    }
    const std::string formatted = format(*tree);
    if (!arguments.check && !arguments.write) return writeOut(formatted) ? kExitDone : kExitText;
    if (formatted == source->bytes()) return kExitDone;
    if (arguments.check) {
        writeOut("would change " + cleanLine(file) + "\n");
        return kExitText;
    }
    if (const Status written = writeFileAtomically(file, formatted); !written) {
        printProblem(written.error().message);
        return kExitText;
    }
    writeOut("formatted " + cleanLine(file) + "\n");
    return kExitDone;
}

ExitCode formatAll(const FormatArguments& arguments) {
    ExitCode worst = kExitDone;
    for (const std::string& file : arguments.files) worst = std::max(worst, formatFile(file, arguments));
    return worst;
}

constexpr const char* kFormatExamples = R"(Examples:
  trundle-cli format my.sim                 print the formatted text
  trundle-cli format configs/*/*.sim --check
  trundle-cli format my.sim --write

Comments, values and the choice of one line or many for a block stay as they are.
Exit codes: 0 done, 1 a file would change (--check) or has syntax errors, 2 a FILE that cannot be read.)";

} // namespace

void addFormat(CLI::App& app, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("format", "Bring files into the house style");
    auto arguments = std::make_shared<FormatArguments>();
    command->add_option("FILE", arguments->files, "Files to format")->required()->type_name("");
    CLI::Option* check = command->add_flag("--check", arguments->check, "Only say which files would change");
    command->add_flag("--write", arguments->write, "Write the files")->excludes(check);
    command->footer(kFormatExamples);
    command->callback([arguments, &chosen] { chosen = [arguments] { return formatAll(*arguments); }; });
}

} // namespace trundle
