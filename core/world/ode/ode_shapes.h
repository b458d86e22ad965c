#pragma once
// Geoms as ODE holds them. A shape is centred: its `centre` says where in the spec's frame, so that bounds are symmetric.

#include <memory>
#include <vector>

#include <ode/ode.h>

#include "base/result.h"
#include "model/body_spec.h"
#include "world/broad_phase.h"

namespace trundle {

/// Memory that ODE reads but does not own; lives as long as its geom.
struct ShapeData {
    std::vector<double> points, planes;
    std::vector<unsigned> polygons;
    std::vector<dTriIndex> triangles;
    std::shared_ptr<const HeightMap> heightMap;
    StaticGrid triangleGrid; ///< of a mesh, in its own axes
    dTriMeshDataID mesh = nullptr;
    dHeightfieldDataID heights = nullptr;

    ShapeData() = default;
    ShapeData(const ShapeData&) = delete;
    ShapeData& operator=(const ShapeData&) = delete;
    ~ShapeData();
};

struct OdeShape {
    dGeomID id = nullptr;
    Pose centre;              ///< of the shape in the geom's frame
    Vec3 half = Vec3::Zero(); ///< of a box around it, in the shape's axes
    double bound = 0;         ///< radius of a sphere around it
    std::shared_ptr<ShapeData> data;
};

/// Makes a geom in no space. Planes are made by the caller, who knows their place. May throw OdeFault.
[[nodiscard]] Result<OdeShape> makeShape(const GeomSpec& spec);

} // namespace trundle
