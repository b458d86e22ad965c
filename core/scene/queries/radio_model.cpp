#include "scene/queries/radio_model.h"

#include <map>

#include "scene/queries/ray_cast.h"

namespace trundle {
namespace {

constexpr std::size_t kNoRobot = ~std::size_t(0);

std::vector<double> numbersOf(const ComponentSpec& spec, std::string_view key) {
    const ResolvedValue* value = spec.find(key);
    return value ? value->value.numbers : std::vector<double>();
}

Vec3 vectorOf(const ComponentSpec& spec, std::string_view key) {
    const std::vector<double> numbers = numbersOf(spec, key);
    return numbers.size() == 3 ? Vec3(numbers.data()) : Vec3::Zero();
}

/// Reads the properties by the names that the kind Transceiver declares.
RadioNode nodeFrom(const ComponentSpec& spec) {
    RadioNode node;
    RadioDefinition& radio = node.radio;
    radio.maxOutputPower = spec.number("MaxOutputPower", radio.maxOutputPower);
    radio.minReceivePower = spec.number("MinReceivePower", radio.minReceivePower);
    radio.maxReceivePower = spec.number("MaxReceivePower", radio.maxReceivePower);
    radio.rssiStep = spec.number("RssiStep", radio.rssiStep);
    radio.bufferLimit = static_cast<std::uint32_t>(spec.number("BufferLimit", radio.bufferLimit));
    radio.channel = static_cast<std::uint32_t>(spec.number("Channel", radio.channel));
    radio.address = static_cast<std::uint32_t>(spec.number("Address", 0));
    radio.bitRate = spec.number("BitRate", radio.bitRate);
    radio.powerLevels = numbersOf(spec, "PowerLevels");
    radio.transmitCurrents = numbersOf(spec, "TransmitCurrent");
    radio.receiveCurrent = spec.number("ReceiveCurrent", radio.receiveCurrent);
    radio.supply = spec.number("SupplyVoltage", radio.supply);
    const Pose mounting{vectorOf(spec, "Pos"), rotationFromHpr(vectorOf(spec, "HPR"))};
    node.mounting = {mounting.position, mounting.rotation.normalized()};
    return node;
}

} // namespace

std::vector<RadioNode> radioNodesOf(const ExperimentSpec& experiment) {
    std::vector<RadioNode> nodes;
    std::map<std::string, std::shared_ptr<const AntennaPattern>> antennas;
    std::size_t firstBody = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Transceiver") continue;
            RadioNode node = nodeFrom(device);
            // Shared by all transceivers with this antenna, because making one takes milliseconds.
            const auto [antenna, isNew] = antennas.try_emplace(device.text("Antenna", "isotropic"));
            if (isNew) antenna->second = antennaNamed(experiment, antenna->first);
            node.radio.antenna = antenna->second;
            node.radio.path = robot.name + "/" + device.name;
            node.robot = robot.name;
            node.body = firstBody;
            const std::string body = device.text("Body");
            for (std::size_t b = 0; b < robot.config->bodies.size(); ++b)
                if (robot.config->bodies[b].name == body) node.body = firstBody + b;
            nodes.push_back(std::move(node));
        }
        firstBody += robot.config->bodies.size();
    }
    return nodes;
}

WallCount wallsBetween(std::shared_ptr<const ObjectIndex> objects, std::shared_ptr<const BodyPoses> poses,
                       const std::vector<RadioNode>& nodes) {
    std::vector<std::size_t> robots;
    for (const RadioNode& node : nodes) {
        const auto object = objects->find(node.robot);
        const auto robot = object ? objects->bodiesOf(*object) : std::nullopt;
        robots.push_back(robot ? *robot : kNoRobot);
    }
    return [objects = std::move(objects), poses = std::move(poses), robots = std::move(robots)](RadioId first, const Vec3& a,
                                                                                                RadioId second, const Vec3& b) {
        const auto robotOf = [&](RadioId radio) { return radio < robots.size() ? robots[radio] : kNoRobot; };
        return solidsBetween(*objects, *poses, a, b, robotOf(first), robotOf(second));
    };
}

} // namespace trundle
