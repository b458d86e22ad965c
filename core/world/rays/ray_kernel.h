#pragma once
// Beams against one shape, several at once in the lanes of a vector register. There is one table of functions for each instruction
// set, compiled from the same code (ray_lanes.h, ray_shapes.h, ray_packets.h); all give the same bits.
//
// Only plain numbers cross this header: a file that is compiled for newer instructions must share no inline function with others,
// because the linker keeps one copy of each for the whole program.

namespace trundle {

inline constexpr int kBeamPadding = 8; ///< elements behind the last beam of a row that may be read and written

/// The beams first..last of one layer. Distances, geoms and parts (what is hit of a mesh or height map) are the nearest hits so far.
struct BeamRow {
    const double *cosines = nullptr, *sines = nullptr; ///< of the bearings
    double *distances = nullptr, *geoms = nullptr, *parts = nullptr;
    int first = 0, last = -1;
};

/// The beams in a shape's own axes: all from `origin`, each in the direction a cos + b sin + c of its bearing.
struct LocalBeams {
    double origin[3], a[3], b[3], c[3];
};

/// Node of a tree over triangles; a leaf has a count, another node its children at `first` and first + 1.
struct TreeNode {
    double lo[3], hi[3];
    int first, count, axis;
};
struct RayTriangle {
    double corner[3], ab[3], ac[3];
};

/// A height map in its own axes: x along columns, y up, z along rows, its middle at x = z = 0. Above the cells are levels of blocks of
/// 2 x 2, 4 x 4 ... cells with their lowest and highest sample.
struct HeightCells {
    static constexpr int kMaxLevels = 24;
    const float* samples = nullptr;
    const float* bounds[kMaxLevels] = {}; ///< by level from 1: lowest and highest of each block, row by row
    int columns = 0, rows = 0;            ///< of cells
    int levels = 0;                       ///< blocks of level `levels` - 1 are the largest
    double dx = 1, dz = 1;                ///< of a cell, m
    double height = 1;                    ///< of white, m

    /// Blocks along one side of a level.
    [[nodiscard, gnu::always_inline]] static inline int blocks(int cells, int level) {
        return (cells + (1 << level) - 1) >> level;
    }
};
/// Blocks of one level, i along x and k along z.
struct HeightBlock {
    int level, i, k;
};

/// What is hit. Sizes as half extents in its own axes; cylinder and capsule are along z, a plane is z = 0.
struct RayShape {
    enum Kind { Plane, Box, Sphere, Cylinder, Capsule, Hull, Mesh, Heights, kKinds };
    Kind kind = Box;
    double half[3] = {0, 0, 0}; ///< of a capsule without its caps
    double radius = 0;
    const double* planes = nullptr; ///< of a hull: outward unit normal and distance
    int planeCount = 0;
    const TreeNode* nodes = nullptr;
    const RayTriangle* triangles = nullptr;
    const HeightCells* heights = nullptr;
};

/// Where the search in a mesh or height map starts, farthest first.
struct RayRoots {
    static constexpr int kMax = 10;
    int count = 0;
    int nodes[kMax] = {};
    HeightBlock blocks[4] = {};
};

struct RayKernel {
    const char* name; ///< of the instruction set
    int lanes;
    /// By kind: hits nearer than those in the row replace them; of equally near ones the lower geom is kept.
    void (*cast[RayShape::kKinds])(const BeamRow& row, const LocalBeams& beams, const RayShape& shape, double geom,
                                   const RayRoots& roots);
};

[[nodiscard]] const RayKernel& baselineRayKernel();
/// nullptr: not for this processor, or not compiled.
[[nodiscard]] const RayKernel* avx2RayKernel();
/// The fastest one for this processor.
[[nodiscard]] const RayKernel& rayKernel();

} // namespace trundle
