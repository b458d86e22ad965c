#include <algorithm>
#include <filesystem>

#include "control/directory_catalog.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "project/loading/search.h"
#include "project/saving/project_save.h"
#include "project/saving/save_plan.h"

namespace trundle {

namespace fs = std::filesystem;

bool Document::isModified() const { return !m_state->files.modified().empty(); }

bool Document::isRemoved(const std::string& file) const {
    const OpenFile* open = isOpen() ? m_state->files.find(file) : nullptr;
    return open && open->isRemoved();
}

bool Document::isModified(const std::string& file) const {
    const OpenFile* known = m_state->files.find(file);
    return known && known->modified();
}

std::vector<std::string> Document::modifiedFiles() const {
    std::vector<std::string> files = m_state->files.modified();
    const auto opened = std::ranges::find(files, m_state->opened);
    if (opened != files.end()) std::rotate(files.begin(), opened, opened + 1);
    return files;
}

void Document::notifyModified() {
    m_state->journal.later();
    const std::vector<std::string> modified = m_state->files.modified();
    std::set<std::string> now(modified.begin(), modified.end());
    if (now == m_state->reportedModified) return;
    m_state->reportedModified = std::move(now);
    Q_EMIT modifiedChanged();
}

std::vector<std::string> Document::modifiedSamples() const {
    std::vector<std::string> samples = m_state->files.modified();
    std::erase_if(samples, [&](const std::string& file) { return !isSample(file); });
    return samples;
}

SaveEnvironment Document::saveEnvironment() {
    SaveEnvironment environment;
    environment.folders = foldersOf(m_loaded->projectFolder);
    environment.isSample = [this](const std::string& path) { return isSample(path); };
    environment.shown = [this](const std::string& path) { return shown(path); };
    environment.loadExternalChange = [this](const std::string& path, SharedText bytes) {
        applyExternalChange(path, std::move(bytes));
    };
    environment.writeJournal = [this] { m_state->journal.writeNow(); };
    return environment;
}

Status Document::save() {
    if (!isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (isNew()) return Error{Code::FileUnwritable, m_state->name + " has no file yet; use Save As"};
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyMessage()};
    const Status saved = ProjectSave(m_state->files, saveEnvironment()).save();
    m_history.endMerge();
    notifyModified();
    m_state->journal.writeNow();
    return saved;
}

Status Document::checkSaveTarget(const std::string& target) const {
    if (!isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (isOpening()) return Error{Code::NoDocument, "another file is being opened"};
    if (isSample(target)) return Error{Code::FileUnwritable, "the samples cannot be overwritten"};
    if (target != m_state->opened && m_state->files.find(target))
        return Error{Code::FileUnwritable, shown(target) + " is a file of this project"};
    std::error_code none;
    if (!fs::is_directory(fs::path(target).parent_path(), none))
        return Error{Code::FileUnwritable, "there is no folder " + fs::path(target).parent_path().string()};
    return {};
}

Result<SavePlan> Document::planFor(const std::string& target, ModuleCopies modules) const {
    if (Status may = checkSaveTarget(target); !may) return may.error();
    const std::vector<std::string> samples = modifiedSamples();
    const auto load = [this](const std::string& path, const TextOverlay& texts) {
        OpenOptions options = optionsNow();
        options.previous = nullptr; // it belongs to another opened file
        for (const auto& [file, text] : texts) options.texts.insert_or_assign(file, text);
        return m_application.open(path, options);
    };
    DirectoryCatalog catalog({m_options.modules, m_application.locations().modules, {}, true}); // reads descriptions only
    return planSaveAs({load, catalog}, *m_loaded, target, {samples.begin(), samples.end()}, modules);
}

Result<Companions> Document::companionsAt(const std::string& path) const {
    const std::string target = canonicalPath(path);
    if (isOpen() && target == m_state->opened && modifiedSamples().empty()) return Companions{};
    Result<SavePlan> plan = planFor(target, ModuleCopies::Make);
    if (!plan) return plan.error();
    return std::move(std::move(plan).value().companions);
}

Status Document::saveAs(const std::string& path, ModuleCopies modules) {
    const std::string target = canonicalPath(path);
    if (isOpen() && target == m_state->opened && (isReadOnly() || modifiedSamples().empty())) return save();
    const Result<SavePlan> plan = planFor(target, modules);
    if (!plan) return plan.error();
    const bool hadErrors = m_loaded->diagnostics.hasErrors();
    if (Status saved = ProjectSave(m_state->files, saveEnvironment()).saveAs(plan.value()); !saved) return saved;
    if (Status followed = followMoves(plan.value()); !followed) return followed;
    notifyMoved(plan.value());
    if (!hadErrors && !m_loaded->pending && m_loaded->diagnostics.hasErrors()) // the text is saved nevertheless
        Q_EMIT notice(tr("Saved, but some references are not found from the new folder; see Problems"));
    return {};
}

Status Document::followMoves(const SavePlan& plan) {
    FileTexts imports; // texts whose imports were rewritten
    for (const auto& [from, to] : plan.moves) {
        if (*plan.texts.at(to) != *m_state->files.text(from)) imports.emplace(to, plan.texts.at(to));
        m_state->files.rename(from, to);
        m_history.renameFile(from, to);
    }
    m_state->opened = plan.target;
    m_state->name.clear();
    m_state->readOnly = false;
    for (const auto& [file, text] : imports) m_state->files.find(file)->disk = text;
    if (Status entered = enter(tr("Save As"), imports, {}); !entered) return entered;
    if (Status read = put({}); !read) return read;
    m_history.endMerge();
    lock();
    m_state->journal.start(journalFolder(), {m_state->opened, m_state->name});
    notifyEdited();
    return {};
}

void Document::notifyMoved(const SavePlan& save) {
    if (save.moves.size() == 1 && save.copies.empty()) return;
    QStringList names;
    for (const auto& [from, to] : save.moves)
        if (to != m_state->opened && to != from) names += QString::fromStdString(shown(to));
    for (const auto& [to, from] : save.copies) names += QString::fromStdString(shown(to));
    Q_EMIT notice(tr("Saved together with: %1").arg(names.join(u", "_qs)));
}

} // namespace trundle
