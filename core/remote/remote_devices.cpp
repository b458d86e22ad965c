#include "remote/remote_devices.h"

#include <algorithm>
#include <utility>

namespace trundle {

// ---- images ----

/// The other end draws what this state shows: its clock waits for the controllers here.
Result<CameraImage> RemoteImages::capture(const std::string& camera, const SignalBlock& block) {
    Result<CameraImage> image = m_link.image(camera);
    if (!image) return image;
    image.value().tick = block.header().tick;
    image.value().time = block.header().time;
    return image;
}

Result<ImageSource*> RemoteImages::source() {
    if (!m_source) {
        Result<std::unique_ptr<ImageSource>> opened = m_open();
        if (!opened) return opened.error();
        m_source = std::move(opened).value();
    }
    return m_source.get();
}

Result<CameraImage> RemoteImages::view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                       const SignalBlock& block) {
    const Result<ImageSource*> source = this->source();
    return source ? source.value()->view(name, width, height, block) : source.error();
}

Result<std::string> RemoteImages::encode(const CameraImage& frame, const std::string& camera, const std::string& fileName) {
    const Result<ImageSource*> source = this->source();
    return source ? source.value()->encode(frame, camera, fileName) : source.error();
}

// ---- radios ----

RemoteRadios::RemoteRadios(RemoteWorld& world) : m_world(world) {
    const RobotSpec& robot = world.experiment().robots[0];
    for (const ComponentSpec& device : robot.config->devices) {
        const std::string path = robot.name + "/" + device.name;
        const auto address = world.layout().find(path + "/address"), pending = world.layout().find(path + "/pending");
        const bool isThere = std::ranges::find(world.missing(), path + "/pending") == world.missing().end();
        if (device.kind == "Transceiver" && address && pending && isThere)
            m_radios.push_back({path, address->offset, pending->offset});
    }
}

std::optional<std::uint32_t> RemoteRadios::find(const std::string& path) {
    const auto found = std::ranges::find(m_radios, path, &Radio::path);
    if (found == m_radios.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - m_radios.begin());
}

std::uint32_t RemoteRadios::address(std::uint32_t radio) const {
    return static_cast<std::uint32_t>(m_world.block().slots()[m_radios[radio].address]);
}

bool RemoteRadios::send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) {
    const std::string_view data(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return m_world.link().sendPacket(m_radios[radio].path, data, to, powerDbm).ok();
}

std::size_t RemoteRadios::pending(std::uint32_t radio) const {
    const Radio& r = m_radios[radio];
    const double count = m_world.block().slots()[r.pending];
    const std::size_t taken = r.tick == m_world.ticks() ? r.taken : 0;
    return count > static_cast<double>(taken) ? static_cast<std::size_t>(count) - taken : 0;
}

/// Asks the other end only if something is in the buffer there.
bool RemoteRadios::receive(std::uint32_t radio, RadioPacket& packet) {
    if (pending(radio) == 0) return false;
    Radio& r = m_radios[radio];
    if (std::exchange(r.tick, m_world.ticks()) != m_world.ticks()) r.taken = 0;
    ++r.taken;
    Result<std::optional<RadioPacket>> received = m_world.link().receivePacket(r.path);
    if (!received || !received.value()) return false;
    packet = std::move(*received.value());
    return true;
}

} // namespace trundle
