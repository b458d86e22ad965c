#include "project/saving/project_save.h"

#include <chrono>
#include <filesystem>

#include "base/platform/atomic_file.h"
#include "base/platform/file_lock.h"
#include "base/platform/read_file.h"
#include "project/loading/search.h"
#include "project/saving/file_transaction.h"
#include "project/saving/save_plan.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

/// `trundle-cli edit` locks a file only while it reads and writes it.
constexpr std::chrono::seconds kLockTimeout(2);

Error unwritable(std::string why) { return {Code::FileUnwritable, std::move(why)}; }

/// Saves a file at its path; a file that an edit created is removed once its text is empty.
Status writeFile(FileTransaction& writing, const std::string& path, const OpenFile& file) {
    if (file.isRemoved()) return writing.remove(path);
    using MissingFolder = FileTransaction::MissingFolder;
    return writing.write(path, *file.text, file.made ? MissingFolder::Create : MissingFolder::Fail);
}

} // namespace

Status ProjectSave::save(const Paths& modified) {
    const Result<std::vector<FileLock>> locks = FileLock::takeAll(modified, kLockTimeout);
    if (!locks) return locks.error();
    if (Status writable = checkWritable(modified); !writable) return writable;
    m_environment.writeJournal();
    if (Status written = writeModified(modified); !written) return written;
    markSaved(modified);
    return {};
}

Status ProjectSave::saveAs(const SavePlan& plan) {
    const Paths staying = stayingFiles(plan);
    Paths replaced = staying;
    for (const auto& [from, to] : plan.moves)
        if (from == to) replaced.push_back(from);
    const Result<std::vector<FileLock>> locks = FileLock::takeAll(replaced, kLockTimeout);
    if (!locks) return locks.error();
    if (Status writable = checkWritable(replaced); !writable) return writable;
    m_environment.writeJournal();
    if (Status written = writeMoved(plan, staying); !written) return written;
    markSaved(staying);
    return {};
}

Status ProjectSave::checkWritable(const Paths& paths) {
    for (const std::string& path : paths) {
        if (Status writable = checkWritable(path); !writable) return writable;
    }
    return {};
}

Status ProjectSave::checkWritable(const std::string& path) {
    const std::string shown = m_environment.shown(path);
    if (m_environment.isSample(path))
        return unwritable(shown + " is a sample and cannot be overwritten, so nothing was saved; use Save As to store a copy "
                                  "beside your own file");
    if (!isInside(path, m_environment.folders))
        return unwritable(shown +
                          " is no longer in the project (it may be a symbolic link now), so nothing was saved; use Save As");
    if (Status unchanged = checkUnchanged(path); !unchanged) return unchanged;
    std::error_code none;
    if (fs::exists(path, none) && !isWritable(path))
        return unwritable(shown + " is not writable, so nothing was saved; use Save As");
    // Saving replaces a file by a new one in the same folder; for a symbolic link, in the folder of its target.
    const fs::path folder = fs::weakly_canonical(path, none).parent_path();
    if (fs::exists(folder, none) && !isWritable(folder.string()))
        return unwritable("the folder of " + shown + " is not writable, so nothing was saved; use Save As");
    return {};
}

/// Fails if the file has bytes on disk that were not loaded, after loading them.
Status ProjectSave::checkUnchanged(const std::string& path) {
    std::error_code none;
    if (fs::exists(path, none)) {
        Result<std::string> disk = readRegularFile(path);
        if (!disk) return disk.error();
        if (disk.value() != *m_files.find(path)->disk) {
            m_environment.loadExternalChange(path, std::make_shared<const std::string>(std::move(disk).value()));
            return unwritable(m_environment.shown(path) + " was changed by another program; review the change, then save again");
        }
    }
    if (m_files.find(path)->theirs)
        return unwritable(m_environment.shown(path) + " was changed by another program; choose which text to keep");
    return {};
}

Status ProjectSave::writeModified(const Paths& modified) {
    FileTransaction writing;
    for (const std::string& path : m_files.inWritingOrder()) {
        if (std::ranges::find(modified, path) == modified.end()) continue;
        if (Status written = writeFile(writing, path, *m_files.find(path)); !written) return writing.rollBack(written.error());
    }
    return {};
}

Status ProjectSave::writeMoved(const SavePlan& plan, const Paths& staying) {
    FileTransaction writing;
    Status status;
    const auto write = [&](const std::string& path) {
        status = writing.write(path, *plan.texts.at(path), FileTransaction::MissingFolder::Create);
    };
    for (const auto& [to, from] : plan.copies)
        if (status) status = writing.copy(from, to);
    for (const auto& [path, text] : plan.texts)
        if (status && path != plan.target) write(path);
    for (const std::string& path : staying)
        if (status) status = writeFile(writing, path, *m_files.find(path));
    if (status) write(plan.target); // the file that imports the others
    return status ? status : writing.rollBack(status.error());
}

/// The modified files that are written with the plan at their own path.
ProjectSave::Paths ProjectSave::stayingFiles(const SavePlan& plan) const {
    Paths staying;
    if (!plan.isInPlace()) return staying;
    for (const std::string& path : m_files.inWritingOrder())
        if (m_files.find(path)->modified() && !m_environment.isSample(path) && !plan.moves.contains(path))
            staying.push_back(path);
    return staying;
}

void ProjectSave::markSaved(const Paths& paths) {
    for (const std::string& path : paths) {
        OpenFile& file = *m_files.find(path);
        file.disk = file.text;
        file.gone = false;
    }
}

} // namespace trundle
