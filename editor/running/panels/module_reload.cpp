#include "editor/running/panels/module_reload.h"

#include <QAction>
#include <QFileInfo>
#include <QSettings>

#include "control/isolation.h"
#include "control/module_file.h"
#include "control/python_kinds.h"
#include "editor/widgets/strings.h"

namespace trundle {
namespace {

constexpr int kSettleMs = 120;
const QString kFollow = QStringLiteral("reloadRebuiltModules");

} // namespace

QStringList hostedModules(const RunSession& session) {
    QStringList libraries;
    const RunResults& results = session.results();
    const bool runs = session.state() == RunState::Running || session.state() == RunState::Paused;
    if (!runs || !results.experiment || !results.built) return libraries;
    const Isolation otherwise = session.source().application().isolation();
    const auto add = [&](const ControllerSpec& controller) {
        const Kind* kind = results.built->registry->find(controller.kind);
        const std::string module = kind ? kind->module : std::string();
        const bool isInside = isolationOf(controller, results.experiment->settings, otherwise) == Isolation::None;
        if (isInside && !isPythonModule(module)) return;
        const QString library = toQString(module);
        if (!library.isEmpty() && !libraries.contains(library)) libraries.append(library);
    };
    for (const RobotSpec& robot : results.experiment->robots)
        for (const ControllerSpec& controller : robot.controllers) add(controller);
    return libraries;
}

ModuleReload::ModuleReload(RunSession& session, QAction& follow, QObject* parent)
    : QObject(parent), m_session(session), m_follow(follow) {
    follow.setChecked(QSettings().value(kFollow, true).toBool());
    connect(&follow, &QAction::toggled, this, [this](bool follows) {
        QSettings().setValue(kFollow, follows);
        begin();
    });
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &ModuleReload::look);
    const auto changed = [this] { m_settle.start(); };
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, changed);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, changed);
    connect(&session, &RunSession::stateChanged, this, &ModuleReload::begin);
}

/// Watches the libraries of the run in progress; keeps what is known of those that it watches already. A run that has ended may go on:
/// it then takes what was rebuilt meanwhile.
void ModuleReload::begin() {
    if (m_session.state() == RunState::Ended && m_follow.isChecked()) return;
    const QStringList libraries = m_follow.isChecked() ? hostedModules(m_session) : QStringList();
    if (libraries.isEmpty() && m_libraries.empty()) return;
    std::erase_if(m_libraries, [&](const auto& known) { return !libraries.contains(known.first); });
    for (const QString& library : libraries)
        if (const Stamp now = stampOf(library); m_libraries.emplace(library, Library{now, now}).second) watch(library);
    if (!m_libraries.empty()) return m_settle.start();
    if (const QStringList watched = m_watcher.files() + m_watcher.directories(); !watched.isEmpty())
        m_watcher.removePaths(watched);
}

/// A linker may replace the file, which ends the watch of it, so its folder is watched as well.
void ModuleReload::watch(const QString& library) {
    const QFileInfo file(library);
    m_watcher.addPath(file.absolutePath());
    if (file.exists()) m_watcher.addPath(library);
}

ModuleReload::Stamp ModuleReload::stampOf(const QString& library) {
    const QFileInfo file(library);
    return file.exists() ? Stamp{file.lastModified(), file.size()} : Stamp{};
}

void ModuleReload::look() {
    if (m_session.state() == RunState::Ended) return;
    for (auto& [path, library] : m_libraries) {
        watch(path);
        const Stamp now = stampOf(path);
        if (now == library.loaded || now.bytes < 0) continue;
        if (std::exchange(library.seen, now) != now) m_settle.start(); // it may still be written
        else if (isPythonModule(path.toStdString()) || checkModuleFile(path.toStdString()).ok()) {
            library.loaded = now;
            m_session.robots().reloadModules(path.toStdString());
        }
    }
}

} // namespace trundle
