#include "editor/document/document.h"

#include <filesystem>

#include "editor/document/document_state.h"
#include "project/journal/state_folder.h"
#include "project/loading/search.h"

namespace trundle {

namespace fs = std::filesystem;

Document::Document(Application& application, QObject* parent)
    : QObject(parent), m_application(application), m_state(std::make_unique<DocumentState>(application)) {
    connect(&m_state->reader, &ProjectReader::aboutToOpen, this, &Document::aboutToOpen);
    connect(&m_state->watch, &DiskWatch::touched, this, &Document::checkExternalChanges);
    connect(&m_state->journal, &JournalWriter::failed, this, [this](const QString& reason) {
        Q_EMIT notice(tr("Unsaved edits cannot be recovered after a crash: %1").arg(reason));
    });
}

Document::~Document() = default;

OpenOptions Document::optionsNow() const {
    OpenOptions options = m_options;
    options.texts = m_state->files.texts();
    options.previous = m_loaded;
    options.shownFromProject = true;
    options.meshesLater = true;
    return options;
}

Status Document::open(const std::string& path) {
    OpenOptions options = m_options;
    options.shownFromProject = true;
    const std::string absolute = canonicalPath(path);
    Result<std::shared_ptr<const LoadedProject>> loaded = m_application.open(absolute, options);
    if (!loaded) return loaded.error();
    start(absolute, {}, std::move(loaded).value());
    return {};
}

void Document::openLater(const std::string& path) {
    const std::string absolute = canonicalPath(path);
    OpenOptions options = m_options;
    options.shownFromProject = true;
    m_state->reader.open(absolute, options, [this, absolute](const ProjectReader::Loaded& loaded) {
        if (loaded) start(absolute, {}, loaded.value());
        else Q_EMIT openFailed(QString::fromStdString(absolute), QString::fromStdString(loaded.error().message));
    });
}

bool Document::isOpening() const { return m_state->reader.isOpening(); }

void Document::cancelOpening() {
    m_state->reader.cancel();
    Q_EMIT openingCancelled();
    checkExternalChanges(); // postponed while opening
}

Status Document::openNew(const std::string& name, const std::string& text) {
    if (name.empty() || name.find('/') != std::string::npos)
        return Error{Code::EditRefused, "a new text needs a plain file name"};
    const std::string path = canonicalPath(userStateFolder() + "/new/" + name);
    OpenOptions options = m_options;
    options.shownFromProject = true;
    options.texts.emplace(path, std::make_shared<const std::string>(text));
    Result<std::shared_ptr<const LoadedProject>> loaded = m_application.open(path, options);
    if (!loaded) return loaded.error();
    start(path, name, std::move(loaded).value());
    return {};
}

// A mesh that an edit refers to for the first time, or that changed on disk, is read in a worker thread; then the texts are
// reloaded.
void Document::readNamed() {
    if (std::exchange(m_state->readsNamed, true)) return;
    OpenOptions options = optionsNow();
    options.meshesLater = false;
    m_state->reader.fillCaches(m_state->opened, std::move(options), [this](bool isCurrent) {
        m_state->readsNamed = false;
        if (isOpen() && (isCurrent || m_loaded->pending)) readAgain();
    });
}

void Document::close() { start({}, {}, nullptr); }

void Document::start(const std::string& path, const std::string& name, std::shared_ptr<const LoadedProject> loaded) {
    m_state->reader.cancel();
    m_state->journal.stop();
    m_state->opened = path;
    m_state->name = name;
    m_state->files.clear();
    m_history.clear();
    m_lastValid = nullptr;
    m_loaded = nullptr;
    ++m_revision;
    m_changes = ChangeSet(nullptr, loaded);
    if (loaded) adopt(std::move(loaded));
    m_state->reportedModified.clear();
    if (isOpen()) m_state->journal.start(journalFolder(), {m_state->opened, m_state->name});
    lock();
    Q_EMIT opened();
    notifyChanged();
    Q_EMIT historyChanged();
    Q_EMIT modifiedChanged();
}

void Document::adopt(std::shared_ptr<const LoadedProject> loaded) {
    m_loaded = std::move(loaded);
    if (!m_loaded->diagnostics.hasErrors()) m_lastValid = m_loaded;
    for (FileId file = 0; file < m_loaded->paths.size(); ++file) {
        const std::string& path = m_loaded->paths[file];
        if (!path.empty()) m_state->files.take(path, m_loaded->trees[file]->source().sharedBytes());
    }
    updateWatchedFiles();
    if (m_loaded->pending) readNamed();
}

void Document::setOptions(const OpenOptions& options) {
    m_options = options;
    m_options.texts.clear();
    m_options.sets.clear();
    m_options.previous = nullptr;
    readAgain();
}

void Document::readAgain() {
    if (!isOpen()) return;
    if (const Status read = put({}); !read) return;
    notifyChanged();
}

void Document::notifyChanged() {
    const ChangeSet changes = m_changes; // a copy: a slot may edit
    Q_EMIT changed(changes);
}

Result<std::shared_ptr<const LoadedProject>> Document::loadedWith(const FileTexts& texts) const {
    OpenOptions options = optionsNow();
    for (const auto& [file, text] : texts) options.texts.insert_or_assign(file, text);
    return m_application.open(m_state->opened, options);
}

Result<std::shared_ptr<const LoadedProject>> Document::loadedFrom(const std::string& file) const {
    OpenOptions options = optionsNow();
    options.previous = nullptr; // it belongs to another opened file
    return m_application.open(file, options);
}

std::string Document::path() const { return m_state->isNew() ? m_state->name : m_state->opened; }

bool Document::isNew() const { return m_state->isNew(); }

std::vector<std::string> Document::files() const {
    std::vector<std::string> files;
    if (!m_loaded) return files;
    for (const std::string& path : m_loaded->paths)
        if (!path.empty()) files.push_back(path);
    return files;
}

SharedText Document::text(const std::string& file) const {
    return m_state->files.text(m_state->isNew() && file == m_state->name ? m_state->opened : file);
}

std::string Document::shown(const std::string& file) const {
    if (m_state->isNew() && file == m_state->opened) return m_state->name;
    return m_loaded ? shownInProject(file, m_loaded->projectFolder) : file;
}

bool Document::isSample(const std::string& file) const {
    const std::string& folder = m_application.locations().configs;
    return !folder.empty() && canonicalPath(file).starts_with(canonicalPath(folder) + "/");
}

} // namespace trundle
