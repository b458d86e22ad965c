#include "host/host_outputs.h"

#include <algorithm>

#include "control/host/wire.h"

namespace trundle {
namespace {

constexpr std::size_t kLongestPiece = 256u << 10;

/// The images that a controller has got, each valid until the next one of its camera.
using Images = std::map<std::string, CameraImage>;

Result<const CameraImage*> capture(RecordSender& sender, std::uint32_t controller, const std::string& camera, Images& images) {
    const std::string reply = sender.ask(HostRecord::Capture, controller, WireWriter().bytes(camera).view());
    WireReader in(reply);
    if (Status status = in.status(); !status) return status.error();
    CameraImage& image = images[camera];
    image.width = in.number<std::uint32_t>();
    image.height = in.number<std::uint32_t>();
    image.tick = in.number<std::uint64_t>();
    image.time = in.number<double>();
    image.pixels = in.numbers<std::uint8_t>();
    image.depth = in.numbers<float>();
    image.objects = in.numbers<std::uint32_t>();
    return &image;
}

} // namespace

std::optional<std::uint32_t> HostRadios::find(const std::string& path) {
    const std::string reply = m_sender.ask(HostRecord::FindRadio, m_controller, WireWriter().bytes(path).view());
    WireReader in(reply);
    if (in.number<std::uint8_t>() == 0) return std::nullopt;
    const auto radio = in.number<std::uint32_t>();
    Known& known = m_known[radio];
    known.address = in.number<std::uint32_t>();
    known.pending = in.number<std::uint64_t>();
    return radio;
}

bool HostRadios::send(std::uint32_t radio, std::span<const std::uint8_t> bytes, std::uint32_t to, double powerDbm) {
    WireWriter out;
    out.number(radio).number(to).number(powerDbm).bytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const std::string reply = m_sender.ask(HostRecord::SendPacket, m_controller, out.view());
    return WireReader(reply).number<std::uint8_t>() != 0;
}

bool HostRadios::receive(std::uint32_t radio, RadioPacket& packet) {
    Known& known = m_known.at(radio);
    if (known.pending == 0) return false;
    const std::string reply = m_sender.ask(HostRecord::ReceivePacket, m_controller, WireWriter().number(radio).view());
    WireReader in(reply);
    if (in.number<std::uint8_t>() == 0) {
        known.pending = 0;
        return false;
    }
    --known.pending;
    packet.time = in.number<double>();
    packet.rssi = in.number<double>();
    packet.lqi = in.number<int>();
    packet.from = in.number<std::uint32_t>();
    packet.to = in.number<std::uint32_t>();
    packet.sequence = in.number<std::uint8_t>();
    packet.bytes = in.numbers<std::uint8_t>();
    return true;
}

void HostRadios::setPending(std::uint32_t radio, std::size_t packets) {
    if (const auto known = m_known.find(radio); known != m_known.end()) known->second.pending = packets;
}

ControllerOutputs makeHostOutputs(RecordSender& sender, std::uint32_t controller, std::shared_ptr<RadioAccess> radios) {
    ControllerOutputs outputs;
    outputs.radios = std::move(radios);
    outputs.print = [&sender, controller](int severity, const std::string& text) {
        sender.record(HostRecord::Print, controller, WireWriter().number<std::int32_t>(severity).bytes(text).view());
    };
    outputs.claim = [&sender, controller](const std::string& command) {
        const std::string reply = sender.ask(HostRecord::Claim, controller, WireWriter().bytes(command).view());
        return WireReader(reply).status();
    };
    outputs.finish = [&sender, controller](const std::string& reason) {
        sender.record(HostRecord::Finish, controller, WireWriter().bytes(reason).view());
    };
    outputs.gaveUp = [&sender, controller](const std::string& text) {
        sender.record(HostRecord::GaveUp, controller, WireWriter().bytes(text).view());
    };
    outputs.openLog = [&sender, controller](const std::string& fileName) {
        const std::string reply = sender.ask(HostRecord::OpenLog, controller, WireWriter().bytes(fileName).view());
        return static_cast<int>(WireReader(reply).number<std::int32_t>());
    };
    outputs.writeLog = [&sender, controller](int log, std::string_view bytes) {
        for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kLongestPiece)))
            sender.record(HostRecord::WriteLog, controller,
                          WireWriter().number<std::int32_t>(log).bytes(bytes.substr(0, kLongestPiece)).view());
    };
    outputs.capture = [&sender, controller, images = std::make_shared<Images>()](const std::string& camera) {
        return capture(sender, controller, camera, *images);
    };
    outputs.savePicture = [&sender, controller](const std::string& camera, const std::string& fileName) {
        const std::string reply =
            sender.ask(HostRecord::SavePicture, controller, WireWriter().bytes(camera).bytes(fileName).view());
        return WireReader(reply).status();
    };
    outputs.objectName = [&sender, controller](std::uint32_t object) {
        const std::string reply = sender.ask(HostRecord::ObjectName, controller, WireWriter().number(object).view());
        return WireReader(reply).text();
    };
    return outputs;
}

} // namespace trundle
