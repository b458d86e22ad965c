#include "editor/running/python_watch.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <QDir>

#include "app/application.h"
#include "control/directory_catalog.h"
#include "control/python_kinds.h"
#include "editor/document/document.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;
constexpr qsizetype kMostBeside = 100;

} // namespace

PythonWatch::PythonWatch(Document& document, const Application& application, QObject* parent)
    : QObject(parent), m_document(document), m_application(application) {
    connect(&document, &Document::opened, this, &PythonWatch::follow);
    connect(&document, &Document::changed, this, &PythonWatch::follow);
    connect(&m_disk, &DiskWatch::touched, this, &PythonWatch::look);
    connect(&document.opening(), &ProjectOpening::cancelled, this, &PythonWatch::look); // postponed while opening
    connect(&document.texts(), &DocumentTexts::modifiedChanged, this, &PythonWatch::look, Qt::QueuedConnection); // after a save
}

/// The path of a module that did not load is looked up without running it.
std::vector<std::string> PythonWatch::modules() const {
    std::vector<std::string> found;
    if (!m_document.loaded()) return found;
    const LoadedProject& loaded = *m_document.loaded();
    const auto didNotLoad = [&](const ModuleSpec& spec) {
        return std::ranges::any_of(loaded.diagnostics.all(),
                                   [&](const Diagnostic& d) { return d.code == Code::PythonModule && d.range == spec.range; });
    };
    const OpenOptions& options = m_document.options();
    for (const ModuleSpec& spec : loaded.experiment->modules) {
        if (isPythonModule(spec.library)) found.push_back(spec.library);
        if (!spec.library.empty() || !didNotLoad(spec) || spec.range.file >= loaded.paths.size()) continue;
        DirectoryCatalog catalog({options.modules, m_application.locations().modules, options.trusted, options.trust});
        const std::string folder = fs::path(loaded.paths[spec.range.file]).parent_path().string();
        if (const auto listing = catalog.find(spec.written, folder)) found.push_back(listing.value().library);
    }
    std::ranges::sort(found);
    return found;
}

PythonWatch::Stamps PythonWatch::stamps() const {
    Stamps now;
    const auto add = [&now](const std::string& file) {
        const auto stamp = regularFileStamp(file);
        now.emplace(file, stamp ? std::optional(stamp.value()) : std::nullopt);
    };
    for (const std::string& module : m_modules) {
        add(module);
        const QDir folder(QString::fromStdString(fs::path(module).parent_path().string()));
        for (const QString& name : folder.entryList({QStringLiteral("*.py")}, QDir::Files).mid(0, kMostBeside))
            add(folder.filePath(name).toStdString());
    }
    return now;
}

void PythonWatch::watch(Stamps now) {
    m_known = std::move(now);
    std::vector<std::string> files;
    for (const auto& [file, stamp] : m_known) files.push_back(file);
    m_disk.watch(files);
}

void PythonWatch::follow() {
    std::vector<std::string> now = modules();
    if (now == m_modules) return;
    m_modules = std::move(now);
    watch(stamps());
}

void PythonWatch::look() {
    if (m_modules.empty() || m_document.opening().isOpening()) return;
    Stamps now = stamps();
    if (now == m_known) return;
    watch(std::move(now));
    Q_EMIT changed();
}

} // namespace trundle
