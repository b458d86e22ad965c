#pragma once
// A robot at the other end of a socket: a served run, or a driver of a real robot. The client side of the protocol in
// resources/guide/remote.md, for one robot.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/platform/socket.h"
#include "radio/radio_state.h"
#include "remote/frame.h"
#include "signals/camera_image.h"

namespace trundle {

struct RobotLinkOptions {
    std::string token, robot;          ///< what the other end asks for; the robot's name, the same at both ends
    double seconds = 10;               ///< without an answer, then the connection has failed
    std::function<bool()> isCancelled; ///< asked while waiting
};

class RobotLink {
public:
    struct Signal {
        std::string path, direction; ///< "robot0/base/odometry"; output, command or truth
        std::size_t offset, count;   ///< in values()
    };

    /// Takes the robot over, from its controller if it has one there, and reads its signals. Fails if the other end does not speak the
    /// protocol, refuses the token, has no such robot or is a run that is not paused.
    [[nodiscard]] static Result<std::unique_ptr<RobotLink>> open(Socket socket, RobotLinkOptions options);
    /// Sets all commands to 0 and gives the robot back, if the other end still answers.
    ~RobotLink();

    [[nodiscard]] double tick() const { return m_tick; } ///< s between two steps
    [[nodiscard]] const std::vector<Signal>& signals() const { return m_signals; }
    [[nodiscard]] std::span<const double> values() const { return m_values; }
    /// Sends commands by path, waits until a tick has passed there, and reads all signals.
    [[nodiscard]] Status step(const std::vector<std::pair<std::string, std::vector<double>>>& commands);
    /// The current image of the camera "robot0/eye"; its tick is that of the other end.
    [[nodiscard]] Result<CameraImage> image(const std::string& camera);
    /// The name of an object in the images so far; empty if it is unknown.
    [[nodiscard]] std::string objectName(std::uint32_t number);
    /// Of the radio "robot0/radio": queues a packet there. Fails if it is refused.
    [[nodiscard]] Status sendPacket(const std::string& radio, std::string_view bytes, std::uint32_t to, double powerDbm);
    /// The oldest packet in its buffer; none: it is empty.
    [[nodiscard]] Result<std::optional<RadioPacket>> receivePacket(const std::string& radio);

private:
    using Json = nlohmann::ordered_json;
    RobotLink(Socket socket, RobotLinkOptions options) : m_socket(std::move(socket)), m_options(std::move(options)) {}
    [[nodiscard]] Status begin();
    /// The reply to a request; the bytes behind it are in m_bytes.
    [[nodiscard]] Result<Json> request(Json members, std::string_view data = {});
    [[nodiscard]] Result<Json> replyTo(std::uint64_t number);
    [[nodiscard]] Status send(std::string_view bytes);
    [[nodiscard]] Status receive();
    [[nodiscard]] Status takeValues();
    [[nodiscard]] Error broken(const std::string& why) const;

    Socket m_socket;
    RobotLinkOptions m_options;
    FrameReader m_reader{{4u << 20, 16u << 20}};
    std::string m_bytes;
    std::uint64_t m_number = 0; ///< of the last request
    double m_tick = 0, m_waited = 0;
    std::uint64_t m_subscription = 0;
    std::vector<Signal> m_signals;
    std::vector<double> m_values;
    std::vector<std::string> m_objects; ///< names by number; empty: not yet asked for
    bool m_taken = false, m_hasController = false;
};

} // namespace trundle
