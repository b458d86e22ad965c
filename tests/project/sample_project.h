#pragma once
// A project with sample kinds, a module catalog and meshes defined here: core/project depends only on their interfaces.

#include <filesystem>
#include <fstream>

#include <QTemporaryDir>

#include "lang/diagnostic_text.h"
#include "model/sample_kinds.h"
#include "project/loading/project.h"

namespace sample {

using namespace trundle;

class Catalog final : public ModuleCatalog {
public:
    Result<ModuleListing> find(const std::string& written, const std::string&) override {
        if (written == "walker" || written == "Controllers/walker.dll") return listing("/modules/libwalker.so", {"Walker"});
        if (written == "other_walker") return listing("/modules/libother.so", {"Walker"});
        if (written == "controllers/prowler") return listing("/modules/controllers/libprowler.so", {"Prowler"});
        if (written == "mystery") return ModuleListing{"/modules/libmystery.so", false, {}};
        if (written == "untrusted") return Error{Code::ModuleNotTrusted, "the folder of untrusted is not trusted"};
        return Error{Code::ModuleNotFound, written + " is not found; tried /modules/lib" + written + ".so"};
    }
    std::string moduleWith(const std::string& kind) override { return kind == "Prowler" ? "controllers/prowler" : ""; }

private:
    static ModuleListing listing(std::string library, const std::vector<std::string>& names) {
        ModuleListing l{std::move(library), true, {}};
        for (const std::string& name : names)
            l.kinds.push_back(kindOf<Walker>(name, Role::Controller, {"Robot", "Grid", "Scatter"}));
        return l;
    }
};

/// The file name selects the shape.
class Meshes final : public MeshSource {
public:
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string& path) override {
        auto cube = std::make_shared<TriangleMesh>();
        for (int i = 0; i < 8; ++i) cube->points.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
        cube->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        const std::string name = std::filesystem::path(path).filename().string();
        if (name == "bad.obj") return Error{Code::MeshUnreadable, "bad.obj cannot be read: it holds no mesh"};
        if (name == "open.obj") cube->triangles.pop_back();
        if (name == "flat.obj")
            for (auto& p : cube->points) p[2] = 0;
        if (name == "far.obj") cube->points[7][0] = 1e9;
        return std::shared_ptr<const TriangleMesh>(cube);
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string& path) override {
        if (path.ends_with("tiny.png")) return std::make_shared<const HeightMap>(HeightMap{1, 1, {0.5f}});
        return std::make_shared<const HeightMap>(HeightMap{2, 2, {0, 1, 0, 1}});
    }
};

/// Opens texts in a temporary folder.
class ProjectFixture {
public:
    std::string folder() const { return m_dir.path().toStdString(); }
    std::string write(const std::string& name, const std::string& text) const {
        const std::filesystem::path path = std::filesystem::path(folder()) / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    Result<std::shared_ptr<const LoadedProject>> tryOpen(const std::string& path) {
        Project project(kinds(), m_catalog, m_meshes, options);
        return project.open(path);
    }
    std::shared_ptr<const LoadedProject> open(const std::string& text) { return openFile(write("main.sim", text)); }
    std::shared_ptr<const LoadedProject> openFile(const std::string& path) {
        auto result = tryOpen(path);
        return result.ok() ? result.value() : nullptr;
    }
    ProjectOptions options;

private:
    QTemporaryDir m_dir;
    Catalog m_catalog;
    Meshes m_meshes;
};

inline std::string rendered(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all()) all += render(d, loaded.sources);
    return all;
}

/// The messages alone, one a line: "E203 Radius is -3 cm, it must be above 0".
inline std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all()) all += codeName(d.code) + " " + d.message + "\n";
    return all;
}

} // namespace sample
