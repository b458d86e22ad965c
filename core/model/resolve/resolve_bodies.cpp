// Resolves bodies and their mass: Body.Mass distributed evenly over the geoms, the sum of the geoms' masses, or a given inertia.
#include "lang/tree_edit.h"
#include "model/kinds/config_fields.h"
#include "model/mass_properties.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

class BodyReader {
public:
    BodyReader(ResolveContext& context, const ExpandedPart& expanded)
        : m_context(context), m_frame(expanded.frame), m_part(*expanded.part), m_overrides(expanded.overrides()),
          m_scope(expanded.frame->scope) {
        m_scope.declare(m_part.params);
        context.evaluator.checkAll(m_scope);
    }

    std::optional<BodySpec> read() {
        m_record = m_context.read(m_part, m_scope, m_overrides, Origin::Config);
        const bool good = readGeoms() && mirrorGeoms() && m_record.complete;
        m_fields = fieldsFrom<BodyFields>(m_record);
        m_body.name = m_part.name;
        m_body.pose = poseOf(m_fields.pos, m_fields.hpr);
        m_body.range = m_part.range;
        m_body.nameRange = m_part.nameRange();
        if (!good) return std::nullopt;
        // The mass of a body with a missing mesh is unknown: a dummy value lets it be shown. The missing file was reported.
        const auto missing = [](const GeomSpec& g) {
            return (g.shape == GeomShape::Mesh || g.shape == GeomShape::Convex) && !g.mesh;
        };
        if (std::any_of(m_body.geoms.begin(), m_body.geoms.end(), missing)) m_body.mass = {1, Vec3::Zero(), Mat3::Identity()};
        else if (!readMass()) return std::nullopt;
        return std::move(m_body);
    }
    [[nodiscard]] const Record& record() const { return m_record; }

private:
    bool readGeoms() {
        if (std::ranges::any_of(m_part.parts, [](const Part& part) { return part.isRepeat(); })) return readRepeated();
        bool good = true;
        for (const Part& part : m_part.parts) {
            if (part.usable && part.is(Role::Geom))
                good = add(part, resolveGeom(m_context, part, m_scope, below(m_overrides, part.name), true)) && good;
            else good = good && !part.kind; // for example a duplicate name
        }
        return good;
    }

    /// The same with those of Repeats: "disc_3.plate".
    bool readRepeated() {
        const std::size_t errors = m_context.diagnostics.errorCount();
        PartExpansion expansion(m_context, m_part, m_scope, m_overrides);
        bool good = m_context.diagnostics.errorCount() == errors;
        for (const Part& part : m_part.parts) good = good && (part.usable || !part.kind);
        expansion.each(Role::Geom, [&](const ExpandedPart& part) {
            std::optional<GeomSpec> geom = resolveGeom(m_context, *part.part, *part.frame->scope, part.overrides(), true);
            if (geom) {
                geom->name = part.name();
                if (!part.place(*geom, m_context)) geom.reset();
            }
            good = add(*part.part, std::move(geom)) && good;
        });
        return good;
    }

    /// Before the mass is read from them, so that it has the bits of a copy by hand.
    bool mirrorGeoms() {
        bool good = true;
        for (const PartFrame* at = m_frame; at->use; at = at->outer)
            for (GeomSpec& geom : m_body.geoms) good = at->placement.mirror(m_context, geom) && good;
        return good;
    }

    bool add(const Part& part, std::optional<GeomSpec> geom) {
        if (!geom) return false;
        m_body.geoms.push_back(std::move(*geom));
        m_parts.push_back(&part);
        return true;
    }

    SourceRange place(const char* property) const { return m_record.rangeOf(property, m_part.nameRange()); }

    bool fail(SourceRange range, const std::string& message) {
        m_context.diagnostics.error(Code::BadMass, range, message);
        return false;
    }

    bool readMass() {
        if (m_context.brokenText(m_part.range)) return false; // the part with errors may contain a mass
        const bool good = m_fields.mass ? spread() : addUp();
        if (!good) return false;
        MassProperties given;
        if (m_fields.centreOfMass) given.centre = vec3(*m_fields.centreOfMass);
        if (m_fields.inertia && !readInertia(*m_fields.inertia, given.inertia)) return false;
        for (const PartFrame* at = m_frame; at->use; at = at->outer) at->placement.mirror(given);
        if (m_fields.centreOfMass) m_body.mass.centre = given.centre;
        if (m_fields.inertia) m_body.mass.inertia = given.inertia;
        const Status status = checkMass(m_body.mass);
        if (status.ok()) return true;
        return fail(place(m_fields.inertia ? "Inertia" : "Mass"),
                    "the mass of " + m_part.title() + " cannot be: " + status.error().message);
    }

    bool readInertia(const std::vector<double>& i, Mat3& m) {
        if (i.size() != 3 && i.size() != 6) {
            m_context.diagnostics.error(Code::WrongCount, place("Inertia"),
                                        "Inertia has " + std::to_string(i.size()) + " elements, it takes three or six numbers");
            return false;
        }
        m = Vec3(i[0], i[1], i[2]).asDiagonal();
        if (i.size() == 6) {
            m(0, 1) = m(1, 0) = i[3];
            m(0, 2) = m(2, 0) = i[4];
            m(1, 2) = m(2, 1) = i[5];
        }
        return true;
    }

    /// A geom's shape as a solid of density 1. An open mesh is replaced by its hull, if its mass is given: then only the inertia
    /// is approximate.
    Result<MassProperties> solid(const GeomSpec& geom, bool openAllowed) {
        if (!geom.mesh) return solidOf(geom);
        MeshShapes& shapes = *m_context.assets.shapes;
        Result<MassProperties> own = shapes.solid(geom.mesh);
        if (own.ok() || !openAllowed) return own;
        const std::shared_ptr<const TriangleMesh> hull = shapes.hull(geom.mesh);
        if (!hull) return Error{Code::BadMass, "the points of the mesh lie in one plane"};
        return shapes.solid(hull);
    }

    /// Distributes Body.Mass evenly over the volumes of the geoms.
    bool spread() {
        std::vector<MassProperties> solids;
        for (std::size_t i = 0; i < m_body.geoms.size(); ++i) {
            const GeomSpec& geom = m_body.geoms[i];
            if (geom.mass || geom.density) {
                m_context.diagnostics.error(Code::Conflict, m_parts[i]->nameRange(),
                                            m_part.title() + " has a Mass, which is spread over its geoms; " +
                                                m_parts[i]->title() + " cannot have its own");
                return false;
            }
            Result<MassProperties> s = solid(geom, true);
            if (!s.ok())
                return fail(m_parts[i]->nameRange(),
                            m_parts[i]->title() + " cannot take part in the mass of its body: " + s.error().message);
            solids.push_back(placed(s.value(), Pose{geom.pose.position, shapeRotation(geom)}));
        }
        if (solids.empty() && !m_fields.inertia) {
            return fail(m_part.nameRange(),
                        m_part.title() + " has a Mass but no geoms to spread it over; give it Inertia or a geom");
        }
        m_body.mass = solids.empty() ? MassProperties{*m_fields.mass, Vec3::Zero(), Mat3::Identity()}
                                     : withMass(sum(solids), *m_fields.mass);
        return true;
    }

    bool addUp() {
        std::vector<MassProperties> solids;
        for (std::size_t i = 0; i < m_body.geoms.size(); ++i) {
            const GeomSpec& geom = m_body.geoms[i];
            if (!geom.mass && !geom.density) continue;
            Result<MassProperties> s = solid(geom, geom.mass.has_value());
            if (!s.ok()) {
                Diagnostic& d = m_context.diagnostics.error(Code::BadMass, m_parts[i]->nameRange(),
                                                            m_parts[i]->title() + " has no mass: " + s.error().message +
                                                                "; give it Mass in place of Density");
                if (const SourceAssignment* a = m_parts[i]->assignments.find("Density")) {
                    d.fixes.push_back({"Mass=1", {{a->keyRange(), "Mass"}, {a->valueRange(), "1"}}});
                }
                return false;
            }
            const double mass = geom.mass ? *geom.mass : s.value().mass * *geom.density;
            solids.push_back(placed(withMass(s.value(), mass), Pose{geom.pose.position, shapeRotation(geom)}));
        }
        if (!solids.empty()) {
            m_body.mass = sum(solids);
            return true;
        }
        // The mass may be in a block of an unknown kind, which is reported.
        if (std::ranges::any_of(m_part.parts, [](const Part& part) { return !part.kind; })) return false;
        Diagnostic& d = m_context.diagnostics.error(Code::BadMass, m_part.nameRange(),
                                                    m_part.title() + " has no mass; give one to it or to its geoms");
        m_context.fixAdd(d, m_part, "Mass", "1");
        return false;
    }

    ResolveContext& m_context;
    const PartFrame* m_frame;
    const Part& m_part;
    const OverrideNode* m_overrides;
    ParamScope m_scope;
    Record m_record;
    BodyFields m_fields;
    BodySpec m_body;
    std::vector<const Part*> m_parts; ///< one for each geom
};

} // namespace

std::optional<BodySpec> resolveBody(ResolveContext& context, const ExpandedPart& expanded, std::string& in, SourceRange& place) {
    BodyReader reader(context, expanded);
    std::optional<BodySpec> body = reader.read();
    const std::optional<std::string> named = bodyOfIn(context, reader.record(), *expanded.frame, expanded.part->name);
    if (!body || !named) return std::nullopt;
    in = *named;
    place = reader.record().rangeOf("In", expanded.part->nameRange());
    return body;
}

} // namespace trundle
