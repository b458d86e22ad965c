#include "world/rays/triangle_tree.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr int kBins = 16, kLeaf = 2, kMaxDepth = 60; // deeper nodes become leaves: traversal has a stack of fixed size
constexpr double kTriangleCost = 1.2;                // of the test of a triangle, in tests of a box; measured
constexpr double kMargin = 1e-6;                     // m around boxes, so that rounding loses no hit

struct Bounds {
    double lo[3] = {1e300, 1e300, 1e300}, hi[3] = {-1e300, -1e300, -1e300};

    void cover(const RayTriangle& t) {
        for (int k = 0; k < 3; ++k) {
            const double a = t.corner[k], b = a + t.ab[k], c = a + t.ac[k];
            lo[k] = std::min({lo[k], a, b, c});
            hi[k] = std::max({hi[k], a, b, c});
        }
    }
    void cover(const Bounds& o) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], o.lo[k]);
            hi[k] = std::max(hi[k], o.hi[k]);
        }
    }
    [[nodiscard]] double area() const {
        const double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
};

struct Split {
    int axis = -1, bin = 0;
    double cost = 0;
};

int binOf(const RayTriangle& t, const Bounds& all, int axis) {
    const double centre = t.corner[axis] + (t.ab[axis] + t.ac[axis]) / 3, wide = all.hi[axis] - all.lo[axis];
    return std::clamp(static_cast<int>(kBins * (centre - all.lo[axis]) / wide), 0, kBins - 1);
}

void tryAxis(std::span<const RayTriangle> triangles, const Bounds& all, int axis, Split& best) {
    struct Bin {
        Bounds bounds;
        int count = 0;
    } bins[kBins];
    for (const RayTriangle& t : triangles) {
        Bin& bin = bins[binOf(t, all, axis)];
        bin.bounds.cover(t);
        ++bin.count;
    }
    double right[kBins] = {};
    Bin sum;
    for (int i = kBins - 1; i > 0; --i) {
        sum.bounds.cover(bins[i].bounds);
        sum.count += bins[i].count;
        right[i] = sum.bounds.area() * sum.count;
    }
    sum = {};
    for (int i = 0; i + 1 < kBins; ++i) {
        sum.bounds.cover(bins[i].bounds);
        sum.count += bins[i].count;
        const double cost = 1 + kTriangleCost * (sum.bounds.area() * sum.count + right[i + 1]) / all.area();
        if (sum.count > 0 && sum.count < static_cast<int>(triangles.size()) && cost < best.cost) best = {axis, i, cost};
    }
}

} // namespace

TriangleTree::TriangleTree(std::span<const std::array<Vec3, 3>> triangles) {
    for (const auto& [a, b, c] : triangles) {
        const Vec3 ab = b - a, ac = c - a;
        m_triangles.push_back({{a.x(), a.y(), a.z()}, {ab.x(), ab.y(), ab.z()}, {ac.x(), ac.y(), ac.z()}});
    }
    m_nodes.reserve(2 * m_triangles.size() + 1);
    m_nodes.push_back({});
    split(0, 0, static_cast<int>(m_triangles.size()), 0);
    m_nodes.shrink_to_fit();
}

Vec3 TriangleTree::normal(std::size_t triangle) const {
    return Vec3(m_triangles[triangle].ab).cross(Vec3(m_triangles[triangle].ac)).normalized();
}

void TriangleTree::split(int node, int first, int count, int depth) {
    const std::span<RayTriangle> mine(m_triangles.data() + first, static_cast<std::size_t>(count));
    Bounds all;
    for (const RayTriangle& t : mine) all.cover(t);
    for (int k = 0; k < 3; ++k) {
        all.lo[k] -= kMargin;
        all.hi[k] += kMargin;
    }
    TreeNode n{{all.lo[0], all.lo[1], all.lo[2]}, {all.hi[0], all.hi[1], all.hi[2]}, first, count, 0};
    Split best{-1, 0, kTriangleCost * count};
    for (int axis = 0; axis < 3 && count > kLeaf && depth < kMaxDepth; ++axis) tryAxis(mine, all, axis, best);
    if (best.axis >= 0) {
        const auto middle = std::stable_partition(mine.begin(), mine.end(),
                                                  [&](const RayTriangle& t) { return binOf(t, all, best.axis) <= best.bin; });
        const int left = static_cast<int>(middle - mine.begin());
        n.first = static_cast<int>(m_nodes.size());
        n.count = 0;
        n.axis = best.axis;
        m_nodes.resize(m_nodes.size() + 2);
        split(n.first, first, left, depth + 1);
        split(n.first + 1, first + left, count - left, depth + 1);
    }
    m_nodes[static_cast<std::size_t>(node)] = n;
}

} // namespace trundle
