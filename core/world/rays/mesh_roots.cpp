#include "world/rays/mesh_roots.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr int kSubtrees = 8; // more cost more at each beam than they save; measured

struct Subtree {
    double gap; ///< square of its distance from the fan, m^2
    int node;
};

/// The distance of a box from the fan, or none if no beam can meet it.
class BoxFilter {
public:
    BoxFilter(const LocalBeams& fan, const FanView& view) : m_fan(fan), m_range(view.fan().range) {
        const auto& layers = view.table().layers;
        const auto [low, high] = std::minmax_element(view.table().elevations.begin(), view.table().elevations.end());
        m_low = layers[static_cast<std::size_t>(low - view.table().elevations.begin())];
        m_high = layers[static_cast<std::size_t>(high - view.table().elevations.begin())];
    }

    [[nodiscard]] bool meets(const double* lo, const double* hi, double& gap) const {
        const Vec3 e = Vec3(hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]) / 2;
        const Vec3 p = Vec3(hi[0] + lo[0], hi[1] + lo[1], hi[2] + lo[2]) / 2 - Vec3(m_fan.origin);
        gap = (p.cwiseAbs() - e).cwiseMax(0).squaredNorm();
        if (gap > m_range * m_range) return false;
        // Against the cones of the lowest and the highest layer: the highest point of the box above its farthest or nearest bearing.
        const Vec3 u(m_fan.a), v(m_fan.b), w(m_fan.c);
        const double height = p.dot(w), thick = e.dot(w.cwiseAbs()), x = p.dot(u), y = p.dot(v), rho = std::sqrt(x * x + y * y),
                     r = e.norm();
        const double near = std::max(0., rho - r), far = rho + r, slack = 1e-9 * (1 + far);
        const double top = m_high.sine > 0 ? far : near, bottom = m_low.sine > 0 ? near : far;
        return (height - thick) * m_high.cosine <= top * m_high.sine + slack &&
               (height + thick) * m_low.cosine >= bottom * m_low.sine - slack;
    }

private:
    const LocalBeams& m_fan;
    double m_range;
    Direction m_low, m_high;
};

} // namespace

RayRoots rootsOf(const TriangleTree& tree, const LocalBeams& fan, const FanView& view) {
    const BoxFilter filter(fan, view);
    Subtree list[kSubtrees + 2];
    int count = 0;
    const auto take = [&](int node) {
        const TreeNode& n = tree.nodes()[static_cast<std::size_t>(node)];
        double gap = 0;
        if (filter.meets(n.lo, n.hi, gap)) list[count++] = {gap, node};
    };
    take(0);
    for (int i = 0; i < count && count < kSubtrees;) { // the first that is no leaf is opened; its children go to the end
        const TreeNode& n = tree.nodes()[static_cast<std::size_t>(list[i].node)];
        if (n.count > 0) {
            ++i;
            continue;
        }
        std::copy(list + i + 1, list + count, list + i);
        --count;
        take(n.first);
        take(n.first + 1);
    }
    std::sort(list, list + count,
              [](const Subtree& a, const Subtree& b) { return a.gap != b.gap ? a.gap > b.gap : a.node < b.node; });
    RayRoots roots;
    roots.count = count;
    for (int i = 0; i < count; ++i) roots.nodes[i] = list[i].node;
    return roots;
}

/// Blocks at least as large as the reach of the fan, so that there are at most four.
RayRoots rootsOf(const HeightCells& cells, const LocalBeams& fan, const FanView& view) {
    int level = 0;
    const double wide = 2 * view.fan().range + 1e-6;
    while (level + 1 < cells.levels && ((1 << level) * cells.dx < wide || (1 << level) * cells.dz < wide)) ++level;
    const auto range = [&](double at, double step, int count) {
        const double middle = at + count * step / 2, size = step * (1 << level);
        const int last = HeightCells::blocks(count, level) - 1;
        const auto block = [&](double x) { return static_cast<int>(std::clamp(x / size, 0., static_cast<double>(last))); };
        return std::pair(block(middle - wide / 2), block(middle + wide / 2));
    };
    const auto [i0, i1] = range(fan.origin[0], cells.dx, cells.columns);
    const auto [k0, k1] = range(fan.origin[2], cells.dz, cells.rows);
    RayRoots roots;
    for (int k = k0; k <= k1; ++k)
        for (int i = i0; i <= i1; ++i) roots.blocks[roots.count++] = {level, i, k};
    return roots;
}

} // namespace trundle
