#include "editor/shell/commands/module_commands.h"

#include <algorithm>
#include <utility>

#include <trundle/abi.h>

#include <QFileInfo>

#include "app/application.h"
#include "app/module_build.h"
#include "control/directory_catalog.h"
#include "control/python_kinds.h"
#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/problems/problems_panel.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/trust.h"
#include "editor/running/session.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/dialogs/new_module_dialog.h"
#include "editor/shell/layouts.h"
#include "editor/shell/status_line.h"
#include "editor/shell/work_area.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/strings.h"
#include "model/robot_path.h"

namespace trundle {
namespace {

QString nameOf(const std::string& folder) { return QFileInfo(toQString(folder)).fileName(); }

/// What a new controller commands: the first of the robots that get it.
CommandedRobot commandedAmong(const LoadedProject& loaded, const std::vector<std::string>& robots) {
    for (const ControlledRobot& controlled : controlledRobots(loaded))
        for (const RobotSpec& robot : loaded.experiment->robots)
            if (controlled.isAmong(robots) && robot.config && isNamedBy(robot.name, controlled.path))
                return commandedRobot(*robot.config);
    return {};
}

/// "robot0, in place of Wander"; empty for no robots.
QString usersText(const LoadedProject& loaded, const std::vector<std::string>& robots) {
    if (robots.empty()) return {};
    QStringList replaced;
    for (const ControlledRobot& robot : controlledRobots(loaded))
        if (robot.isAmong(robots) && !robot.kind.empty()) replaced += toQString(robot.kind);
    const QString users = robots.size() == 1 ? toQString(robots[0]) : ModuleCommands::tr("%1 robots").arg(robots.size());
    if (replaced.isEmpty()) return users;
    if (robots.size() > 1) return ModuleCommands::tr("%1, in place of their controllers").arg(users);
    return ModuleCommands::tr("%1, in place of %2").arg(users, replaced.first());
}

} // namespace

ModuleCommands::ModuleCommands(QWidget& window, Actions& actions, const Targets& targets)
    : QObject(&window), m_window(window), m_actions(actions), m_targets(targets),
      m_builder(new ModuleBuilder(targets.application.locations(), this)) {
    const auto on = [&](const char* id, auto what) { connect(&actions.at(id), &QAction::triggered, this, what); };
    on("controllers.new", [this] { askForNew(true); });
    on("controllers.newComponent", [this] { askForNew(false); });
    on("controllers.build", [this] { build(); });
    on("controllers.cancelBuild", [this] { m_builder->cancel(); });
    connect(&m_targets.problems, &ProblemsPanel::trustRequested, this, [this](const SourceRange& place) {
        ControllerCommands& commands = m_targets.controllers.commands();
        const std::vector<ModuleInfo> modules = commands.modules();
        const auto module = std::ranges::find(modules, place, &ModuleInfo::range);
        if (module != modules.end()) (void)commands.trust(*module);
    });
    connect(m_builder, &ModuleBuilder::printed, this, [this](const QStringList& lines) { showLines(lines, TRUNDLE_INFO); });
    connect(m_builder, &ModuleBuilder::ended, this, &ModuleCommands::finish);
    connect(&m_targets.document, &Document::opened, this, [this] {
        m_builder->cancel();
        m_uses.clear();
        showState();
    });
    showState();
}

void ModuleCommands::showState() {
    const bool open = m_targets.document.isOpen();
    for (const char* id : {"controllers.new", "controllers.newComponent"}) m_actions.at(id).setEnabled(open);
    m_actions.at("controllers.build").setEnabled(open && !m_builder->isRunning());
    m_actions.at("controllers.cancelBuild").setEnabled(m_builder->isRunning());
}

// ---- new modules ----

QString ModuleCommands::nameFault(ModuleTemplate what, const std::string& kind) const {
    if (const std::string fault = kindNameFault(what, kind); !fault.empty()) return toQString(fault);
    const std::vector<Kind> shipped = m_targets.application.moduleKinds({});
    const bool isTaken = (m_targets.document.loaded() && m_targets.document.loaded()->registry->find(kind)) ||
                         std::ranges::find(shipped, kind, &Kind::name) != shipped.end();
    return isTaken ? tr("There is a kind %1 already.").arg(toQString(kind)) : QString();
}

/// Its files are beside the experiment, so the experiment needs a folder of its own.
void ModuleCommands::askForNew(bool isController) {
    Document& document = m_targets.document;
    if (!document.isOpen()) return;
    if ((document.isNew() || document.texts().isSample(document.path())) && !m_targets.files.save())
        return m_targets.status.refuse(tr("The files of a module are beside the experiment: save the experiment first."));
    std::vector<std::string> robots; // that get it: a component is only loaded
    if (isController) robots = robotsAmong(*document.loaded(), m_targets.selection.paths());
    NewModuleDialog::Options options;
    options.isController = isController;
    options.project = toQString(document.loaded()->projectFolder);
    options.user = usersText(*document.loaded(), robots);
    options.fault = [this](ModuleTemplate what, const std::string& kind) { return nameFault(what, kind); };
    auto* dialog = new NewModuleDialog(std::move(options), &m_window);
    connect(&document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog, robots] { create(*dialog, robots); });
    dialog->open();
}

void ModuleCommands::create(const NewModuleDialog& dialog, const std::vector<std::string>& robots) {
    const ModuleTemplate what = dialog.what();
    const Result<NewModule> made = makeModule(what, dialog.kind(), dialog.folder(), m_targets.application.locations(),
                                              commandedAmong(*m_targets.document.loaded(), robots));
    if (!made) return m_targets.status.refuse(toQString(made.error().message));
    const NewModule& module = made.value();
    TrustedFolders::add(toQString(module.folder)); // the dialog says so
    m_targets.controllers.commands().applyTrust();
    m_targets.work.showText(true);
    m_targets.text.reveal(module.source, {}, true);
    const NewUse wanted{module.folder, module.library, dialog.kind(), robots};
    if (!dialog.isUsed()) return m_targets.status.refuse(tr("Wrote %1").arg(toQString(m_targets.document.texts().shown(module.source))));
    if (isPython(what)) return use(wanted);
    m_uses.push_back(wanted);
    start({module.folder});
}

/// The edit selects what it creates, which shows the text of the experiment: the source stays shown instead.
void ModuleCommands::use(const NewUse& wanted) {
    TextPanel& text = m_targets.text;
    const std::string shown = text.page() ? text.page()->file() : std::string();
    const bool hadKeyboard = text.hasKeyboard();
    addUse(wanted);
    if (FilePage* page = shown.empty() ? nullptr : text.openFile(shown); page && hadKeyboard) page->setFocus();
}

/// One entry of the history: the #loadModule and the blocks of the robots.
void ModuleCommands::addUse(const NewUse& wanted) {
    ControllerCommands& commands = m_targets.controllers.commands();
    if (wanted.robots.empty()) {
        (void)commands.load(toQString(wanted.library));
        return;
    }
    OpenOptions options = m_targets.document.options();
    options.modules = {QFileInfo(toQString(wanted.library)).absolutePath().toStdString()};
    for (const Kind& kind : m_targets.application.moduleKinds(options))
        if (kind.name == wanted.kind) {
            (void)commands.assign(wanted.robots, {kind, commands.writtenPath(wanted.library)});
            return;
        }
    m_targets.status.refuse(tr("%1 has no kind %2").arg(toQString(wanted.library), toQString(wanted.kind)));
}

// ---- building ----

/// The module of the source that is shown, else all that the experiment loads and that have sources in its folder.
std::vector<std::string> ModuleCommands::foldersToBuild() const {
    const std::string project = m_targets.document.loaded()->projectFolder;
    if (const FilePage* page = m_targets.text.page()) {
        const std::string folder = moduleFolderOf(page->file(), project);
        if (page->id() == kNoFile && !folder.empty()) return {folder};
    }
    std::vector<std::string> folders;
    for (const ModuleInfo& module : m_targets.controllers.commands().modules())
        if (!module.library.empty() && !isPythonModule(module.library)) folders.push_back(moduleFolderOf(module.library, project));
    for (const NewUse& wanted : m_uses) folders.push_back(wanted.folder);
    std::erase(folders, std::string());
    std::ranges::sort(folders);
    folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
    return folders;
}

void ModuleCommands::build() {
    Document& document = m_targets.document;
    if (!document.isOpen() || m_builder->isRunning()) return;
    m_targets.text.flush();
    if (document.texts().isModified() && !m_targets.files.save()) return;
    const FilePage* page = m_targets.text.page();
    if (page && isPythonModule(page->file())) {
        if (m_targets.session.state() == RunState::Start || m_targets.session.state() == RunState::Ended) document.loading().readAgain();
        return m_targets.status.refuse(tr("Saved. Python needs no build."));
    }
    const std::vector<std::string> folders = foldersToBuild();
    if (folders.empty())
        return m_targets.status.refuse(tr("No module with a CMakeLists.txt in this project: Controllers ▸ New Controller… starts one."));
    for (const std::string& folder : folders)
        if (!m_targets.controllers.commands().trustFolder(toQString(folder + "/CMakeLists.txt"), toQString(folder)))
            return m_targets.status.refuse(tr("Not built: the folder %1 is not trusted.").arg(toQString(folder)));
    start(folders);
}

void ModuleCommands::start(const std::vector<std::string>& folders) {
    if (!m_builder->build(folders, m_targets.document.loaded()->projectFolder))
        return m_targets.status.refuse(tr("A build is in progress."));
    m_targets.problems.setBuildProblems({}, nullptr);
    QStringList names;
    for (const std::string& folder : folders) names.append(nameOf(folder));
    const QString text = tr("Building %1…").arg(names.join(QStringLiteral(", ")));
    showLines({text}, TRUNDLE_INFO);
    m_targets.status.refuse(text);
    showState();
}

void ModuleCommands::showLines(const QStringList& lines, int severity) {
    const double time = m_targets.session.results().time();
    for (const QString& line : lines) m_targets.session.messages().add(time, severity, line);
}

void ModuleCommands::finish(const BuildResult& result) {
    showState();
    if (!m_targets.document.isOpen()) return;
    const std::vector<NewUse> uses = result.succeeded || result.cancelled ? std::exchange(m_uses, {}) : m_uses;
    m_targets.problems.setBuildProblems(result.messages.found, result.messages.sources);
    m_targets.text.setBuildProblems(result.messages.found, result.messages.sources);
    QString text = tr("Built in %1 s").arg(result.seconds, 0, 'f', 1);
    if (result.cancelled) text = tr("The build was cancelled");
    else if (!result.succeeded) text = tr("The build failed: %1").arg(result.failure);
    showLines({text}, result.succeeded || result.cancelled ? TRUNDLE_INFO : TRUNDLE_ERROR);
    m_targets.status.refuse(text);
    if (!result.succeeded) {
        if (!result.cancelled) m_targets.layouts.raise(result.messages.found.empty() ? QStringLiteral("console") : QStringLiteral("problems"));
        return;
    }
    // A run in progress reloads its modules by itself, and reads descriptions that have changed when it starts again.
    const RunState state = m_targets.session.state();
    const bool isIdle = state == RunState::Start || state == RunState::Ended;
    if (isIdle || m_targets.document.loaded()->diagnostics.hasErrors()) m_targets.document.loading().readAgain();
    for (const NewUse& wanted : uses) use(wanted);
}

} // namespace trundle
