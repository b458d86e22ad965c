#include "editor/viewport/view/auto_framing.h"

#include <algorithm>

#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/view.h"

namespace trundle {
namespace {

constexpr double kMargin = 0.5; // of the radius of where the robots were

bool isSame(const CameraView& a, const CameraView& b) { return a.eye == b.eye && a.target == b.target; }

} // namespace

void AutoFraming::watch(const View& view) { m_watched[&view] = {view.camera().destination().view(), robots()}; }

void AutoFraming::update(View& view) {
    const auto found = m_watched.find(&view);
    if (found == m_watched.end() || !view.isVisible() || view.camera().isMoving()) return;
    Watched& watched = found->second;
    const ViewCamera& camera = view.camera().free();
    const bool isFree = camera.kind() == ViewKind::Perspective && !view.camera().isThrough() && view.camera().named().empty();
    if (!isFree || !isSame(camera.view(), watched.camera)) return void(m_watched.erase(found)); // the user has moved it
    if (m_context.session.state() != RunState::Running || showsRobot(view)) return;
    Bounds all = watched.robots;
    all.add(robots());
    const Vec3 size = all.size();
    if (size.z() > std::max(size.x(), size.y())) return; // a robot that falls is not followed
    watched.robots = all;
    all.grow(kMargin * all.radius());
    view.frame(all, true);
    watched.camera = view.camera().destination().view();
}

Bounds AutoFraming::robots() const {
    Bounds all;
    const std::size_t count = m_context.world.objects()->experiment().robots.size();
    for (std::uint32_t i = 0; i < count; ++i) all.add(m_context.world.boundsOf({ObjectKind::Robot, i}));
    return all;
}

/// Ends at the first that it finds.
bool AutoFraming::showsRobot(const View& view) const {
    const std::size_t count = m_context.world.objects()->experiment().robots.size();
    for (std::uint32_t i = 0; i < count; ++i) {
        const Bounds robot = m_context.world.boundsOf({ObjectKind::Robot, i});
        const auto at = robot.empty() ? std::nullopt : view.camera().pixelOf(robot.centre());
        if (at && view.rect().contains(at->toPoint())) return true;
    }
    return count == 0;
}

} // namespace trundle
