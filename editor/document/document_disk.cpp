#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/platform/read_file.h"
#include "editor/document/document.h"
#include "editor/document/document_state.h"
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

void Document::checkExternalChanges() {
    if (!isOpen() || isOpening()) return;
    requestProject();
    std::vector<std::string> known;
    for (const auto& [path, file] : m_state->files.all())
        if (!isNew() || path != m_state->opened) known.push_back(path);
    for (const std::string& path : known) {
        OpenFile* file = m_state->files.find(path);
        if (!file) return; // a slot connected to the last notification has closed the project
        std::error_code none;
        if (!std::filesystem::exists(path, none)) {
            if (file->made && file->disk->empty()) continue; // it was never on disk
            if (!std::exchange(file->gone, true))
                Q_EMIT notice(
                    tr("%1 was deleted by another program; saving writes it again").arg(QString::fromStdString(shown(path))));
        } else if (file->disk->size() > kLargeText && !file->theirs && isOnDisk(path, *file->disk)) {
            file->gone = false;
        } else if (Result<std::string> bytes = readRegularFile(path); bytes) {
            applyExternalChange(path, std::make_shared<const std::string>(std::move(bytes).value()));
        }
    }
    notifyModified();
    if (isOpen() && isNamedStale()) readNamed();
}

/// Whether a mesh or an image changed since it was read, or a missing one may exist now.
bool Document::isNamedStale() const {
    for (const auto& [use, file] : m_loaded->named) {
        if (file.path.empty()) return true;
        const Result<FileStamp> now = regularFileStamp(file.path);
        if (!now || now.value() != file.stamp) return true;
    }
    return std::ranges::any_of(m_loaded->diagnostics.all(), [](const Diagnostic& d) { return d.code == Code::ImportNotFound; });
}

void Document::applyExternalChange(const std::string& path, SharedText bytes) {
    OpenFile& file = *m_state->files.find(path);
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
        Q_EMIT diskChanged(QString::fromStdString(path));
        return;
    }
    file.theirs = nullptr;
    file.disk = std::move(bytes);
    m_history.endMerge();
    (void)reportFailure(enter(tr("Changed on disk"), {{path, std::make_shared<const std::string>(std::move(*merged))}}, {}));
}

FileTexts Document::diskChanges() const {
    FileTexts changes;
    for (const auto& [path, file] : m_state->files.all())
        if (file.theirs) changes.emplace(path, file.theirs);
    return changes;
}

Status Document::resolveDiskChange(const std::string& path, Resolution resolution) {
    OpenFile* file = m_state->files.find(path);
    if (!file || !file->theirs) return {};
    const SharedText theirs = std::exchange(file->theirs, nullptr);
    file->disk = theirs;
    Status taken;
    if (resolution == Resolution::Theirs) taken = enter(tr("Changed on disk"), {{path, theirs}}, {});
    notifyModified();
    return reportFailure(taken);
}

void Document::updateWatchedFiles() {
    std::vector<std::string> files;
    for (const auto& [path, file] : m_state->files.all())
        if (!isNew() || path != m_state->opened) files.push_back(path);
    for (const auto& [use, file] : m_loaded->named) {
        if (!file.path.empty()) files.push_back(file.path);
        else if (use.first < m_loaded->paths.size()) // the first place where it is searched for
            files.push_back((std::filesystem::path(m_loaded->paths[use.first]).parent_path() / use.second).string());
    }
    m_state->watch.watch(files);
}

} // namespace trundle
