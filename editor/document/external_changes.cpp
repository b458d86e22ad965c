#include "editor/document/external_changes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/platform/read_file.h"
#include "editor/document/document_edits.h"
#include "editor/document/document_loading.h"
#include "editor/document/document_state.h"
#include "editor/document/document_texts.h"
#include "editor/document/project_access.h"
#include "lang/line_merge.h"

namespace trundle {

namespace {

/// Whether the file has exactly these bytes. Reads in pieces, so that it is never in memory as a whole.
bool isOnDisk(const std::string& path, const std::string& bytes) {
    const Result<FileStamp> stamp = regularFileStamp(path);
    if (!stamp || stamp.value().size != bytes.size()) return false;
    std::ifstream file(path, std::ios::binary);
    char piece[65536];
    std::size_t at = 0;
    while (file.read(piece, sizeof piece), file.gcount() > 0) {
        const std::string_view read(piece, static_cast<std::size_t>(file.gcount()));
        if (std::string_view(bytes).substr(at, read.size()) != read) return false;
        at += read.size();
    }
    return at == bytes.size() && !file.bad();
}

constexpr std::size_t kLargeText = std::size_t(1) << 20; // bytes

} // namespace

ExternalChanges::ExternalChanges(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access,
                                 DocumentEdits& edits)
    : m_state(state), m_texts(texts), m_loading(loading), m_access(access), m_edits(edits) {
    connect(&m_state.watch, &DiskWatch::touched, this, &ExternalChanges::check);
}

void ExternalChanges::check() {
    if (!m_state.isOpen() || m_state.reader.isOpening()) return;
    m_access.request();
    std::vector<std::string> known;
    for (const auto& [path, file] : m_state.files.all())
        if (!m_state.isNew() || path != m_state.opened) known.push_back(path);
    for (const std::string& path : known) {
        OpenFile* file = m_state.files.find(path);
        if (!file) return; // a slot connected to the last notification has closed the project
        std::error_code none;
        if (!std::filesystem::exists(path, none)) {
            if (file->made && file->disk->empty()) continue; // it was never on disk
            if (!std::exchange(file->gone, true))
                Q_EMIT m_state.messages.notice(tr("%1 was deleted by another program; saving writes it again")
                                                   .arg(QString::fromStdString(m_state.shown(path))));
        } else if (file->disk->size() > kLargeText && !file->theirs && isOnDisk(path, *file->disk)) {
            file->gone = false;
        } else if (Result<std::string> bytes = readRegularFile(path); bytes) {
            apply(path, std::make_shared<const std::string>(std::move(bytes).value()));
        }
    }
    m_texts.checkModified();
    if (m_state.isOpen() && isNamedStale()) m_loading.readNamed();
}

/// Whether a mesh or an image changed since it was read, or a missing one may exist now.
bool ExternalChanges::isNamedStale() const {
    for (const auto& [use, file] : m_state.loaded->named) {
        if (file.path.empty()) return true;
        const Result<FileStamp> now = regularFileStamp(file.path);
        if (!now || now.value() != file.stamp) return true;
    }
    return std::ranges::any_of(m_state.loaded->diagnostics.all(),
                               [](const Diagnostic& d) { return d.code == Code::ImportNotFound; });
}

void ExternalChanges::apply(const std::string& path, std::shared_ptr<const std::string> bytes) {
    OpenFile& file = *m_state.files.find(path);
    file.gone = false;
    if (*bytes == *file.disk) {
        file.theirs = nullptr;
        return;
    }
    const SharedText base = file.disk, mine = file.text;
    std::optional<std::string> merged = *mine == *base ? *bytes : *mine == *bytes ? *mine : mergedByLines(*base, *mine, *bytes);
    if (!merged) {
        if (file.theirs && *file.theirs == *bytes) return;
        file.theirs = std::move(bytes);
        Q_EMIT conflictFound(QString::fromStdString(path));
        return;
    }
    file.theirs = nullptr;
    file.disk = std::move(bytes);
    m_state.history.endMerge();
    (void)m_state.report(m_edits.enter(tr("Changed on disk"), {{path, std::make_shared<const std::string>(std::move(*merged))}}));
}

FileTexts ExternalChanges::conflicts() const {
    FileTexts changes;
    for (const auto& [path, file] : m_state.files.all())
        if (file.theirs) changes.emplace(path, file.theirs);
    return changes;
}

Status ExternalChanges::resolve(const std::string& path, Resolution resolution) {
    OpenFile* file = m_state.files.find(path);
    if (!file || !file->theirs) return {};
    const SharedText theirs = std::exchange(file->theirs, nullptr);
    file->disk = theirs;
    Status taken;
    if (resolution == Resolution::Theirs) taken = m_edits.enter(tr("Changed on disk"), {{path, theirs}});
    m_texts.checkModified();
    return m_state.report(taken);
}

} // namespace trundle
