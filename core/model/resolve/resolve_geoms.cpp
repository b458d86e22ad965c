// Resolves geoms of bodies and of scenery.
#include "base/mesh_appearance.h"
#include "model/kinds/config_fields.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

class GeomReader {
public:
    GeomReader(ResolveContext& context, const Part& part, ParamScope& scope, const OverrideNode* overrides, bool onBody)
        : m_context(context), m_part(part), m_onBody(onBody) {
        ParamScope own(&scope);
        own.declare(part.params);
        context.evaluator.checkAll(own);
        m_record = context.read(part, own, overrides, Origin::Config);
    }

    std::optional<GeomSpec> read() {
        lookUpNames();
        if (!m_record.complete) return std::nullopt;
        m_geom.name = m_part.name;
        m_geom.range = m_part.range;
        m_geom.nameRange = m_part.nameRange();
        const bool read = readShape();
        recordDefaults();
        return read ? std::optional<GeomSpec>(std::move(m_geom)) : std::nullopt;
    }

private:
    void lookUpNames() {
        m_geom.material = m_context.materialIndex(m_record, m_part);
        m_geom.surface = m_context.surfaceIndex(m_record, m_part);
    }

    void recordDefaults() {
        const bool ownAppearance = m_geom.shape == GeomShape::Mesh && m_geom.mesh && m_geom.mesh->look;
        const bool looks = m_record.given("Material") || ownAppearance, touches = m_record.given("Surface");
        if (looks && touches) return;
        if (!m_context.defaultedParts.insert(&m_part).second) return; // already recorded for another instance of the config
        m_context.defaulted.emplace_back(&m_part, looks ? "Surface" : touches ? "Material" : "Material and no Surface");
    }

    void common(const GeomFields& f) {
        m_geom.pose = poseOf(f.pos, f.hpr);
        m_geom.collide = f.collide;
        m_geom.visible = f.visible;
    }

    bool solid(const SolidFields& f) {
        common(f);
        m_geom.mass = f.mass;
        m_geom.density = f.density;
        if (!f.mass || !f.density) return true;
        m_context.diagnostics.error(Code::Conflict, m_record.rangeOf("Density", m_part.nameRange()),
                                    m_part.title() + " has both Mass and Density, only one can hold");
        return false;
    }

    bool readShape() {
        const std::string& kind = m_part.kind->name;
        if (kind == "Box") return readBox();
        if (kind == "Sphere") return readSphere();
        if (kind == "Cylinder") return readRound<CylinderFields>(GeomShape::Cylinder);
        if (kind == "Capsule") return readRound<CapsuleFields>(GeomShape::Capsule);
        if (kind == "Convex") return readConvex();
        if (kind == "Mesh") return readMesh();
        if (kind == "Heightfield") return readHeightfield();
        m_geom.shape = GeomShape::Plane;
        common(fieldsFrom<PlaneFields>(m_record));
        return true;
    }

    bool readBox() {
        const auto f = fieldsFrom<BoxFields>(m_record);
        m_geom.shape = GeomShape::Box;
        m_geom.size = vec3(f.size);
        return solid(f);
    }

    bool readSphere() {
        const auto f = fieldsFrom<SphereFields>(m_record);
        m_geom.shape = GeomShape::Sphere;
        m_geom.radius = f.radius;
        return solid(f);
    }

    template <class Fields> bool readRound(GeomShape shape) {
        const auto f = fieldsFrom<Fields>(m_record);
        m_geom.shape = shape;
        m_geom.radius = f.radius;
        m_geom.length = f.length;
        return solid(f);
    }

    /// The mesh of File, scaled; nullptr after a diagnostic. If the file is missing, the geom has no mesh and a placeholder is
    /// drawn.
    std::shared_ptr<const TriangleMesh> load(const std::string& file, const std::vector<double>& scale) {
        const SourceRange place = m_record.rangeOf("File", m_part.nameRange());
        if (scale.size() == 2) {
            m_context.diagnostics.error(Code::WrongCount, m_record.rangeOf("Scale", m_part.nameRange()),
                                        "Scale has 2 elements, it takes one or three numbers");
            return nullptr;
        }
        if (!m_context.assets.mesh) return nullptr;
        Result<FoundAsset<TriangleMesh>> found = m_context.assets.mesh(file, place.file);
        if (!found.ok()) {
            m_context.diagnostics.error(found.error().code, place, found.error().message);
            m_missing = true;
            return nullptr;
        }
        m_geom.file = found.value().path;
        const std::shared_ptr<const TriangleMesh>& mesh = found.value().content;
        if (mesh->triangles.empty() || mesh->points.empty()) {
            m_context.diagnostics.error(Code::BadGeometry, place, "the mesh " + file + " has no triangles");
            return nullptr;
        }
        const double first = scale.empty() ? 1 : scale[0];
        const auto scaled = m_context.assets.shapes->scaled(mesh, scale.size() == 3 ? std::array{scale[0], scale[1], scale[2]}
                                                                                    : std::array{first, first, first});
        return inReach(*scaled, file, place) ? scaled : nullptr;
    }

    bool inReach(const TriangleMesh& mesh, const std::string& file, SourceRange place) {
        double most = 0;
        for (const auto& p : mesh.points) most = std::max({most, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
        if (most <= 1e5) return true;
        m_context.diagnostics.error(Code::BadGeometry, place,
                                    "the mesh " + file + " reaches " + numberText(most) +
                                        " m from its origin, more than 100000 m; is a Scale missing?");
        return false;
    }

    std::shared_ptr<const TriangleMesh> hullOf(const std::shared_ptr<const TriangleMesh>& mesh) {
        if (auto hull = m_context.assets.shapes->hull(mesh)) return hull;
        m_context.diagnostics.error(Code::BadGeometry, m_record.rangeOf("File", m_part.nameRange()),
                                    "the points of the mesh lie in one plane, they have no convex hull");
        return nullptr;
    }

    bool readConvex() {
        const auto f = fieldsFrom<ConvexFields>(m_record);
        m_geom.shape = GeomShape::Convex;
        const std::shared_ptr<const TriangleMesh> mesh = load(f.file, f.scale);
        if (!mesh) return m_missing && solid(f);
        m_geom.hull = hullOf(mesh);
        if (!m_geom.hull) return false;
        m_geom.mesh = m_geom.hull;
        m_geom.collideAsHull = true;
        return solid(f);
    }

    bool readMesh() {
        const auto f = fieldsFrom<MeshFields>(m_record);
        m_geom.shape = GeomShape::Mesh;
        m_geom.mesh = load(f.file, f.scale);
        if (!m_geom.mesh) return m_missing && solid(f);
        if (!solid(f)) return false;
        if (m_geom.mesh->look && !m_record.given("Material"))
            for (const std::string& warning : m_geom.mesh->look->warnings)
                m_context.diagnostics.warning(Code::MeshUnreadable, m_record.rangeOf("File", m_part.nameRange()),
                                              "the mesh " + f.file + ": " + warning);
        const std::string shape = f.shape.value_or(m_onBody ? "hull" : "mesh");
        if (shape == "none") m_geom.collide = false;
        m_geom.collideAsHull = shape == "hull" && m_geom.collide;
        if (m_geom.collideAsHull) m_geom.hull = hullOf(m_geom.mesh);
        return !m_geom.collideAsHull || m_geom.hull;
    }

    bool readHeightfield() {
        const auto f = fieldsFrom<HeightfieldFields>(m_record);
        m_geom.shape = GeomShape::Heightfield;
        m_geom.size = vec3(f.size);
        common(f);
        const SourceRange place = m_record.rangeOf("File", m_part.nameRange());
        if (!m_context.assets.heightMap) return false;
        Result<FoundAsset<HeightMap>> found = m_context.assets.heightMap(f.file, place.file);
        if (!found.ok()) {
            m_context.diagnostics.error(found.error().code, place, found.error().message);
            return true; // a placeholder is drawn
        }
        m_geom.file = found.value().path;
        m_geom.heightMap = found.value().content;
        const HeightMap& map = *m_geom.heightMap;
        if (map.columns >= 2 && map.rows >= 2 && map.heights.size() == std::size_t{map.columns} * map.rows) return true;
        m_context.diagnostics.error(Code::BadGeometry, place, "the picture " + f.file + " is smaller than 2 x 2 points");
        return false;
    }

    ResolveContext& m_context;
    const Part& m_part;
    bool m_onBody, m_missing = false;
    Record m_record;
    GeomSpec m_geom;
};

} // namespace

std::optional<GeomSpec> resolveGeom(ResolveContext& context, const Part& part, ParamScope& scope, const OverrideNode* overrides,
                                    bool onBody) {
    return GeomReader(context, part, scope, overrides, onBody).read();
}

} // namespace trundle
