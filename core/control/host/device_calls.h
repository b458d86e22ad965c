#pragma once
#include <string>
#include <vector>

#include <trundle/device.h>

#include "control/host/wire.h"

namespace trundle {

/// Answers what a device in a host process asks: in its setup of its mount, in act and sense of the services. One per device; the
/// other side is core/sdk/python/trundle/host/devices.py.
class DeviceCalls {
public:
    /// During a call of the device. The other one is null.
    void begin(const TrundleMount* mount, const TrundleServices* services) { m_mount = mount, m_services = services; }

    /// The reply to a call; empty if it has none.
    [[nodiscard]] std::string answer(WireReader& in);

    /// Signals of other devices that it has bound, in order.
    [[nodiscard]] std::vector<double> peers() const;
    void setPeers(const std::vector<double>& values);

private:
    /// In the order of _QUERIES and _COMMANDS there.
    enum class Call : std::uint32_t {
        Joint,
        MeasuredJoint,
        Body,
        Geom,
        Frame,
        Peer,
        PeerNumber,
        PeerText,
        AddAxialInertia,
        AddRotor,
        JointState,
        JointAnchor,
        JointWrench,
        BodyState,
        FramePose,
        Contacts,
        Cast,
        GeomInfo,
        Reflectance,
        Print,
        Motor,
        Servo,
        JointTorque,
        BodyForce,
        SurfaceVelocity,
        Draw
    };
    struct Frame {
        BodyId body;
        Pose pose; ///< in the body
    };
    using Find = std::int32_t (*)(void*, const char*, std::uint32_t*);

    [[nodiscard]] std::string find(Call call, WireReader& in);
    [[nodiscard]] std::string found(Find find, WireReader& in) const;
    [[nodiscard]] std::string addInertia(Call call, WireReader& in);
    [[nodiscard]] std::string addFrame(WireReader& in);
    [[nodiscard]] std::string addPeer(WireReader& in);
    [[nodiscard]] std::string read(Call call, WireReader& in) const;
    [[nodiscard]] std::string readJoint(Call call, std::uint32_t joint) const;
    [[nodiscard]] std::string readContacts(std::uint32_t geom) const;
    [[nodiscard]] std::string readGeom(std::uint32_t geom) const;
    [[nodiscard]] Result<Pose> poseOf(std::uint32_t frame) const;
    [[nodiscard]] std::string cast(WireReader& in) const;
    void drive(Call call, WireReader& in) const;
    void print(WireReader& in) const;

    const TrundleMount* m_mount = nullptr;
    const TrundleServices* m_services = nullptr;
    std::vector<Frame> m_frames;
    std::vector<double*> m_peers;
};

} // namespace trundle
