// Needs: finite points. Assumes: distances below 1e-9 of the extent are rounding errors. Method: quickhull - start with a
// tetrahedron, take the point farthest outside a face, replace all faces visible from it by a fan over their horizon edges. Data:
// faces with their neighbours and the points still outside them. A point whose horizon is not a simple loop (by rounding) counts
// as inside.
#include "model/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <trundle/geometry.h>

namespace trundle {

namespace {

struct Face {
    std::array<int, 3> corner;
    std::array<int, 3> neighbour{-1, -1, -1}; ///< across the edge corner[i] -> corner[i + 1]
    Vec3 normal;
    double offset;
    std::vector<int> outside;
    bool alive = true;
};

class QuickHull {
public:
    explicit QuickHull(std::vector<Vec3> points) : m_points(std::move(points)) {}

    bool build() {
        if (!start()) return false;
        for (std::size_t f = 0; f < m_faces.size(); ++f) { // new faces are appended, so the loop reaches all
            while (m_faces[f].alive && !m_faces[f].outside.empty()) grow(static_cast<int>(f));
        }
        return true;
    }

    TriangleMesh mesh() const {
        TriangleMesh out;
        std::map<int, std::uint32_t> places;
        for (const Face& face : m_faces) {
            if (!face.alive) continue;
            std::array<std::uint32_t, 3> triangle;
            for (int i = 0; i < 3; ++i) {
                const auto [it, fresh] = places.try_emplace(face.corner[i], static_cast<std::uint32_t>(out.points.size()));
                if (fresh)
                    out.points.push_back(
                        {m_points[face.corner[i]].x(), m_points[face.corner[i]].y(), m_points[face.corner[i]].z()});
                triangle[i] = it->second;
            }
            out.triangles.push_back(triangle);
        }
        return out;
    }

private:
    double distance(const Face& face, int point) const { return face.normal.dot(m_points[point]) - face.offset; }

    int addFace(int a, int b, int c) {
        Face face{{a, b, c}, {-1, -1, -1}, Vec3::Zero(), 0, {}, true};
        face.normal = (m_points[b] - m_points[a]).cross(m_points[c] - m_points[a]);
        const double length = face.normal.norm();
        if (length > 0) face.normal /= length;
        face.offset = face.normal.dot(m_points[a]);
        m_faces.push_back(std::move(face));
        return static_cast<int>(m_faces.size()) - 1;
    }

    bool start() {
        if (m_points.size() < 4) return false;
        Vec3 low = m_points[0], high = m_points[0];
        for (const Vec3& p : m_points) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        m_tolerance = (high - low).norm() * 1e-9;
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const auto byAxis = [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
        const auto ends = std::minmax_element(m_points.begin(), m_points.end(), byAxis);
        const int a = static_cast<int>(ends.first - m_points.begin()), b = static_cast<int>(ends.second - m_points.begin());
        const Vec3 line = m_points[b] - m_points[a];
        if (!(line.norm() > m_tolerance) || !(m_tolerance > 0)) return false;
        const int c = farthest([&](const Vec3& p) { return (p - m_points[a]).cross(line).norm() / line.norm(); });
        if (c < 0) return false;
        Vec3 normal = line.cross(m_points[c] - m_points[a]).normalized();
        const int d = farthest([&](const Vec3& p) { return std::abs(normal.dot(p - m_points[a])); });
        if (d < 0) return false;
        const bool above = normal.dot(m_points[d] - m_points[a]) > 0;
        const int b2 = above ? c : b, c2 = above ? b : c;
        addFace(a, b2, c2);
        addFace(a, d, b2);
        addFace(b2, d, c2);
        addFace(c2, d, a);
        linkAll();
        std::vector<int> all(m_points.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
        distribute(all, {0, 1, 2, 3});
        return true;
    }

    template <class Measure> int farthest(const Measure& measure) const {
        int best = -1;
        double most = m_tolerance;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const double value = measure(m_points[i]);
            if (value > most) {
                most = value;
                best = static_cast<int>(i);
            }
        }
        return best;
    }

    void linkAll() {
        std::map<std::pair<int, int>, std::pair<int, int>> edges;
        for (int f = 0; f < 4; ++f)
            for (int i = 0; i < 3; ++i) edges[{m_faces[f].corner[i], m_faces[f].corner[(i + 1) % 3]}] = {f, i};
        for (const auto& [edge, place] : edges)
            m_faces[place.first].neighbour[place.second] = edges.at({edge.second, edge.first}).first;
    }

    void distribute(const std::vector<int>& points, const std::vector<int>& faces) {
        for (int p : points) {
            for (int f : faces) {
                if (distance(m_faces[f], p) <= m_tolerance) continue;
                m_faces[f].outside.push_back(p);
                break;
            }
        }
    }

    struct RimEdge {
        int from, to, beyond;
    };

    /// Collects the faces visible from `eye`, starting at `first`, and their horizon edges.
    bool visibleFaces(int eye, int first, std::vector<int>& seen, std::vector<RimEdge>& rim) {
        m_mark.resize(m_faces.size(), 0);
        ++m_round;
        seen = {first};
        m_mark[first] = m_round;
        for (std::size_t k = 0; k < seen.size(); ++k) {
            for (int i = 0; i < 3; ++i) {
                const int n = m_faces[seen[k]].neighbour[i];
                if (m_mark[n] == m_round) continue;
                if (distance(m_faces[n], eye) > m_tolerance) {
                    m_mark[n] = m_round;
                    seen.push_back(n);
                }
            }
        }
        std::map<int, int> starts;
        for (int f : seen) {
            for (int i = 0; i < 3; ++i) {
                const int n = m_faces[f].neighbour[i];
                if (m_mark[n] == m_round) continue;
                const int from = m_faces[f].corner[i];
                if (!starts.try_emplace(from, static_cast<int>(rim.size())).second) return false;
                rim.push_back({from, m_faces[f].corner[(i + 1) % 3], n});
            }
        }
        std::vector<RimEdge> ordered;
        for (int at = rim.empty() ? -1 : rim[0].from; at >= 0 && ordered.size() <= rim.size();) {
            const auto it = starts.find(at);
            if (it == starts.end()) return false;
            ordered.push_back(rim[it->second]);
            at = ordered.back().to;
            if (at == ordered.front().from) break;
        }
        if (ordered.size() != rim.size() || ordered.size() < 3) return false;
        rim = std::move(ordered);
        return true;
    }

    void grow(int f) {
        std::vector<int>& outside = m_faces[f].outside;
        const auto best = std::max_element(outside.begin(), outside.end(),
                                           [&](int a, int b) { return distance(m_faces[f], a) < distance(m_faces[f], b); });
        const int eye = *best;
        outside.erase(best);
        std::vector<int> seen;
        std::vector<RimEdge> rim;
        if (!visibleFaces(eye, f, seen, rim)) return;
        const int first = static_cast<int>(m_faces.size()), count = static_cast<int>(rim.size());
        std::vector<int> fresh;
        for (int i = 0; i < count; ++i) {
            const int face = addFace(rim[i].from, rim[i].to, eye);
            m_faces[face].neighbour = {rim[i].beyond, first + (i + 1) % count, first + (i + count - 1) % count};
            Face& beyond = m_faces[rim[i].beyond];
            for (int k = 0; k < 3; ++k) {
                if (beyond.corner[k] == rim[i].to && beyond.corner[(k + 1) % 3] == rim[i].from) beyond.neighbour[k] = face;
            }
            fresh.push_back(face);
        }
        std::vector<int> loose;
        for (int s : seen) {
            m_faces[s].alive = false;
            for (int p : m_faces[s].outside) {
                if (p != eye) loose.push_back(p);
            }
            m_faces[s].outside.clear();
        }
        distribute(loose, fresh);
    }

    std::vector<Vec3> m_points;
    std::vector<Face> m_faces;
    std::vector<int> m_mark;
    int m_round = 0;
    double m_tolerance = 0;
};

} // namespace

std::optional<TriangleMesh> convexHull(const std::vector<std::array<double, 3>>& points) {
    std::vector<std::array<double, 3>> unique = points;
    std::sort(unique.begin(), unique.end());
    unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
    std::vector<Vec3> all;
    all.reserve(unique.size());
    for (const auto& p : unique) all.emplace_back(p[0], p[1], p[2]);
    QuickHull hull(std::move(all));
    if (!hull.build()) return std::nullopt;
    return hull.mesh();
}

std::vector<std::array<double, 3>> farthestPoints(const std::vector<std::array<double, 3>>& points, std::size_t most) {
    if (points.size() <= most) return points;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < most; ++i) { // directions along a Fibonacci spiral
        const double z = 1 - 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(most);
        const double turn = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
        const Vec3 direction(r * std::cos(turn), r * std::sin(turn), z);
        const auto reach = [&](std::size_t k) { return direction.dot(Vec3(points[k].data())); };
        std::size_t best = 0;
        for (std::size_t k = 1; k < points.size(); ++k)
            if (reach(k) > reach(best)) best = k;
        chosen.push_back(best);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<std::array<double, 3>> out;
    for (const std::size_t k : chosen) out.push_back(points[k]);
    return out;
}

} // namespace trundle
