#include <array>

#include "devices/builtin.h"
#include "fuzz/random_experiment.h"
#include "fuzz/targets.h"
#include "remote/server.h"

namespace trundle::fuzz {
namespace {

using Json = nlohmann::json;

constexpr int kFrames = 60, kManyRounds = 100'000;

const char* const kText = R"(Tick = 0.01
RadioMedium air { Model=ideal }
RobotConfig Cart {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.1 Mass=2 } }
  Body left { Pos=0,0.12,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.1 } }
  Hinge axle { Parent=chassis Child=left Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
  Encoder encoder { Joint=axle }
  TouchSensor bumper { Geom=chassis.hull }
  Camera eye { Body=chassis }
  Transceiver radio { Body=chassis }
  Led lamp { Body=chassis }
}
StaticConfig Floor { Plane ground { } }
Static floor { Config=Floor }
Robot r { Config=Cart }
Robot s { Config=Cart Pos=1,0,0 }
)";

/// One run for all inputs.
class Served {
public:
    Served() : m_loaded(open({reinterpret_cast<const std::uint8_t*>(kText), std::char_traits<char>::length(kText)})) {
        require(!m_loaded->diagnostics.hasErrors());
        require(run.reset());
    }
    ServedRun run{[this](std::optional<std::uint64_t>) {
        ServedExperiment built;
        Diagnostics problems;
        built.runner = Runner::create(
            m_loaded->experiment, [](const std::string& kind) { return findBuiltInDevice(kind); },
            [](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                return Error{Code::Internal, "there are no controllers here"};
            },
            {}, problems);
        return built;
    }};
    RemoteServer server{run, {"0123456789abcdef", "fuzz", 16, std::chrono::seconds(5)}};

    Socket connect() {
        auto [ours, theirs] = std::move(Socket::pair().value());
        server.adopt(std::move(theirs));
        return std::move(ours);
    }

private:
    std::shared_ptr<const LoadedProject> m_loaded;
};

/// A value that a member of a request may have, or must not.
Json randomValue(Choices& choices, int depth = 0) {
    static const Json values[] = {0,
                                  1,
                                  2,
                                  3,
                                  -1,
                                  0.5,
                                  -1e300,
                                  1e308,
                                  1'000'000'000,
                                  18446744073709551615ull,
                                  true,
                                  false,
                                  nullptr,
                                  "",
                                  "r",
                                  "s",
                                  "r/base",
                                  "r/motor",
                                  "r/eye",
                                  "r/radio",
                                  "s/radio",
                                  "r/bumper",
                                  "r/chassis",
                                  "r/motor/voltage",
                                  "r/lamp/color",
                                  "r/encoder/count",
                                  "r/*",
                                  "*",
                                  "?/*",
                                  "r/motor/*",
                                  "\xf0\x9f\xa4\x96",
                                  "0123456789abcdef"};
    if (depth < 3 && choices.chance(3)) {
        Json array = Json::array();
        for (std::uint32_t i = choices.pick(5); i-- > 0;) array.push_back(randomValue(choices, depth + 1));
        return array;
    }
    if (depth < 3 && choices.chance(2)) {
        Json object = Json::object();
        for (std::uint32_t i = choices.pick(4); i-- > 0;) {
            const Json key = randomValue(choices, 3);
            object[key.is_string() ? key.get<std::string>() : "x"] = randomValue(choices, depth + 1);
        }
        return object;
    }
    return values[choices.pick(std::size(values))];
}

Json randomRequest(Choices& choices) {
    static const std::vector<std::pair<const char*, std::vector<const char*>>> operations = {
        {"hello", {"token", "protocol"}}, {"status", {}}, {"list", {}}, {"describe", {"robot"}}, {"subscribe", {"signals", "every"}},
        {"unsubscribe", {"subscription"}}, {"read", {"device"}}, {"read", {"signals"}}, {"read", {"subscription"}},
        {"command", {"signals"}}, {"command", {"device", "voltage", "vel"}}, {"hold", {"robot", "held"}},
        {"place", {"robot", "position", "heading"}}, {"push", {"body", "force", "point"}}, {"restart", {"robot"}},
        {"step", {"ticks", "signals", "subscription"}}, {"run", {"speed"}}, {"pause", {}}, {"hash", {}}, {"image", {"camera"}},
        {"send", {"device", "to", "power"}}, {"receive", {"device"}}, {"console", {"on"}}, {"", {"op"}}, {"reset", {"seed"}}};
    const auto& [name, members] = operations[choices.pick(static_cast<std::uint32_t>(operations.size() - (choices.chance(1) ? 0 : 1)))];
    Json request{{"op", name}};
    if (choices.chance(12)) request["id"] = randomValue(choices);
    for (const char* member : members)
        if (choices.chance(13)) request[member] = randomValue(choices);
    if (choices.chance(1)) request["more"] = randomValue(choices);
    if (std::string_view(name) == "place" && choices.chance(8)) request["position"] = {0, 0, 0.1};
    if (std::string_view(name) == "step" && choices.chance(12)) request["ticks"] = choices.pick(4);
    return request;
}

/// A frame, in most cases a valid one.
std::string randomFrame(Choices& choices) {
    std::string json = randomRequest(choices).dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string bytes(choices.chance(2) ? choices.pick(64) : 0, 'b');
    for (std::uint32_t i = choices.chance(3) ? choices.pick(8) : 0; i-- > 0 && !json.empty();)
        json[choices.pick(static_cast<std::uint32_t>(json.size()))] = static_cast<char>(choices.pick(256));
    if (choices.chance(1)) json = std::string(choices.pick(2000), choices.chance(8) ? '[' : '{');
    std::string frame;
    appendFrame(frame, json, bytes);
    if (choices.pick(64) == 1) frame[choices.pick(8)] = static_cast<char>(choices.pick(256));
    if (choices.pick(64) == 1) frame.resize(choices.pick(static_cast<std::uint32_t>(frame.size())));
    return frame;
}

/// Each message of the server is a whole frame with an object.
void readAll(Socket& socket, FrameReader& reader) {
    std::array<char, 1u << 16> bytes;
    for (auto got = socket.read(bytes); got && *got > 0; got = socket.read(bytes)) reader.add(std::span(bytes).first(*got));
    for (;;) {
        auto frame = reader.next();
        require(frame.ok());
        if (!frame.value()) return;
        const Json message = Json::parse(frame.value()->json, nullptr, false);
        require(message.is_object() && message.contains("ok") != message.contains("event"));
        require(message.contains("event") || message["ok"].get<bool>() != message.contains("message"));
    }
}

} // namespace

std::size_t tryRemote(std::span<const std::uint8_t> bytes) {
    static Served s_served;
    Choices choices(bytes);
    Socket wild = s_served.connect(), sound = s_served.connect();
    FrameReader fromWild({1u << 26, 1u << 26}), fromSound({1u << 26, 1u << 26});
    std::size_t frames = 0;
    const bool reads = choices.chance(12);
    for (int i = 0; i < kFrames && !choices.spent(); ++i, ++frames) {
        const std::string frame = randomFrame(choices);
        const std::size_t cut = choices.chance(4) ? choices.pick(static_cast<std::uint32_t>(frame.size() + 1)) : 0;
        for (const std::string_view part : {std::string_view(frame).substr(0, cut), std::string_view(frame).substr(cut)}) {
            (void)wild.write(part);
            s_served.server.serve(std::chrono::milliseconds(0));
        }
        if (reads) readAll(wild, fromWild);
    }
    if (!s_served.run.exists() || s_served.run.state() == ServedState::Ended) require(s_served.run.reset()); // it blew up
    std::string status;
    appendFrame(status, R"({"id":1,"op":"status"})");
    require(sound.write(status) == status.size());
    std::array<char, 1> first;
    std::size_t got = 0;
    for (int i = 0; i < kManyRounds && got == 0; ++i) { // also while the other one runs or steps
        s_served.server.serve(std::chrono::milliseconds(0));
        got = sound.read(first).value_or(0);
    }
    require(got == 1);
    fromSound.add(first);
    readAll(sound, fromSound);
    wild.close();
    sound.close();
    for (int i = 0; i < kManyRounds && s_served.server.clientCount() > 0; ++i) s_served.server.serve(std::chrono::milliseconds(0));
    require(s_served.server.clientCount() == 0);
    s_served.run.pause();
    return frames;
}

} // namespace trundle::fuzz
