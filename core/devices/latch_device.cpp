#include "devices/latch_device.h"

namespace trundle {

void Latch::describe(Describe<Latch>& d) {
    d.help("Holds what is within its reach, as a coupling, a magnet or a suction cup does, while its command engage is 1.");
    d.field("Body", &Latch::m_bodyName, reference("Body").required(), "The body it is fixed to, and holds other things to.");
    d.field("Pos", &Latch::m_position, metres().within(-1e5, 1e5), "Its position in the body.");
    d.field("HPR", &Latch::m_hpr, degrees().within(-1e6, 1e6), "Heading, pitch and roll in the body; it reaches along x.");
    d.field("Reach", &Latch::m_reach, metres().above(0).atMost(1e3).live(),
            "How far from Pos the nearest surface of another robot or of scenery may be.");
    d.field("MaxForce", &Latch::m_maxForce, newtons().above(0).atMost(1e9).live(),
            "A larger force tears it off, until engage ends; not given: none does.");
    LatchSignals::describe(d);
}

void Latch::setup(Mount& mount) {
    m_body = mount.body(m_bodyName);
    m_pose = {Vec3(m_position.data()), rotationFromHpr(Vec3(m_hpr.data()))};
}

GeomId Latch::find(const Services& world) const {
    const TrundleBodyState s = world.bodyState(m_body);
    const Pose at = Pose{Vec3(s.position), Quat(s.quaternion[0], s.quaternion[1], s.quaternion[2], s.quaternion[3])} * m_pose;
    TrundleHit hit{};
    if (!world.ray(at.position, at.rotation * Vec3::UnitX(), m_reach, hit)) return {};
    return GeomId{hit.geom};
}

void Latch::act(Actuation& world) {
    const bool wanted = engage.read(world) != 0;
    if (!wanted) m_tornOff = false;
    Wrench load;
    const bool holds = world.held(load);
    if (holds && (!wanted || m_tornOff)) world.release();
    if (holds || !wanted || m_tornOff) return;
    if (const GeomId near = find(world); near) (void)world.hold(m_body, near);
}

void Latch::sense(Sensing& world) {
    Wrench load{Vec3::Zero(), Vec3::Zero()};
    const bool holds = world.held(load);
    const double pull = holds ? load.force.norm() : 0;
    m_tornOff = m_tornOff || (holds && m_maxForce && pull > *m_maxForce);
    engaged.set(holds && !m_tornOff);
    inReach.set(bool(find(world)));
    force.set(pull);
}

} // namespace trundle
