#include "project/journal/journal.h"

#include <atomic>
#include <chrono>
#include <filesystem>

#include "base/platform/process_identity.h"
#include "project/journal/journal_record.h"
#include "project/journal/state_folder.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSmallJournal = 1u << 20; ///< bytes; smaller files are not compacted

std::string now() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(since).count());
}

std::string headBytes(const JournalHead& head) {
    const ProcessIdentity self = thisProcess();
    return std::string(kJournalMark) +
           journalBytes(
               {JournalRecord::Head, {head.opened, head.name, std::to_string(self.pid), std::to_string(self.start), self.host}});
}

} // namespace

Journal::Journal(std::string projectFolder, JournalHead head)
    : m_projectFolder(std::move(projectFolder)), m_head(std::move(head)) {}

Journal::~Journal() = default;

Status Journal::makeFile() {
    static std::atomic<unsigned> counter{0};
    const std::string folder = projectStateFolder(m_projectFolder) + "/journal";
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return Error{Code::FileUnwritable, "no journal can be written in " + folder + ": " + failed.message()};
    for (int attempt = 0; attempt < 100; ++attempt) {
        const ProcessIdentity self = thisProcess();
        const std::string path = folder + "/" + std::to_string(self.pid) + "-" + std::to_string(self.start) + "-" +
                                 std::to_string(counter++) + ".journal";
        Result<LockedFile> made = LockedFile::make(path);
        if (!made && fs::exists(path, failed)) continue;
        if (!made) return made.error();
        m_file = std::make_shared<LockedFile>(std::move(made).value());
        m_bytes = 0;
        return append(headBytes(m_head));
    }
    return Error{Code::FileUnwritable, "a journal cannot be made in " + folder};
}

Status Journal::append(const std::string& record) {
    if (Status written = m_file->append(record); !written) return written;
    m_bytes += record.size();
    return {};
}

Result<std::uint64_t> Journal::begin(LockedFile& journal, const std::string& file, const JournaledText& journaled) {
    const std::string time = now();
    std::vector<std::string_view> fields{file, *journaled.base, time};
    if (journaled.isCreated) fields.push_back(kCreatedMark);
    const JournalPieces pieces(JournalRecord::Begin, fields);
    if (const Status written = journal.append(pieces.all()); !written) return written.error();
    return pieces.size();
}

std::string Journal::changeBytes(const std::string& file, const TextSplice& splice) {
    return journalBytes({JournalRecord::Change,
                         {file, std::to_string(splice.at), std::to_string(splice.removed.size()), splice.inserted, now()}});
}

Status Journal::note(const std::string& file, SharedText base, SharedText text, bool isCreated) {
    if (!m_file) {
        if (Status made = makeFile(); !made) return made;
    }
    const auto known = m_journaled.find(file);
    const bool begins = known == m_journaled.end() || *known->second.base != *base || known->second.isCreated != isCreated;
    const TextSplice splice = spliceBetween(begins ? *base : *known->second.text, *text);
    if (!begins && splice.empty()) return {};
    JournaledText journaled{std::move(base), std::move(text), isCreated};
    if (begins) {
        const Result<std::uint64_t> written = begin(*m_file, file, journaled);
        if (!written) return written.error();
        m_bytes += written.value();
    }
    if (Status written = append(changeBytes(file, splice)); !written) return written;
    m_journaled.insert_or_assign(file, std::move(journaled));
    return compact();
}

Status Journal::forget(const std::string& file) {
    if (m_journaled.erase(file) == 0) return {};
    if (m_journaled.empty()) {
        discard();
        return {};
    }
    return append(journalBytes({JournalRecord::Forget, {file}}));
}

// Keeps the file small: it is replaced by one that gives the same texts in fewer bytes.
Status Journal::compact() {
    std::uint64_t needed = kSmallJournal;
    for (const auto& [file, journaled] : m_journaled) needed += 2 * (journaled.base->size() + journaled.text->size());
    if (m_bytes <= 2 * needed) return {};
    const std::string path = m_file->path();
    Result<LockedFile> fresh = LockedFile::make(path + ".new");
    if (!fresh) return {}; // keep the current file
    LockedFile& file = fresh.value();
    const std::string head = headBytes(m_head);
    std::uint64_t bytes = head.size();
    bool isWhole = file.append(head).ok();
    for (const auto& [name, journaled] : m_journaled) {
        const Result<std::uint64_t> begun = begin(file, name, journaled);
        const std::string change = changeBytes(name, spliceBetween(*journaled.base, *journaled.text));
        isWhole = isWhole && begun && file.append(change);
        if (isWhole) bytes += begun.value() + change.size();
    }
    if (!isWhole || !file.sync() || !file.renameTo(path)) {
        file.remove();
        return {};
    }
    m_file = std::make_shared<LockedFile>(std::move(file));
    m_bytes = bytes;
    return {};
}

void Journal::discard() {
    m_journaled.clear();
    if (!m_file) return;
    const fs::path folder = fs::path(m_file->path()).parent_path();
    m_file->unlink(); // a thread may still be syncing it
    m_file.reset();
    std::error_code notEmpty;
    if (fs::remove(folder, notEmpty)) tidyWorkFolder(folder.parent_path().string());
}

} // namespace trundle
