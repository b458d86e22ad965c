#include "editor/document/document_edits.h"

#include <algorithm>
#include <filesystem>

#include "base/platform/read_file.h"
#include "editor/document/document_state.h"
#include "editor/document/document_texts.h"
#include "editor/document/project_access.h"
#include "editor/document/selection.h"
#include "lang/tree_edit.h"
#include "project/edits/edit_target.h"
#include "project/loading/loader.h"
#include "project/loading/search.h"
#include "project/objects/object_location.h"

namespace trundle {

namespace {

/// Fails if a file that does not exist cannot be created in the project's folders.
Status checkCreatable(const std::string& path, const std::string& folder) {
    std::error_code none;
    if (canonicalPath(path) != path || !path.starts_with(canonicalPath(folder) + "/"))
        return Error{Code::EditRefused, path + " is no file of this project"};
    if (std::filesystem::exists(path, none)) return Error{Code::DuplicateName, path + " already exists"};
    return {};
}

} // namespace

DocumentEdits::DocumentEdits(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access)
    : m_state(state), m_texts(texts), m_loading(loading), m_access(access) {}

const History& DocumentEdits::history() const { return m_state.history; }

Status DocumentEdits::mayChange(const FileEdits& edits) const {
    for (const auto& [file, changes] : edits)
        if (!changes.empty() && isShippedFile(*m_state.loaded, file))
            return Error{Code::FileUnwritable, m_state.shown(m_state.loaded->paths[file]) +
                                                   " came with Trundle and is read-only; define your own in " +
                                                   m_state.shown(m_state.opened) + " under another name and use that instead"};
    return {};
}

Status DocumentEdits::enter(const QString& name, FileTexts after, const std::string& mergeKey, const Validator& validate) {
    HistoryEntry entry{name, {}, {}, mergeKey};
    for (auto& [file, text] : after) {
        const SharedText before = m_state.files.text(file);
        if (!before) return Error{Code::EditRefused, file + " is no file of this project"};
        if (*before == *text) continue;
        entry.before.emplace(file, before);
        entry.after.emplace(file, std::move(text));
    }
    if (entry.after.empty()) return {};
    if (Status put = m_loading.replace(entry.after, validate); !put) return put;
    if (!m_state.history.canDiscardMerge(mergeKey)) keepSelection();
    m_state.history.push(std::move(entry));
    notifyEdited();
    return {};
}

void DocumentEdits::notifyEdited() {
    m_loading.notifyChanged();
    Q_EMIT historyChanged();
    m_texts.checkModified();
}

Result<FileTexts> DocumentEdits::textsAfter(const FileEdits& edits) const {
    FileTexts after;
    for (const auto& [file, changes] : edits) {
        if (file >= m_state.loaded->paths.size() || m_state.loaded->paths[file].empty())
            return Error{Code::EditRefused, "an edit of a file that is not of this project"};
        const std::string& path = m_state.loaded->paths[file];
        Result<std::string> bytes = applyEdits(*m_state.files.text(path), changes);
        if (!bytes) return bytes.error();
        after.emplace(path, std::make_shared<const std::string>(std::move(bytes).value()));
    }
    return after;
}

Status DocumentEdits::edit(const QString& name, const FileEdits& edits, const std::string& mergeKey, const Validator& validate) {
    if (Status may = m_access.checkEditable(); !may) return m_state.report(may);
    if (Status may = mayChange(edits); !may) return m_state.report(may);
    Result<FileTexts> after = textsAfter(edits);
    return m_state.report(after ? enter(name, std::move(after).value(), mergeKey, validate) : Status(after.error()));
}

Status DocumentEdits::replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey) {
    if (Status may = m_access.checkEditable(); !may) return m_state.report(may);
    const std::string path = m_state.isNew() && file == m_state.name ? m_state.opened : file;
    const bool makes = !m_state.files.find(path);
    if (makes) {
        if (Status may = checkCreatable(path, m_state.loaded->projectFolder); !may) return m_state.report(may);
        m_state.files.make(path);
    }
    const Status entered = enter(name, {{path, std::make_shared<const std::string>(std::move(bytes))}}, mergeKey);
    if (makes && !entered) m_state.files.remove(path);
    return m_state.report(entered);
}

Status DocumentEdits::addText(const std::string& file) {
    if (m_state.files.find(file)) return {};
    if (!m_state.isOpen() || m_state.isNew() || m_state.isSample(file) || canonicalPath(file) != file ||
        !isInside(file, {m_state.loaded->projectFolder}))
        return Error{Code::FileUnreadable, m_state.shown(file) + " is no text of this project"};
    Result<std::string> bytes = readRegularFile(file, kMaxTextBytes);
    if (!bytes) return bytes.error();
    m_state.files.take(file, std::make_shared<const std::string>(std::move(bytes).value()));
    m_state.updateWatchedFiles();
    return {};
}

Status DocumentEdits::replaceTexts(const QString& name, const FileTexts& texts, const std::vector<std::string>& selects) {
    if (Status may = m_access.checkEditable(); !may) return m_state.report(may);
    for (const auto& [file, text] : texts)
        if (Status added = addText(file); !added) return m_state.report(added);
    if (Status entered = enter(name, texts, {}); !entered) return m_state.report(entered);
    if (!selects.empty()) Q_EMIT m_state.messages.selectionRequested(selects);
    return {};
}

Status DocumentEdits::apply(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey) {
    if (!plan) return m_state.report(plan.error());
    if (Status done = edit(name, plan.value().edits, mergeKey); !done) return done;
    Q_EMIT m_state.messages.selectionRequested(plan.value().selects);
    return {};
}

void DocumentEdits::endMerge() { m_state.history.endMerge(); }

void DocumentEdits::discardMerge(const std::string& mergeKey) {
    if (!m_state.history.canDiscardMerge(mergeKey)) return;
    const std::size_t before = m_state.history.position();
    const std::shared_ptr<const LoadedProject> was = m_state.loaded;
    if (const Status back = m_loading.replace(m_state.history.moveTo(before - 1)); !back) {
        (void)m_state.history.moveTo(before);
        (void)m_state.report(back);
        return;
    }
    m_state.history.dropDiscarded();
    notifyEdited();
    selectAgain(*was);
}

void DocumentEdits::undo() {
    if (m_state.history.canUndo()) moveTo(m_state.history.position() - 1);
}

void DocumentEdits::redo() {
    if (m_state.history.canRedo()) moveTo(m_state.history.position() + 1);
}

void DocumentEdits::moveTo(std::size_t position) {
    if (const Status may = m_access.checkEditable(); !may) {
        (void)m_state.report(may);
        return;
    }
    const std::size_t before = m_state.history.position();
    if (std::min(position, m_state.history.entries().size()) == before) return;
    keepSelection();
    const std::shared_ptr<const LoadedProject> was = m_state.loaded;
    if (const Status moved = m_loading.replace(m_state.history.moveTo(position)); !moved) {
        (void)m_state.history.moveTo(before);
        (void)m_state.report(moved);
        return;
    }
    notifyEdited();
    selectAgain(*was);
}

void DocumentEdits::keepSelection() {
    if (m_selection) m_selected[m_state.history.position()] = m_selection->paths();
}

std::vector<std::string> DocumentEdits::selectedPaths() const {
    return m_selection ? m_selection->paths() : std::vector<std::string>();
}

/// After a step of undo or redo from `was`: a rename takes the selection to the other name, and what appears again is selected if
/// it was when this position was left.
void DocumentEdits::selectAgain(const LoadedProject& was) {
    const auto then = m_selected.find(m_state.history.position());
    if (!m_selection || then == m_selected.end()) return;
    const auto exists = [](const LoadedProject& loaded, const std::string& path) { return placeOf(loaded, path).has_value(); };
    std::vector<std::string> paths = then->second;
    std::erase_if(paths, [&](const std::string& path) { return !exists(*m_state.loaded, path); });
    const bool lost =
        std::ranges::any_of(m_selection->paths(), [&](const std::string& p) { return !exists(*m_state.loaded, p); });
    const bool appears =
        m_selection->empty() && std::ranges::any_of(paths, [&](const std::string& p) { return !exists(was, p); });
    if (!paths.empty() && (lost || appears)) Q_EMIT m_state.messages.selectionRequested(paths);
}

} // namespace trundle
