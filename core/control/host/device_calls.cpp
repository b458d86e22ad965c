#include "control/host/device_calls.h"

#include <array>
#include <cmath>

namespace trundle {
namespace {

constexpr std::uint64_t kMostBeams = 1'000'000;

std::string refused(const std::string& why) { return WireWriter().status(Error{Code::ControllerFailed, why}).take(); }

WireWriter accepted() {
    WireWriter out;
    out.status({});
    return out;
}

template <std::size_t N> std::array<double, N> numbersOf(WireReader& in) {
    std::array<double, N> values{};
    for (double& value : values) value = in.number<double>();
    return values;
}
Vec3 vectorOf(WireReader& in) { return Vec3(numbersOf<3>(in).data()); }

void write(WireWriter& out, const double* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) out.number(values[i]);
}
void write(WireWriter& out, const Vec3& v) { write(out, v.data(), 3); }

} // namespace

std::string DeviceCalls::answer(WireReader& in) {
    const auto call = static_cast<Call>(in.number<std::uint32_t>());
    if (call == Call::Print) return print(in), std::string();
    if (call <= Call::AddRotor) return m_mount ? find(call, in) : refused("it is found in setup alone");
    if (call < Call::Print) return m_services ? read(call, in) : refused("the world is read in act and sense alone");
    if (m_services) drive(call, in);
    return {};
}

std::vector<double> DeviceCalls::peers() const {
    std::vector<double> values;
    for (const double* peer : m_peers) values.push_back(*peer);
    return values;
}

void DeviceCalls::setPeers(const std::vector<double>& values) {
    for (std::size_t i = 0; i < std::min(values.size(), m_peers.size()); ++i) *m_peers[i] = values[i];
}

// ---- setup. What is not there the mount reports itself, with the names that are. ----

std::string DeviceCalls::found(Find find, WireReader& in) const {
    const std::string name = in.text();
    std::uint32_t index = 0;
    if (find(m_mount->context, name.c_str(), &index) != 0) return refused("there is no " + name);
    return accepted().number(index).take();
}

std::string DeviceCalls::find(Call call, WireReader& in) {
    const TrundleMount& m = *m_mount;
    switch (call) {
    case Call::Joint: return found(m.joint, in);
    case Call::MeasuredJoint: return found(m.measureJoint, in);
    case Call::Body: return found(m.body, in);
    case Call::Geom: return found(m.geom, in);
    case Call::Frame: return addFrame(in);
    case Call::Peer: return addPeer(in);
    case Call::PeerNumber:
    case Call::PeerText: {
        const std::string device = in.text(), field = in.text();
        double value = 0;
        const bool isNumber = m.peerNumber(m.context, device.c_str(), field.c_str(), &value) == 0;
        const char* text = m.peerText(m.context, device.c_str(), field.c_str());
        if (call == Call::PeerNumber && isNumber) return accepted().number(value).take();
        if (call == Call::PeerText && text) return accepted().bytes(text).take();
        if (isNumber) return refused(device + "." + field + " is a number, no text");
        return refused(text ? device + "." + field + " is a text, no number" : "there is no " + device + "." + field);
    }
    default: return addInertia(call, in);
    }
}

std::string DeviceCalls::addInertia(Call call, WireReader& in) {
    const auto joint = in.number<std::uint32_t>();
    const auto inertia = in.number<double>();
    const bool added = call == Call::AddRotor ? m_mount->addRotor(m_mount->context, joint, inertia, in.number<double>()) == 0
                                              : m_mount->addAxialInertia(m_mount->context, joint, inertia) == 0;
    if (added) return accepted().take();
    return refused(std::isfinite(inertia) && inertia >= 0 ? "the joint takes no inertia" : "an inertia is a number from 0 on");
}

std::string DeviceCalls::addFrame(WireReader& in) {
    const std::string body = in.text();
    const Vec3 position = vectorOf(in), hpr = vectorOf(in);
    std::uint32_t index = 0;
    if (m_mount->body(m_mount->context, body.c_str(), &index) != 0) return refused("there is no body " + body);
    if (!position.allFinite() || !hpr.allFinite()) return refused("the position and the angles of a frame are finite numbers");
    m_frames.push_back({BodyId{index}, {position, rotationFromHpr(hpr)}});
    return accepted().number(static_cast<std::uint32_t>(m_frames.size() - 1)).take();
}

std::string DeviceCalls::addPeer(WireReader& in) {
    const std::string kind = in.text(), device = in.text(), signal = in.text();
    double* slot = m_mount->peerSignal(m_mount->context, kind.c_str(), device.c_str(), signal.c_str());
    if (!slot) return refused("there is no " + device + "/" + signal);
    double direction = TRUNDLE_OUTPUT;
    (void)m_mount->peerNumber(m_mount->context, device.c_str(), (signal + "/direction").c_str(), &direction);
    m_peers.push_back(slot);
    return accepted().number(*slot).number(static_cast<std::uint32_t>(direction)).take();
}

// ---- act and sense ----

Result<Pose> DeviceCalls::poseOf(std::uint32_t frame) const {
    if (frame >= m_frames.size()) return Error{Code::ControllerFailed, "that is no frame of the device"};
    const TrundleBodyState s = Services(*m_services).bodyState(m_frames[frame].body);
    const double* q = s.quaternion;
    return Pose{Vec3(s.position), Quat(q[0], q[1], q[2], q[3])} * m_frames[frame].pose;
}

std::string DeviceCalls::read(Call call, WireReader& in) const {
    const Services world(*m_services);
    if (call == Call::Cast) return cast(in);
    const auto handle = in.number<std::uint32_t>();
    if (call <= Call::JointWrench) return readJoint(call, handle);
    if (call == Call::Contacts) return readContacts(handle);
    if (call == Call::GeomInfo) return readGeom(handle);
    WireWriter out = accepted();
    if (call == Call::BodyState) {
        const TrundleBodyState s = world.bodyState({handle});
        write(out, s.position, 3);
        write(out, s.quaternion, 4);
        write(out, s.linear, 3);
        write(out, s.angular, 3);
    } else if (call == Call::FramePose) {
        const Result<Pose> pose = poseOf(handle);
        if (!pose) return refused(pose.error().message);
        const Quat& q = pose.value().rotation;
        write(out, pose.value().position);
        out.number(q.w()).number(q.x()).number(q.y()).number(q.z());
    } else {
        const Vec3 point = vectorOf(in), normal = vectorOf(in);
        out.number(world.reflectance({handle}, point, normal));
    }
    return out.take();
}

std::string DeviceCalls::readJoint(Call call, std::uint32_t joint) const {
    const Services world(*m_services);
    const JointId id{joint};
    WireWriter out = accepted();
    Vec3 first = Vec3::Zero(), second = Vec3::UnitZ();
    if (call == Call::JointState) {
        return out.number(world.jointPosition(id)).number(world.jointRate(id)).number(world.jointMotorEffort(id)).take();
    } else if (call == Call::JointAnchor) {
        (void)world.jointAnchor(id, first, second);
    } else {
        Wrench wrench;
        out.number<std::uint8_t>(world.jointWrench(id, wrench));
        first = wrench.force;
        second = wrench.torque;
    }
    write(out, first);
    write(out, second);
    return out.take();
}

std::string DeviceCalls::readContacts(std::uint32_t geom) const {
    std::vector<TrundleContact> contacts;
    Services(*m_services).contacts({geom}, contacts);
    WireWriter list;
    for (const TrundleContact& c : contacts) {
        write(list, c.position, 3);
        write(list, c.normal, 3);
        list.number(c.depth).number(c.force).number(c.other);
    }
    return accepted().bytes(list.view()).take();
}

std::string DeviceCalls::readGeom(std::uint32_t geom) const {
    TrundleGeomInfo info{};
    const bool known = Services(*m_services).geomInfo({geom}, info);
    WireWriter out = accepted();
    out.number<std::uint8_t>(known).bytes(info.path).bytes(info.material);
    write(out, info.colour, 3);
    return out.number(info.reflectance).number(info.opacity).number(info.shininess).number(info.object).take();
}

std::string DeviceCalls::cast(WireReader& in) const {
    const auto frame = in.number<std::uint32_t>();
    Fan fan;
    fan.range = in.number<double>();
    fan.firstBearing = in.number<double>();
    fan.bearingStep = in.number<double>();
    fan.count = in.number<std::uint32_t>();
    fan.elevations = in.numbers<double>();
    fan.own = in.number<std::uint8_t>() != 0;
    const Result<Pose> pose = poseOf(frame);
    if (!pose) return refused(pose.error().message);
    if (std::uint64_t{fan.count} * fan.elevations.size() > kMostBeams)
        return refused("a fan has at most " + std::to_string(kMostBeams) + " beams");
    std::vector<double> distances(fan.size());
    std::vector<GeomId> geoms(fan.size());
    std::vector<Vec3> normals(fan.size());
    if (!Services(*m_services).castFan(fan, pose.value(), {distances, geoms, normals}))
        return refused("a fan has at least one beam, a range above 0, and finite numbers");
    return accepted().numbers(distances).numbers(geoms).numbers(normals).take();
}

void DeviceCalls::drive(Call call, WireReader& in) const {
    Actuation world(*m_services);
    if (call == Call::Draw) {
        const auto [watts, conductance] = numbersOf<2>(in);
        return Sensing(*m_services).draw(watts, conductance);
    }
    const auto handle = in.number<std::uint32_t>();
    switch (call) {
    case Call::Motor: {
        const auto [rate, softness, limit] = numbersOf<3>(in);
        return world.motorRow({handle}, rate, softness, limit);
    }
    case Call::Servo: {
        const auto [rate, limit, damping] = numbersOf<3>(in);
        return world.servoRow({handle}, rate, limit, damping);
    }
    case Call::JointTorque: return world.jointTorque({handle}, in.number<double>());
    case Call::BodyForce: {
        const Vec3 force = vectorOf(in), point = vectorOf(in);
        return world.bodyForce({handle}, force, point);
    }
    case Call::SurfaceVelocity: return world.surfaceVelocity({handle}, vectorOf(in));
    default: break;
    }
}

void DeviceCalls::print(WireReader& in) const {
    const auto severity = in.number<std::int32_t>();
    const std::string text = in.text();
    if (m_services) m_services->print(m_services->context, severity, text.c_str());
    else if (m_mount) m_mount->print(m_mount->context, severity, text.c_str());
}

} // namespace trundle
