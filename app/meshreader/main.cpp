// trundle-meshreader: reads one mesh or picture of a foreign format with resource limits and writes it to standard output in the
// format of assets/mesh_stream.h. Exit code 0, or 1 with one line on standard error.

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "assets/mesh_stream.h"
#include "base/platform/limits.h"
#include "meshreader/mesh_file.h"
#include "meshreader/picture_file.h"

namespace {

constexpr const char* kUsage = "Usage: trundle-meshreader mesh FILE      (OBJ, STL, DAE, glTF, GLB)\n"
                               "       trundle-meshreader picture FILE   (PNG, JPEG, BMP, PGM, PPM: as heights)\n"
                               "       trundle-meshreader colours FILE   (the same files, as colours)\n"
                               "Writes the mesh, the heights or the colours to standard output in Trundle's binary form.\n";

constexpr trundle::ResourceLimits kLimits{.memoryBytes = 1u << 30, .cpuSeconds = 30, .fileBytes = 0, .coreDumps = false};

trundle::Result<std::string> read(std::string_view kind, const std::string& path) {
    if (kind == "mesh") {
        const trundle::Result<trundle::TriangleMesh> mesh = trundle::readMeshFile(path);
        return mesh ? trundle::Result<std::string>(trundle::encodeMesh(mesh.value())) : mesh.error();
    }
    if (kind == "colours") {
        const trundle::Result<trundle::Raster> raster = trundle::readColourFile(path);
        return raster ? trundle::Result<std::string>(trundle::encodeRaster(raster.value())) : raster.error();
    }
    const trundle::Result<trundle::HeightMap> map = trundle::readPictureFile(path);
    return map ? trundle::Result<std::string>(trundle::encodeHeightMap(map.value())) : map.error();
}

int run(std::string_view kind, const std::string& path) {
    const trundle::Result<std::string> bytes = read(kind, path);
    if (!bytes) {
        std::fprintf(stderr, "%s\n", bytes.error().message.c_str());
        return 1;
    }
    const bool written = std::fwrite(bytes.value().data(), 1, bytes.value().size(), stdout) == bytes.value().size();
    return written && std::fflush(stdout) == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const std::string_view kind = argc > 1 ? argv[1] : "";
    if (kind == "--help" || kind == "-h") {
        std::fputs(kUsage, stdout);
        return 0;
    }
    if (argc != 3 || (kind != "mesh" && kind != "picture" && kind != "colours")) {
        std::fputs(kUsage, stderr);
        return 2;
    }
    if (!trundle::applyLimits(kLimits)) {
        std::fputs("its reader could not limit itself\n", stderr);
        return 1;
    }
    try {
        return run(kind, argv[2]);
    } catch (const std::bad_alloc&) {
        std::fputs("it needs more than 1 GiB of memory\n", stderr);
    } catch (const std::exception& fault) { std::fprintf(stderr, "%s\n", fault.what()); }
    return 1;
}
