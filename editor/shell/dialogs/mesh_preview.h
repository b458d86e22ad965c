#pragma once
#include <QLabel>

#include "scene/shapes/mesh_fit.h"

namespace trundle {

/// A picture of a mesh from ahead and above, with the shapes that collide as lines. z is up.
class MeshPreview final : public QLabel {
    Q_OBJECT
public:
    explicit MeshPreview(const char* name);

    void show(const TriangleMesh& mesh, const std::vector<GeomSpec>& shapes);
};

} // namespace trundle
