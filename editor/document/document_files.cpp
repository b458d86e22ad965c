#include <algorithm>
#include <chrono>
#include <filesystem>

#include <QFileInfo>

#include "base/platform/atomic_file.h"
#include "base/platform/file_lock.h"
#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "editor/document/save_plan.h"
#include "project/loading/search.h"

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

Status Document::checkWritable(const std::vector<std::string>& files) {
    for (const std::string& path : files) {
        if (isSample(path))
            return Error{Code::FileUnwritable, shown(path) + " is a sample and cannot be overwritten, so nothing was saved; " +
                                                   "use Save As to store a copy beside your own file"};
        if (!isInside(path, foldersOf(m_loaded->projectFolder)))
            return Error{Code::FileUnwritable,
                         shown(path) +
                             " is no longer in the project (it may be a symbolic link now), so nothing was saved; use Save As"};
        OpenFile& file = *m_state->files.find(path);
        std::error_code none;
        const bool exists = fs::exists(path, none);
        const Result<std::string> disk = exists ? readRegularFile(path) : Result<std::string>(std::string());
        if (!disk) return disk.error();
        if (exists && disk.value() != *file.disk) {
            applyExternalChange(path, std::make_shared<const std::string>(disk.value()));
            return Error{Code::FileUnwritable,
                         shown(path) + " was changed by another program; review the change, then save again"};
        }
        if (file.theirs)
            return Error{Code::FileUnwritable, shown(path) + " was changed by another program; choose which text to keep"};
        if (exists && !QFileInfo(QString::fromStdString(path)).isWritable())
            return Error{Code::FileUnwritable, shown(path) + " is not writable, so nothing was saved; use Save As"};
        // Saving replaces a file by a new one in the same folder; for a symbolic link, in the folder of its target.
        const QFileInfo folder(QString::fromStdString(fs::weakly_canonical(path, none).parent_path().string()));
        if (folder.exists() && !folder.isWritable())
            return Error{Code::FileUnwritable,
                         "the folder of " + shown(path) + " is not writable, so nothing was saved; " + "use Save As"};
    }
    return {};
}

namespace {

/// Writes files all or none: if one fails, rollBack() restores those written before. The caller writes the importing file
/// last.
class FileTransaction {
public:
    Status copy(const std::string& from, const std::string& to) {
        std::error_code failed;
        fs::create_directories(fs::path(to).parent_path(), failed);
        if (!fs::copy_file(from, to, failed)) {
            std::error_code none;
            if (failed != std::errc::file_exists) fs::remove(to, none); // remove an incomplete copy
            return Error{Code::FileUnwritable, from + " cannot be copied to " + to + ": " + failed.message()};
        }
        m_before.emplace_back(to, std::nullopt);
        return {};
    }
    Status write(const std::string& path, const std::string& bytes) {
        std::error_code none;
        Result<std::string> old = readRegularFile(path);
        if (!old && fs::exists(path, none)) return old.error();
        if (Status written = writeFileAtomically(path, bytes); !written) return written;
        m_before.emplace_back(path, old ? std::optional(std::move(old).value()) : std::nullopt);
        return {};
    }
    /// Saves a file of the document; a file that an edit created is removed once its text is empty.
    Status save(const std::string& path, const OpenFile& file) {
        if (file.isRemoved()) return remove(path);
        std::error_code failed; // ignored: the write below fails and reports why
        if (file.made) fs::create_directories(fs::path(path).parent_path(), failed);
        return write(path, *file.text);
    }
    Status remove(const std::string& path) {
        std::error_code failed;
        Result<std::string> old = readRegularFile(path);
        if (old && !fs::remove(path, failed))
            return Error{Code::FileUnwritable, path + " cannot be removed: " + failed.message()};
        if (old) m_before.emplace_back(path, std::move(old).value());
        return {};
    }
    /// Restores in reverse order, so that the older text fits on a full disk as it did before. Returns `why`, extended by
    /// every file that could not be restored.
    Error rollBack(Error why) {
        for (auto it = m_before.rbegin(); it != m_before.rend(); ++it) {
            const auto& [path, bytes] = *it;
            std::error_code failed;
            if (!bytes) fs::remove(path, failed);
            if (failed) why.message += "; " + path + " was created before it and cannot be removed: " + failed.message();
            const Status back = bytes ? writeFileAtomically(path, *bytes) : Status();
            if (!back) why.message += "; files already written cannot be restored: " + back.error().message;
        }
        return why;
    }

private:
    std::vector<std::pair<std::string, std::optional<std::string>>> m_before; // no bytes: the file did not exist
};

} // namespace

/// `trundle-cli edit` locks a file only while it reads and writes it.
static constexpr std::chrono::seconds kLockTimeout(2);

Status Document::save() {
    if (!isOpen()) return Error{Code::NoDocument, "nothing is open"};
    if (isNew()) return Error{Code::FileUnwritable, m_state->name + " has no file yet; use Save As"};
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyMessage()};
    const std::vector<std::string> modified = m_state->files.modified();
    const Result<std::vector<FileLock>> locks = FileLock::takeAll(modified, kLockTimeout);
    if (!locks) return locks.error();
    if (Status may = checkWritable(modified); !may) {
        notifyModified();
        return may;
    }
    m_state->journal.writeNow(); // if the process is killed now, nothing is left to restore
    FileTransaction writing;
    Status saved;
    for (const std::string& path : m_state->files.inWritingOrder())
        if (const OpenFile& file = *m_state->files.find(path); saved && file.modified()) saved = writing.save(path, file);
    if (!saved) saved = writing.rollBack(saved.error());
    for (const std::string& path : modified) {
        OpenFile& file = *m_state->files.find(path);
        if (saved) file.disk = file.text, file.gone = false;
    }
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

void Document::moveFile(const std::string& from, const std::string& to) {
    const OpenFile moved = *m_state->files.find(from);
    m_state->files.remove(from);
    m_state->files.take(to, *moved.text);
    m_state->files.find(to)->made |= moved.made;
    m_history.renameFile(from, to);
    if (m_state->opened == from) m_state->opened = to;
}

namespace {

/// `others`: files of the project that keep their path.
Status writeMoved(const SavePlan& save, const OpenFiles& files, const std::vector<std::string>& others, const std::string& last) {
    FileTransaction writing;
    Status status;
    const auto write = [&](const std::string& path) {
        std::error_code failed;
        fs::create_directories(fs::path(path).parent_path(), failed);
        return writing.write(path, *save.texts.at(path));
    };
    for (const auto& [to, from] : save.copies)
        if (status) status = writing.copy(from, to);
    for (const auto& [path, text] : save.texts)
        if (status && path != last) status = write(path);
    for (const std::string& path : others)
        if (status) status = writing.save(path, *files.find(path));
    if (status) status = write(last); // the file that imports the others
    return status ? status : writing.rollBack(status.error());
}

} // namespace

Result<SavePlan> Document::planFor(const std::string& target, ModuleCopies modules) const {
    if (Status may = checkSaveTarget(target); !may) return may.error();
    const std::vector<std::string> samples = modifiedSamples();
    return planSaveAs(m_application, *m_loaded, optionsNow(), target, {samples.begin(), samples.end()}, modules);
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
    const bool inPlace = isOpen() && target == m_state->opened;
    if (inPlace && (isReadOnly() || modifiedSamples().empty())) return save();
    const Result<SavePlan> plan = planFor(target, modules);
    if (!plan) return plan.error();
    const SavePlan& save = plan.value();
    std::vector<std::string> others; // they keep their path
    if (inPlace) {
        for (const std::string& file : m_state->files.inWritingOrder())
            if (isModified(file) && !isSample(file) && !save.moves.contains(file)) others.push_back(file);
        std::vector<std::string> own = others;
        for (const auto& [from, to] : save.moves)
            if (from == to) own.push_back(from);
        if (Status may = checkWritable(own); !may) return may;
        m_state->journal.writeNow(); // as in save()
    }
    const bool hadErrors = m_loaded->diagnostics.hasErrors();
    if (Status written = writeMoved(save, m_state->files, others, target); !written) return written;

    for (const std::string& path : others) {
        OpenFile& file = *m_state->files.find(path);
        file.disk = file.text, file.gone = false;
    }

    FileTexts imports; // texts whose imports were rewritten
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
    m_state->journal.start(journalFolder(), {m_state->opened, m_state->name});
    notifyEdited();
    if (save.moves.size() > 1 || !save.copies.empty()) notifyMoved(save);
    if (!hadErrors && !m_loaded->pending && m_loaded->diagnostics.hasErrors()) // the text is saved nevertheless
        Q_EMIT notice(tr("Saved, but some references are not found from the new folder; see Problems"));
    return {};
}

void Document::notifyMoved(const SavePlan& save) {
    QStringList names;
    for (const auto& [from, to] : save.moves)
        if (to != m_state->opened && to != from) names += QString::fromStdString(shown(to));
    for (const auto& [to, from] : save.copies) names += QString::fromStdString(shown(to));
    Q_EMIT notice(tr("Saved together with: %1").arg(names.join(u", "_qs)));
}

} // namespace trundle
