// An example of a sensor in a module of its own: a sonar that gives the distance of the nearest echo and how strong it is. Place, rate,
// latency and noise come from the SDK's Sensor and RangeNoise; a copy of this file is a start for another sensor.
#include <numbers>

#include <trundle/sensor.h>

namespace {

class EchoSonar final : public trundle::Sensor, public trundle::RangeNoise {
public:
    static void describe(trundle::Describe<EchoSonar>& d) {
        d.help("Hears the nearest echo in a cone, and how strong it is.");
        describeSensor(d);
        d.field("MinRange", &EchoSonar::minRange, trundle::metres().within(0, 100),
                "Its transducer still rings: nearer echoes are lost.");
        d.field("MaxRange", &EchoSonar::maxRange, trundle::metres().above(0).atMost(100), "Farther echoes are too weak.");
        d.field("ConeAngle", &EchoSonar::coneAngle, trundle::degrees().within(1, 120), "Of its beam, from edge to edge.");
        describeNoise(d);
        d.output("range", &EchoSonar::range, "m", "Distance of the nearest echo; MaxRange where there is none.");
        d.output("strength", &EchoSonar::strength, "",
                 "Of that echo: 1 straight from a wall at 1 m, less with the square of the distance.");
        d.output("time", &EchoSonar::time, "s", "When it was measured.");
    }

private:
    static constexpr int kRays = 9; // across and up

    void begin(trundle::Mount& mount) override {
        if (minRange >= maxRange) mount.fail("MinRange must be smaller than MaxRange");
        fan.range = maxRange;
        fan.count = kRays;
        fan.firstBearing = -coneAngle / 2;
        fan.bearingStep = coneAngle / (kRays - 1);
        fan.elevations.clear();
        for (int i = 0; i < kRays; ++i) fan.elevations.push_back(fan.firstBearing + i * fan.bearingStep);
        distances.resize(fan.size());
        normals.resize(fan.size());
        range.set(maxRange);
        time.set(-1); // no reading yet
    }

    void measure(trundle::Sensing& world, std::vector<double>& reading) override {
        const trundle::Pose eye = pose(world);
        world.castFan(fan, eye, {distances, {}, normals});
        double nearest = maxRange, returned = 0;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const double facing = -normals[i].dot(eye.rotation * fan.direction(i)); // 1: straight, 0: grazing or no hit
            if (facing < 0.5 || distances[i] < minRange || distances[i] >= nearest) continue;
            nearest = distances[i];
            returned = facing / (nearest * nearest);
        }
        reading = {apply(nearest, minRange, maxRange, world, 0), returned};
    }

    void publish(std::span<const double> reading, double measured) override {
        range.set(reading[0]);
        strength.set(reading[1]);
        time.set(measured);
    }

    double minRange = 0.1, maxRange = 5, coneAngle = std::numbers::pi / 9; // m, m, rad
    trundle::Fan fan;
    std::vector<double> distances;
    std::vector<trundle::Vec3> normals;
    trundle::OutputSlot<double> range, strength, time;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.device<EchoSonar>("EchoSonar"); }
