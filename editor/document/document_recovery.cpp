#include "editor/document/document_recovery.h"

#include <algorithm>
#include <filesystem>

#include "base/clean_text.h"
#include "base/platform/read_file.h"
#include "editor/document/document_edits.h"
#include "editor/document/document_state.h"
#include "editor/document/document_texts.h"
#include "editor/document/external_changes.h"
#include "editor/document/project_opening.h"
#include "editor/widgets/plain_text.h"
#include "lang/line_merge.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

bool isMissing(const std::string& path) {
    std::error_code none;
    return !std::filesystem::exists(path, none);
}

} // namespace

DocumentRecovery::DocumentRecovery(DocumentState& state, DocumentTexts& texts, DocumentEdits& edits, ExternalChanges& disk,
                                   ProjectOpening& opening)
    : m_state(state), m_texts(texts), m_edits(edits), m_disk(disk), m_opening(opening) {}

std::vector<Recovery> DocumentRecovery::recoveries() const {
    std::vector<Recovery> found = findRecoveries(m_state.journalFolder());
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

std::string DocumentRecovery::recoveredText(const std::string& path, const RecoveredText& kept) {
    const Result<std::string> disk = readRegularFile(path);
    return *recoveredOver(kept, disk ? disk.value() : kept.base).text;
}

std::vector<std::string> DocumentRecovery::foldersOf(const std::string& project) const {
    std::vector<std::string> folders{project, m_state.application.locations().configs};
    folders.insert(folders.end(), m_state.options.includes.begin(), m_state.options.includes.end());
    return folders;
}

Status DocumentRecovery::openFor(const Recovery& recovery) {
    if (!recovery.head.name.empty()) {
        const auto text = recovery.files.find(recovery.head.opened);
        return m_opening.openNew(recovery.head.name, text == recovery.files.end() ? std::string() : text->second.base);
    }
    if (m_state.isOpen() && !m_state.isNew() && m_state.opened == recovery.head.opened) return {};
    const auto text = recovery.files.find(recovery.head.opened);
    std::error_code none;
    if (std::filesystem::exists(recovery.head.opened, none) || text == recovery.files.end())
        return m_opening.open(recovery.head.opened);
    return m_opening.openMissing(recovery.head.opened, text->second.base); // the journal has its text
}

bool DocumentRecovery::isReplacedBy(const Recovery& recovery) const {
    const bool same = recovery.head.name.empty() && !m_state.isNew() && m_state.opened == recovery.head.opened;
    return m_state.isOpen() && !same;
}

Status DocumentRecovery::recover(const Recovery& recovery) {
    const std::vector<std::string> folders = foldersOf(recovery.project), outside = filesOutside(recovery, folders);
    if (outside.size() == recovery.files.size() || !isInside(recovery.head.opened, folders))
        return m_state.report(Error{Code::FileUnwritable, "these edits are not restored: " + cleanLine(recovery.head.opened) +
                                                              " lies outside the project " + cleanLine(recovery.project)});
    if (Status opened = openFor(recovery); !opened) return m_state.report(opened);
    m_disk.check();
    FileTexts texts;
    std::vector<std::string> both;
    for (const auto& [path, kept] : recovery.files) {
        if (std::ranges::find(outside, path) != outside.end()) continue;
        if (!m_state.files.find(path)) { // imported only by the recovered text
            const Result<std::string> disk = readRegularFile(path);
            const bool isCreated = kept.isCreated && isMissing(path); // by an edit, and not on disk yet
            m_state.files.take(path, std::make_shared<const std::string>(disk        ? disk.value()
                                                                         : isCreated ? std::string()
                                                                                     : kept.base));
            m_state.files.find(path)->gone = !disk && !isCreated;
        }
        OpenFile& file = *m_state.files.find(path);
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
    if (Status entered = m_edits.enter(tr("Recovered"), std::move(texts)); !entered) return m_state.report(entered);
    m_state.journal.writeNow(); // before the old journal is deleted
    if (outside.empty()) discardRecovery(recovery);
    else Q_EMIT m_state.messages.notice(tr("Not restored, as outside the project: %1").arg(shownLine(listed(outside))));
    m_texts.checkModified();
    for (const std::string& path : both) Q_EMIT m_disk.conflictFound(QString::fromStdString(path));
    return {};
}

} // namespace trundle
