#include "remote/client.h"

#include <bit>
#include <cstdio>
#include <cstring>

namespace trundle {

static_assert(std::endian::native == std::endian::little, "values are sent as they are in memory");

void RemoteClient::receive(std::span<const char> bytes) {
    m_reader.add(bytes);
    if (!step || !m_reader.hasNext()) return;
    const auto next = FrameReader(m_reader).next();
    if (!next || !next.value()) return;
    const nlohmann::json request = nlohmann::json::parse(next.value()->json, nullptr, false);
    if (request.is_object() && request.value("op", nlohmann::json()) == "pause") step->ticks = step->done;
}

void RemoteClient::authorize() {
    m_authorized = true;
    m_reader.setLimits(kRequest);
}

void RemoteClient::send(const nlohmann::ordered_json& message, std::string_view bytes) {
    appendFrame(m_out, message.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace), bytes);
}

bool RemoteClient::sendEvent(const nlohmann::ordered_json& message, std::string_view bytes) {
    if (m_closing || unsent().size() > kMostUnsentForEvents) return false;
    send(message, bytes);
    return true;
}

void RemoteClient::sent(std::size_t bytes) {
    m_sent += bytes;
    if (m_sent < m_out.size() && m_sent < kMostUnsent) return;
    m_out.erase(0, m_sent);
    m_sent = 0;
}

std::string hashDigits(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string valuesOf(const Subscription& subscription, const SignalBlock& block) {
    std::string bytes;
    for (const SignalEntry& entry : subscription.entries) {
        const std::size_t start = bytes.size(), size = entry.count * sizeof(double);
        bytes.resize(start + size);
        std::memcpy(bytes.data() + start, block.slots().data() + entry.offset, size);
    }
    return bytes;
}

} // namespace trundle
