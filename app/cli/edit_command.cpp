#include <algorithm>
#include <chrono>

#include "base/clean_text.h"
#include "base/platform/atomic_file.h"
#include "base/platform/file_lock.h"
#include "cli/messages.h"
#include "cli/open_arguments.h"
#include "cli/subcommands.h"
#include "lang/tree_edit.h"
#include "project/loading/set_path.h"

namespace trundle {
namespace {

constexpr std::chrono::seconds kTimeout(30); // to wait for other programs that change the same files

struct EditArguments {
    OpenOptions open;
    std::string file;
    bool write = false;
};

struct ChangedFile {
    std::string path, bytes;
};

/// The new content of every file changed by --set.
Result<std::vector<ChangedFile>> changedFiles(const LoadedProject& loaded) {
    std::vector<ChangedFile> changed;
    for (const auto& [file, edits] : editsForSets(loaded)) {
        const SourceText& source = loaded.trees[file]->source();
        Result<std::string> bytes = applyEdits(source.bytes(), edits);
        if (!bytes) return bytes.error();
        if (bytes.value() != source.bytes()) changed.push_back({source.path(), std::move(bytes).value()});
    }
    return changed;
}

ExitCode writeAll(const std::vector<ChangedFile>& changed) {
    for (const ChangedFile& file : changed) {
        if (const Status written = writeFileAtomically(file.path, file.bytes); !written) {
            printProblem(written.error().message);
            return kExitText;
        }
        writeOut("changed " + cleanLine(file.path) + "\n");
    }
    if (changed.empty()) writeOut("nothing to change\n");
    return kExitDone;
}

struct EditedText {
    ExitCode code = kExitDone; ///< otherwise the reason has already been reported
    std::vector<ChangedFile> files;
    std::string opened; ///< content of FILE, without the changes
};

/// Whether the values bring errors elsewhere into the text: an override of a member that there is no more.
bool breaks(Application& application, const EditArguments& arguments, const LoadedProject& changed) {
    if (!changed.diagnostics.hasErrors()) return false;
    auto before = arguments.open;
    before.sets.clear();
    const Result<std::shared_ptr<const LoadedProject>> was = application.open(arguments.file, before);
    return was && was.value()->diagnostics.errorCount() < changed.diagnostics.errorCount();
}

EditedText edited(Application& application, const EditArguments& arguments) {
    const Result<std::shared_ptr<const LoadedProject>> opened = application.open(arguments.file, arguments.open);
    if (!opened) {
        printProblem(opened.error().message);
        return {kExitUsage, {}, {}};
    }
    const LoadedProject& loaded = *opened.value();
    if (setsFailed(loaded)) { // other errors in the text are ignored, since this command may be the one that fixes them
        printDiagnostics(loaded.diagnostics.all(), loaded.sources);
        return {kExitText, {}, {}};
    }
    if (breaks(application, arguments, loaded)) {
        printDiagnostics(loaded.diagnostics.all(), loaded.sources);
        printProblem("nothing is changed: the text would have this error");
        return {kExitText, {}, {}};
    }
    Result<std::vector<ChangedFile>> changed = changedFiles(loaded);
    if (changed) return {kExitDone, std::move(changed).value(), std::string(loaded.trees[0]->source().bytes())};
    printProblem(changed.error().message);
    return {kExitText, {}, {}};
}

/// Which files change is only known after reading them, so they are then locked and read again.
ExitCode editInPlace(Application& application, const EditArguments& arguments) {
    std::vector<std::string> mine;
    for (;;) {
        const Result<std::vector<FileLock>> locks = FileLock::takeAll(mine, kTimeout);
        if (!locks) {
            printProblem(locks.error().message);
            return kExitText;
        }
        const EditedText now = edited(application, arguments);
        if (now.code != kExitDone) return now.code;
        const std::size_t before = mine.size();
        for (const ChangedFile& file : now.files)
            if (std::ranges::find(mine, file.path) == mine.end()) mine.push_back(file.path);
        if (mine.size() == before) return writeAll(now.files);
    }
}

ExitCode edit(Application& application, const EditArguments& arguments) {
    if (arguments.write) return editInPlace(application, arguments);
    const EditedText now = edited(application, arguments);
    if (now.code != kExitDone) return now.code;
    for (const ChangedFile& file : now.files) {
        // With a single changed file, the usual case, standard output contains only the new text.
        if (now.files.size() > 1) writeOut("// " + cleanLine(file.path) + "\n");
        if (!writeOut(file.bytes)) return kExitText;
    }
    if (!now.files.empty()) return kExitDone;
    printProblem("nothing to change");
    return writeOut(now.opened) ? kExitDone : kExitText;
}

constexpr const char* kEditExamples = R"(Examples:
  trundle-cli edit my.sim --set robot0.brain.Speed=0.3              print the changed text
  trundle-cli edit my.sim --set Duration=60 --set Seed=2 --write
  trundle-cli edit my.sim --set RobotConfig.SimpleRobot.leftMotor.Resistance=3 --write

A path that starts in the world writes into that instance's block, as an override where needed; one that starts with a kind edits
the definition, in the file that owns it. The path decides: nothing is asked or copied, as the window does for shared configs.
Nothing else in the files changes. Several edits of one file at once all land.
Exit codes: 0 done, 1 a wrong path or value or a file that cannot be written, 2 wrong usage or unreadable FILE.)";

} // namespace

void addEdit(CLI::App& app, const ApplicationFactory& application, ChosenCommand& chosen) {
    CLI::App* command = app.add_subcommand("edit", "Change values in the text, touching nothing else");
    auto arguments = std::make_shared<EditArguments>();
    command->add_option("FILE", arguments->file, "The experiment")->required()->type_name("");
    addSetOption(*command, arguments->open)->required();
    command->add_flag("--write", arguments->write, "Write the files; without it the changed text is printed");
    addOpenOptions(*command, arguments->open);
    command->footer(kEditExamples);
    command->callback(
        [arguments, &application, &chosen] { chosen = [arguments, &application] { return edit(application(), *arguments); }; });
}

} // namespace trundle
