#include "app/mesh_files.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/clean_text.h"

namespace trundle {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestText = 64u << 20; // bytes; a larger file is not searched

std::string textOfFile(const fs::path& path) {
    std::error_code ec;
    if (fs::file_size(path, ec) > kLargestText || ec) return {};
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string decoded(std::string name) {
    for (std::size_t at = 0; (at = name.find("%20", at)) != std::string::npos; ++at) name.replace(at, 3, " ");
    for (const char* before : {"file://", "./"})
        if (name.starts_with(before)) name.erase(0, std::string_view(before).size());
    std::ranges::replace(name, '\\', '/');
    return name;
}

/// The text between two marks, for each pair of them.
std::vector<std::string> between(const std::string& text, std::string_view open, std::string_view close) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        const std::size_t end = text.find(close, at);
        if (end == std::string::npos) break;
        std::string name = text.substr(at, end - at);
        const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
        while (!name.empty() && isSpace(name.back())) name.pop_back();
        name.erase(name.begin(), std::ranges::find_if_not(name, isSpace));
        found.push_back(std::move(name));
    }
    return found;
}

/// The rest of the lines that begin with a word; of an MTL map, whose options come first, the last word.
std::vector<std::string> restOfLines(const std::string& text, const std::vector<std::string>& words, bool lastWord) {
    std::vector<std::string> found;
    for (const std::string& line : between('\n' + text + '\n', "\n", "\n")) {
        for (const std::string& word : words) {
            if (!line.starts_with(word)) continue;
            const std::size_t gap = line.find_first_of(" \t");
            if (gap == std::string::npos) continue;
            std::string rest = line.substr(line.find_first_not_of(" \t", gap));
            if (lastWord && rest.find_last_of(" \t") != std::string::npos) rest = rest.substr(rest.find_last_of(" \t") + 1);
            found.push_back(rest);
        }
    }
    return found;
}

/// In small letters.
std::string endingOf(const fs::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return ending;
}

std::vector<std::string> references(const fs::path& mesh, const std::string& text) {
    const std::string ending = endingOf(mesh);
    if (ending == ".obj") return restOfLines(text, {"mtllib"}, false);
    if (ending == ".mtl") return restOfLines(text, {"map_", "bump", "disp", "norm", "refl"}, true);
    if (ending == ".dae") return between(text, "<init_from>", "</init_from>");
    if (ending != ".gltf") return {};
    std::vector<std::string> found;
    for (std::size_t at = text.find("\"uri\""); at != std::string::npos; at = text.find("\"uri\"", at)) {
        const std::size_t first = text.find('"', at += 5), last = first == std::string::npos ? first : text.find('"', first + 1);
        if (last == std::string::npos) break;
        const std::string name = text.substr(first + 1, last - first - 1);
        if (!name.starts_with("data:")) found.push_back(name);
    }
    return found;
}

/// Adds what a file refers to. Names outside of the folder are left out; exporters write paths of other machines, so a file of that name
/// beside the mesh counts.
void addFilesOf(const fs::path& folder, const fs::path& file, std::vector<std::string>& names) {
    for (const std::string& written : references(file, textOfFile(file))) {
        fs::path name = fs::path(decoded(written)).lexically_normal();
        std::error_code ec;
        const bool isOutside = name.is_absolute() || (!name.empty() && *name.begin() == "..");
        if (isOutside || !fs::is_regular_file(folder / name, ec)) name = name.filename();
        if (name.empty() || !fs::is_regular_file(folder / name, ec) || std::ranges::count(names, name.string()) > 0) continue;
        names.push_back(name.string());
        if (endingOf(name) == ".mtl") addFilesOf(folder, folder / name, names);
    }
}

} // namespace

std::vector<std::string> filesOfMesh(const std::string& mesh) {
    std::vector<std::string> names;
    addFilesOf(fs::path(mesh).parent_path(), mesh, names);
    return names;
}

Result<std::string> bringMesh(const std::string& mesh, const std::string& folder) {
    std::error_code ec;
    const fs::path from = fs::weakly_canonical(mesh, ec), project = fs::weakly_canonical(folder, ec);
    const fs::path inside = from.lexically_relative(project);
    if (!inside.empty() && *inside.begin() != "..") return inside.generic_string();
    const std::string stem = from.stem().string();
    std::string name = stem;
    for (int number = 2; fs::exists(project / "meshes" / name, ec); ++number) name = stem + std::to_string(number);
    const fs::path to = project / "meshes" / name;
    std::vector<std::string> files = filesOfMesh(from.string());
    files.insert(files.begin(), from.filename().string());
    for (const std::string& file : files) {
        fs::create_directories((to / file).parent_path(), ec);
        if (!ec) fs::copy_file(from.parent_path() / file, to / file, ec);
        if (!ec) continue;
        Error failed{Code::FileUnwritable,
                     cleanLine(file) + " cannot be copied to " + cleanLine(to.string()) + ": " + cleanLine(ec.message())};
        fs::remove_all(to, ec); // made above, so all in it is ours
        return failed;
    }
    return (fs::path("meshes") / name / from.filename()).generic_string();
}

Result<std::vector<std::string>> writeHulls(const std::vector<TriangleMesh>& hulls, const std::string& mesh,
                                            const std::string& folder) {
    const fs::path inside = fs::path(mesh).parent_path(), project(folder);
    const std::string stem = fs::path(mesh).stem().string();
    const auto pathOf = [&](const std::string& name, std::size_t i) {
        return inside / (name + "_part" + std::to_string(i + 1) + ".obj");
    };
    std::error_code ec;
    std::string name = stem;
    for (int number = 2; fs::exists(project / pathOf(name, 0), ec); ++number) name = stem + std::to_string(number);
    std::vector<std::string> files;
    for (std::size_t i = 0; i < hulls.size(); ++i) {
        const fs::path file = pathOf(name, i);
        std::ofstream out(project / file, std::ios::binary);
        for (const auto& [x, y, z] : hulls[i].points) {
            char line[100];
            std::snprintf(line, sizeof line, "v %.6g %.6g %.6g\n", x, y, z);
            out << line;
        }
        for (const auto& [a, b, c] : hulls[i].triangles) out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        out.close();
        if (!out) return Error{Code::FileUnwritable, cleanLine((project / file).string()) + " cannot be written"};
        files.push_back(file.generic_string());
    }
    return files;
}

} // namespace trundle
