#include "editor/document/document_loading.h"

#include <utility>

#include "editor/document/document_state.h"

namespace trundle {

OpenOptions DocumentLoading::optionsNow() const {
    OpenOptions options = m_state.options;
    options.texts = m_state.files.texts();
    options.previous = m_state.loaded;
    options.shownFromProject = true;
    options.meshesLater = true;
    return options;
}

Result<DocumentLoading::Loaded> DocumentLoading::with(const TextOverlay& texts) const {
    OpenOptions options = optionsNow();
    for (const auto& [file, text] : texts) options.texts.insert_or_assign(file, text);
    return m_state.application.open(m_state.opened, options);
}

Result<DocumentLoading::Loaded> DocumentLoading::from(const std::string& file, const TextOverlay& texts) const {
    OpenOptions options = optionsNow();
    options.previous = nullptr; // it belongs to another opened file
    for (const auto& [path, text] : texts) options.texts.insert_or_assign(path, text);
    return m_state.application.open(file, options);
}

Status DocumentLoading::replace(const TextOverlay& texts, const Validator& validate) {
    TextOverlay before;
    for (const auto& [file, text] : texts) before.emplace(file, m_state.files.text(file));
    m_state.files.setTexts(texts);
    Result<std::shared_ptr<const LoadedProject>> loaded = m_state.application.open(m_state.opened, optionsNow());
    if (!loaded) {
        m_state.files.setTexts(before);
        return loaded.error();
    }
    // Without new texts, what they refer to has changed: modules, meshes or folders.
    ChangeSet changes =
        texts.empty() ? ChangeSet::ofEverything(m_state.loaded, loaded.value()) : ChangeSet(m_state.loaded, loaded.value());
    if (std::string reason = validate ? validate(changes) : std::string(); !reason.empty()) {
        m_state.files.setTexts(before);
        return Error{Code::OutOfRange, std::move(reason)};
    }
    m_state.changes = std::move(changes);
    if (!texts.empty()) ++m_state.revision;
    adopt(std::move(loaded).value());
    return {};
}

void DocumentLoading::readAgain() {
    if (!m_state.isOpen()) return;
    if (const Status read = replace({}); !read) return;
    notifyChanged();
}

void DocumentLoading::adopt(Loaded loaded) {
    m_state.loaded = std::move(loaded);
    if (!m_state.loaded->diagnostics.hasErrors()) m_state.lastValid = m_state.loaded;
    for (FileId file = 0; file < m_state.loaded->paths.size(); ++file) {
        const std::string& path = m_state.loaded->paths[file];
        if (!path.empty()) m_state.files.take(path, m_state.loaded->trees[file]->source().sharedBytes());
    }
    m_state.updateWatchedFiles();
    if (m_state.loaded->pending) readNamed();
}

// A mesh that an edit refers to for the first time, or that changed on disk, is read in a worker thread; then the texts are
// reloaded.
void DocumentLoading::readNamed() {
    if (std::exchange(m_readsNamed, true)) return;
    OpenOptions options = optionsNow();
    options.meshesLater = false;
    m_state.reader.fillCaches(m_state.opened, std::move(options), [this](bool isCurrent) {
        m_readsNamed = false;
        if (m_state.isOpen() && (isCurrent || m_state.loaded->pending)) readAgain();
    });
}

void DocumentLoading::notifyChanged() {
    const ChangeSet changes = std::exchange(m_state.changes, {}); // a slot may edit; the texts before the edit are not kept
    Q_EMIT changed(changes);
}

} // namespace trundle
