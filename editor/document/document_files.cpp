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
#include "project/search.h"

namespace trundle {

namespace fs = std::filesystem;

bool Document::isModified() const { return !m_state->files.modified().empty(); }

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

void Document::sayModified() {
    m_state->journal.later();
    const std::vector<std::string> modified = m_state->files.modified();
    std::set<std::string> now(modified.begin(), modified.end());
    if (now == m_state->saidModified) return;
    m_state->saidModified = std::move(now);
    Q_EMIT modifiedChanged();
}

std::vector<std::string> Document::modifiedSamples() const {
    std::vector<std::string> samples = m_state->files.modified();
    std::erase_if(samples, [&](const std::string& file) { return !isSample(file); });
    return samples;
}

Status Document::mayWrite(const std::vector<std::string>& files) {
    for (const std::string& path : files) {
        if (isSample(path))
            return Error{Code::FileUnwritable, shown(path) + " came with the program and stays as it is, so nothing was saved; " +
                                                   "use Save As: it puts a copy of it beside your own file"};
        if (!liesInside(path, foldersOf(m_loaded->projectFolder)))
            return Error{Code::FileUnwritable,
                         shown(path) +
                             " is not in the project any more, perhaps a symbolic link now, so nothing was saved; use Save As"};
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
        if (exists && !QFileInfo(QString::fromStdString(path)).isWritable())
            return Error{Code::FileUnwritable, shown(path) + " may not be written, so nothing was saved; use Save As"};
        // A file is replaced by a new one beside it; of a link, beside what it leads to.
        const QFileInfo folder(QString::fromStdString(fs::weakly_canonical(path, none).parent_path().string()));
        if (folder.exists() && !folder.isWritable())
            return Error{Code::FileUnwritable,
                         "the folder of " + shown(path) + " may not be written, so nothing was saved; " + "use Save As"};
    }
    return {};
}

namespace {

/// All or none: what was written before one failed is as it was. The last one is written last.
class Writing {
public:
    Status copy(const std::string& from, const std::string& to) {
        std::error_code failed;
        fs::create_directories(fs::path(to).parent_path(), failed);
        if (!fs::copy_file(from, to, failed)) {
            std::error_code none;
            if (failed != std::errc::file_exists) fs::remove(to, none); // half of it may be there
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
    /// A file of the document: one that an edit created goes with its last text.
    Status save(const std::string& path, const OpenFile& file) {
        if (file.isRemoved()) return remove(path);
        std::error_code failed; // then it cannot be written, which says why
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
    /// The last one first: then there is room for each older text on a disk that is full, as there was before. Gives why all
    /// this was needed, and what is not as it was all the same.
    Error takeBack(Error why) {
        for (auto it = m_before.rbegin(); it != m_before.rend(); ++it) {
            const auto& [path, bytes] = *it;
            std::error_code failed;
            if (!bytes) fs::remove(path, failed);
            if (failed) why.message += "; " + path + " was made before it and cannot be removed: " + failed.message();
            const Status back = bytes ? writeFileAtomically(path, *bytes) : Status();
            if (!back) why.message += "; what was written before it cannot be taken back: " + back.error().message;
        }
        return why;
    }

private:
    std::vector<std::pair<std::string, std::optional<std::string>>> m_before; // no bytes: there was no such file
};

} // namespace

/// `trundle-cli edit` keeps a file for as long as it takes to read and write it.
static constexpr std::chrono::seconds kLockPatience(2);

Status Document::save() {
    if (!isOpen()) return Error{Code::Internal, "nothing is open"};
    if (isNew()) return Error{Code::FileUnwritable, m_state->name + " has no file yet; use Save As"};
    if (isReadOnly()) return Error{Code::FileUnwritable, readOnlyReason()};
    const std::vector<std::string> modified = m_state->files.modified();
    const Result<std::vector<FileLock>> locks = FileLock::takeAll(modified, kLockPatience);
    if (!locks) return locks.error();
    if (Status may = mayWrite(modified); !may) {
        sayModified();
        return may;
    }
    m_state->journal.writeNow(); // who is killed in between finds the bytes of the disk in the journal, and nothing to bring back
    Writing writing;
    Status saved;
    for (const std::string& path : m_state->files.inWritingOrder())
        if (const OpenFile& file = *m_state->files.find(path); saved && file.modified()) saved = writing.save(path, file);
    if (!saved) saved = writing.takeBack(saved.error());
    for (const std::string& path : modified) {
        OpenFile& file = *m_state->files.find(path);
        if (saved) file.disk = file.text, file.gone = false;
    }
    m_history.endMerge();
    sayModified();
    m_state->journal.writeNow();
    return saved;
}

Status Document::mayBecome(const std::string& target) const {
    if (!isOpen()) return Error{Code::Internal, "nothing is open"};
    if (isOpening()) return Error{Code::Internal, "another file is being opened"};
    if (isSample(target)) return Error{Code::FileUnwritable, "the samples that came with the program stay as they are"};
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

/// `others`: files of the project that stay where they are.
Status writeMoved(const SavePlan& save, const OpenFiles& files, const std::vector<std::string>& others, const std::string& last) {
    Writing writing;
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
    if (status) status = write(last); // the one that asks for the others
    return status ? status : writing.takeBack(status.error());
}

} // namespace

Result<SavePlan> Document::planFor(const std::string& target, ModuleCopies modules) const {
    if (Status may = mayBecome(target); !may) return may.error();
    const std::vector<std::string> samples = modifiedSamples();
    return planSaveAs(m_parts, *m_loaded, optionsNow(), target, {samples.begin(), samples.end()}, modules);
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
    std::vector<std::string> others; // that stay where they are
    if (inPlace) {
        for (const std::string& file : m_state->files.inWritingOrder())
            if (isModified(file) && !isSample(file) && !save.moves.contains(file)) others.push_back(file);
        std::vector<std::string> own = others;
        for (const auto& [from, to] : save.moves)
            if (from == to) own.push_back(from);
        if (Status may = mayWrite(own); !may) return may;
        m_state->journal.writeNow(); // as in save()
    }
    const bool hadErrors = m_loaded->diagnostics.hasErrors();
    if (Status written = writeMoved(save, m_state->files, others, target); !written) return written;

    for (const std::string& path : others) {
        OpenFile& file = *m_state->files.find(path);
        file.disk = file.text, file.gone = false;
    }

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
        if (to != m_state->opened && to != from) names += QString::fromStdString(shown(to));
    for (const auto& [to, from] : save.copies) names += QString::fromStdString(shown(to));
    Q_EMIT notice(tr("Saved with what it needs: %1").arg(names.join(u", "_qs)));
}

} // namespace trundle
