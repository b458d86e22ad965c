// What rays of range sensors take: fans and lists of rays of the engine beside a loop over ODE's geoms, in the same moving world.
//
//   ray_bench ROBOTS BEAMS RANGE FLOOR PARTS ROUNDS     FLOOR plane or mesh; PARTS 1 (a box) or 5 (hull, bumper, two tyres, slider)
//
// Assumes one robot per square metre, 20 boxes, 20 cylinders, 4 walls; the mesh is rolling ground of 20,000 triangles. Method: all methods
// in turn after each step, processor time of one thread, the median of the rounds. At most 40,000 rays a round are cast, spread over the
// robots; what every round costs once (poses, grid) is charged as if each robot had cast. `fan` comes right after the step, with little in
// the caches, `again` right after it. Prints one JSON object, in us per ray, with the update in us and the largest difference in m.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "base/rng.h"
#include "bench/rays/ode_loop.h"
#include "world/engine.h"
#include "world/rays/ray_kernel.h"
#include "world/rays/ray_targets.h"

using namespace raybench;

namespace {

struct Options {
    int robots = 100, beams = 360;
    double range = 5;
    bool mesh = false;
    int parts = 1, rounds = 11;
};

constexpr double kHeight = 0.07, kSensor = 0.013; // m: of a robot's middle; of the sensor above it

double processorTime() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

class Random {
public:
    double operator()(double low, double high) {
        return low + (high - low) * static_cast<double>(randomBits(7, 1, 0, m_index++) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t m_index = 0;
};

GeomSpec geom(GeomShape shape, const Vec3& size, double radius = 0, double length = 0, const Pose& pose = {}) {
    GeomSpec g;
    g.name = "geom";
    g.shape = shape;
    g.size = size;
    g.radius = radius;
    g.length = length;
    g.pose = pose;
    return g;
}

GeomSpec ground(double side, Random& random) {
    GeomSpec g = geom(GeomShape::Mesh, Vec3::Zero());
    auto mesh = std::make_shared<TriangleMesh>();
    constexpr std::uint32_t n = 100;
    for (std::uint32_t k = 0; k <= n; ++k)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double x = side * i / n, y = side * k / n;
            mesh->points.push_back(
                {x, y,
                 0.06 * std::sin(1.9 * x + 0.3) * std::cos(1.3 * y) + 0.05 * std::sin(0.7 * x - 1.1 * y) + random(0, 0.01)});
        }
    for (std::uint32_t k = 0; k < n; ++k)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = k * (n + 1) + i;
            mesh->triangles.push_back({a, a + 1, a + n + 1});
            mesh->triangles.push_back({a + 1, a + n + 2, a + n + 1});
        }
    g.mesh = mesh;
    return g;
}

/// In the body's frame, whose origin is the middle of the hull.
std::vector<GeomSpec> robotParts(int parts) {
    std::vector<GeomSpec> geoms{geom(GeomShape::Box, {0.3, 0.2, 0.1})};
    if (parts == 1) return geoms;
    const Quat axle = rotationFromHpr({0, 0, std::numbers::pi / 2});
    geoms.push_back(geom(GeomShape::Box, {0.02, 0.3, 0.04}, 0, 0, {{0.16, 0, -0.02}, Quat::Identity()}));
    for (const double side : {-0.125, 0.125})
        geoms.push_back(geom(GeomShape::Cylinder, Vec3::Zero(), 0.05, 0.03, {{0.06, side, -0.04}, axle}));
    geoms.push_back(geom(GeomShape::Sphere, Vec3::Zero(), 0.02, 0, {{-0.12, 0, -0.07}, Quat::Identity()}));
    return geoms;
}

/// The engine and the loop with the same geoms.
class BenchWorld {
public:
    explicit BenchWorld(const Options& options) : m_options(options), m_side(std::sqrt(options.robots)) {
        EngineSettings settings;
        settings.gravity = Vec3::Zero();
        settings.surfaces.push_back({"default", 0, 0, 0, 0, {}});
        m_engine = std::move(makeOdeEngine(settings)).value();
        if (options.mesh) add(ground(m_side, m_random), {});
        else add(geom(GeomShape::Plane, Vec3::Zero()), {});
        for (int i = 0; i < 20; ++i)
            add(geom(GeomShape::Box, {m_random(0.2, 0.6), m_random(0.2, 0.6), 0.5}), {place(0.5, 0.25), heading()});
        for (int i = 0; i < 20; ++i)
            add(geom(GeomShape::Cylinder, Vec3::Zero(), m_random(0.05, 0.2), 0.5), {place(0.5, 0.25), Quat::Identity()});
        for (int i = 0; i < 4; ++i) {
            const double c = i < 2 ? -0.05 : m_side + 0.05, middle = m_side / 2;
            const Vec3 across(0.1, m_side + 0.2, 0.5), along(m_side + 0.2, 0.1, 0.5);
            add(geom(GeomShape::Box, i % 2 ? across : along),
                {i % 2 ? Vec3(c, middle, 0.25) : Vec3(middle, c, 0.25), Quat::Identity()});
        }
        for (int i = 0; i < options.robots; ++i) addRobot();
        m_loop.updateBoxes();
    }

    /// Every robot goes a few millimetres and turns a little, whatever is in its way: rays are measured, not contacts.
    void step() {
        for (std::size_t r = 0; r < m_robots.size(); ++r) {
            const Pose now = poseOf(r);
            Vec3 next = now.position + now.rotation * Vec3(0.005, 0, 0);
            next = Vec3(std::clamp(next.x(), 0.2, m_side - 0.2), std::clamp(next.y(), 0.2, m_side - 0.2), kHeight);
            m_yaws[r] += m_random(-0.05, 0.05);
            m_engine->moveActor(m_robots[r].actor, Pose{next, rotationFromHpr({m_yaws[r], 0, 0})} * now.inverse());
        }
        (void)m_engine->step(0.001);
        for (std::size_t r = 0; r < m_robots.size(); ++r)
            for (std::size_t k = 0; k < m_parts.size(); ++k)
                m_loop.place(m_statics + r * m_parts.size() + k, poseOf(r) * m_parts[k].pose);
        m_loop.updateBoxes();
    }
    [[nodiscard]] Pose poseOf(std::size_t robot) const {
        const BodyState& s = m_engine->state(m_robots[robot].bodies[0]);
        return {s.position, s.rotation};
    }
    [[nodiscard]] std::uint32_t actorOf(std::size_t robot) const { return m_robots[robot].actor.index; }
    [[nodiscard]] const RayTargets& rays() const { return m_engine->rays(); }
    [[nodiscard]] const OdeLoop& loop() const { return m_loop; }
    [[nodiscard]] bool hasMesh() const { return m_options.mesh; }

private:
    Vec3 place(double border, double height) {
        const double x = m_random(border, m_side - border), y = m_random(border, m_side - border);
        return {x, y, height};
    }
    Quat heading() { return rotationFromHpr({m_random(-3, 3), 0, 0}); }
    void add(const GeomSpec& spec, const Pose& pose) {
        (void)m_engine->addStatic(spec, pose);
        m_loop.add(spec, pose, kNoGeom);
        ++m_statics;
    }
    void addRobot() {
        BodySpec body;
        body.name = "body";
        body.geoms = m_parts;
        body.mass = {2, Vec3::Zero(), Mat3(Vec3(0.02, 0.02, 0.02).asDiagonal())};
        m_yaws.push_back(m_random(-3, 3));
        const Pose pose{place(0.2, kHeight), rotationFromHpr({m_yaws.back(), 0, 0})};
        ActorDef def;
        def.frame = pose;
        def.bodies.push_back({pose, &body});
        const std::vector<JointSpec> none;
        def.joints = &none;
        m_robots.push_back(m_engine->addActor(def).value());
        for (const GeomSpec& g : m_parts) m_loop.add(g, pose * g.pose, m_robots.back().actor.index);
    }

    Options m_options;
    double m_side;
    Random m_random;
    std::vector<GeomSpec> m_parts = robotParts(m_options.parts);
    std::unique_ptr<Engine> m_engine;
    OdeLoop m_loop;
    std::size_t m_statics = 0;
    std::vector<ActorHandles> m_robots;
    std::vector<double> m_yaws;
};

/// What a round took, s: once, and the casts.
struct Times {
    std::vector<double> update, fan, again, rays, loop;
};

struct Sensors {
    std::vector<std::size_t> robots;
    RayFan shape;

    [[nodiscard]] RayFan fanOf(const BenchWorld& world, std::size_t robot) const {
        const Pose pose = world.poseOf(robot);
        RayFan fan = shape;
        fan.origin = pose * Vec3(0, 0, kSensor);
        fan.axes = pose.rotation.toRotationMatrix();
        return fan;
    }
    [[nodiscard]] std::vector<SingleRay> raysOf(const RayFan& fan) const {
        std::vector<SingleRay> rays;
        for (std::uint32_t k = 0; k < fan.count; ++k) {
            const double bearing = fan.firstBearing + k * fan.bearingStep;
            rays.push_back({fan.origin, fan.axes * Vec3(std::cos(bearing), std::sin(bearing), 0), fan.range});
        }
        return rays;
    }
};

template <class Cast> double timed(const Sensors& sensors, Cast cast) {
    const double start = processorTime();
    for (std::size_t s = 0; s < sensors.robots.size(); ++s) cast(s);
    return processorTime() - start;
}

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
}

/// All methods in turn, each for all sensors; the largest difference between them, m.
double round(const BenchWorld& world, Sensors& sensors, Times& times) {
    std::vector<RayFan> fans;
    std::vector<std::vector<SingleRay>> lists;
    for (const std::size_t robot : sensors.robots) {
        fans.push_back(sensors.fanOf(world, robot));
        lists.push_back(sensors.raysOf(fans.back()));
    }
    const std::size_t beams = sensors.shape.count;
    std::vector<double> byFan(fans.size() * beams), byRays(byFan.size()), byLoop(byFan.size());
    std::vector<std::uint32_t> geoms(byFan.size());
    const double start = processorTime();
    (void)world.rays().ray({Vec3::Zero(), Vec3::UnitZ(), 1e-3}, kNoGeom);
    times.update.push_back(processorTime() - start);
    times.fan.push_back(timed(sensors, [&](std::size_t s) {
        world.rays().castFan(fans[s], world.actorOf(sensors.robots[s]), {&byFan[s * beams], &geoms[s * beams]});
    }));
    times.again.push_back(timed(sensors, [&](std::size_t s) {
        world.rays().castFan(fans[s], world.actorOf(sensors.robots[s]), {&byFan[s * beams], &geoms[s * beams]});
    }));
    times.rays.push_back(timed(sensors, [&](std::size_t s) {
        world.rays().castRays(lists[s], world.actorOf(sensors.robots[s]), {&byRays[s * beams], &geoms[s * beams]});
    }));
    times.loop.push_back(timed(sensors, [&](std::size_t s) {
        for (std::size_t i = 0; i < beams; ++i) {
            const auto hit = world.loop().cast(lists[s][i], world.actorOf(sensors.robots[s]));
            byLoop[s * beams + i] = hit ? hit->distance : lists[s][i].range;
        }
    }));
    // ODE keeps triangles in single precision, and now and then meets one that a ray passes by.
    return std::max(differenceOf(byFan, byRays), world.hasMesh() ? 0 : differenceOf(byFan, byLoop));
}

} // namespace

int main(int count, char** words) {
    if (count != 7) return std::fputs("ray_bench ROBOTS BEAMS RANGE plane|mesh PARTS ROUNDS\n", stderr), 2;
    const Options options{std::atoi(words[1]), std::atoi(words[2]), std::atof(words[3]), std::strcmp(words[4], "mesh") == 0,
                          std::atoi(words[5]), std::atoi(words[6])};
    BenchWorld world(options);
    const double flat[1] = {0};
    Sensors sensors;
    const int cast = std::clamp(40000 / options.beams, 3, options.robots);
    for (int s = 0; s < cast; ++s) sensors.robots.push_back(static_cast<std::size_t>(s) * options.robots / cast);
    sensors.shape = {Vec3::Zero(),
                     Mat3::Identity(),
                     options.range,
                     0,
                     2 * std::numbers::pi / options.beams,
                     static_cast<std::uint32_t>(options.beams),
                     flat};
    Times times;
    double worst = 0;
    for (int k = 0; k < options.rounds; ++k) {
        world.step();
        worst = std::max(worst, round(world, sensors, times));
    }
    const double rays = static_cast<double>(cast) * options.beams,
                 update = median(times.update) / (options.robots * options.beams);
    std::printf("{\"fan\": %.4f, \"again\": %.4f, \"rays\": %.4f, \"loop\": %.4f, \"update\": %.1f, \"difference\": %.1e, "
                "\"kernel\": \"%s\"}\n",
                1e6 * (median(times.fan) / rays + update), 1e6 * (median(times.again) / rays + update),
                1e6 * (median(times.rays) / rays + update), 1e6 * median(times.loop) / rays, 1e6 * median(times.update), worst,
                rayKernel().name);
}
