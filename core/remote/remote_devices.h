#pragma once
// What a controller reaches of a robot that is elsewhere besides its signals: images of its cameras, and its radios.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "control/backend.h"
#include "remote/remote_world.h"
#include "signals/camera_image.h"

namespace trundle {

/// Images come from the other end. Views and image files are made by another source, which is opened when they are needed.
class RemoteImages final : public ImageSource {
public:
    using OpenSource = std::function<Result<std::unique_ptr<ImageSource>>()>;
    RemoteImages(RobotLink& link, OpenSource open) : m_link(link), m_open(std::move(open)) {}

    [[nodiscard]] Result<CameraImage> capture(const std::string& camera, const SignalBlock& block) override;
    [[nodiscard]] Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                           const SignalBlock& block) override;
    [[nodiscard]] Result<std::string> encode(const CameraImage& frame, const std::string& camera,
                                             const std::string& fileName) override;

private:
    [[nodiscard]] Result<ImageSource*> source();

    RobotLink& m_link;
    OpenSource m_open;
    std::unique_ptr<ImageSource> m_source;
};

/// The radios of the robot. A request that fails because the connection is gone ends the run with the next tick.
class RemoteRadios final : public RadioAccess {
public:
    explicit RemoteRadios(RemoteWorld& world);

    std::optional<std::uint32_t> find(const std::string& path) override;
    bool exists(std::uint32_t radio) const override { return radio < m_radios.size(); }
    std::uint32_t address(std::uint32_t radio) const override;
    bool send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) override;
    bool receive(std::uint32_t radio, RadioPacket& packet) override;
    std::size_t pending(std::uint32_t radio) const override;

private:
    struct Radio {
        std::string path;
        std::size_t address, pending; ///< slots
        std::uint64_t tick = 0;       ///< in which `taken` packets were received
        std::size_t taken = 0;
    };
    RemoteWorld& m_world;
    std::vector<Radio> m_radios;
};

} // namespace trundle
