// Document: the project lock (one window per project) and recovery of unsaved edits after a crash.

#include <algorithm>
#include <filesystem>

#include "base/clean_text.h"
#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
#include "editor/document/found_journals.h"
#include "editor/widgets/plain_text.h"
#include "lang/line_merge.h"
#include "project/journal/state_folder.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

bool isMissing(const std::string& path) {
    std::error_code none;
    return !std::filesystem::exists(path, none);
}

} // namespace

// Samples and new texts have their journals in the user's state folder, independent of the program folder and the working
// directory.
std::string Document::journalFolder() const {
    if (!isOpen() || isNew()) return userStateFolder() + "/new";
    return isSample(m_state->opened) ? userStateFolder() + "/samples" : m_loaded->projectFolder;
}

void Document::lock() {
    m_state->lock.reset(); // release it before locking again: it may be the same project
    QString holder;
    if (isOpen() && !isNew() && !isSample(m_state->opened)) {
        m_state->lock = std::make_unique<ProjectLock>(m_loaded->projectFolder, m_state->opened);
        if (!m_state->lock->taken()) holder = QString::fromStdString(m_state->lock->holder().description());
    }
    const bool was = std::exchange(m_state->readOnly, !holder.isEmpty());
    if (was || m_state->readOnly) Q_EMIT readOnlyChanged(holder);
}

bool Document::isReadOnly() const { return m_state->readOnly; }

std::string Document::readOnlyMessage() const {
    return "the project is open in " + m_state->lock->holder().description() + "; this window has it read-only";
}

void Document::requestProject() {
    if (!isReadOnly()) return;
    m_state->lock.reset();
    m_state->lock = std::make_unique<ProjectLock>(m_loaded->projectFolder, m_state->opened);
    if (!m_state->lock->taken()) return;
    editAnyway();
    Q_EMIT notice(tr("The other window closed this project: it can be edited here now."));
}

void Document::editAnyway() {
    if (!std::exchange(m_state->readOnly, false)) return;
    Q_EMIT readOnlyChanged({});
}

std::vector<Recovery> Document::recoveries() const {
    std::vector<Recovery> found = findRecoveries(journalFolder());
    std::erase_if(found, [](const Recovery& recovery) {
        for (const auto& [path, kept] : recovery.files) {
            const Result<std::string> disk = readRegularFile(path);
            const bool isRemoved = kept.isCreated && kept.text.empty() && isMissing(path);
            if (!isRemoved && (!disk || disk.value() != kept.text)) return false;
        }
        discardRecovery(recovery); // the journal has no unsaved edits
        return true;
    });
    return found;
}

namespace {

std::string listed(const std::vector<std::string>& paths) {
    std::string text;
    for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + path;
    return text;
}

/// A recovered text, merged with the content on disk where possible.
struct Recovered {
    SharedText text;
    SharedText theirs; ///< content on disk; set if it changed in the same lines
};

Recovered recoveredOver(const RecoveredText& kept, const std::string& disk) {
    const auto shared = [](std::string text) { return std::make_shared<const std::string>(std::move(text)); };
    if (disk == kept.base || disk == kept.text) return {shared(kept.text), nullptr};
    if (std::optional<std::string> merged = mergedByLines(kept.base, kept.text, disk))
        return {shared(std::move(*merged)), nullptr};
    return {shared(kept.text), shared(disk)};
}

} // namespace

std::string Document::recoveredText(const std::string& path, const RecoveredText& kept) {
    const Result<std::string> disk = readRegularFile(path);
    return *recoveredOver(kept, disk ? disk.value() : kept.base).text;
}

std::vector<std::string> Document::foldersOf(const std::string& project) const {
    std::vector<std::string> folders{project, m_application.locations().configs};
    folders.insert(folders.end(), m_options.includes.begin(), m_options.includes.end());
    return folders;
}

QString journalsNotRead(const Document& document) {
    if (!document.isOpen() || document.isNew() || document.isSample(document.path())) return {};
    const std::string& project = document.loaded()->projectFolder;
    if (journalsInProject(project).empty()) return {};
    return Document::tr(
               "%1 holds journals of unsaved edits, which an earlier version of Trundle left there, or which came with this "
               "folder. They are not restored, since a journal of another user could change any file of yours. If they "
               "are your own, move them to %2 and open this file again; if not, delete them.")
        .arg(shownLine(project + "/.trundle/journal"), shownLine(projectStateFolder(project) + "/journal"));
}

Status Document::openFor(const Recovery& recovery) {
    if (!recovery.head.name.empty()) {
        const auto text = recovery.files.find(recovery.head.opened);
        return openNew(recovery.head.name, text == recovery.files.end() ? std::string() : text->second.base);
    }
    if (isOpen() && !isNew() && m_state->opened == recovery.head.opened) return {};
    const auto text = recovery.files.find(recovery.head.opened);
    std::error_code none;
    if (std::filesystem::exists(recovery.head.opened, none) || text == recovery.files.end()) return open(recovery.head.opened);
    OpenOptions options = m_options; // the file is missing, but the journal has its text
    options.shownFromProject = true;
    options.texts.emplace(recovery.head.opened, std::make_shared<const std::string>(text->second.base));
    Result<std::shared_ptr<const LoadedProject>> loaded = m_application.open(recovery.head.opened, options);
    if (!loaded) return loaded.error();
    start(recovery.head.opened, {}, std::move(loaded).value());
    m_state->files.find(recovery.head.opened)->gone = true;
    return {};
}

bool Document::isReplacedBy(const Recovery& recovery) const {
    const bool same = recovery.head.name.empty() && !isNew() && m_state->opened == recovery.head.opened;
    return isOpen() && !same;
}

Status Document::recover(const Recovery& recovery) {
    const std::vector<std::string> folders = foldersOf(recovery.project), outside = filesOutside(recovery, folders);
    if (outside.size() == recovery.files.size() || !isInside(recovery.head.opened, folders))
        return reportFailure(Error{Code::FileUnwritable, "these edits are not restored: " + cleanLine(recovery.head.opened) +
                                                             " lies outside the project " + cleanLine(recovery.project)});
    if (Status opened = openFor(recovery); !opened) return reportFailure(opened);
    checkExternalChanges();
    FileTexts texts;
    std::vector<std::string> both;
    for (const auto& [path, kept] : recovery.files) {
        if (std::ranges::find(outside, path) != outside.end()) continue;
        if (!m_state->files.find(path)) { // imported only by the recovered text
            const Result<std::string> disk = readRegularFile(path);
            const bool isCreated = kept.isCreated && isMissing(path); // by an edit, and not on disk yet
            m_state->files.take(path, std::make_shared<const std::string>(disk        ? disk.value()
                                                                          : isCreated ? std::string()
                                                                                      : kept.base));
            m_state->files.find(path)->gone = !disk && !isCreated;
        }
        OpenFile& file = *m_state->files.find(path);
        file.made |= kept.isCreated;
        Recovered text = kept.isCreated && isMissing(path) ? Recovered{std::make_shared<const std::string>(kept.text), nullptr}
                                                           : recoveredOver(kept, *file.disk);
        if (text.theirs) {
            file.disk = std::make_shared<const std::string>(kept.base);
            file.theirs = text.theirs;
            both.push_back(path);
        }
        texts.emplace(path, std::move(text.text));
    }
    if (Status entered = enter(tr("Recovered"), std::move(texts), {}); !entered) return reportFailure(entered);
    m_state->journal.writeNow(); // before the old journal is deleted
    if (outside.empty()) discardRecovery(recovery);
    else Q_EMIT notice(tr("Not restored, as outside the project: %1").arg(shownLine(listed(outside))));
    notifyModified();
    for (const std::string& path : both) Q_EMIT diskChanged(QString::fromStdString(path));
    return {};
}

} // namespace trundle
