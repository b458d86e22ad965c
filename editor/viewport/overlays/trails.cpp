#include "editor/viewport/overlays/trails.h"

#include "editor/viewport/context/viewport_scene.h"

namespace trundle {
namespace {

constexpr double kApart = 0.01;        // m
constexpr double kLeap = 1;            // m; a jump, such as a moved robot, starts a new trail
constexpr std::size_t kLongest = 3000; // points per robot
constexpr std::size_t kMaxTrailRobots = 400;

} // namespace

Trails::Trails(ViewportScene& world, QObject* parent) : QObject(parent), m_world(world) {
    connect(&world, &ViewportScene::posed, this, &Trails::note);
    connect(&world, &ViewportScene::replaced, this, [this] { m_trails.clear(); });
}

void Trails::setWanted(bool wanted) {
    m_wanted = wanted;
    if (!wanted) m_trails.clear();
}

void Trails::note() {
    if (!m_world.isRunning()) m_trails.clear();
    if (!m_wanted || !m_world.isRunning()) return;
    const auto& robots = m_world.objects()->experiment().robots;
    for (std::uint32_t i = 0; i < robots.size() && i < kMaxTrailRobots; ++i) {
        if (robots[i].scenery) continue;
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
