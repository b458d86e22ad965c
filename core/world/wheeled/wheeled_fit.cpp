#include "world/wheeled/wheeled.h"

#include <set>
#include <tuple>

#include "world/wheeled/actor_shape.h"

namespace trundle {

namespace {

class Fit {
public:
    Fit(const ExperimentSpec& experiment, Diagnostics* out) : m_experiment(experiment), m_out(out) {}

    bool check() {
        const SettingsSpec& s = m_experiment.settings;
        if (!(s.gravity.z() < 0)) refuse("Gravity does not pull down", s.engineRange);
        findGround();
        if (m_experiment.robots.empty()) return true;
        if (!m_ground) refuse("there is no level ground: no level Plane or Box below the first robot", s.engineRange);
        if (!m_fits) return false;
        checkScenery();
        for (const RobotSpec& robot : m_experiment.robots) checkRobot(robot);
        checkLinks();
        return m_fits;
    }

private:
    void refuse(const std::string& reason, SourceRange range) {
        m_fits = false;
        if (m_out && m_reported.insert({range, reason}).second)
            m_out->error(Code::NotInEngine, range,
                         "Engine = " + std::string(nameOf(m_experiment.settings.engine)) + " is not possible: " + reason +
                             "; use Engine = general");
    }

    template <class Use> void eachStatic(Use use) const {
        for (const StaticSpec& s : m_experiment.statics)
            if (s.geoms)
                for (const GeomSpec& g : *s.geoms)
                    if (g.collide) use(s, g);
    }
    /// Below the first robot.
    void findGround() {
        GroundSearch grounds;
        std::vector<std::pair<const StaticSpec*, const GeomSpec*>> all;
        eachStatic([&](const StaticSpec& s, const GeomSpec& g) {
            grounds.add(static_cast<std::uint32_t>(all.size()), g, s.pose * g.pose);
            all.emplace_back(&s, &g);
        });
        if (m_experiment.robots.empty()) return;
        const RobotSpec& first = m_experiment.robots[0];
        m_ground = grounds.under(lowestOf(actorOf(first)), first.pose.position.head<2>());
        if (!m_ground) return;
        for (const LevelGround::Slab& slab : m_ground->slabs)
            if (!isSame(m_experiment.surfaces[slab.surface], m_experiment.surfaces[m_ground->surface()]))
                refuse(all[slab.geom].first->name + ": geom " + all[slab.geom].second->name +
                           " is level with the rest of the ground and has another surface",
                       all[slab.geom].second->nameRange);
    }
    static bool isSame(const SurfaceSpec& a, const SurfaceSpec& b) {
        const auto values = [](const SurfaceSpec& s) {
            return std::tuple(s.friction, s.friction2, s.frictionHeading, s.restitution, s.rollingFriction, s.softness);
        };
        return values(a) == values(b);
    }
    static ActorDef actorOf(const RobotSpec& spec) {
        ActorDef def{spec.pose, {}, &spec.config->joints, spec.config->selfCollision, &spec.config->springs, &spec.config->gears};
        for (const BodySpec& body : spec.config->bodies) def.bodies.push_back({spec.pose * body.pose, &body});
        return def;
    }
    void checkScenery() {
        eachStatic([&](const StaticSpec& s, const GeomSpec& g) {
            if (const auto why = whyNotScenery(g, s.pose * g.pose, *m_ground)) refuse(s.name + ": " + why->reason, why->range);
            else if (hasTwoFrictions(m_experiment.surfaces[g.surface]))
                refuse(s.name + ": geom " + g.name + " " + kTwoFrictions, g.nameRange);
        });
    }
    void checkLinks() {
        for (const auto& link : m_experiment.joints) refuse(link.spec.name + ": it joins robots", link.spec.nameRange);
        for (const auto& link : m_experiment.springs) refuse(link.spec.name + ": it joins robots", link.spec.nameRange);
        if (!m_experiment.noContact.empty())
            refuse("NoContact lets robots pass through each other", m_experiment.settings.engineRange);
    }
    void checkRobot(const RobotSpec& spec) {
        const auto key = std::tuple(static_cast<const void*>(spec.config.get()), spec.pose.position.z(), spec.pose.rotation.x(),
                                    spec.pose.rotation.y());
        if (!m_known.insert(key).second) return;
        if (spec.scenery) return refuse(spec.name + ": it is scenery with bodies or devices", spec.nameRange);
        for (const ComponentSpec& device : spec.config->devices)
            if (device.kind == "Belt" || device.kind == "Track")
                refuse(spec.name + ": " + device.name + " is a " + device.kind + ", which moves a surface", device.nameRange);
            else if (device.kind == "ForceSensor")
                refuse(spec.name + ": " + device.name + " is a ForceSensor, which measures in a joint", device.nameRange);
            else if (device.kind == "Latch")
                refuse(spec.name + ": " + device.name + " is a Latch, which joins robots", device.nameRange);
        NotWheeled why;
        if (!ActorReader(m_experiment.surfaces, *m_ground).read(actorOf(spec), why))
            refuse(spec.name + ": " + why.reason, why.range.known() ? why.range : spec.nameRange);
    }

    const ExperimentSpec& m_experiment;
    Diagnostics* m_out;
    std::optional<LevelGround> m_ground;
    bool m_fits = true;
    std::set<std::pair<SourceRange, std::string>> m_reported;
    std::set<std::tuple<const void*, double, double, double>> m_known;
};

} // namespace

bool fitsWheeled(const ExperimentSpec& experiment, Diagnostics* out) { return Fit(experiment, out).check(); }

} // namespace trundle
