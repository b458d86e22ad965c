#include <algorithm>
#include <filesystem>

#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "editor/document/structure_edits.h"
#include "lang/tree_edit.h"
#include "project/edits/edit_target.h"
#include "project/loading/loader.h"
#include "project/loading/search.h"

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

Status Document::reportFailure(Status status) {
    if (!status) Q_EMIT refused(QString::fromStdString(status.error().message));
    return status;
}

Status Document::checkEditable() {
    if (!isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (isOpening()) return Error{Code::NoDocument, "another file is being opened"};
    requestProject();
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyMessage()};
    return {};
}

Status Document::mayChange(const FileEdits& edits) const {
    for (const auto& [file, changes] : edits)
        if (!changes.empty() && isShippedFile(*m_loaded, file))
            return Error{Code::FileUnwritable, shown(m_loaded->paths[file]) +
                                                   " came with Trundle and is read-only; define your own in " +
                                                   shown(m_state->opened) + " under another name and use that instead"};
    return {};
}

Status Document::put(const FileTexts& texts, const Validator& validate) {
    FileTexts before;
    for (const auto& [file, text] : texts) before.emplace(file, m_state->files.text(file));
    m_state->files.setTexts(texts);
    Result<std::shared_ptr<const LoadedProject>> loaded = m_application.open(m_state->opened, optionsNow());
    if (!loaded) {
        m_state->files.setTexts(before);
        return loaded.error();
    }
    // Without new texts, what they refer to has changed: modules, meshes or folders.
    ChangeSet changes = texts.empty() ? ChangeSet::ofEverything(m_loaded, loaded.value()) : ChangeSet(m_loaded, loaded.value());
    if (std::string reason = validate ? validate(changes) : std::string(); !reason.empty()) {
        m_state->files.setTexts(before);
        return Error{Code::OutOfRange, std::move(reason)};
    }
    m_changes = std::move(changes);
    if (!texts.empty()) ++m_revision;
    adopt(std::move(loaded).value());
    return {};
}

Status Document::enter(const QString& name, FileTexts after, const std::string& mergeKey, const Validator& validate) {
    HistoryEntry entry{name, {}, {}, mergeKey};
    for (auto& [file, text] : after) {
        const SharedText before = m_state->files.text(file);
        if (!before) return Error{Code::EditRefused, file + " is no file of this project"};
        if (*before == *text) continue;
        entry.before.emplace(file, before);
        entry.after.emplace(file, std::move(text));
    }
    if (entry.after.empty()) return {};
    if (Status put = this->put(entry.after, validate); !put) return put;
    m_history.push(std::move(entry));
    notifyEdited();
    return {};
}

void Document::notifyEdited() {
    notifyChanged();
    Q_EMIT historyChanged();
    notifyModified();
}

Result<FileTexts> Document::textsAfter(const FileEdits& edits) const {
    FileTexts after;
    for (const auto& [file, changes] : edits) {
        if (file >= m_loaded->paths.size() || m_loaded->paths[file].empty())
            return Error{Code::EditRefused, "an edit of a file that is not of this project"};
        const std::string& path = m_loaded->paths[file];
        Result<std::string> bytes = applyEdits(*m_state->files.text(path), changes);
        if (!bytes) return bytes.error();
        after.emplace(path, std::make_shared<const std::string>(std::move(bytes).value()));
    }
    return after;
}

Status Document::edit(const QString& name, const FileEdits& edits, const std::string& mergeKey, const Validator& validate) {
    if (Status may = checkEditable(); !may) return reportFailure(may);
    if (Status may = mayChange(edits); !may) return reportFailure(may);
    Result<FileTexts> after = textsAfter(edits);
    return reportFailure(after ? enter(name, std::move(after).value(), mergeKey, validate) : Status(after.error()));
}

Status Document::replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey) {
    if (Status may = checkEditable(); !may) return reportFailure(may);
    const std::string path = isNew() && file == m_state->name ? m_state->opened : file;
    const bool makes = !m_state->files.find(path);
    if (makes) {
        if (Status may = checkCreatable(path, m_loaded->projectFolder); !may) return reportFailure(may);
        m_state->files.make(path);
    }
    const Status entered = enter(name, {{path, std::make_shared<const std::string>(std::move(bytes))}}, mergeKey);
    if (makes && !entered) m_state->files.remove(path);
    return reportFailure(entered);
}

Status Document::addText(const std::string& file) {
    if (m_state->files.find(file)) return {};
    if (!isOpen() || isNew() || isSample(file) || canonicalPath(file) != file || !isInside(file, {m_loaded->projectFolder}))
        return Error{Code::FileUnreadable, shown(file) + " is no text of this project"};
    Result<std::string> bytes = readRegularFile(file, kMaxTextBytes);
    if (!bytes) return bytes.error();
    m_state->files.take(file, std::make_shared<const std::string>(std::move(bytes).value()));
    updateWatchedFiles();
    return {};
}

Status Document::replaceTexts(const QString& name, const FileTexts& texts, const std::vector<std::string>& selects) {
    if (Status may = checkEditable(); !may) return reportFailure(may);
    for (const auto& [file, text] : texts)
        if (Status added = addText(file); !added) return reportFailure(added);
    if (Status entered = enter(name, texts, {}); !entered) return reportFailure(entered);
    if (!selects.empty()) Q_EMIT selectionRequested(selects);
    return {};
}

Status Document::apply(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey) {
    if (!plan) return reportFailure(plan.error());
    if (Status done = edit(name, plan.value().edits, mergeKey); !done) return done;
    Q_EMIT selectionRequested(plan.value().selects);
    return {};
}

Status Document::setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey) {
    return structure().setValues(name, values, mergeKey);
}

StructureEdits& Document::structure() {
    if (!m_state->structure) m_state->structure = std::make_shared<StructureEdits>(*this);
    return *m_state->structure;
}

void Document::endMerge() { m_history.endMerge(); }

void Document::discardMerge(const std::string& mergeKey) {
    if (!m_history.canDiscardMerge(mergeKey)) return;
    const std::size_t before = m_history.position();
    if (const Status back = put(m_history.moveTo(before - 1)); !back) {
        (void)m_history.moveTo(before);
        (void)reportFailure(back);
        return;
    }
    m_history.dropDiscarded();
    notifyEdited();
}

void Document::undo() {
    if (m_history.canUndo()) moveTo(m_history.position() - 1);
}

void Document::redo() {
    if (m_history.canRedo()) moveTo(m_history.position() + 1);
}

void Document::moveTo(std::size_t position) {
    if (const Status may = checkEditable(); !may) {
        (void)reportFailure(may);
        return;
    }
    const std::size_t before = m_history.position();
    if (std::min(position, m_history.entries().size()) == before) return;
    if (const Status moved = put(m_history.moveTo(position)); !moved) {
        (void)m_history.moveTo(before);
        (void)reportFailure(moved);
        return;
    }
    notifyEdited();
}

} // namespace trundle
