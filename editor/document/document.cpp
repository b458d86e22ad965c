#include "editor/document/document.h"

#include <filesystem>

#include <QTimer>

#include "editor/document/document_state.h"
#include "project/search.h"
#include "project/state_folder.h"

namespace trundle {

namespace fs = std::filesystem;

Document::Document(Parts& parts, QObject* parent) : QObject(parent), m_parts(parts), m_state(std::make_unique<State>()) {
    m_state->structure = std::make_unique<StructureEdits>(*this);
    m_state->pool.setMaxThreadCount(4); // a file that is slow to read does not keep the next one waiting
    connect(&m_state->watch, &DiskWatch::touched, this, &Document::lookAtDisk);
    connect(&m_state->journal, &JournalKeeper::failed, this,
            [this](const QString& reason) { Q_EMIT notice(tr("Unsaved edits are not kept against a crash: %1").arg(reason)); });
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
    Result<std::shared_ptr<const Loaded>> loaded = m_parts.open(absolute, options);
    if (!loaded) return loaded.error();
    start(absolute, {}, std::move(loaded).value());
    return {};
}

void Document::openLater(const std::string& path) {
    const std::string absolute = canonicalPath(path);
    m_opening = absolute;
    OpenOptions options = m_options;
    options.shownFromProject = true;
    m_state->pool.start([this, absolute, options, opening = ++m_state->openings] {
        auto loaded = m_parts.open(absolute, options);
        const auto deliver = [this, absolute, opening, loaded = std::move(loaded)] {
            if (opening != m_state->openings) return;
            if (!loaded) {
                m_opening.clear();
                Q_EMIT openFailed(QString::fromStdString(absolute), QString::fromStdString(loaded.error().message));
                return;
            }
            Q_EMIT aboutToOpen();
            const auto begin = [this, absolute, opening, loaded] {
                if (opening == m_state->openings) start(absolute, {}, loaded.value());
            };
            QTimer::singleShot(1, this, begin); // one of 0 is a posted event: no mouse, no key would come between
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

void Document::cancelOpening() {
    ++m_state->openings;
    m_opening.clear();
    Q_EMIT openingCancelled();
    lookAtDisk(); // that was put off
}

Status Document::openNew(const std::string& name, const std::string& text) {
    if (name.empty() || name.find('/') != std::string::npos) return Error{Code::Internal, "a new text needs a plain file name"};
    const std::string path = canonicalPath(userStateFolder() + "/new/" + name);
    OpenOptions options = m_options;
    options.shownFromProject = true;
    options.texts.emplace(path, std::make_shared<const std::string>(text));
    Result<std::shared_ptr<const Loaded>> loaded = m_parts.open(path, options);
    if (!loaded) return loaded.error();
    start(path, name, std::move(loaded).value());
    return {};
}

// A mesh that an edit names for the first time, or that is another one now, is read in a thread; then the texts are read again.
void Document::readNamed() {
    if (std::exchange(m_state->readsNamed, true)) return;
    OpenOptions options = optionsNow();
    options.meshesLater = false;
    m_state->pool.start([this, path = m_state->opened, options = std::move(options), opening = m_state->openings] {
        (void)m_parts.open(path, options); // what it read is kept
        const auto deliver = [this, opening] {
            m_state->readsNamed = false;
            if (isOpen() && (opening == m_state->openings || m_loaded->pending)) readAgain();
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

void Document::close() { start({}, {}, nullptr); }

void Document::start(const std::string& path, const std::string& name, std::shared_ptr<const Loaded> loaded) {
    ++m_state->openings;
    m_opening.clear();
    m_state->journal.stop();
    m_state->opened = path;
    m_state->name = name;
    m_state->files.clear();
    m_history.clear();
    m_lastGood = nullptr;
    m_loaded = nullptr;
    ++m_revision;
    if (loaded) adopt(std::move(loaded));
    m_state->saidModified.clear();
    if (isOpen()) m_state->journal.start(workPlace(), {m_state->opened, m_state->name});
    lock();
    Q_EMIT opened();
    Q_EMIT changed();
    Q_EMIT historyChanged();
    Q_EMIT modifiedChanged();
}

void Document::adopt(std::shared_ptr<const Loaded> loaded) {
    m_loaded = std::move(loaded);
    if (!m_loaded->diagnostics.hasErrors()) m_lastGood = m_loaded;
    for (FileId file = 0; file < m_loaded->paths.size(); ++file) {
        const std::string& path = m_loaded->paths[file];
        if (!path.empty()) m_state->files.take(path, m_loaded->trees[file]->source().bytes());
    }
    sayWatched();
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
    Q_EMIT changed();
}

StructureEdits& Document::structure() const { return *m_state->structure; }

Result<std::shared_ptr<const Loaded>> Document::loadedWith(const FileTexts& texts) const {
    OpenOptions options = optionsNow();
    for (const auto& [file, text] : texts) options.texts.insert_or_assign(file, text);
    return m_parts.open(m_state->opened, options);
}

Result<std::shared_ptr<const Loaded>> Document::loadedFrom(const std::string& file) const {
    OpenOptions options = optionsNow();
    options.previous = nullptr; // of another opened file
    return m_parts.open(file, options);
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
    const std::string& folder = m_parts.locations().configs;
    return !folder.empty() && canonicalPath(file).starts_with(canonicalPath(folder) + "/");
}

} // namespace trundle
