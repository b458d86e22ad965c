#include "editor/running/panels/controller_commands.h"

#include <algorithm>

#include <QFileInfo>
#include <QSettings>

#include "control/directory_catalog.h"
#include "editor/running/panels/module_reload.h"
#include "editor/running/panels/trust.h"
#include "project/edits/module_lines.h"

namespace trundle {
namespace {

const QString kRecent = QStringLiteral("recentModules");
constexpr int kMaxRecent = 10;

void remember(const QString& library) {
    QStringList list = QSettings().value(kRecent).toStringList();
    list.removeAll(library);
    list.prepend(library);
    QSettings().setValue(kRecent, list.mid(0, kMaxRecent));
}

} // namespace

ControllerCommands::ControllerCommands(Document& document, RunSession& session, QObject* parent)
    : QObject(parent), m_document(document), m_session(session), m_given(document.options().modules) {
    applyTrust();
}

bool ControllerCommands::reject(const QString& reason) {
    Q_EMIT refused(reason);
    return false;
}

/// Edits modules, which are not objects: the selection is kept.
bool ControllerCommands::edit(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey) {
    if (!plan) return reject(QString::fromStdString(plan.error().message));
    return m_document.edits().edit(name, plan.value().edits, mergeKey).ok(); // the document reports a failure
}

void ControllerCommands::applyTrust() {
    OpenOptions options = m_document.options();
    std::vector<std::string> folders;
    for (const QString& folder : TrustedFolders::all()) folders.push_back(folder.toStdString());
    if (folders == options.trusted) return;
    options.trusted = std::move(folders);
    m_document.setOptions(options);
}

std::vector<ModuleInfo> ControllerCommands::modules() const {
    if (!m_document.loaded()) return {};
    return modulesOf(*m_document.loaded(), m_document.options(), m_session.source().application().locations());
}

std::vector<ControllerChoice> ControllerCommands::choices() const {
    if (!m_document.loaded()) return {};
    OpenOptions own; // only the program's modules: other folders may have thousands of files
    return controllerChoices(*m_document.loaded(), m_session.source().application().moduleKinds(own),
                             m_session.source().application().locations().modules);
}

QStringList ControllerCommands::recent() {
    QStringList there;
    for (const QString& library : QSettings().value(kRecent).toStringList())
        if (QFileInfo(library).isFile()) there.append(library);
    return there;
}

/// Whether a library is in the program's folder or a trusted one; otherwise asks the user to trust its folder.
bool ControllerCommands::isTrusted(const QString& library) {
    const OpenOptions& options = m_document.options();
    DirectoryCatalog catalog(
        {options.modules, m_session.source().application().locations().modules, options.trusted, options.trust});
    const QString folder = QFileInfo(library).absolutePath();
    if (catalog.find(library.toStdString(), folder.toStdString())) return true;
    if (!m_ask || !m_ask(library, folder)) return false;
    TrustedFolders::add(folder);
    applyTrust();
    return true;
}

bool ControllerCommands::load(const QString& library) {
    if (!m_document.isOpen()) return reject(tr("Open an experiment first."));
    const QFileInfo file(library);
    DirectoryCatalog open({{}, {}, {}, true}); // reads descriptions, loads no module
    const Result<ModuleListing> found = open.find(file.absoluteFilePath().toStdString(), file.absolutePath().toStdString());
    if (!found) return reject(QString::fromStdString(found.error().message));
    const std::string& path = found.value().library;
    if (!isTrusted(QString::fromStdString(path))) return false;
    const std::string written = writtenPath(path);
    for (const ModuleInfo& module : modules())
        if (module.library == path) return reject(tr("%1 is loaded already.").arg(QString::fromStdString(module.written)));
    if (!edit(tr("Load Module %1").arg(QString::fromStdString(written)), planLoadModule(*m_document.loaded(), written)))
        return false;
    remember(QString::fromStdString(path));
    return true;
}

std::string ControllerCommands::writtenPath(const std::string& library) const {
    return writtenFor(library, *m_document.loaded(), m_session.source().application().locations().modules, m_given);
}

bool ControllerCommands::trustFolder(const QString& file, const QString& folder) {
    const OpenOptions& options = m_document.options();
    const auto isBelow = [&folder](const std::string& trusted) {
        const QString top = QFileInfo(QString::fromStdString(trusted)).canonicalFilePath();
        const QString real = QFileInfo(folder).canonicalFilePath();
        return !top.isEmpty() && (real == top || real.startsWith(top + QLatin1Char('/')));
    };
    if (options.trust || TrustedFolders::covers(folder) || std::ranges::any_of(m_given, isBelow)) return true;
    if (!m_ask || !m_ask(file, folder)) return false;
    TrustedFolders::add(folder);
    applyTrust();
    return true;
}

bool ControllerCommands::trust(const ModuleInfo& module) {
    if (module.library.empty()) return reject(module.trouble);
    return isTrusted(QString::fromStdString(module.library));
}

bool ControllerCommands::unload(const ModuleInfo& module) {
    if (!m_document.loaded()) return false;
    const QString written = QString::fromStdString(module.written);
    if (!module.usedBy.empty())
        return reject(tr("%1 has a kind of %2; take that out first").arg(QString::fromStdString(module.usedBy), written));
    return edit(tr("Unload Module %1").arg(written), planUnloadModule(*m_document.loaded(), module.range.file, module.written));
}

void ControllerCommands::reload() {
    if (!hostedModules(m_session).isEmpty()) {
        m_session.robots().reloadModules({});
        return;
    }
    m_session.reset();
    if (m_document.isOpen()) m_document.loading().readAgain();
}

bool ControllerCommands::assign(const std::vector<std::string>& robots, const ControllerChoice& choice) {
    if (!m_document.loaded()) return false;
    const QString name =
        robots.size() == 1
            ? tr("Assign %1 to %2").arg(QString::fromStdString(choice.kind.name), QString::fromStdString(robots[0]))
            : tr("Assign %1").arg(QString::fromStdString(choice.kind.name));
    const std::string key = "assign " + choice.kind.name;
    m_document.edits().endMerge();
    if (!choice.module.empty() && !edit(name, planLoadModule(*m_document.loaded(), choice.module), key)) return false;
    const Kind* kind = m_document.loaded()->registry->find(choice.kind.name);
    const bool done =
        m_document.edits().apply(name, planAssign(*m_document.loaded(), robots, kind ? *kind : choice.kind), key).ok();
    if (!done) m_document.edits().discardMerge(key); // undo the #loadModule if the assignment failed
    m_document.edits().endMerge();
    return done;
}

bool ControllerCommands::unassign(const std::vector<std::string>& robots) {
    if (!m_document.loaded()) return false;
    return m_document.edits().apply(tr("Remove Controller"), planUnassign(*m_document.loaded(), robots)).ok();
}

} // namespace trundle
