#pragma once
// The triangles of a surface near a geom, in the world: of a mesh, a hull, or the cells of a height map.

#include <span>
#include <vector>

#include "world/ode/collision/hull_on_mesh.h"
#include "world/ode/objects/ode_objects.h"

namespace trundle {

class NearTriangles {
public:
    /// The objects outlive this; their geoms are where their bodies are.
    explicit NearTriangles(const OdeObjects& objects) : m_objects(objects) {}

    [[nodiscard]] static bool isSurface(GeomShape shape) {
        return shape == GeomShape::Mesh || shape == GeomShape::Heightfield || shape == GeomShape::Convex;
    }
    NearTriangles(const NearTriangles&) = delete;
    NearTriangles& operator=(const NearTriangles&) = delete;
    ~NearTriangles();

    /// Those that touch the bounding box of a geom, counter-clockwise seen from outside. Valid until the next call.
    [[nodiscard]] std::span<const Triangle> find(std::uint32_t surface, std::uint32_t geom);
    /// The same as a mesh of ODE, null for none. Height maps of ODE know no edges between their samples, and no faces of what lies there.
    [[nodiscard]] dGeomID findAsMesh(std::uint32_t surface, std::uint32_t geom);

private:
    void addOfMesh(const ShapeData& data, const Box3& box);
    void addOfHull(const ShapeData& data);
    void addOfHeights(const OdeGeom& geom, const Box3& box);

    const OdeObjects& m_objects;
    std::vector<std::uint32_t> m_numbers;
    std::vector<Triangle> m_triangles;
    std::vector<double> m_points; ///< of the mesh, about its middle
    std::vector<dTriIndex> m_corners;
    dTriMeshDataID m_data = nullptr;
    dGeomID m_mesh = nullptr;
};

} // namespace trundle
