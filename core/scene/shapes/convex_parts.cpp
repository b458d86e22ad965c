// Method: a decomposition by planes, in the manner of V-HACD (Mamou, Volumetric Hierarchical Approximate Convex Decomposition, in Game
// Engine Gems 3, 2016): the mesh becomes cells, filled where the outside does not reach; the box of cells whose hull holds most empty
// space is cut where the hulls of both sides hold least. Then the triangles are clipped at the planes, each moved to corners of the mesh
// nearby, each part becomes the hull of what is left of them, and hulls are joined where that adds least.
// Assumption: parts are cut along the axes of the mesh. Data: counts of filled cells as prefix sums, boxes of cells.

#include "scene/shapes/convex_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <trundle/geometry.h>

#include "model/convex_hull.h"
#include "scene/shapes/bounds.h"

namespace trundle {
namespace {

constexpr int kCells = 32;            // along the longest side
constexpr double kEmptyEnough = 0.02; // of the solid: the empty space that all hulls may hold together
constexpr double kLeastEmpty = 0.004; // of the solid: a part that holds less is not cut
constexpr double kBalance = 0.15;     // what a cell more on one side of a cut counts, in empty cells
constexpr double kLeastAdded = 0.004; // of the volume of all: two hulls become one where that adds less
constexpr std::size_t kCutsPerPart = 3;
constexpr int kCoarse = 4;              // cells between the planes that are tried first
constexpr std::size_t kPartPoints = 64; // of a hull
constexpr double kThinPart = 1e-3;      // of a cell
constexpr std::size_t kMostPartSamples = 20000;

using Cell = std::array<int, 3>;

struct CellBox {
    Cell low{}, high{}; // high is one past the last cell
    [[nodiscard]] int size(int k) const { return high[std::size_t(k)] - low[std::size_t(k)]; }
};

double volumeOf(const TriangleMesh& hull) {
    double six = 0;
    for (const auto& [i, j, k] : hull.triangles) {
        const Vec3 a(hull.points[i].data()), b(hull.points[j].data()), c(hull.points[k].data());
        six += a.dot(b.cross(c));
    }
    return six / 6;
}

/// The convex hull of points of a plane, without points on its edges.
std::vector<std::array<double, 2>> outlineOf(std::vector<std::array<double, 2>> points) {
    std::ranges::sort(points);
    std::vector<std::array<double, 2>> hull;
    const auto add = [&](const std::array<double, 2>& p, std::size_t least) {
        const auto isInside = [&] {
            const auto &a = hull[hull.size() - 2], &b = hull.back();
            return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) <= 0;
        };
        while (hull.size() > least && isInside()) hull.pop_back();
        hull.push_back(p);
    };
    for (const auto& p : points) add(p, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = points.size(); i-- > 0;) add(points[i], lower);
    return hull;
}

/// The mesh as cells of a grid.
class CellGrid {
public:
    explicit CellGrid(const TriangleMesh& mesh) {
        Bounds bounds;
        for (const auto& p : mesh.points) bounds.add(Vec3(p.data()));
        m_cell = bounds.size().maxCoeff() / kCells;
        m_low = bounds.low;
        for (int k = 0; k < 3; ++k) m_size[std::size_t(k)] = std::max(1, int(std::ceil(bounds.size()[k] / m_cell - 1e-9)));
        m_filled.assign(index({m_size[0], m_size[1], m_size[2]}), 0);
        for (const auto& triangle : mesh.triangles) addTriangle(mesh, triangle);
        fillInside();
        addUp();
    }

    [[nodiscard]] CellBox all() const { return {{}, m_size}; }
    [[nodiscard]] double planeAt(int axis, int cell) const { return m_low[axis] + cell * m_cell; }
    [[nodiscard]] double cell() const { return m_cell; }

    /// How many cells of the box are filled.
    [[nodiscard]] long count(const CellBox& box) const {
        long sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            Cell at{};
            int sign = 1;
            for (std::size_t k = 0; k < 3; ++k) {
                const bool isHigh = corner >> k & 1;
                at[k] = isHigh ? box.high[k] : box.low[k];
                if (!isHigh) sign = -sign;
            }
            sum += sign * m_sums[sumIndex(at)];
        }
        return sum;
    }
    /// In cells; 0 if there are none.
    [[nodiscard]] double hullVolume(const CellBox& box) const {
        std::vector<std::array<double, 3>> points;
        for (int z = box.low[2]; z < box.high[2]; ++z) {
            std::vector<std::array<double, 2>> slice;
            for (int y = box.low[1]; y < box.high[1]; ++y) {
                int first = box.low[0], last = box.high[0] - 1;
                while (first <= last && !m_filled[index({first, y, z})]) ++first;
                while (last >= first && !m_filled[index({last, y, z})]) --last;
                if (first > last) continue;
                for (const double side : {0., 1.})
                    slice.push_back({double(first), y + side}), slice.push_back({last + 1., y + side});
            }
            if (!slice.empty())
                for (const auto& [x, y] : outlineOf(std::move(slice)))
                    for (const double side : {0., 1.}) points.push_back({x, y, z + side});
        }
        const auto hull = convexHull(points);
        return hull ? volumeOf(*hull) : 0;
    }

private:
    [[nodiscard]] std::size_t index(const Cell& c) const {
        if (c == m_size) return std::size_t(m_size[0]) * std::size_t(m_size[1]) * std::size_t(m_size[2]);
        return (std::size_t(c[2]) * std::size_t(m_size[1]) + std::size_t(c[1])) * std::size_t(m_size[0]) + std::size_t(c[0]);
    }
    [[nodiscard]] std::size_t sumIndex(const Cell& c) const {
        return (std::size_t(c[2]) * std::size_t(m_size[1] + 1) + std::size_t(c[1])) * std::size_t(m_size[0] + 1) +
               std::size_t(c[0]);
    }
    [[nodiscard]] Cell cellOf(const Vec3& p) const {
        Cell cell{};
        for (int k = 0; k < 3; ++k)
            cell[std::size_t(k)] = std::clamp(int((p[k] - m_low[k]) / m_cell), 0, m_size[std::size_t(k)] - 1);
        return cell;
    }

    /// Points of the triangle less than half of a cell apart. They count a little inside of it, so that a face on the border of two cells
    /// fills the one that it bounds.
    void addTriangle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
        const Vec3 a(mesh.points[triangle[0]].data()), b(mesh.points[triangle[1]].data()), c(mesh.points[triangle[2]].data());
        const Vec3 normal = (b - a).cross(c - a);
        const Vec3 in = normal.norm() > 0 ? Vec3(-1e-3 * m_cell * normal.normalized()) : Vec3(Vec3::Zero());
        const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
        const int steps = std::max(1, int(std::ceil(longest / (0.45 * m_cell))));
        for (int i = 0; i <= steps; ++i)
            for (int k = 0; k <= steps - i; ++k)
                m_filled[index(cellOf(a + double(i) / steps * (b - a) + double(k) / steps * (c - a) + in))] = 1;
    }

    /// What cannot be reached from outside through empty cells.
    void fillInside() {
        std::vector<std::uint8_t> isOutside(m_filled.size(), 0);
        std::vector<Cell> open;
        const auto visit = [&](const Cell& c) {
            if (std::uint8_t& seen = isOutside[index(c)]; !seen && !m_filled[index(c)]) seen = 1, open.push_back(c);
        };
        const auto each = [&](const auto& use) {
            for (int z = 0; z < m_size[2]; ++z)
                for (int y = 0; y < m_size[1]; ++y)
                    for (int x = 0; x < m_size[0]; ++x) use(Cell{x, y, z});
        };
        each([&](const Cell& c) {
            for (std::size_t k = 0; k < 3; ++k)
                if (c[k] == 0 || c[k] == m_size[k] - 1) return visit(c);
        });
        while (!open.empty()) {
            const Cell c = open.back();
            open.pop_back();
            for (std::size_t k = 0; k < 3; ++k)
                for (const int by : {-1, 1}) {
                    Cell next = c;
                    next[k] += by;
                    if (next[k] >= 0 && next[k] < m_size[k]) visit(next);
                }
        }
        for (std::size_t i = 0; i < m_filled.size(); ++i) m_filled[i] = !isOutside[i];
    }

    void addUp() {
        m_sums.assign(std::size_t(m_size[0] + 1) * std::size_t(m_size[1] + 1) * std::size_t(m_size[2] + 1), 0);
        for (int z = 1; z <= m_size[2]; ++z)
            for (int y = 1; y <= m_size[1]; ++y) {
                long row = 0;
                for (int x = 1; x <= m_size[0]; ++x) {
                    row += m_filled[index({x - 1, y - 1, z - 1})];
                    m_sums[sumIndex({x, y, z})] = row + m_sums[sumIndex({x, y - 1, z})] + m_sums[sumIndex({x, y, z - 1})] -
                                                  m_sums[sumIndex({x, y - 1, z - 1})];
                }
            }
    }

    Vec3 m_low = Vec3::Zero();
    double m_cell = 1; // m
    Cell m_size{};
    std::vector<std::uint8_t> m_filled;
    std::vector<long> m_sums;
};

/// A box of cells, and the empty ones in the hull of its filled ones.
struct Region {
    CellBox box;
    double empty = 0;
    bool isDone = false;
};

Region regionOf(const CellGrid& grid, const CellBox& box) { return {box, grid.hullVolume(box) - double(grid.count(box)), false}; }

struct Cut {
    Region low, high;
    double cost = 0;
};

/// Where both sides together hold least that is empty, and are about as large: a ring is as empty in two halves as before, in four quarters
/// it is not. Nothing if the box cannot be cut into two that are filled in part.
std::optional<Cut> bestCut(const CellGrid& grid, const CellBox& box) {
    std::optional<Cut> best;
    std::array<int, 2> bestPlane{};
    const auto attempt = [&](int axis, int plane) {
        const auto k = std::size_t(axis);
        if (plane <= box.low[k] || plane >= box.high[k]) return;
        CellBox low = box, high = box;
        low.high[k] = high.low[k] = plane;
        const auto inLow = double(grid.count(low)), inHigh = double(grid.count(high));
        if (inLow == 0 || inHigh == 0) return;
        Cut cut{regionOf(grid, low), regionOf(grid, high)};
        cut.cost = cut.low.empty + cut.high.empty + kBalance * std::abs(inLow - inHigh);
        if (!best || cut.cost < best->cost - 1e-9) best = cut, bestPlane = {axis, plane};
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int plane = box.low[std::size_t(axis)] + 1;
             plane<box.high[std::size_t(axis)]; plane += box.size(axis)> 2 * kCoarse ? kCoarse : 1)
            attempt(axis, plane);
    const auto [axis, middle] = bestPlane;
    if (best)
        for (int by = 1 - kCoarse; by < kCoarse; ++by) attempt(axis, middle + by);
    return best;
}

std::vector<CellBox> cutApart(const CellGrid& grid, std::size_t most) {
    const double solid = double(grid.count(grid.all()));
    std::vector<Region> regions{regionOf(grid, grid.all())};
    double empty = regions[0].empty;
    while (regions.size() < most && empty > kEmptyEnough * solid) {
        const auto region = std::ranges::max_element(regions, {}, [](const Region& r) { return r.isDone ? -1.0 : r.empty; });
        if (region->isDone || region->empty < kLeastEmpty * solid) break;
        const auto cut = bestCut(grid, region->box);
        if (!cut) {
            region->isDone = true;
            continue;
        }
        empty += cut->low.empty + cut->high.empty - region->empty;
        *region = cut->low;
        regions.push_back(cut->high);
    }
    std::vector<CellBox> boxes;
    for (const Region& region : regions) boxes.push_back(region.box);
    return boxes;
}

/// The planes of the grid that cut, at coordinates of corners of the mesh where some are within a cell.
class PlanePositions {
public:
    PlanePositions(const TriangleMesh& mesh, const CellGrid& grid) : m_grid(grid) {
        for (const auto& p : mesh.points)
            for (std::size_t k = 0; k < 3; ++k) {
                Corners& corners = m_corners[k][std::llround(p[k] / (kSamePlane * grid.cell()))];
                ++corners.count;
                corners.at = p[k];
            }
    }
    [[nodiscard]] double at(int axis, int cell) const {
        const double plane = m_grid.planeAt(axis, cell), unit = kSamePlane * m_grid.cell();
        const auto& corners = m_corners[std::size_t(axis)];
        auto most = corners.end();
        for (auto it = corners.lower_bound(std::llround((plane - m_grid.cell()) / unit));
             it != corners.end() && double(it->first) * unit <= plane + m_grid.cell(); ++it)
            if (most == corners.end() || it->second.count > most->second.count) most = it;
        return most != corners.end() && most->second.count >= kLeastCorners ? most->second.at : plane;
    }

private:
    static constexpr double kSamePlane = 0.01; // of a cell
    static constexpr int kLeastCorners = 3;
    struct Corners {
        int count = 0;
        double at = 0;
    };
    const CellGrid& m_grid;
    std::array<std::map<long long, Corners>, 3> m_corners;
};

/// What is left of a polygon on one side of a plane across an axis; nothing if it only touches the plane, by `thin` m.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double plane, double side, double thin) {
    std::vector<Vec3> left;
    if (std::ranges::none_of(polygon, [&](const Vec3& p) { return side * (p[axis] - plane) > thin; })) return left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = side * (a[axis] - plane), db = side * (b[axis] - plane);
        if (da >= 0) left.push_back(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) left.push_back(a + da / (da - db) * (b - a));
    }
    return left;
}

/// Signed, m: negative inside.
double distanceTo(const TriangleMesh& hull, const Vec3& p) {
    double out = -INFINITY;
    for (const auto& [i, j, k] : hull.triangles) {
        const Vec3 a(hull.points[i].data()), b(hull.points[j].data()), c(hull.points[k].data());
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.norm() > 0) out = std::max(out, normal.normalized().dot(p - a));
    }
    return out;
}

void measure(const TriangleMesh& mesh, ConvexParts& parts) {
    std::vector<Vec3> samples;
    for (const auto& p : mesh.points) samples.emplace_back(p.data());
    for (const auto& [i, j, k] : mesh.triangles) samples.push_back((samples[i] + samples[j] + samples[k]) / 3);
    const std::size_t step = samples.size() / kMostPartSamples + 1, count = (samples.size() + step - 1) / step;
    for (std::size_t i = 0; i < samples.size(); i += step) {
        double nearest = INFINITY;
        for (const TriangleMesh& hull : parts.hulls) nearest = std::min(nearest, distanceTo(hull, samples[i]));
        parts.largest = std::max(parts.largest, std::abs(nearest));
        parts.mean += std::abs(nearest) / double(count);
    }
}

struct Hull {
    TriangleMesh mesh;
    double volume = 0;
};

std::optional<Hull> hullOf(const std::vector<std::array<double, 3>>& points) {
    auto mesh = points.empty() ? std::nullopt : convexHull(farthestPoints(points, kPartPoints));
    if (!mesh) return std::nullopt;
    const double volume = volumeOf(*mesh);
    return Hull{std::move(*mesh), volume};
}

std::optional<Hull> joined(const Hull& a, const Hull& b) {
    std::vector<std::array<double, 3>> points = a.mesh.points;
    points.insert(points.end(), b.mesh.points.begin(), b.mesh.points.end());
    return hullOf(points);
}

/// Makes one of two where that adds least, until there are `most` and each further one would add much.
void joinHulls(std::vector<Hull>& hulls, std::size_t most) {
    double whole = 0;
    for (const Hull& hull : hulls) whole += hull.volume;
    std::map<std::pair<std::size_t, std::size_t>, double> added; // by pair of indices; a hull that is gone has none
    const auto compare = [&](std::size_t a, std::size_t b) {
        if (const auto both = joined(hulls[a], hulls[b]))
            added[std::minmax(a, b)] = both->volume - hulls[a].volume - hulls[b].volume;
    };
    for (std::size_t a = 0; a < hulls.size(); ++a)
        for (std::size_t b = a + 1; b < hulls.size(); ++b) compare(a, b);
    std::vector<bool> isGone(hulls.size(), false);
    std::size_t left = hulls.size();
    while (!added.empty()) {
        const auto least = std::ranges::min_element(added, {}, [](const auto& each) { return each.second; });
        const auto [pair, by] = *least;
        if (left <= most && by > kLeastAdded * whole) break;
        hulls[pair.first] = *joined(hulls[pair.first], hulls[pair.second]);
        isGone[pair.second] = true;
        --left;
        std::erase_if(added, [gone = pair](const auto& each) {
            return each.first.first == gone.first || each.first.second == gone.first || each.first.first == gone.second ||
                   each.first.second == gone.second;
        });
        for (std::size_t other = 0; other < hulls.size(); ++other)
            if (!isGone[other] && other != pair.first) compare(pair.first, other);
    }
    std::size_t next = 0;
    std::erase_if(hulls, [&](const Hull&) { return bool(isGone[next++]); });
}

} // namespace

ConvexParts convexPartsOf(const TriangleMesh& mesh, std::size_t most) {
    ConvexParts parts;
    if (mesh.triangles.empty() || !convexHull(farthestPoints(mesh.points, kPartPoints))) return parts;
    const CellGrid grid(mesh);
    const PlanePositions planes(mesh, grid);
    const CellBox all = grid.all();
    const double thin = kThinPart * grid.cell();
    std::vector<Hull> hulls;
    for (const CellBox& box : cutApart(grid, most > 1 ? kCutsPerPart * most : 1)) {
        std::vector<std::array<double, 3>> points;
        for (const auto& triangle : mesh.triangles) {
            std::vector<Vec3> polygon;
            for (const std::uint32_t corner : triangle) polygon.emplace_back(mesh.points[corner].data());
            for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
                const auto k = std::size_t(axis);
                if (box.low[k] > all.low[k]) polygon = clipped(polygon, axis, planes.at(axis, box.low[k]), 1, thin);
                if (box.high[k] < all.high[k]) polygon = clipped(polygon, axis, planes.at(axis, box.high[k]), -1, thin);
            }
            for (const Vec3& p : polygon) points.push_back({p.x(), p.y(), p.z()});
        }
        if (auto hull = hullOf(points)) hulls.push_back(std::move(*hull)); // none: a flat rest
    }
    joinHulls(hulls, most);
    for (Hull& hull : hulls) {
        parts.volumes.push_back(hull.volume);
        parts.hulls.push_back(std::move(hull.mesh));
    }
    measure(mesh, parts);
    return parts;
}

} // namespace trundle
