#include "devices/track_drive.h"

#include <cmath>
#include <utility>

namespace trundle {
namespace {

Quat rotationOf(const TrundleBodyState& body) {
    const double* q = body.quaternion;
    return {q[0], q[1], q[2], q[3]};
}

} // namespace

void TrackDrive::describe(Describe<TrackDrive>& d) {
    d.help("A base on two tracks: turns speeds of the robot into speeds of the tracks.").independent();
    d.field("LeftTrack", &TrackDrive::m_leftName, reference("Track").required(), "The left track.");
    d.field("RightTrack", &TrackDrive::m_rightName, reference("Track").required(), "The right track.");
    d.field("TrackSeparation", &TrackDrive::m_separationM, metres().within(1e-4, 1e3).required(), "Between the tracks' middles.");
    d.field("SkidFactor", &TrackDrive::m_skidFactor, number().within(1, 100),
            "Multiplies TrackSeparation: tracks that skid sideways have to be this much faster for a turn.");
    describeAcceleration(d);
    describeTurning(d);
    DifferentialDriveSignals::describe(d);
}

void TrackDrive::setup(Mount& mount) {
    if (m_leftName == m_rightName) return mount.fail("LeftTrack and RightTrack are the same track");
    m_left.port = mount.peer<TrackSignals>(m_leftName);
    m_right.port = mount.peer<TrackSignals>(m_rightName);
    m_left.body = mount.body(mount.peerText(m_leftName, "Geom"));
    m_right.body = mount.body(mount.peerText(m_rightName, "Geom"));
}

void TrackDrive::act(Actuation& world) {
    const ChassisMotion velocity{linearVelocity.read(world), angularVelocity.read(world)};
    const ChassisMotion amount{linearAmount.read(world), angularAmount.read(world)};
    const ChassisMotion now = follow(world, velocity, amount, sequence.read(world));
    const double difference = now.angular * m_separationM * m_skidFactor / 2;
    m_left.port.set(&TrackSignals::speed, now.linear - difference);
    m_right.port.set(&TrackSignals::speed, now.linear + difference);
}

double TrackDrive::travelledSince(TrackState& track) {
    const double now = track.port.get(&TrackSignals::travel);
    return now - std::exchange(track.travel, now);
}

void TrackDrive::sense(Sensing& world) {
    const double left = travelledSince(m_left), right = travelledSince(m_right);
    m_odometryPose = alongArc(m_odometryPose, {(left + right) / 2, (right - left) / (m_separationM * m_skidFactor), 0});
    publishState(*this, m_odometryPose);
    const TrundleBodyState a = world.bodyState(m_left.body), b = world.bodyState(m_right.body);
    const Vec3 forward = rotationOf(a) * Vec3::UnitX();
    publishPose(*this, PlanePose{(a.position[0] + b.position[0]) / 2, (a.position[1] + b.position[1]) / 2,
                                 std::atan2(forward.y(), forward.x())});
    const double side = m_left.body == m_right.body ? m_separationM / 2 : 0;
    slip.set(0, slipOf(world, m_left, side));
    slip.set(1, slipOf(world, m_right, -side));
}

double TrackDrive::slipOf(const Services& world, TrackState& track, double side) {
    const TrundleBodyState body = world.bodyState(track.body);
    const Quat rotation = rotationOf(body);
    const double forward = Vec3(body.linear).dot(rotation * Vec3::UnitX()),
                 turn = Vec3(body.angular).dot(rotation * Vec3::UnitZ());
    return track.port.get(&TrackSignals::rate) - (forward - side * turn);
}

} // namespace trundle
