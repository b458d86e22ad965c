#include "remote/robot_link.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <map>

#include "base/clean_text.h"
#include "remote/client.h"

namespace trundle {
namespace {

constexpr std::chrono::milliseconds kWait(100); ///< until a cancellation is seen
constexpr double kLastAnswer = 0.5;             ///< s, after a cancellation: a tick that is executed there is one here too
constexpr std::size_t kReadSize = 64u << 10;
constexpr std::uint64_t kMostPixels = 1u << 16; ///< along a side

/// The member of a reply that may be missing or of another type, as the other end may be any program.
template <class T> std::optional<T> memberOf(const nlohmann::ordered_json& object, const char* name) {
    const auto found = object.is_object() ? object.find(name) : object.end();
    if (found == object.end()) return std::nullopt;
    if constexpr (std::is_same_v<T, std::string>) {
        if (!found->is_string()) return std::nullopt;
    } else if constexpr (std::is_same_v<T, bool>) {
        if (!found->is_boolean()) return std::nullopt;
    } else if (!found->is_number()) return std::nullopt;
    return found->template get<T>();
}

/// One number as such, as drivers of the first version of the protocol need it.
nlohmann::ordered_json jsonOf(const std::vector<double>& numbers) {
    if (numbers.size() == 1) return numbers[0];
    return numbers;
}

} // namespace

Error RobotLink::broken(const std::string& why) const {
    return {Code::SystemRefused, m_options.robot + " at the other end: " + why};
}

Result<std::unique_ptr<RobotLink>> RobotLink::open(Socket socket, RobotLinkOptions options) {
    std::unique_ptr<RobotLink> link(new RobotLink(std::move(socket), std::move(options)));
    if (const Status begun = link->begin(); !begun) return begun.error();
    return link;
}

Status RobotLink::begin() {
    const Result<Json> hello = request({{"op", "hello"}, {"token", m_options.token}, {"protocol", RemoteClient::kProtocol}});
    if (!hello) return hello.error();
    const Result<Json> status = request({{"op", "status"}});
    if (!status) return status.error();
    m_tick = memberOf<double>(status.value(), "tick_s").value_or(0);
    if (!(m_tick > 0)) return broken("it does not say how long its tick is");
    if (const auto state = memberOf<std::string>(status.value(), "state"); state != "paused")
        return broken("the run there is " + cleanLine(state.value_or("in no state")) + ", and has to be paused");
    const Result<Json> robot = request({{"op", "describe"}, {"robot", m_options.robot}});
    if (!robot) return robot.error();
    std::map<std::string, std::string> directions;
    if (const auto signals = robot.value().find("signals"); signals != robot.value().end() && signals->is_array())
        for (const Json& signal : *signals)
            directions[memberOf<std::string>(signal, "path").value_or("")] =
                memberOf<std::string>(signal, "direction").value_or("");
    m_hasController = robot.value().contains("controller") && robot.value()["controller"].is_object();
    if (m_hasController)
        if (const Result<Json> held = request({{"op", "hold"}, {"robot", m_options.robot}, {"held", true}}); !held)
            return held.error();
    m_taken = true;
    const Result<Json> subscribed = request({{"op", "subscribe"}, {"signals", {m_options.robot + "/*"}}, {"every", 0}});
    if (!subscribed) return subscribed.error();
    m_subscription = memberOf<std::uint64_t>(subscribed.value(), "subscription").value_or(0);
    std::size_t offset = 0;
    if (const auto signals = subscribed.value().find("signals"); signals != subscribed.value().end() && signals->is_array())
        for (const Json& signal : *signals) {
            if (!signal.is_array() || signal.size() != 2 || !signal[0].is_string() || !signal[1].is_number_unsigned())
                return broken("its list of signals cannot be read");
            const std::string path = signal[0].get<std::string>();
            m_signals.push_back({path, directions[path], offset, signal[1].get<std::size_t>()});
            offset += m_signals.back().count;
            if (offset > (2u << 20)) return broken("it has too many signals");
        }
    m_values.resize(offset);
    const Result<Json> read = request({{"op", "read"}, {"subscription", m_subscription}});
    return read ? takeValues() : read.error();
}

RobotLink::~RobotLink() {
    if (!m_taken || !m_socket.isOpen()) return;
    m_options.isCancelled = nullptr;
    m_options.seconds = std::min(m_options.seconds, 1.0);
    Json zeros = Json::object();
    for (const Signal& signal : m_signals)
        if (signal.direction == "command") zeros[signal.path] = jsonOf(std::vector<double>(signal.count));
    if (!zeros.empty() && !request({{"op", "command"}, {"signals", std::move(zeros)}})) return;
    if (m_hasController) (void)request({{"op", "hold"}, {"robot", m_options.robot}, {"held", false}});
}

Status RobotLink::step(const std::vector<std::pair<std::string, std::vector<double>>>& commands) {
    Json members{{"op", "step"}, {"ticks", 1}, {"subscription", m_subscription}};
    for (const auto& [path, numbers] : commands) members["signals"][path] = jsonOf(numbers);
    const Result<Json> reply = request(std::move(members));
    return reply ? takeValues() : reply.error();
}

Result<CameraImage> RobotLink::image(const std::string& camera) {
    const Result<Json> reply = request({{"op", "image"}, {"camera", camera}});
    if (!reply) return Error{Code::PictureFailed, reply.error().message};
    const auto size = [&](const char* name) { return memberOf<std::uint64_t>(reply.value(), name).value_or(0); };
    CameraImage image;
    const std::uint64_t width = size("width"), height = size("height"), pixels = size("pixels"), depth = size("depth"),
                        objects = size("objects");
    const std::uint64_t area = width <= kMostPixels && height <= kMostPixels ? width * height : 0;
    const bool isWhole = area > 0 && pixels == 3 * area && (depth == 0 || depth == area * sizeof(float)) &&
                         (objects == 0 || objects == area * sizeof(std::uint32_t)) && m_bytes.size() == pixels + depth + objects;
    if (!isWhole) return broken("its image of " + camera + " cannot be read");
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    image.tick = size("tick");
    image.time = memberOf<double>(reply.value(), "time").value_or(0);
    auto take = [at = m_bytes.data()](auto& elements, std::uint64_t bytes) mutable {
        elements.resize(bytes / sizeof elements[0]);
        if (bytes > 0) std::memcpy(elements.data(), at, bytes);
        at += bytes;
    };
    take(image.pixels, pixels);
    take(image.depth, depth);
    take(image.objects, objects);
    return image;
}

std::string RobotLink::objectName(std::uint32_t number) {
    if (m_objects.empty()) {
        const Result<Json> reply = request({{"op", "objects"}});
        const auto names = reply ? reply.value().find("objects") : Json::const_iterator();
        if (reply && names != reply.value().end() && names->is_array())
            for (const Json& name : *names) m_objects.push_back(name.is_string() ? name.get<std::string>() : std::string());
    }
    return number < m_objects.size() ? m_objects[number] : std::string();
}

Status RobotLink::sendPacket(const std::string& radio, std::string_view bytes, std::uint32_t to, double powerDbm) {
    const Result<Json> reply = request({{"op", "send"}, {"device", radio}, {"to", to}, {"power", powerDbm}}, bytes);
    return reply ? Status() : reply.error();
}

Result<std::optional<RadioPacket>> RobotLink::receivePacket(const std::string& radio) {
    const Result<Json> reply = request({{"op", "receive"}, {"device", radio}});
    if (!reply) return reply.error();
    if (memberOf<bool>(reply.value(), "received") != true) return std::optional<RadioPacket>();
    RadioPacket packet;
    packet.time = memberOf<double>(reply.value(), "time").value_or(0);
    packet.rssi = memberOf<double>(reply.value(), "rssi").value_or(0);
    packet.lqi = memberOf<int>(reply.value(), "lqi").value_or(0);
    packet.from = memberOf<std::uint32_t>(reply.value(), "from").value_or(0);
    packet.to = memberOf<std::uint32_t>(reply.value(), "to").value_or(0);
    packet.sequence = memberOf<std::uint8_t>(reply.value(), "sequence").value_or(0);
    packet.bytes.assign(m_bytes.begin(), m_bytes.end());
    return std::optional(std::move(packet));
}

Status RobotLink::takeValues() {
    if (m_bytes.size() != m_values.size() * sizeof(double)) return broken("it sent a wrong number of values");
    if (!m_bytes.empty()) std::memcpy(m_values.data(), m_bytes.data(), m_bytes.size());
    return {};
}

Result<RobotLink::Json> RobotLink::request(Json members, std::string_view data) {
    Json message{{"id", ++m_number}};
    message.update(members);
    std::string bytes;
    appendFrame(bytes, message.dump(-1, ' ', false, Json::error_handler_t::replace), data);
    m_waited = 0;
    if (const Status sent = send(bytes); !sent) return sent.error();
    return replyTo(m_number);
}

/// Skips events.
Result<RobotLink::Json> RobotLink::replyTo(std::uint64_t number) {
    for (;;) {
        Result<std::optional<Frame>> frame = m_reader.next();
        if (!frame) return broken(frame.error().message);
        if (!frame.value()) {
            if (const Status received = receive(); !received) return received.error();
            continue;
        }
        Json message = Json::parse(frame.value()->json, nullptr, false);
        if (!message.is_object()) return broken("what it sent is not the protocol of trundle-cli serve");
        if (memberOf<std::string>(message, "event") == "reset") return broken("its run was reset by another program");
        if (message.contains("event")) continue;
        if (message.contains("id") && message["id"].is_number() && message["id"] != number) continue;
        if (memberOf<bool>(message, "ok") != true)
            return broken(cleanLine(memberOf<std::string>(message, "message").value_or("it refused a request")));
        m_bytes = std::move(frame.value()->bytes);
        return message;
    }
}

Status RobotLink::send(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::optional<std::size_t> sent = m_socket.write(bytes);
        if (!sent) return broken("the connection was closed");
        bytes.remove_prefix(*sent);
        if (*sent > 0) continue;
        SocketWait wait{m_socket.descriptor(), false, true};
        waitForSockets(std::span(&wait, 1), kWait);
    }
    return {};
}

Status RobotLink::receive() {
    const auto since = std::chrono::steady_clock::now();
    SocketWait wait{m_socket.descriptor(), true, false};
    waitForSockets(std::span(&wait, 1), kWait);
    std::array<char, kReadSize> bytes;
    const std::optional<std::size_t> got = m_socket.read(bytes);
    if (!got) {
        m_socket.close();
        return broken("the connection was closed");
    }
    m_reader.add(std::span(bytes).first(*got));
    m_waited = *got > 0 ? 0 : m_waited + std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    const bool isCancelled = m_options.isCancelled && m_options.isCancelled();
    if (isCancelled && m_waited >= std::min(kLastAnswer, m_options.seconds)) return Error{Code::Interrupted, "interrupted"};
    if (m_waited > m_options.seconds) {
        m_socket.close();
        return broken("no answer for " + std::to_string(static_cast<int>(m_options.seconds)) + " s");
    }
    return {};
}

} // namespace trundle
