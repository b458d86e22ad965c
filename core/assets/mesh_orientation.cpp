// Method: triangles that share an edge are joined into shells, by union-find; two that share one are wound alike if they run along
// it in opposite directions, and each keeps whether it is wound like the first of its shell. A shell is closed if each edge is
// used as often in one direction as in the other. The sign of its volume shows which side is outside. Time is linear in the
// triangles, but for meshes with shells of both signs, where one may be a cavity of another: there triangles are compared with
// points, with a limit.
#include "assets/mesh_orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace trundle {
namespace {

using Point = std::array<double, 3>;

constexpr double kFlat = 1e-9;                  // a smaller volume, relative to the sum of its parts, is only rounding
constexpr std::uint64_t kMaxSteps = 50'000'000; // comparisons between shells: half a second

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Union-find over triangles.
class TriangleGroups {
public:
    explicit TriangleGroups(std::size_t count) : m_parent(count), m_isReversed(count), m_isOpen(count) {
        std::iota(m_parent.begin(), m_parent.end(), 0u);
    }

    struct Place {
        std::uint32_t first; ///< of the group: its lowest number
        bool isReversed;     ///< unlike the first
    };
    Place find(std::uint32_t triangle) {
        bool isReversed = false;
        while (m_parent[triangle] != triangle) {
            const std::uint32_t parent = m_parent[triangle];
            m_isReversed[triangle] ^= m_isReversed[parent]; // 0 for a first one
            isReversed ^= m_isReversed[triangle] != 0;
            m_parent[triangle] = m_parent[parent];
            triangle = m_parent[parent];
        }
        return {triangle, isReversed};
    }
    void join(std::uint32_t a, std::uint32_t b, bool isReversed) {
        Place one = find(a), other = find(b);
        const bool isFirstReversed = isReversed != (one.isReversed != other.isReversed);
        if (one.first == other.first) {
            if (isFirstReversed) m_isOpen[one.first] = 1; // it has no inside
            return;
        }
        if (other.first < one.first) std::swap(one, other);
        m_parent[other.first] = one.first;
        m_isReversed[other.first] = isFirstReversed;
        m_isOpen[one.first] |= m_isOpen[other.first];
    }
    void open(std::uint32_t triangle) { m_isOpen[find(triangle).first] = 1; }
    [[nodiscard]] bool isOpen(std::uint32_t first) const { return m_isOpen[first] != 0; }

private:
    std::vector<std::uint32_t> m_parent;
    std::vector<std::uint8_t> m_isReversed, m_isOpen; // relative to the parent; of groups, by their first triangle
};

/// A triangle at an edge: the higher of the edge's points, the triangle, and whether it runs from the higher to the lower one.
using EdgeUse = std::uint64_t;
std::uint32_t triangleOf(EdgeUse use) { return static_cast<std::uint32_t>(use) >> 1; }
bool runsDown(EdgeUse use) { return (use & 1) != 0; }

/// Calls `visit` with the triangles around each edge.
template <class Visit> void forEdges(const TriangleMesh& mesh, Visit visit) {
    const auto forUses = [&](auto add) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
                if (a != b) add(std::min(a, b), EdgeUse{std::max(a, b)} << 32 | EdgeUse{t} << 1 | EdgeUse{a > b});
            }
        }
    };
    std::vector<std::uint32_t> start(mesh.points.size() + 1, 0); // of the uses of the edges up from each point
    forUses([&](std::uint32_t low, EdgeUse) { ++start[low + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<EdgeUse> uses(start.back());
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    forUses([&](std::uint32_t low, EdgeUse use) { uses[next[low]++] = use; });
    for (std::size_t point = 0; point + 1 < start.size(); ++point) {
        const auto end = uses.begin() + start[point + 1];
        std::sort(uses.begin() + start[point], end);
        for (auto at = uses.begin() + start[point]; at != end;) {
            const auto from = at;
            at = std::find_if(at, end, [&](EdgeUse use) { return use >> 32 != *from >> 32; });
            visit(std::span<const EdgeUse>(from, at));
        }
    }
}

/// Triangles joined by edges. Signs are those of its first triangle.
struct Shell {
    std::uint32_t first = 0;
    bool isOpen = false;
    Point low{}, high{};
    double volume = 0, parts = 0; ///< six times; the sum of the tetrahedra that it consists of, and of their sizes

    [[nodiscard]] bool isClosed() const { return !isOpen && std::abs(volume) > kFlat * parts; }
    [[nodiscard]] double width() const { return dot(minus(high, low), minus(high, low)); }
};

class Shells {
public:
    explicit Shells(const TriangleMesh& mesh)
        : m_mesh(mesh), m_shells(mesh.triangles.size()), m_isReversed(mesh.triangles.size()) {
        TriangleGroups groups(mesh.triangles.size());
        forEdges(mesh, [&](std::span<const EdgeUse> uses) { join(groups, uses); });
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto [first, isReversed] = groups.find(t);
            if (first == t) m_all.push_back({.first = t, .isOpen = groups.isOpen(t), .low = corner(t, 0), .high = corner(t, 0)});
            m_shells[t] = first == t ? static_cast<std::uint32_t>(m_all.size() - 1) : m_shells[first];
            m_isReversed[t] = isReversed;
            add(m_all[m_shells[t]], t);
        }
    }

    /// Which triangles are to be reversed; empty if none.
    [[nodiscard]] std::vector<bool> reversedTriangles() {
        const auto reversed = reversedShells();
        if (!reversed) return {};
        std::vector<bool> result(m_shells.size());
        bool isAny = false;
        for (std::size_t t = 0; t < result.size(); ++t) {
            result[t] = m_all[m_shells[t]].isClosed() && m_isReversed[t] != (*reversed)[m_shells[t]];
            isAny = isAny || result[t];
        }
        return isAny ? result : std::vector<bool>();
    }

private:
    [[nodiscard]] const Point& corner(std::uint32_t triangle, std::size_t i) const {
        return m_mesh.points[m_mesh.triangles[triangle][i]];
    }

    static void join(TriangleGroups& groups, std::span<const EdgeUse> uses) {
        // Of more than two it is not known which belong together: they stay as they are.
        for (const EdgeUse use : uses.subspan(1))
            groups.join(triangleOf(uses[0]), triangleOf(use), uses.size() == 2 && runsDown(use) == runsDown(uses[0]));
        const auto down = static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), runsDown));
        if (uses.size() != 2 && 2 * down != uses.size()) groups.open(triangleOf(uses[0]));
    }

    void add(Shell& shell, std::uint32_t triangle) const {
        const Point& origin = corner(shell.first, 0); // of the shell itself, for precision
        const Point a = minus(corner(triangle, 0), origin), b = minus(corner(triangle, 1), origin),
                    c = minus(corner(triangle, 2), origin);
        const double volume = dot(a, cross(b, c));
        shell.volume += m_isReversed[triangle] ? -volume : volume;
        shell.parts += std::abs(volume);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                shell.low[k] = std::min(shell.low[k], corner(triangle, i)[k]);
                shell.high[k] = std::max(shell.high[k], corner(triangle, i)[k]);
            }
        }
    }

    /// Those that are inside out and not in a sound one, and what is in them. Nothing if that takes too long to find out.
    [[nodiscard]] std::optional<std::vector<bool>> reversedShells() {
        std::vector<bool> result(m_all.size());
        std::vector<std::uint32_t> closed;
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < m_all.size(); ++i) {
            if (!m_all[i].isClosed()) continue;
            closed.push_back(i);
            result[i] = m_all[i].volume < 0;
            count += result[i] ? 1 : 0;
        }
        if (count == 0 || count == closed.size()) return result;
        sortTriangles();
        std::stable_sort(closed.begin(), closed.end(), [&](auto a, auto b) { return m_all[a].width() > m_all[b].width(); });
        std::array<std::vector<std::uint32_t>, 2> outer; // sound ones and others; none is in one of the other kind
        std::uint64_t steps = 0;
        for (const std::uint32_t s : closed) {
            const bool isInsideOut = result[s];
            const auto& others = outer[isInsideOut ? 0 : 1];
            if (std::any_of(others.begin(), others.end(), [&](std::uint32_t o) { return isInside(s, o, steps); }))
                result[s] = !isInsideOut;
            else outer[isInsideOut ? 1 : 0].push_back(s);
            if (steps > kMaxSteps) return std::nullopt;
        }
        return result;
    }

    /// Fills m_sorted and m_starts.
    void sortTriangles() {
        m_starts.assign(m_all.size() + 1, 0);
        for (const std::uint32_t shell : m_shells) ++m_starts[shell + 1];
        std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
        m_sorted.resize(m_shells.size());
        std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
        for (std::uint32_t t = 0; t < m_shells.size(); ++t) m_sorted[next[m_shells[t]]++] = t;
    }

    /// A ray from a point of one shell crosses the other one an odd number of times.
    [[nodiscard]] bool isInside(std::uint32_t shell, std::uint32_t other, std::uint64_t& steps) const {
        ++steps;
        for (std::size_t k = 0; k < 3; ++k)
            if (m_all[shell].low[k] < m_all[other].low[k] || m_all[shell].high[k] > m_all[other].high[k]) return false;
        const std::uint32_t first = m_all[shell].first;
        Point from{}; // not on an edge, where shells often touch
        for (std::size_t k = 0; k < 3; ++k)
            from[k] = 0.5 * corner(first, 0)[k] + 0.3 * corner(first, 1)[k] + 0.2 * corner(first, 2)[k];
        bool isOdd = false;
        for (std::uint32_t i = m_starts[other]; i < m_starts[other + 1]; ++i) isOdd ^= isCrossed(m_sorted[i], from);
        steps += m_starts[other + 1] - m_starts[other];
        return isOdd;
    }

    /// By a ray in a direction along which meshes have no edges (Möller and Trumbore 1997).
    [[nodiscard]] bool isCrossed(std::uint32_t triangle, const Point& from) const {
        constexpr Point direction{0.913, 0.271, 0.304};
        const Point a = corner(triangle, 0), ab = minus(corner(triangle, 1), a), ac = minus(corner(triangle, 2), a);
        const Point p = cross(direction, ac), to = minus(from, a), q = cross(to, ab);
        const double determinant = dot(ab, p);
        if (determinant == 0) return false;
        const double u = dot(to, p) / determinant, v = dot(direction, q) / determinant;
        return u >= 0 && v >= 0 && u + v <= 1 && dot(ac, q) / determinant > 0;
    }

    const TriangleMesh& m_mesh;
    std::vector<Shell> m_all;
    std::vector<std::uint32_t> m_shells;           // of triangles
    std::vector<bool> m_isReversed;                // triangles: unlike the first of their shell
    std::vector<std::uint32_t> m_sorted, m_starts; // triangles by shell, and where in them each shell starts
};

} // namespace

void orientOutwards(TriangleMesh& mesh) {
    if (const std::vector<bool> reversed = Shells(mesh).reversedTriangles(); !reversed.empty()) reverseTriangles(mesh, reversed);
}

} // namespace trundle
