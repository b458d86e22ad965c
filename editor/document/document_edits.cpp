#include <algorithm>

#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "lang/tree_edit.h"
#include "project/set_path.h"

namespace trundle {

namespace {

/// Why the sets of a load cannot be: an error in what was typed, or one elsewhere that comes of it. "" where they can.
std::string reasonAgainstSets(const Loaded& loaded) {
    const TextSet& texts = loaded.outline->texts();
    std::string reason;
    for (const Diagnostic& d : loaded.diagnostics.all()) {
        if (d.severity != Severity::Error) continue;
        if (loaded.pending && d.code == Code::MeshUnreadable) continue; // not read yet; then it is said in the text
        if (texts.commandLine(d.range.file)) return d.message;
        const bool comesOfIt =
            std::ranges::any_of(d.notes, [&](const auto& note) { return texts.commandLine(note.second.file); });
        if (comesOfIt && reason.empty()) reason = d.message;
    }
    return reason;
}

} // namespace

Status Document::answer(Status status) {
    if (!status) Q_EMIT refused(QString::fromStdString(status.error().message));
    return status;
}

Status Document::mayEdit() const {
    if (!isOpen()) return Error{Code::Internal, "nothing is open"};
    if (isOpening()) return Error{Code::Internal, "another file is being opened"};
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyReason()};
    return {};
}

Status Document::put(const FileTexts& texts) {
    FileTexts before;
    for (const auto& [file, text] : texts) before.emplace(file, m_state->files.text(file));
    m_state->files.setTexts(texts);
    Result<std::shared_ptr<const Loaded>> loaded = m_parts.open(m_state->opened, optionsNow());
    if (!loaded) {
        m_state->files.setTexts(before);
        return loaded.error();
    }
    if (!texts.empty()) ++m_revision;
    adopt(std::move(loaded).value());
    return {};
}

Status Document::enter(const QString& name, FileTexts after, const std::string& mergeKey) {
    HistoryEntry entry{name, {}, {}, mergeKey};
    for (auto& [file, text] : after) {
        const SharedText before = m_state->files.text(file);
        if (!before) return Error{Code::Internal, file + " is no file of this project"};
        if (*before == *text) continue;
        entry.before.emplace(file, before);
        entry.after.emplace(file, std::move(text));
    }
    if (entry.after.empty()) return {};
    if (Status put = this->put(entry.after); !put) return put;
    m_history.push(std::move(entry));
    sayEdited();
    return {};
}

void Document::sayEdited() {
    Q_EMIT changed();
    Q_EMIT historyChanged();
    sayModified();
}

Result<FileTexts> Document::textsAfter(const FileEdits& edits) const {
    FileTexts after;
    for (const auto& [file, changes] : edits) {
        if (file >= m_loaded->paths.size() || m_loaded->paths[file].empty())
            return Error{Code::Internal, "an edit of a file that is not of this project"};
        const std::string& path = m_loaded->paths[file];
        Result<std::string> bytes = applyEdits(*m_state->files.text(path), changes);
        if (!bytes) return bytes.error();
        after.emplace(path, std::make_shared<const std::string>(std::move(bytes).value()));
    }
    return after;
}

Status Document::edit(const QString& name, const FileEdits& edits, const std::string& mergeKey) {
    if (Status may = mayEdit(); !may) return answer(may);
    Result<FileTexts> after = textsAfter(edits);
    return answer(after ? enter(name, std::move(after).value(), mergeKey) : Status(after.error()));
}

Status Document::replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey) {
    if (Status may = mayEdit(); !may) return answer(may);
    const std::string path = isNew() && file == m_state->name ? m_state->opened : file;
    return answer(enter(name, {{path, std::make_shared<const std::string>(std::move(bytes))}}, mergeKey));
}

Status Document::carryOut(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey) {
    if (!plan) return answer(plan.error());
    if (Status done = edit(name, plan.value().edits, mergeKey); !done) return done;
    Q_EMIT selectionWanted(plan.value().selects);
    return {};
}

Status Document::setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey) {
    if (Status may = mayEdit(); !may) return answer(may);
    OpenOptions options = optionsNow();
    for (const ValueEdit& value : values) options.sets.push_back(value.path + "=" + value.text);
    const Result<std::shared_ptr<const Loaded>> tried = m_parts.open(m_state->opened, options);
    if (!tried) return answer(tried.error());
    if (std::string reason = reasonAgainstSets(*tried.value()); !reason.empty())
        return answer(Error{Code::OutOfRange, std::move(reason)});
    return edit(name, editsForSets(*tried.value()), mergeKey);
}

void Document::endMerge() { m_history.endMerge(); }

void Document::undo() {
    if (m_history.canUndo()) moveTo(m_history.position() - 1);
}

void Document::redo() {
    if (m_history.canRedo()) moveTo(m_history.position() + 1);
}

void Document::moveTo(std::size_t position) {
    if (const Status may = mayEdit(); !may) {
        (void)answer(may);
        return;
    }
    const std::size_t before = m_history.position();
    if (std::min(position, m_history.entries().size()) == before) return;
    if (const Status moved = put(m_history.moveTo(position)); !moved) {
        (void)m_history.moveTo(before);
        (void)answer(moved);
        return;
    }
    sayEdited();
}

} // namespace trundle
