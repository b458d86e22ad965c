#pragma once
// One text resolved by core/model alone: no files, no imports, no modules.
#include <memory>
#include <string>
#include <vector>

#include "model/provenance.h"
#include "model/resolver.h"
#include "model/sample_kinds.h"
#include "model/set_targets.h"

namespace sample {

/// The corners of a box, triangles counter-clockwise seen from outside.
inline TriangleMesh boxMesh(const Vec3& size, const Pose& pose) {
    TriangleMesh m;
    for (int i = 0; i < 8; ++i) {
        const Vec3 p = pose * Vec3(0.5 * size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        m.points.push_back({p.x(), p.y(), p.z()});
    }
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

/// The kinds of a project that has loaded a module with the controller Walker.
inline std::shared_ptr<const Registry> kindsWithWalker() {
    Registry all = *kinds();
    const bool good = all.add(kindOf<Walker>("Walker", Role::Controller, {"Robot", "Grid", "Scatter"})).ok();
    assert(good);
    (void)good;
    return std::make_shared<const Registry>(withControllerProperties(all));
}

/// A mesh in memory for every path: cube.obj is the unit cube with one corner at the origin, open.obj lacks a triangle.
inline AssetLookup assets() {
    AssetLookup lookup;
    lookup.mesh = [](const std::string& written, FileId) -> Result<FoundAsset<TriangleMesh>> {
        if (written == "missing.obj") return Error{Code::MeshUnreadable, "missing.obj is not found"};
        TriangleMesh cube = boxMesh({1, 1, 1}, {Vec3(0.5, 0.5, 0.5), Quat::Identity()});
        if (written == "open.obj") cube.triangles.pop_back();
        return FoundAsset<TriangleMesh>{"/" + written, std::make_shared<const TriangleMesh>(std::move(cube))};
    };
    lookup.heightMap = [](const std::string& written, FileId) -> Result<FoundAsset<HeightMap>> {
        return FoundAsset<HeightMap>{"/" + written, std::make_shared<const HeightMap>(HeightMap{2, 2, {0, 0, 1, 1}})};
    };
    return lookup;
}

/// Everything that the model makes of a text.
struct Resolved {
    std::shared_ptr<TextSet> texts = std::make_shared<TextSet>();
    Diagnostics diagnostics;
    std::shared_ptr<Outline> outline;
    AppliedSets sets;
    std::shared_ptr<const ExperimentSpec> experiment;

    /// The messages, one a line: "E203 Radius is -3 cm, it must be above 0".
    [[nodiscard]] std::string messages() const {
        std::string all;
        for (const Diagnostic& d : diagnostics.all()) all += codeName(d.code) + " " + d.message + "\n";
        return all;
    }
    [[nodiscard]] std::string slice(const SourceRange& range) const { return std::string(texts->slice(range)); }
    [[nodiscard]] const RobotConfigSpec& config(std::size_t robot = 0) const { return *experiment->robots.at(robot).config; }
};

inline FileId addText(Resolved& r, std::string name, std::string text) {
    const auto file = static_cast<FileId>(r.texts->trees.size());
    r.texts->trees.push_back(parse(std::make_shared<const SourceText>(std::move(name), std::move(text)), file));
    r.diagnostics.append(r.texts->trees.back()->diagnostics());
    return file;
}

inline Resolved resolved(const std::string& text, const std::vector<std::string>& sets = {}) {
    Resolved r;
    addText(r, "main.sim", text);
    r.texts->firstSet = 1;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const FileId file = addText(r, "--set#" + std::to_string(i + 1), sets[i]);
        r.texts->sets.push_back({file, r.texts->trees[file]->items().at(0).as<AssignmentItem>()});
    }
    r.outline = Outline::build(r.texts, kindsWithWalker(), r.diagnostics);
    r.sets = applySets(*r.outline, r.diagnostics);
    r.experiment = resolve(*r.outline, assets(), r.diagnostics);
    return r;
}

inline std::string rover(const std::string& more) { return std::string(kGoodRobot) + more; }

/// `text` with the first `what` replaced.
inline std::string with(std::string text, const std::string& what, const std::string& instead) {
    const std::size_t place = text.find(what);
    assert(place != std::string::npos);
    return text.replace(place, what.size(), instead);
}

} // namespace sample

/// Compares what is reported, message by message.
#define SAYS(resolved, expected) QCOMPARE(QString::fromStdString((resolved).messages()), QString(expected))
