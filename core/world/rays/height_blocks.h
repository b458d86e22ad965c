#pragma once
// The blocks above the cells of a height map, with their lowest and highest sample: an eighth of a tree's memory over its triangles.

#include <memory>
#include <vector>

#include <trundle/geometry.h>

#include "base/triangle_mesh.h"
#include "world/rays/ray_kernel.h"

namespace trundle {

class HeightBlocks {
public:
    /// At least 2 x 2 samples over `width` x `depth` m, white at `height`. The map is shared.
    HeightBlocks(std::shared_ptr<const HeightMap> map, double width, double depth, double height);

    [[nodiscard]] const HeightCells& cells() const { return m_cells; }
    /// Upwards. `part` as in BeamRow.
    [[nodiscard]] Vec3 normal(std::size_t part) const;

private:
    void addLevel(int level);

    std::shared_ptr<const HeightMap> m_map;
    HeightCells m_cells;
    std::vector<std::vector<float>> m_bounds; ///< by level
};

} // namespace trundle
