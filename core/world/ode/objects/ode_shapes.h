#pragma once
// ODE geoms of the specs' shapes. A shape is centred at `centre` in the spec's frame, so that its bounds are symmetric.

#include <memory>
#include <vector>

#include <ode/ode.h>

#include "base/result.h"
#include "model/body_spec.h"
#include "world/broad_phase.h"

namespace trundle {

/// Memory that ODE reads but does not own; must outlive its geom.
struct ShapeData {
    std::vector<double> points, planes;
    std::vector<unsigned> polygons;
    std::vector<dTriIndex> triangles;
    std::shared_ptr<const HeightMap> heightMap;
    StaticGrid triangleGrid; ///< for meshes, in the mesh's axes
    dTriMeshDataID mesh = nullptr;
    dHeightfieldDataID heights = nullptr;

    ShapeData() = default;
    ShapeData(const ShapeData&) = delete;
    ShapeData& operator=(const ShapeData&) = delete;
    ~ShapeData();
};

struct OdeShape {
    dGeomID id = nullptr;
    Pose centre;              ///< pose of the shape in the geom's frame
    Vec3 half = Vec3::Zero(); ///< half the extent of its bounding box, in the shape's axes
    double bound = 0;         ///< radius of its bounding sphere
    std::shared_ptr<ShapeData> data;
};

/// Creates a geom outside any space. Not for planes, whose pose only the caller has. May throw OdeFault.
[[nodiscard]] Result<OdeShape> makeShape(const GeomSpec& spec);

} // namespace trundle
