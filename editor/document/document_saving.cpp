#include "editor/document/document_saving.h"

#include <algorithm>
#include <filesystem>

#include "control/directory_catalog.h"
#include "editor/document/document_edits.h"
#include "editor/document/document_loading.h"
#include "editor/document/document_recovery.h"
#include "editor/document/document_state.h"
#include "editor/document/document_texts.h"
#include "editor/document/external_changes.h"
#include "editor/document/project_access.h"
#include "editor/widgets/strings.h"
#include "project/loading/search.h"
#include "project/saving/project_save.h"
#include "project/saving/save_plan.h"

namespace trundle {

namespace fs = std::filesystem;

SaveEnvironment DocumentSaving::saveEnvironment() {
    SaveEnvironment environment;
    environment.folders = m_parts.recovery.foldersOf(m_state.loaded->projectFolder);
    environment.isSample = [this](const std::string& path) { return m_state.isSample(path); };
    environment.shown = [this](const std::string& path) { return m_state.shown(path); };
    environment.loadExternalChange = [this](const std::string& path, SharedText bytes) {
        m_parts.disk.apply(path, std::move(bytes));
    };
    environment.writeJournal = [this] { m_state.journal.writeNow(); };
    return environment;
}

Status DocumentSaving::save() {
    if (!m_state.isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (m_state.isNew()) return Error{Code::FileUnwritable, m_state.name + " has no file yet; use Save As"};
    return save(m_state.files.modified());
}

Status DocumentSaving::save(const std::vector<std::string>& modified) {
    if (!m_state.isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (m_parts.access.isReadOnly()) return Error{Code::FileUnwritable, m_parts.access.readOnlyMessage()};
    const Status saved = ProjectSave(m_state.files, saveEnvironment()).save(modified);
    m_state.history.endMerge();
    m_parts.texts.checkModified();
    m_state.journal.writeNow();
    return saved;
}

Status DocumentSaving::checkSaveTarget(const std::string& target) const {
    if (!m_state.isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (m_state.reader.isOpening()) return Error{Code::NoDocument, "another file is being opened"};
    if (m_state.isSample(target)) return Error{Code::FileUnwritable, "the samples cannot be overwritten"};
    if (target != m_state.opened && m_state.files.find(target))
        return Error{Code::FileUnwritable, m_state.shown(target) + " is a file of this project"};
    std::error_code none;
    if (!fs::is_directory(fs::path(target).parent_path(), none))
        return Error{Code::FileUnwritable, "there is no folder " + fs::path(target).parent_path().string()};
    return {};
}

Result<SavePlan> DocumentSaving::planFor(const std::string& target, ModuleCopies modules) const {
    if (Status may = checkSaveTarget(target); !may) return may.error();
    const std::vector<std::string> samples = m_parts.texts.modifiedSamples();
    const auto load = [this](const std::string& path, const TextOverlay& texts) { return m_parts.loading.from(path, texts); };
    DirectoryCatalog catalog(
        {m_state.options.modules, m_state.application.locations().modules, {}, true}); // reads descriptions only
    return planSaveAs({load, catalog}, *m_state.loaded, target, {samples.begin(), samples.end()}, modules);
}

Result<Companions> DocumentSaving::companionsAt(const std::string& path) const {
    const std::string target = canonicalPath(path);
    if (m_state.isOpen() && target == m_state.opened && m_parts.texts.modifiedSamples().empty()) return Companions{};
    Result<SavePlan> plan = planFor(target, ModuleCopies::Make);
    if (!plan) return plan.error();
    return std::move(std::move(plan).value().companions);
}

Status DocumentSaving::saveAs(const std::string& path, ModuleCopies modules) {
    const std::string target = canonicalPath(path);
    if (m_state.isOpen() && target == m_state.opened && (m_parts.access.isReadOnly() || m_parts.texts.modifiedSamples().empty()))
        return save();
    const Result<SavePlan> plan = planFor(target, modules);
    if (!plan) return plan.error();
    const bool hadErrors = m_state.loaded->diagnostics.hasErrors();
    if (Status saved = ProjectSave(m_state.files, saveEnvironment()).saveAs(plan.value()); !saved) return saved;
    if (Status followed = followMoves(plan.value()); !followed) return followed;
    notifyMoved(plan.value());
    if (!hadErrors && !m_state.loaded->pending && m_state.loaded->diagnostics.hasErrors()) // the text is saved nevertheless
        Q_EMIT m_state.messages.notice(tr("Saved, but some references are not found from the new folder; see Problems"));
    return {};
}

Status DocumentSaving::followMoves(const SavePlan& plan) {
    FileTexts imports; // texts whose imports were rewritten
    for (const auto& [from, to] : plan.moves) {
        if (*plan.texts.at(to) != *m_state.files.text(from)) imports.emplace(to, plan.texts.at(to));
        m_state.files.rename(from, to);
        m_state.history.renameFile(from, to);
    }
    m_state.opened = plan.target;
    m_state.name.clear();
    m_parts.access.forget();
    for (const auto& [file, text] : imports) m_state.files.find(file)->disk = text;
    if (Status entered = m_parts.edits.enter(tr("Save As"), imports); !entered) return entered;
    if (Status read = m_parts.loading.replace({}); !read) return read;
    m_state.history.endMerge();
    m_parts.access.lock();
    m_state.journal.start(m_state.journalFolder(), {m_state.opened, m_state.name});
    m_parts.edits.notifyEdited();
    return {};
}

void DocumentSaving::notifyMoved(const SavePlan& save) {
    if (save.moves.size() == 1 && save.copies.empty()) return;
    QStringList names;
    for (const auto& [from, to] : save.moves)
        if (to != m_state.opened && to != from) names += QString::fromStdString(m_state.shown(to));
    for (const auto& [to, from] : save.copies) names += QString::fromStdString(m_state.shown(to));
    Q_EMIT m_state.messages.notice(tr("Saved together with: %1").arg(names.join(u", "_qs)));
}

} // namespace trundle
