#include "world/wheeled/wheeled.h"

#include <algorithm>
#include <cstdio>
#include <map>
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
        if (m_experiment.robots.empty()) return m_first.empty();
        if (!m_ground) refuse("there is no level ground: no level Plane or Box below a robot", s.engineRange);
        if (!m_first.empty()) return false;
        for (const RobotSpec& robot : m_experiment.robots) checkRobot(robot);
        checkScenery();
        checkLinks();
        return m_first.empty();
    }
    /// Its first reason; empty where it fits.
    [[nodiscard]] const std::string& reason() const { return m_first; }
    [[nodiscard]] const std::optional<LevelGround>& ground() const { return m_ground; }

    /// That below most robots, of equal ones the highest: whatever their names and order. What is fixed to the world counts last. Where
    /// no robot is above level ground, that which they are deep in.
    void findGround() {
        std::vector<std::pair<const StaticSpec*, const GeomSpec*>> all;
        eachStatic([&](const StaticSpec& s, const GeomSpec& g) {
            m_grounds.add(static_cast<std::uint32_t>(all.size()), g, s.pose * g.pose);
            all.emplace_back(&s, &g);
        });
        auto height = mostCommonLevel(&Heights::lowest);
        if (!height) height = mostCommonLevel(&Heights::middle);
        if (!height) return;
        m_ground = m_grounds.at(*height);
        for (const LevelGround::Slab& slab : m_ground->slabs)
            if (!isSame(m_experiment.surfaces[slab.surface], m_experiment.surfaces[m_ground->surface()]))
                refuse(all[slab.geom].first->name + ": geom " + all[slab.geom].second->name +
                           " is level with the rest of the ground and has another surface",
                       all[slab.geom].second->nameRange);
    }

private:
    void refuse(const std::string& reason, SourceRange range) {
        if (m_first.empty()) m_first = reason;
        if (m_out && m_reported.insert({range, reason}).second)
            m_out->error(Code::NotInEngine, range,
                         "Engine = " + std::string(trundle::nameOf(m_experiment.settings.engine)) +
                             " is not possible: " + reason + "; use Engine = general");
    }

    template <class Use> void eachStatic(Use use) const {
        for (const StaticSpec& s : m_experiment.statics)
            if (s.geoms)
                for (const GeomSpec& g : *s.geoms)
                    if (g.collide) use(s, g);
    }
    /// Same for robots of one config at one height, whose headings may differ.
    using Start = std::tuple<const void*, double, double, double>;
    static Start startOf(const RobotSpec& spec) {
        return {spec.config.get(), spec.pose.position.z(), spec.pose.rotation.x(), spec.pose.rotation.y()};
    }
    struct Heights {
        double lowest = 0;      ///< point of what collides, m
        double middle = -1e300; ///< the highest centre of mass of its bodies, m
    };
    const Heights& heights(const RobotSpec& spec) {
        const auto [known, isNew] = m_heights.try_emplace(startOf(spec));
        if (!isNew) return known->second;
        const ActorDef actor = actorOf(spec);
        known->second.lowest = lowestOf(actor);
        for (const BodyDef& body : actor.bodies)
            known->second.middle = std::max(known->second.middle, (body.pose * body.spec->mass.centre).z());
        return known->second;
    }
    /// Below the given points of its robots.
    std::optional<double> mostCommonLevel(double Heights::*from) {
        std::map<double, std::pair<std::size_t, std::size_t>> robots; // by height of the ground: free and fixed ones
        for (const RobotSpec& robot : m_experiment.robots) {
            const auto level = m_grounds.under(heights(robot).*from, robot.pose.position.head<2>());
            if (level) ++(isFixed(robot) ? robots[level->height].second : robots[level->height].first);
        }
        if (robots.empty()) return {};
        return std::ranges::max_element(robots, {}, [](const auto& entry) { return std::pair(entry.second, entry.first); })
            ->first;
    }
    /// Refuses a free robot on level ground at another height than the ground.
    bool isOnOtherLevel(const RobotSpec& spec) {
        if (isFixed(spec)) return false;
        const double lowest = heights(spec).lowest;
        const auto level = m_grounds.under(lowest, spec.pose.position.head<2>());
        if (!level || lowest - level->height > kOnGround || std::abs(level->height - m_ground->height) < kTouching) return false;
        char text[100];
        std::snprintf(text, sizeof text, "it starts on level ground %.1f mm %s that of other robots",
                      1e3 * std::abs(level->height - m_ground->height), level->height > m_ground->height ? "above" : "below");
        refuse(spec.name + ": " + text, spec.nameRange);
        return true;
    }
    static bool isFixed(const RobotSpec& spec) {
        return spec.scenery || std::ranges::any_of(spec.config->joints, [](const JointSpec& joint) {
                   return joint.type == JointType::Fixed && joint.parent == kWorldBody;
               });
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
            if (const auto why = whyNotScenery(g, s.pose * g.pose, *m_ground, m_movers))
                refuse(s.name + ": " + why->reason, why->range);
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
        const auto [known, isNew] = m_shapes.try_emplace(startOf(spec));
        if (isNew) known->second = shapeOf(spec);
        if (known->second && isBeyondEdge(spec, *known->second)) known->second = nullptr; // once for all of them
    }
    /// Null for one that was refused.
    std::shared_ptr<const ActorShape> shapeOf(const RobotSpec& spec) {
        if (spec.scenery) {
            refuse(spec.name + ": it is scenery with bodies or devices", spec.nameRange);
            return nullptr;
        }
        for (const ComponentSpec& device : spec.config->devices)
            if (device.kind == "Belt" || device.kind == "Track")
                refuse(spec.name + ": " + device.name + " is a " + device.kind + ", which moves a surface", device.nameRange);
            else if (device.kind == "ForceSensor")
                refuse(spec.name + ": " + device.name + " is a ForceSensor, which measures in a joint", device.nameRange);
            else if (device.kind == "Latch")
                refuse(spec.name + ": " + device.name + " is a Latch, which joins robots", device.nameRange);
        if (isOnOtherLevel(spec)) return nullptr;
        NotWheeled why;
        auto shape = ActorReader(m_experiment.surfaces, *m_ground).read(actorOf(spec), why);
        if (!shape) {
            refuse(spec.name + ": " + why.reason, why.range.known() ? why.range : spec.nameRange);
            return shape;
        }
        if (shape->kind == ActorKind::Fixed) return shape;
        m_movers.top = std::max(m_movers.top, (spec.pose * shape->centre).z() + shape->tall);
        for (const Support& s : shape->supports) m_movers.wheel = std::max(m_movers.wheel, s.radius);
        return shape;
    }
    /// Refuses a robot where the ground is not below each support, or below the centre of mass of something loose.
    bool isBeyondEdge(const RobotSpec& spec, const ActorShape& shape) {
        if (shape.kind == ActorKind::Fixed || m_ground->isEndless()) return false;
        const auto isCarried = [&](const Vec3& at, double inside) {
            return m_ground->isBelow((spec.pose * (shape.centre + at)).head<2>(), inside);
        };
        const auto isOver = [&](const Support& s) { return isCarried(s.centre, -kBridged); };
        const auto beyond = std::ranges::find_if_not(shape.supports, isOver);
        if (shape.kind == ActorKind::Vehicle ? beyond == shape.supports.end() : isCarried(Vec3::Zero(), 0)) return false;
        if (std::ranges::none_of(shape.supports, isOver))
            refuse(spec.name + ": there is no level ground below it", spec.nameRange);
        else
            refuse(spec.name + ": " + nameOf(*beyond, *spec.config, shape) + " is beyond the edge of the ground", spec.nameRange);
        return true;
    }
    static std::string nameOf(const Support& support, const RobotConfigSpec& config, const ActorShape& shape) {
        const BodySpec& body = config.bodies[support.body];
        if (support.lever != 0) return "wheel " + body.name;
        std::uint32_t geom = support.geom; // within the body, of those that collide
        for (std::uint32_t i = 0; i < support.body; ++i) geom -= shape.geomCounts[i];
        for (const GeomSpec& g : body.geoms)
            if (g.collide && geom-- == 0) return "geom " + g.name;
        return "body " + body.name;
    }

    const ExperimentSpec& m_experiment;
    Diagnostics* m_out;
    GroundSearch m_grounds;
    std::optional<LevelGround> m_ground;
    Movers m_movers;
    std::string m_first; ///< reason
    std::set<std::pair<SourceRange, std::string>> m_reported;
    std::map<Start, Heights> m_heights;
    std::map<Start, std::shared_ptr<const ActorShape>> m_shapes;
};

} // namespace

bool fitsWheeled(const ExperimentSpec& experiment, Diagnostics& out) { return Fit(experiment, &out).check(); }

std::string whyNotWheeled(const ExperimentSpec& experiment) {
    Fit fit(experiment, nullptr);
    (void)fit.check();
    return fit.reason();
}

std::optional<double> wheeledGround(const ExperimentSpec& experiment) {
    Fit fit(experiment, nullptr);
    fit.findGround();
    return fit.ground() ? std::optional(fit.ground()->height) : std::nullopt;
}

} // namespace trundle
