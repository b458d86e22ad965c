#include "remote/radio_operations.h"

#include <algorithm>

#include "radio/medium.h"

namespace trundle {
namespace {

constexpr double kFullPowerDbm = 1000;

} // namespace

RadioOperations::Radio RadioOperations::radio(const std::string& device) {
    Radio radio;
    radio.medium = m_request.run.world().medium();
    const std::optional<std::uint32_t> found = radio.medium ? radio.medium->find(device) : std::nullopt;
    if (found) radio.number = *found;
    radio.wrong = found ? Reply::of(m_request.run.checkOwner(device)) : Reply::failed("no_such_path", "there is no radio " + shortenedMessage(device));
    return radio;
}

Reply RadioOperations::send() {
    const std::string device = m_request.arguments.text("device");
    const auto to = static_cast<std::uint32_t>(m_request.arguments.count("to", kBroadcastAddress, kBroadcastAddress));
    const double power = m_request.arguments.number("power", kFullPowerDbm);
    if (auto wrong = m_request.mistake()) return *wrong;
    const Radio from = radio(device);
    if (!from.wrong.error.empty()) return from.wrong;
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(m_request.bytes.data()), m_request.bytes.size());
    if (from.medium->send(from.number, bytes, to, power)) return {};
    return Reply::failed("refused", "the packet is too long, or the radio's queue is full");
}

Reply RadioOperations::receive() {
    const std::string device = m_request.arguments.text("device");
    if (auto wrong = m_request.mistake()) return *wrong;
    const Radio at = radio(device);
    if (!at.wrong.error.empty()) return at.wrong;
    Reply reply;
    RadioPacket packet;
    reply.members["received"] = at.medium->receive(at.number, packet);
    if (reply.members["received"] == false) return reply;
    reply.members.update({{"time", packet.time},
                          {"rssi", packet.rssi},
                          {"lqi", packet.lqi},
                          {"from", packet.from},
                          {"to", packet.to},
                          {"sequence", packet.sequence}});
    reply.bytes.assign(packet.bytes.begin(), packet.bytes.end());
    return reply;
}

} // namespace trundle
