#include "assets/mesh_stream.h"
#include "assets/mesh_appearance_stream.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace trundle {
namespace {

static_assert(std::endian::native == std::endian::little, "the stream is copied, not converted");

constexpr std::string_view kMeshMagic = "TRMESH02";
constexpr std::string_view kGreyMagic = "TRGREY01";
constexpr std::string_view kColourMagic = "TRRGB001";
constexpr std::size_t kHeaderBytes = 16;

Error damaged(const std::string& why) { return Error{Code::MeshUnreadable, "its reader's output is damaged: " + why}; }

struct Header {
    std::uint32_t first = 0, second = 0;
};

std::string startStream(std::string_view magic, Header header) {
    std::string bytes(magic);
    bytes.append(reinterpret_cast<const char*>(&header), sizeof header);
    return bytes;
}

Result<Header> readHeader(std::string_view bytes, std::string_view magic) {
    if (bytes.size() < kHeaderBytes || !bytes.starts_with(magic)) return damaged("no " + std::string(magic));
    Header header;
    std::memcpy(&header, bytes.data() + magic.size(), sizeof header);
    return header;
}

// `count` was checked against its limit, so the product cannot overflow.
template <class Item> void copyItems(std::string_view bytes, std::size_t offset, std::size_t count, std::vector<Item>& into) {
    into.resize(count);
    if (count > 0) std::memcpy(into.data(), bytes.data() + offset, count * sizeof(Item));
}

template <class Item> void appendItems(std::string& bytes, const std::vector<Item>& items) {
    bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
}

bool allFinite(const std::vector<std::array<double, 3>>& points) {
    for (const auto& point : points)
        for (const double number : point)
            if (!std::isfinite(number)) return false;
    return true;
}

bool allBelow(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::uint32_t limit) {
    for (const auto& triangle : triangles)
        for (const std::uint32_t index : triangle)
            if (index >= limit) return false;
    return true;
}

bool allGrey(const std::vector<float>& heights) {
    for (const float height : heights)
        if (!(height >= 0.0f && height <= 1.0f)) return false; // also false for NaN
    return true;
}

} // namespace

std::string encodeMesh(const TriangleMesh& mesh) {
    std::string bytes = startStream(
        kMeshMagic, {static_cast<std::uint32_t>(mesh.points.size()), static_cast<std::uint32_t>(mesh.triangles.size())});
    appendItems(bytes, mesh.points);
    appendItems(bytes, mesh.triangles);
    if (mesh.look) bytes += encodeAppearance(*mesh.look);
    return bytes;
}

std::string encodeHeightMap(const HeightMap& map) {
    std::string bytes = startStream(kGreyMagic, {map.columns, map.rows});
    appendItems(bytes, map.heights);
    return bytes;
}

std::string encodeRaster(const Raster& raster) {
    std::string bytes = startStream(kColourMagic, {raster.width, raster.height});
    appendItems(bytes, raster.pixels);
    return bytes;
}

Result<Raster> decodeRaster(std::string_view bytes) {
    const Result<Header> header = readHeader(bytes, kColourMagic);
    if (!header) return header.error();
    const auto [width, height] = header.value();
    if (width < 1 || height < 1) return damaged("no pixel");
    if (width > kMaxRasterSide || height > kMaxRasterSide) return damaged("too many pixels");
    const std::size_t count = std::size_t{width} * height * 3;
    if (bytes.size() != kHeaderBytes + count) return damaged("its length does not fit its counts");
    Raster raster{width, height, {}};
    copyItems(bytes, kHeaderBytes, count, raster.pixels);
    return raster;
}

Result<TriangleMesh> decodeMesh(std::string_view bytes) {
    const Result<Header> header = readHeader(bytes, kMeshMagic);
    if (!header) return header.error();
    const auto [points, triangles] = header.value();
    if (points > kMaxMeshPoints || triangles > kMaxMeshTriangles) return damaged("too many points or triangles");
    const std::size_t trianglesAt = kHeaderBytes + 24ull * points;
    const std::size_t lookAt = trianglesAt + 12ull * triangles;
    if (bytes.size() < lookAt) return damaged("its length does not fit its counts");
    if (triangles == 0) return damaged("no triangle");
    TriangleMesh mesh;
    copyItems(bytes, kHeaderBytes, points, mesh.points);
    copyItems(bytes, trianglesAt, triangles, mesh.triangles);
    if (!allFinite(mesh.points)) return damaged("a coordinate is not a number");
    if (!allBelow(mesh.triangles, points)) return damaged("a triangle names a point that is not there");
    if (bytes.size() == lookAt) return mesh;
    Result<std::shared_ptr<const MeshAppearance>> look = decodeAppearance(bytes.substr(lookAt), triangles);
    if (!look) return look.error();
    mesh.look = std::move(look).value();
    return mesh;
}

Result<HeightMap> decodeHeightMap(std::string_view bytes) {
    const Result<Header> header = readHeader(bytes, kGreyMagic);
    if (!header) return header.error();
    const auto [columns, rows] = header.value();
    const std::uint64_t count = std::uint64_t{columns} * rows;
    if (columns < 2 || rows < 2) return damaged("fewer than 2 x 2 heights");
    if (columns > kMaxGreySide || rows > kMaxGreySide || count > kMaxGreyPoints) return damaged("too many heights");
    if (bytes.size() != kHeaderBytes + 4 * count) return damaged("its length does not fit its counts");
    HeightMap map{.columns = columns, .rows = rows, .heights = {}};
    copyItems(bytes, kHeaderBytes, count, map.heights);
    if (!allGrey(map.heights)) return damaged("a height is outside 0..1");
    return map;
}

} // namespace trundle
