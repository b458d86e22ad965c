#include "world/ode/collision/contact_search.h"

#include <cmath>
#include <utility>

namespace trundle {

namespace {

constexpr double kSameWay = 1e-7; // less than 1 the cosine between normals that are the same
constexpr double kSeam = 1e-6;    // m

} // namespace

void ContactSearch::placeGeoms(const OdeBody& body) {
    for (std::uint32_t i = body.geoms.begin; i < body.geoms.end; ++i) {
        const OdeGeom& g = m_objects.geoms[i];
        const Vec3 c = vec(body.p) + turn(body.r, g.offset);
        Vec3 half = Vec3::Constant(g.bound);
        if (!g.wheel && g.shape != GeomShape::Sphere) half = half.cwiseMin(m_objects.axesOf(g).cwiseAbs() * g.half);
        m_objects.centres[i] = c;
        m_objects.boxes[i] = {{c.x() - half.x(), c.y() - half.y(), c.z() - half.z()},
                              {c.x() + half.x(), c.y() + half.y(), c.z() + half.z()}};
    }
}

void ContactSearch::updateBoxes() {
    if (m_gridded != m_objects.statics.size()) {
        std::vector<Box3> boxes;
        for (const std::uint32_t geom : m_objects.statics) boxes.push_back(m_objects.boxes[geom]);
        m_grid.build(std::move(boxes));
        m_gridded = m_objects.statics.size();
    }
    for (std::uint32_t a = 0; a < m_objects.actors.size(); ++a) {
        const OdeActor& actor = m_objects.actors[a];
        Box3 all{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
        for (std::uint32_t b = actor.bodies.begin; b < actor.bodies.end; ++b) {
            placeGeoms(m_objects.bodies[b]);
            for (std::uint32_t i = m_objects.bodies[b].geoms.begin; i < m_objects.bodies[b].geoms.end; ++i)
                all.cover(m_objects.boxes[i]);
        }
        if (all.lo[0] > all.hi[0]) all = {{0, 0, -1e30}, {0, 0, -1e30}}; // never collides: placed far away
        m_objects.actorBoxes[a] = all;
    }
}

bool ContactSearch::areBodiesApart(std::uint32_t first, std::uint32_t second) const {
    return OdeObjects::areApart(m_objects.apartBodies, m_objects.geoms[first].body, m_objects.geoms[second].body);
}

void ContactSearch::find(std::vector<OdeContact>& contacts) {
    updateBoxes();
    contacts.clear();
    m_pairGrid.pairs(m_objects.actorBoxes, m_pairs);
    std::size_t pair = 0;
    for (std::uint32_t a = 0; a < m_objects.actors.size(); ++a) {
        const OdeActor& actor = m_objects.actors[a];
        if (actor.geoms.begin == actor.geoms.end || actor.ended) {
            while (pair < m_pairs.size() && m_pairs[pair].first == a) ++pair;
            continue;
        }
        collideWithScenery(a, contacts);
        for (const auto& [first, second] : actor.selfPairs)
            if (m_objects.boxes[first].touches(m_objects.boxes[second]) && !(actor.isApart && areBodiesApart(first, second)))
                m_collider.meet(first, second, contacts);
        for (; pair < m_pairs.size() && m_pairs[pair].first == a; ++pair) {
            const OdeActor& partner = m_objects.actors[m_pairs[pair].second];
            if (partner.ended) continue;
            const bool someApart = actor.isApart && partner.isApart;
            if (someApart && OdeObjects::areApart(m_objects.apartActors, a, m_pairs[pair].second)) continue;
            for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i) {
                if (!m_objects.boxes[i].touches(m_objects.actorBoxes[m_pairs[pair].second])) continue;
                for (std::uint32_t k = partner.geoms.begin; k < partner.geoms.end; ++k)
                    if (m_objects.boxes[i].touches(m_objects.boxes[k]) && !(someApart && areBodiesApart(i, k)))
                        m_collider.meet(i, k, contacts);
            }
        }
    }
}

void ContactSearch::collideWithScenery(std::uint32_t a, std::vector<OdeContact>& contacts) {
    const OdeActor& actor = m_objects.actors[a];
    const std::size_t begin = contacts.size();
    for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i)
        for (const GroundPlane& plane : m_objects.planes) {
            const Vec3& n = plane.normal;
            const double height = n.dot(m_objects.centres[i]) - plane.distance;
            if (height <= m_objects.geoms[i].bound) m_collider.meetPlane(i, plane, contacts);
        }
    if (m_objects.statics.empty()) return;
    m_grid.query(m_objects.actorBoxes[a], m_found);
    if (m_found.empty()) return;
    for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i)
        for (const std::uint32_t found : m_found)
            if (m_objects.boxes[i].touches(m_objects.boxes[m_objects.statics[found]]))
                m_collider.meet(i, m_objects.statics[found], contacts);
    dropInnerEdges(contacts, begin);
}

/// How far a geom that does not move reaches that way, m, or a little farther.
double ContactSearch::reachOf(std::uint32_t geom, const Vec3& way) const {
    const OdeGeom& g = m_objects.geoms[geom];
    if (g.shape == GeomShape::Plane) return HUGE_VAL;
    if (g.shape == GeomShape::Box)
        return way.dot(m_objects.centres[geom]) + (m_objects.axesOf(g).transpose() * way).cwiseAbs().dot(g.half);
    const Box3& box = m_objects.boxes[geom];
    double reach = 0;
    for (int k = 0; k < 3; ++k) reach += way[k] * (way[k] > 0 ? box.hi : box.lo)[k];
    return reach;
}

/// Whether a contact is on a side of its box, and not beside it.
bool ContactSearch::isOnFace(const OdeContact& c) const {
    const OdeGeom& g = m_objects.geoms[c.second];
    if (g.shape == GeomShape::Plane) return true;
    if (g.shape != GeomShape::Box) return false;
    const Mat3 axes = m_objects.axesOf(g);
    const Vec3 normal = (axes.transpose() * vec(c.normal)).cwiseAbs(),
               beyond = (axes.transpose() * (vec(c.position) - m_objects.centres[c.second])).cwiseAbs() - g.half;
    int along = 0;
    if (normal.maxCoeff(&along) < 1 - kSameWay) return false;
    for (int k = 0; k < 3; ++k)
        if (k != along && beyond[k] > kSeam) return false;
    return true;
}

/// Where what rolls touches a face, another geom that is not above this face cannot hinder it: its edge is a seam of a level floor. A contact
/// there, which points aside or is too deep, would throw what rolls over it.
void ContactSearch::dropInnerEdges(std::vector<OdeContact>& contacts, std::size_t begin) const {
    const auto isSeam = [&](const OdeContact& edge) {
        const GeomShape shape = m_objects.geoms[edge.first].shape;
        if (shape != GeomShape::Sphere && shape != GeomShape::Capsule && shape != GeomShape::Cylinder) return false;
        if (isOnFace(edge)) return false;
        for (std::size_t i = begin; i < contacts.size(); ++i) {
            const OdeContact& face = contacts[i];
            const Vec3 normal = vec(face.normal);
            if (face.first == edge.first && isOnFace(face) &&
                reachOf(edge.second, normal) - normal.dot(vec(face.position)) < kSeam + face.depth)
                return true;
        }
        return false;
    };
    if (contacts.size() < begin + 2) return;
    m_seams.clear();
    for (std::size_t i = begin; i < contacts.size(); ++i)
        if (isSeam(contacts[i])) m_seams.push_back(i);
    while (!m_seams.empty()) {
        contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(m_seams.back()));
        m_seams.pop_back();
    }
}

} // namespace trundle
