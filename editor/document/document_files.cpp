#include <algorithm>
#include <filesystem>

#include "base/platform/atomic_file.h"
#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "editor/document/save_plan.h"
#include "project/search.h"

namespace trundle {

namespace fs = std::filesystem;

bool Document::isModified() const { return !m_state->files.modified().empty(); }

bool Document::isModified(const std::string& file) const {
    const OpenFile* known = m_state->files.find(file);
    return known && known->modified();
}

void Document::sayModified() {
    m_state->journal.later();
    const std::vector<std::string> modified = m_state->files.modified();
    std::set<std::string> now(modified.begin(), modified.end());
    if (now == m_state->saidModified) return;
    m_state->saidModified = std::move(now);
    Q_EMIT modifiedChanged();
}

Status Document::saveFile(const std::string& path) {
    if (isSample(path))
        return Error{Code::FileUnwritable,
                     shown(path) + " came with the program and stays as it is; use Save As to keep your own"};
    OpenFile& file = *m_state->files.find(path);
    std::error_code none;
    const bool exists = fs::exists(path, none);
    const Result<std::string> disk = exists ? readRegularFile(path) : Result<std::string>(std::string());
    if (!disk) return disk.error();
    if (exists && disk.value() != *file.disk) {
        noteDisk(path, std::make_shared<const std::string>(disk.value()));
        return Error{Code::FileUnwritable,
                     shown(path) + " was changed by another program; look at what it wrote, then save again"};
    }
    if (file.theirs)
        return Error{Code::FileUnwritable, shown(path) + " was changed by another program; choose which text to keep"};
    if (Status written = writeFileAtomically(path, *file.text); !written) return written;
    file.disk = file.text;
    file.gone = false;
    return {};
}

Status Document::save() {
    if (!isOpen()) return Error{Code::Internal, "nothing is open"};
    if (isNew()) return Error{Code::FileUnwritable, m_state->name + " has no file yet; use Save As"};
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyReason()};
    m_state->journal.writeNow(); // who is killed in between finds the bytes of the disk in the journal, and nothing to bring back
    Status first;
    for (const std::string& path : m_state->files.modified())
        if (Status saved = saveFile(path); !saved && first) first = saved;
    m_history.endMerge();
    sayModified();
    m_state->journal.writeNow();
    return first;
}

Status Document::mayBecome(const std::string& target) const {
    if (!isOpen()) return Error{Code::Internal, "nothing is open"};
    if (isOpening()) return Error{Code::Internal, "another file is being opened"};
    if (isSample(target)) return Error{Code::FileUnwritable, "the samples that came with the program stay as they are"};
    if (m_state->files.find(target)) return Error{Code::FileUnwritable, shown(target) + " is a file of this project"};
    std::error_code none;
    if (!fs::is_directory(fs::path(target).parent_path(), none))
        return Error{Code::FileUnwritable, "there is no folder " + fs::path(target).parent_path().string()};
    return {};
}

void Document::moveFile(const std::string& from, const std::string& to) {
    const SharedText text = m_state->files.text(from);
    m_state->files.remove(from);
    m_state->files.take(to, *text);
    m_history.renameFile(from, to);
    if (m_state->opened == from) m_state->opened = to;
}

namespace {

/// All or none: what was written before one failed goes again.
Status writeMoved(const SavePlan& save, const std::string& last) {
    std::vector<std::string> made;
    const auto write = [&](const std::string& path, const std::string& bytes) -> Status {
        std::error_code failed;
        const bool existed = fs::exists(path, failed);
        fs::create_directories(fs::path(path).parent_path(), failed);
        if (Status written = writeFileAtomically(path, bytes); !written) return written;
        if (!existed) made.push_back(path);
        return {};
    };
    const auto copy = [&](const std::string& to, const std::string& from) -> Status {
        std::error_code failed;
        fs::create_directories(fs::path(to).parent_path(), failed);
        if (!fs::copy_file(from, to, failed))
            return Error{Code::FileUnwritable, from + " cannot be copied to " + to + ": " + failed.message()};
        made.push_back(to);
        return {};
    };
    const TextOverlay& texts = save.texts;
    Status status;
    for (const auto& [to, from] : save.copies)
        if (status) status = copy(to, from);
    for (const auto& [path, text] : texts)
        if (status && path != last) status = write(path, *text);
    if (status) status = write(last, *texts.at(last));
    std::error_code none;
    if (!status)
        for (const std::string& path : made) fs::remove(path, none);
    return status;
}

} // namespace

Result<SavePlan> Document::planFor(const std::string& target, ModuleCopies modules) const {
    if (Status may = mayBecome(target); !may) return may.error();
    std::set<std::string> mustMove;
    for (const std::string& file : m_state->files.modified())
        if (isSample(file)) mustMove.insert(file);
    return planSaveAs(m_parts, *m_loaded, optionsNow(), target, mustMove, modules);
}

Result<Companions> Document::companionsAt(const std::string& path) const {
    const std::string target = canonicalPath(path);
    if (isOpen() && target == m_state->opened) return Companions{};
    Result<SavePlan> plan = planFor(target, ModuleCopies::Make);
    if (!plan) return plan.error();
    return std::move(std::move(plan).value().companions);
}

Status Document::saveAs(const std::string& path, ModuleCopies modules) {
    const std::string target = canonicalPath(path);
    if (isOpen() && target == m_state->opened) return save();
    const Result<SavePlan> plan = planFor(target, modules);
    if (!plan) return plan.error();
    const SavePlan& save = plan.value();
    const bool hadErrors = m_loaded->diagnostics.hasErrors();
    if (Status written = writeMoved(save, target); !written) return written;

    FileTexts imports; // texts whose imports read otherwise now
    for (const auto& [from, to] : save.moves) {
        if (*save.texts.at(to) != *m_state->files.text(from)) imports.emplace(to, save.texts.at(to));
        moveFile(from, to);
    }
    m_state->name.clear();
    m_state->readOnly = false;
    for (const auto& [file, text] : imports) m_state->files.find(file)->disk = text;
    if (Status entered = enter(tr("Save As"), imports, {}); !entered) return entered;
    if (Status read = put({}); !read) return read;
    m_history.endMerge();
    lock();
    m_state->journal.start(workPlace(), {m_state->opened, m_state->name});
    sayEdited();
    if (save.moves.size() > 1 || !save.copies.empty()) sayMoved(save);
    if (!hadErrors && !m_loaded->pending && m_loaded->diagnostics.hasErrors()) // the text is saved all the same
        Q_EMIT notice(tr("Saved, but from there something is not found; see the problems"));
    return {};
}

void Document::sayMoved(const SavePlan& save) {
    QStringList names;
    for (const auto& [from, to] : save.moves)
        if (to != m_state->opened) names += QString::fromStdString(shown(to));
    for (const auto& [to, from] : save.copies) names += QString::fromStdString(shown(to));
    Q_EMIT notice(tr("Saved with what it needs: %1").arg(names.join(u", "_qs)));
}

} // namespace trundle
