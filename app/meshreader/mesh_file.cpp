// Needs: a file. Assumes: it may be hostile; the parent process has set resource limits, and a crash of assimp ends only this
// process.
// Method: only the importers of the five formats stay registered, so that the file's first bytes cannot select another; assimp
// triangulates, then the nodes are traversed without recursion, equal points are merged and every number is checked, and closed
// surfaces that are wound inside out are reversed. Data: metres, z up.
#include "meshreader/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "assets/mesh_orientation.h"
#include "assets/mesh_stream.h"
#include "meshreader/appearance_collector.h"
#include "meshreader/restricted_io_system.h"

namespace trundle {
namespace {

Error failure(const std::string& why) { return Error{Code::MeshUnreadable, why}; }

bool isOwnFormat(const aiImporterDesc* description) {
    if (description == nullptr || description->mFileExtensions == nullptr) return false;
    const std::string endings = std::string(" ") + description->mFileExtensions + " ";
    for (const char* ours : {" obj ", " stl ", " dae ", " gltf ", " glb "})
        if (endings.find(ours) != std::string::npos) return true;
    return false;
}

void keepOwnReaders(Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        if (isOwnFormat(importer.GetImporterInfo(i))) continue;
        const std::unique_ptr<Assimp::BaseImporter> reader(importer.GetImporter(i)); // unregistered, so it is owned here
        importer.UnregisterLoader(reader.get());
    }
}

void configure(Assimp::Importer& importer) {
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                            aiComponent_COLORS | aiComponent_BONEWEIGHTS |
                                                            aiComponent_ANIMATIONS | aiComponent_LIGHTS | aiComponent_CAMERAS);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
}

/// Merges bitwise equal points, since formats like STL repeat every corner.
class PointMerger {
public:
    explicit PointMerger(std::vector<std::array<double, 3>>& points) : m_points(points) {}

    std::uint32_t add(std::array<double, 3> point) {
        for (double& number : point) number += 0.0; // -0 and 0 are the same coordinate
        const auto [found, fresh] = m_known.try_emplace(point, static_cast<std::uint32_t>(m_points.size()));
        if (fresh) m_points.push_back(point);
        return found->second;
    }

private:
    struct Hash {
        std::size_t operator()(const std::array<double, 3>& point) const {
            std::size_t hash = 0;
            for (const double number : point) hash = hash * 0x9e3779b97f4a7c15ull + std::hash<double>{}(number);
            return hash;
        }
    };
    std::vector<std::array<double, 3>>& m_points;
    std::unordered_map<std::array<double, 3>, std::uint32_t, Hash> m_known;
};

class MeshCollector {
public:
    MeshCollector(bool yIsUp, AppearanceCollector& look) : m_yIsUp(yIsUp), m_look(look), m_joiner(m_mesh.points) {}

    Status addNodes(const aiScene& scene) {
        struct Open {
            const aiNode* node;
            aiMatrix4x4 toWorld;
        };
        std::vector<Open> open{{scene.mRootNode, scene.mRootNode->mTransformation}};
        while (!open.empty()) {
            const Open now = open.back();
            open.pop_back();
            for (unsigned i = 0; i < now.node->mNumMeshes; ++i) {
                if (now.node->mMeshes[i] >= scene.mNumMeshes)
                    return failure("it is damaged: a node names a mesh that is not there");
                if (const Status added = addMesh(*scene.mMeshes[now.node->mMeshes[i]], now.toWorld); !added) return added;
            }
            for (unsigned i = now.node->mNumChildren; i-- > 0;)
                open.push_back({now.node->mChildren[i], now.toWorld * now.node->mChildren[i]->mTransformation});
        }
        return {};
    }

    [[nodiscard]] TriangleMesh take() { return std::move(m_mesh); }

private:
    Status addMesh(const aiMesh& mesh, const aiMatrix4x4& toWorld) {
        // Only points used by a triangle are added.
        std::vector<std::uint32_t> places(mesh.mNumVertices, kUnplaced);
        const bool isMirrored = aiMatrix3x3(toWorld).Determinant() < 0; // the other side of its triangles is outside
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices != 3) continue;
            std::array<std::uint32_t, 3> triangle{}, corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
            if (isMirrored) std::swap(corners[1], corners[2]);
            for (unsigned corner = 0; corner < 3; ++corner) {
                const unsigned index = corners[corner];
                if (index >= mesh.mNumVertices) return failure("it is damaged: a triangle names a point that is not there");
                if (places[index] == kUnplaced) {
                    const Result<std::uint32_t> place = addPoint(toWorld * mesh.mVertices[index]);
                    if (!place) return place.error();
                    places[index] = place.value();
                }
                triangle[corner] = places[index];
            }
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
            if (!isNew(triangle)) continue;
            m_mesh.triangles.push_back(triangle);
            m_look.add(mesh, corners);
            if (m_mesh.triangles.size() > kMaxMeshTriangles)
                return failure("it has more than " + std::to_string(kMaxMeshTriangles) +
                               " triangles, the most that a mesh may have");
        }
        return {};
    }

    /// False for a duplicate of an earlier triangle with the same winding, which would only cost time.
    bool isNew(std::array<std::uint32_t, 3> triangle) {
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        return m_triangles.insert(triangle).second;
    }

    Result<std::uint32_t> addPoint(const aiVector3D& at) {
        if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
            return failure("one of its points is not a number");
        if (std::fabs(at.x) > kFarthest || std::fabs(at.y) > kFarthest || std::fabs(at.z) > kFarthest)
            return failure("one of its points is more than 1e9 away");
        const std::uint32_t place = m_yIsUp ? m_joiner.add({at.x, -at.z, at.y}) : m_joiner.add({at.x, at.y, at.z});
        if (m_mesh.points.size() > kMaxMeshPoints)
            return failure("it has more than " + std::to_string(kMaxMeshPoints) + " points");
        return place;
    }

    static constexpr std::uint32_t kUnplaced = 0xffffffffu;
    static constexpr double kFarthest = 1e9;

    bool m_yIsUp;
    AppearanceCollector& m_look;
    TriangleMesh m_mesh;
    PointMerger m_joiner;
    struct Hash {
        std::size_t operator()(const std::array<std::uint32_t, 3>& triangle) const {
            std::size_t hash = 0;
            for (const std::uint32_t point : triangle) hash = (hash ^ point) * 0x9e3779b97f4a7c15ull;
            return hash ^ hash >> 32;
        }
    };
    std::unordered_set<std::array<std::uint32_t, 3>, Hash> m_triangles; // each rotated so that its smallest point index is first
};

// Rewords assimp messages that are meant for programmers.
std::string describeFailure(const std::string& words) {
    if (words.find("bad_alloc") != std::string::npos) return "it needs more memory than its reader may take";
    if (words.find("STL storage representation") != std::string::npos)
        return "its length is not that of a binary STL with its count, and it is no text STL";
    if (words.find("No suitable reader") != std::string::npos) return "its content is not of the format that its name says";
    if (words.find("No meshes remaining") != std::string::npos) return "it holds no triangle";
    return words.empty() ? "its format is not understood" : words;
}

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

} // namespace

Result<TriangleMesh> readMeshFile(const std::string& path) {
    auto* files = new RestrictedIOSystem(path); // owned by the importer
    Assimp::Importer importer;
    importer.SetIOHandler(files);
    keepOwnReaders(importer);
    configure(importer);
    const aiScene* scene =
        importer.ReadFile(files->meshFile(), aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType);
    if (!files->refused().empty()) return failure("it refers to " + files->refused() + ", which lies outside its folder");
    if (scene == nullptr && !files->unreadable().empty()) return failure(files->unreadable());
    if (scene == nullptr) return failure(describeFailure(importer.GetErrorString()));
    if (scene->mRootNode == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0) return failure("it is incomplete");
    const std::string ending = endingOf(path);
    const bool isGltf = ending == ".gltf" || ending == ".glb";
    AppearanceCollector look(*scene, *files,
                             isGltf ? AppearanceCollector::Colours::Linear : AppearanceCollector::Colours::AsShown);
    if (!files->missingMaterials().empty()) look.addWarning("its file of materials, " + files->missingMaterials());
    // assimp converts COLLADA to y up, and glTF is y up by its standard.
    MeshCollector collector(isGltf || ending == ".dae", look);
    if (const Status added = collector.addNodes(*scene); !added) return added.error();
    TriangleMesh mesh = collector.take();
    if (mesh.triangles.empty()) return failure("it holds no triangle");
    if (ending != ".stl") mesh.look = look.take();
    orientOutwards(mesh);
    return mesh;
}

} // namespace trundle
