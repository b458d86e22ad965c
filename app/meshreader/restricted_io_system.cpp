#include "meshreader/restricted_io_system.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/platform/read_file.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxFileBytes = 256u << 20;

/// A file's content as an assimp stream.
class MemoryStream final : public Assimp::IOStream {
public:
    explicit MemoryStream(std::string bytes) : m_bytes(std::move(bytes)) {}

    size_t Read(void* into, size_t itemBytes, size_t count) override {
        if (itemBytes == 0 || count == 0) return 0;
        const size_t items = std::min(count, (m_bytes.size() - m_at) / itemBytes);
        std::memcpy(into, m_bytes.data() + m_at, items * itemBytes);
        m_at += items * itemBytes;
        return items;
    }
    size_t Write(const void*, size_t, size_t) override { return 0; }
    aiReturn Seek(size_t offset, aiOrigin origin) override {
        // A negative offset from the end is passed as a wrapped size_t; the addition wraps it again.
        const size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? m_at : m_bytes.size();
        const size_t next = base + offset;
        if (next > m_bytes.size()) return aiReturn_FAILURE;
        m_at = next;
        return aiReturn_SUCCESS;
    }
    size_t Tell() const override { return m_at; }
    size_t FileSize() const override { return m_bytes.size(); }
    void Flush() override {}

private:
    std::string m_bytes;
    size_t m_at = 0;
};

bool isMaterials(const std::string& file) {
    const std::string ending = fs::path(file).extension().string();
    return ending == ".mtl" || ending == ".MTL";
}

/// Completes the message "its file of materials, NAME,".
std::string materialsProblem(const fs::path& path) {
    std::error_code fault;
    const fs::file_type type = fs::status(path, fault).type();
    if (fault == std::errc::too_many_symbolic_link_levels) return "is a link that leads back to itself";
    if (fault == std::errc::filename_too_long) return "has a longer name than a file can have";
    if (type == fs::file_type::not_found) return "is not there";
    if (type == fs::file_type::directory) return "is a folder";
    if (type != fs::file_type::regular) return "is not a plain file";
    return isMaterials(path.string()) ? "cannot be read" : "does not end in .mtl";
}

/// An OBJ file with 0.5 in its vertices for .5, which assimp takes for no number.
std::string withLeadingZeros(const std::string& obj) {
    std::string out;
    std::size_t copied = 0;
    bool isVertex = false;
    for (std::size_t i = 0; i < obj.size(); ++i) {
        const bool begins = i == 0 || obj[i - 1] == '\n';
        if (begins) isVertex = obj[i] == 'v';
        const bool isLone = isVertex && obj[i] == '.' && !begins && (obj[i - 1] == ' ' || obj[i - 1] == '\t');
        if (!isLone || i + 1 == obj.size() || obj[i + 1] < '0' || obj[i + 1] > '9') continue;
        out.append(obj, copied, i - copied) += '0';
        copied = i;
    }
    return copied == 0 ? obj : out.append(obj, copied);
}

std::string realPath(const fs::path& path) {
    std::error_code fault;
    const fs::path real = fs::weakly_canonical(path, fault);
    return fault ? std::string() : real.string();
}

} // namespace

RestrictedIOSystem::RestrictedIOSystem(const std::string& meshFile) : m_meshFile(realPath(meshFile)) {
    m_folder = fs::path(m_meshFile).parent_path().string();
    if (!m_folder.ends_with('/')) m_folder += '/';
}

RestrictedIOSystem::FileAccess RestrictedIOSystem::accessOf(const std::string& file) const {
    const fs::path written(file);
    const std::string real = realPath(written.is_absolute() ? written : fs::path(m_folder) / written);
    if (!real.empty() && real == m_meshFile) return FileAccess::Readable;
    if (real.empty()) return FileAccess::Ignored; // not a valid path
    if (!real.starts_with(m_folder)) return FileAccess::Outside;
    return fs::path(real).extension() == ".bin" || isMaterials(real) ? FileAccess::Readable : FileAccess::Ignored;
}

bool RestrictedIOSystem::Exists(const char* file) const {
    if (accessOf(file) != FileAccess::Readable) return false;
    const fs::path written(file);
    std::error_code fault;
    return fs::is_regular_file(written.is_absolute() ? written : fs::path(m_folder) / written, fault);
}

Assimp::IOStream* RestrictedIOSystem::Open(const char* file, const char* mode) {
    if (std::string_view(mode).find_first_of("wa+") != std::string_view::npos) return nullptr;
    const FileAccess access = accessOf(file);
    const std::string_view name = file;
    const bool isBelow = name.starts_with(m_folder); // assimp prefixes names from the mesh with the mesh's folder
    const std::string shownName(name.substr(isBelow ? m_folder.size() : 0));
    if (access == FileAccess::Outside && m_refused.empty()) m_refused = shownName;
    if (access == FileAccess::Outside) return nullptr;
    const fs::path written(file), path = written.is_absolute() ? written : fs::path(m_folder) / written;
    Result<std::string> bytes = access == FileAccess::Readable ? readRegularFile(path.string(), kMaxFileBytes)
                                                               : Result<std::string>(Error{Code::MeshUnreadable, ""});
    if (!bytes) {
        // An OBJ refers only to MTL files; if those are missing, assimp also tries files with the mesh's own name.
        const bool asksForMaterials = isMaterials(file) || fs::path(m_meshFile).extension() == ".obj";
        if (!asksForMaterials || realPath(path) == m_meshFile) m_unreadable = bytes.error().message;
        else if (m_missingMaterials.empty()) m_missingMaterials = shownName.substr(0, 80) + ", " + materialsProblem(path);
        return nullptr;
    }
    if (const fs::path ending = fs::path(file).extension(); ending == ".obj" || ending == ".OBJ")
        return new MemoryStream(withLeadingZeros(bytes.value()));
    if (isMaterials(file)) return new MemoryStream(withoutPictureOptions(bytes.value(), m_placements));
    return new MemoryStream(std::move(bytes).value());
}

TextureTransform RestrictedIOSystem::placementOf(const std::string& material) const {
    const auto found = m_placements.find(material);
    return found == m_placements.end() ? TextureTransform{} : found->second;
}

Result<std::string> RestrictedIOSystem::pictureFile(std::string written) const {
    if (written.starts_with("file://")) written.erase(0, 7);
    std::replace(written.begin(), written.end(), '\\', '/');
    bool outside = false;
    for (const fs::path& place : {fs::path(written), fs::path(written).filename()}) {
        if (place.empty() || written.find('\0') != std::string::npos) continue;
        const std::string real = realPath(place.is_absolute() ? place : fs::path(m_folder) / place);
        std::error_code fault;
        if (real.empty()) continue; // not a valid file name
        if (!real.starts_with(m_folder)) outside = true;
        else if (fs::is_regular_file(real, fault)) return real;
    }
    return Error{Code::MeshUnreadable, outside ? "it lies outside the folder of the mesh" : "it is not there"};
}

} // namespace trundle
