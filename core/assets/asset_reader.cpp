#include "assets/asset_reader.h"

#include <array>
#include <cmath>

#include "assets/mesh_stream.h"
#include "base/platform/process.h"

namespace trundle {
namespace {

constexpr std::array<std::string_view, 5> kMeshEndings{".obj", ".stl", ".dae", ".gltf", ".glb"};
constexpr std::array<std::string_view, 6> kPictureEndings{".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm"};

Error failure(const std::string& path, const std::string& why) {
    return Error{Code::MeshUnreadable, "cannot read " + path + ": " + why};
}

std::string lowerEnding(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || path.find('/', dot) != std::string::npos) return {};
    std::string ending = path.substr(dot);
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending;
}

template <std::size_t Count> bool endsInOne(const std::string& path, const std::array<std::string_view, Count>& endings) {
    const std::string ending = lowerEnding(path);
    for (const std::string_view known : endings)
        if (ending == known) return true;
    return false;
}

// The message comes from another process: reduced to one printable line of limited length.
std::string firstLine(const std::string& text) {
    std::string line;
    for (const char letter : text) {
        if (letter == '\n' && !line.empty()) break;
        const auto code = static_cast<unsigned char>(letter);
        if (code >= 0x20 && code != 0x7f) line += letter;
        if (line.size() >= 300) break;
    }
    return line;
}

std::string reasonOf(const ProcessRequest& request, const ProcessResult& result) {
    if (result.end == ProcessEnd::Exited) {
        const std::string words = firstLine(result.errors);
        return words.empty() ? "its reader " + describeEnd(request, result) : words;
    }
    if (result.end == ProcessEnd::Signalled) return "it is damaged (its reader was " + describeEnd(request, result) + ")";
    return "its reader " + describeEnd(request, result);
}

} // namespace

AssetReader::AssetReader(std::string program, AssetLimits limits) : m_program(std::move(program)), m_limits(limits) {}

namespace {

Error noMesh(const std::string& path) { return failure(path, "a mesh is an OBJ, STL, DAE, glTF or GLB file"); }
Error noPicture(const std::string& path) { return failure(path, "a picture is a PNG, JPEG, BMP, PGM or PPM file"); }

} // namespace

Result<std::shared_ptr<const TriangleMesh>> AssetReader::mesh(const std::string& path) {
    if (!endsInOne(path, kMeshEndings)) return noMesh(path);
    return find(m_meshes, "mesh", path, decodeMesh);
}

Result<std::shared_ptr<const HeightMap>> AssetReader::heightMap(const std::string& path) {
    if (!endsInOne(path, kPictureEndings)) return noPicture(path);
    return find(m_heightMaps, "picture", path, decodeHeightMap);
}

Result<std::shared_ptr<const Raster>> AssetReader::picture(const std::string& path) {
    if (!endsInOne(path, kPictureEndings)) return noPicture(path);
    return find(m_pictures, "colours", path, decodeRaster);
}

std::optional<Result<std::shared_ptr<const Raster>>> AssetReader::cachedPicture(const std::string& path) {
    if (!endsInOne(path, kPictureEndings)) return noPicture(path);
    return cached(m_pictures, path);
}

std::optional<Result<std::shared_ptr<const TriangleMesh>>> AssetReader::cachedMesh(const std::string& path) {
    if (!endsInOne(path, kMeshEndings)) return noMesh(path);
    return cached(m_meshes, path);
}

std::optional<Result<std::shared_ptr<const HeightMap>>> AssetReader::cachedHeightMap(const std::string& path) {
    if (!endsInOne(path, kPictureEndings)) return noPicture(path);
    return cached(m_heightMaps, path);
}

template <class Asset>
std::optional<AssetReader::ReaderOutput<Asset>> AssetReader::cached(const Cache<Asset>& cache, const std::string& path) {
    const Result<FileStamp> stamp = regularFileStamp(path);
    if (!stamp) return Error{Code::MeshUnreadable, stamp.error().message};
    if (stamp.value().size == 0) return failure(path, "it is empty");
    if (stamp.value().size > m_limits.fileBytes)
        return failure(path, "it is larger than " + std::to_string(m_limits.fileBytes >> 20) + " MiB");
    const std::lock_guard lock(m_mutex);
    const auto kept = cache.find(path);
    if (kept == cache.end() || kept->second.stamp != stamp.value()) return std::nullopt;
    return kept->second.answer;
}

template <class Asset, class Decode>
AssetReader::ReaderOutput<Asset> AssetReader::find(Cache<Asset>& cache, const char* kind, const std::string& path,
                                                   Decode decode) {
    if (auto known = cached(cache, path)) return *known;
    const std::lock_guard reading(m_reading);
    if (auto known = cached(cache, path)) return *known; // another thread may have read it in the meantime
    const Result<FileStamp> stamp = regularFileStamp(path);
    const auto read = [&]() -> ReaderOutput<Asset> {
        if (!stamp) return Error{Code::MeshUnreadable, stamp.error().message};
        const Result<std::string> bytes = ask(kind, path);
        if (!bytes) return bytes.error();
        Result<Asset> asset = decode(bytes.value());
        if (!asset) return failure(path, asset.error().message);
        return std::make_shared<const Asset>(std::move(asset).value());
    };
    ReaderOutput<Asset> answer = read();
    const std::lock_guard lock(m_mutex);
    if (stamp) cache.insert_or_assign(path, CacheEntry<Asset>{stamp.value(), answer});
    return answer;
}

Result<std::string> AssetReader::ask(const char* kind, const std::string& path) const {
    ProcessRequest request;
    request.program = m_program;
    request.arguments = {kind, path};
    request.seconds = m_limits.seconds;
    request.outputBytes = kMaxStreamBytes;
    request.limits = {.memoryBytes = m_limits.memoryBytes,
                      .cpuSeconds = static_cast<std::uint64_t>(std::ceil(m_limits.seconds)) + 1,
                      .fileBytes = 1, // it writes only to a pipe
                      .coreDumps = false};
    Result<ProcessResult> run = runProcess(request);
    if (!run) return failure(path, run.error().message);
    if (!run.value().succeeded()) return failure(path, reasonOf(request, run.value()));
    return std::move(std::move(run).value().output);
}

} // namespace trundle
