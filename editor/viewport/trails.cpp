#include "editor/viewport/trails.h"

#include "editor/viewport/shown_world.h"

namespace trundle {
namespace {

constexpr double kApart = 0.01;        // m
constexpr double kLeap = 1;            // m: a robot that was put elsewhere begins a new trail
constexpr std::size_t kLongest = 3000; // places of one robot
constexpr std::size_t kMostRobots = 400;

} // namespace

Trails::Trails(ShownWorld& world, QObject* parent) : QObject(parent), m_world(world) {
    connect(&world, &ShownWorld::posed, this, &Trails::note);
    connect(&world, &ShownWorld::replaced, this, [this] { m_trails.clear(); });
}

void Trails::setWanted(bool wanted) {
    m_wanted = wanted;
    if (!wanted) m_trails.clear();
}

void Trails::note() {
    if (!m_world.isRunning()) m_trails.clear();
    if (!m_wanted || !m_world.isRunning()) return;
    const auto& robots = m_world.objects()->experiment().robots;
    for (std::uint32_t i = 0; i < robots.size() && i < kMostRobots; ++i) {
        const Vec3 at = m_world.poseOf({ObjectKind::Robot, i}).position;
        std::deque<Vec3>& trail = m_trails[robots[i].name];
        const double far = trail.empty() ? kApart : (at - trail.back()).norm();
        if (far > kLeap) trail.clear();
        if (far < kApart) continue;
        trail.push_back(at);
        if (trail.size() > kLongest) trail.pop_front();
    }
}

} // namespace trundle
