#include "control/host/host_reply.h"

#include <algorithm>

namespace trundle {
namespace {

Status noPictures() { return Error{Code::NoGraphics, "this run takes no pictures"}; }

std::string capture(const ControllerOutputs& outputs, const std::string& camera) {
    WireWriter out;
    const Result<const CameraImage*> taken = outputs.capture ? outputs.capture(camera) : noPictures().error();
    if (!taken) return out.status(taken.error()).take();
    const CameraImage& image = *taken.value();
    out.status({}).number(image.width).number(image.height).number(image.tick).number(image.time);
    return out.numbers(image.pixels).numbers(image.depth).numbers(image.objects).take();
}

std::string findRadio(const ControllerOutputs& outputs, const std::string& robot, const std::string& path,
                      std::vector<std::uint32_t>& radios) {
    const auto found = outputs.radios && path.starts_with(robot + "/") ? outputs.radios->find(path) : std::nullopt;
    WireWriter out;
    out.number<std::uint8_t>(found.has_value());
    if (!found) return out.take();
    if (std::ranges::find(radios, *found) == radios.end()) radios.push_back(*found);
    return out.number(*found).number(outputs.radios->address(*found)).number<std::uint64_t>(outputs.radios->pending(*found)).take();
}

std::string sendPacket(const ControllerOutputs& outputs, std::uint32_t radio, WireReader& in) {
    const auto to = in.number<std::uint32_t>();
    const auto power = in.number<double>();
    const std::vector<std::uint8_t> bytes = in.numbers<std::uint8_t>();
    return WireWriter().number<std::uint8_t>(outputs.radios->send(radio, bytes, to, power)).take();
}

std::string receivePacket(const ControllerOutputs& outputs, std::uint32_t radio) {
    RadioPacket packet;
    WireWriter out;
    const bool any = outputs.radios->receive(radio, packet);
    out.number<std::uint8_t>(any);
    if (any)
        out.number(packet.time).number(packet.rssi).number(packet.lqi).number(packet.from).number(packet.to).number(
            packet.sequence).numbers(packet.bytes);
    return out.take();
}

} // namespace

std::string answerHost(HostRecord record, const std::string& robot, const ControllerOutputs& outputs,
                       std::vector<std::uint32_t>& radios, WireReader& in) {
    switch (record) {
    case HostRecord::Print: {
        const auto severity = in.number<std::int32_t>();
        if (outputs.print) outputs.print(severity, in.text());
        return {};
    }
    case HostRecord::WriteLog: {
        const auto log = in.number<std::int32_t>();
        if (outputs.writeLog) outputs.writeLog(log, in.bytes());
        return {};
    }
    case HostRecord::OpenLog: {
        const std::string name = in.text();
        return WireWriter().number<std::int32_t>(outputs.openLog ? outputs.openLog(name) : -1).take();
    }
    case HostRecord::Capture: return capture(outputs, in.text());
    case HostRecord::SavePicture: {
        const std::string camera = in.text(), fileName = in.text();
        return WireWriter().status(outputs.savePicture ? outputs.savePicture(camera, fileName) : noPictures()).take();
    }
    case HostRecord::ObjectName: {
        const auto object = in.number<std::uint32_t>();
        return WireWriter().bytes(outputs.objectName ? outputs.objectName(object) : std::string()).take();
    }
    case HostRecord::FindRadio: return findRadio(outputs, robot, in.text(), radios);
    case HostRecord::SendPacket:
    case HostRecord::ReceivePacket: {
        const auto radio = in.number<std::uint32_t>();
        if (std::ranges::find(radios, radio) == radios.end()) return WireWriter().number<std::uint8_t>(0).take();
        return record == HostRecord::SendPacket ? sendPacket(outputs, radio, in) : receivePacket(outputs, radio);
    }
    case HostRecord::Done:
    case HostRecord::Updated:
    case HostRecord::Finish:
    case HostRecord::GaveUp:
    case HostRecord::Claim:
    case HostRecord::DeviceCommand:
    case HostRecord::DeviceQuery: break;
    }
    return {};
}

} // namespace trundle
