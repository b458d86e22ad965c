#pragma once
// Beams of one register together through the tree of a mesh or the blocks of a height map. Method: a node is opened while any beam meets
// its box before its nearest hit; a beam takes a hit only in a leaf whose box it meets itself, so that its neighbours do not matter.
// Triangles by Möller and Trumbore, from both sides. Included only by the files of the kernels.

#include "world/rays/ray_kernel.h"
#include "world/rays/ray_lanes.h"
#include "world/rays/ray_shapes.h"

namespace trundle {
namespace {

constexpr double kSlack = 1e-12;  // closes gaps between neighbouring triangles
constexpr double kEdgeOn = 1e-10; // sine of the angle to a triangle's plane below which it is not hit
constexpr double kMargin = 1e-6;  // m around the boxes of a height map, as around those of a tree

struct Packet {
    const double* origin;
    Lanes3 d, inverse;
    Lanes distance, geom, part;
    double id;
};

inline Packet packetOf(const BeamRow& row, const LocalBeams& beams, int i, double geom) {
    Packet p{beams.origin,        directions(row, beams, i), {},  load(row.distances + i),
             load(row.geoms + i), load(row.parts + i),       geom};
    p.inverse = {1.0 / nonZero(p.d.x), 1.0 / nonZero(p.d.y), 1.0 / nonZero(p.d.z)};
    return p;
}
inline void keep(const BeamRow& row, int i, const Packet& p) {
    store(row.distances + i, p.distance);
    store(row.geoms + i, p.geom);
    store(row.parts + i, p.part);
}

/// The beams that meet a box before their nearest hits.
inline Mask meets(const Packet& p, const double* lo, const double* hi) {
    const Lanes ax = (lo[0] - p.origin[0]) * p.inverse.x, bx = (hi[0] - p.origin[0]) * p.inverse.x;
    const Lanes ay = (lo[1] - p.origin[1]) * p.inverse.y, by = (hi[1] - p.origin[1]) * p.inverse.y;
    const Lanes az = (lo[2] - p.origin[2]) * p.inverse.z, bz = (hi[2] - p.origin[2]) * p.inverse.z;
    const Lanes from = most(most(least(ax, bx), least(ay, by)), most(least(az, bz), all(0)));
    const Lanes to = least(least(most(ax, bx), most(ay, by)), least(most(az, bz), p.distance));
    return from <= to;
}

/// Of equally near triangles of one geom the lower number wins.
inline void hitTriangle(Packet& p, Mask mine, const RayTriangle& g, double part) {
    const double s[3] = {p.origin[0] - g.corner[0], p.origin[1] - g.corner[1], p.origin[2] - g.corner[2]};
    double q[3], across[3], c[3];
    cross(s, g.ab, q);
    cross(g.ac, g.ab, across);
    cross(g.ac, s, c);
    const Lanes det = dot(across, p.d), inverse = 1.0 / nonZero(det);
    const Lanes u = dot(c, p.d) * inverse, v = dot(q, p.d) * inverse, t = dot(g.ac, q) * inverse;
    const Mask inside = (u >= -kSlack) & (v >= -kSlack) & (u + v <= 1 + kSlack) & (t >= 0.0) &
                        (det * det > kEdgeOn * kEdgeOn * dot(across, across));
    const Mask first = (p.id < p.geom) | ((p.id == p.geom) & (part < p.part));
    const Mask nearer = mine & inside & ((t < p.distance) | ((t == p.distance) & first));
    p.distance = select(nearer, t, p.distance);
    p.geom = select(nearer, all(p.id), p.geom);
    p.part = select(nearer, all(part), p.part);
}

inline void walkTree(Packet& p, const RayShape& mesh, const RayRoots& roots) {
    int stack[96], top = 0;
    for (; top < roots.count; ++top) stack[top] = roots.nodes[top];
    const double heading[3] = {p.d.x[0], p.d.y[0], p.d.z[0]};
    while (top > 0) {
        const TreeNode& n = mesh.nodes[stack[--top]];
        const Mask mine = meets(p, n.lo, n.hi);
        if (!any(mine)) continue;
        for (int i = n.first; i < n.first + n.count; ++i) hitTriangle(p, mine, mesh.triangles[i], i);
        if (n.count > 0) continue;
        const int near = heading[n.axis] < 0 ? 1 : 0;
        stack[top++] = n.first + 1 - near;
        stack[top++] = n.first + near;
    }
}

void castMesh(const BeamRow& row, const LocalBeams& beams, const RayShape& mesh, double geom, const RayRoots& roots) {
    for (int i = row.first; i <= row.last; i += TRUNDLE_LANES) {
        Packet p = packetOf(row, beams, i, geom);
        walkTree(p, mesh, roots);
        keep(row, i, p);
    }
}

inline double sample(const HeightCells& m, int i, int k) {
    return m.height * static_cast<double>(m.samples[static_cast<long>(k) * (m.columns + 1) + i]);
}

/// The two triangles of a cell, as ODE divides it.
inline void hitCell(Packet& p, const HeightCells& m, int i, int k) {
    const double x = i * m.dx - m.columns * m.dx / 2, z = k * m.dz - m.rows * m.dz / 2;
    const double a = sample(m, i, k), b = sample(m, i + 1, k), c = sample(m, i, k + 1), d = sample(m, i + 1, k + 1);
    const double low = __builtin_fmin(__builtin_fmin(a, b), __builtin_fmin(c, d));
    const double high = __builtin_fmax(__builtin_fmax(a, b), __builtin_fmax(c, d));
    const double lo[3] = {x - kMargin, low - kMargin, z - kMargin};
    const double hi[3] = {x + m.dx + kMargin, high + kMargin, z + m.dz + kMargin};
    const Mask mine = meets(p, lo, hi);
    if (!any(mine)) return;
    const double part = 2.0 * (static_cast<double>(k) * m.columns + i);
    hitTriangle(p, mine, {{x, a, z}, {m.dx, b - a, 0}, {0, c - a, m.dz}}, part);
    hitTriangle(p, mine, {{x + m.dx, d, z + m.dz}, {-m.dx, c - d, 0}, {0, b - d, -m.dz}}, part + 1);
}

inline bool meetsBlock(const Packet& p, const HeightCells& m, const HeightBlock& b) {
    const float* bounds = m.bounds[b.level] + 2 * (static_cast<long>(b.k) * HeightCells::blocks(m.columns, b.level) + b.i);
    const double wide = m.dx * (1 << b.level), deep = m.dz * (1 << b.level);
    const double x = b.i * wide - m.columns * m.dx / 2, z = b.k * deep - m.rows * m.dz / 2;
    const double lo[3] = {x - kMargin, m.height * static_cast<double>(bounds[0]) - kMargin, z - kMargin};
    const double hi[3] = {x + wide + kMargin, m.height * static_cast<double>(bounds[1]) + kMargin, z + deep + kMargin};
    return any(meets(p, lo, hi));
}

/// Nearest blocks first, by the first beam.
inline void walkBlocks(Packet& p, const HeightCells& m, const RayRoots& roots) {
    HeightBlock stack[3 * HeightCells::kMaxLevels + RayRoots::kMax];
    int top = 0;
    for (; top < roots.count; ++top) stack[top] = roots.blocks[top];
    const int left = p.d.x[0] < 0 ? 0 : 1, back = p.d.z[0] < 0 ? 0 : 1; // of the child that is opened last
    while (top > 0) {
        const HeightBlock b = stack[--top];
        if (b.level == 0) {
            hitCell(p, m, b.i, b.k);
            continue;
        }
        if (!meetsBlock(p, m, b)) continue;
        const int columns = HeightCells::blocks(m.columns, b.level - 1), rows = HeightCells::blocks(m.rows, b.level - 1);
        for (int n = 0; n < 4; ++n) {
            const int i = 2 * b.i + ((n & 1) ? 1 - left : left), k = 2 * b.k + ((n & 2) ? 1 - back : back);
            if (i < columns && k < rows) stack[top++] = {b.level - 1, i, k};
        }
    }
}

void castHeights(const BeamRow& row, const LocalBeams& beams, const RayShape& map, double geom, const RayRoots& roots) {
    for (int i = row.first; i <= row.last; i += TRUNDLE_LANES) {
        Packet p = packetOf(row, beams, i, geom);
        walkBlocks(p, *map.heights, roots);
        keep(row, i, p);
    }
}

} // namespace
} // namespace trundle
