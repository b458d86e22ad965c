// An example of an actuator in a module of its own: a conveyor that carries things by a way that a controller gives it, item by item, and
// stops. A copy of this file is a start for another actuator.
#include <algorithm>
#include <cmath>

#include <trundle/device.h>

namespace {

class IndexConveyor final : public trundle::Device {
public:
    static void describe(trundle::Describe<IndexConveyor>& d) {
        d.help("Carries what lies on a geom along its x axis, by one pitch for each step.");
        d.field("Geom", &IndexConveyor::geomPath, trundle::reference("Geom").required(), "The geom whose surface runs.");
        d.field("Pitch", &IndexConveyor::pitch, trundle::metres().above(0).atMost(100), "Way of one step.");
        d.field("MaxSpeed", &IndexConveyor::maxSpeed, trundle::metresPerSecond().above(0).atMost(100).live(), "Of its surface.");
        d.field("MaxAcceleration", &IndexConveyor::maxAcceleration, trundle::metresPerSecondSquared().above(0).atMost(1e4).live(),
                "So low that friction can carry the load.");
        d.command("steps", &IndexConveyor::steps, "", "How many steps it is to be from its start; negative: backwards.");
        d.output("travel", &IndexConveyor::travel, "m", "Way of its surface since the start.");
        d.output("busy", &IndexConveyor::busy, "", "A step is under way.");
    }

    void setup(trundle::Mount& mount) override { geom = mount.geom(geomPath); }

    /// As fast as it can still stop at its target: v^2 = 2 a way.
    void act(trundle::Actuation& world) override {
        const double way = pitch * steps.read(world) - now, step = maxAcceleration * world.tick();
        const double safe = std::sqrt(2 * maxAcceleration * std::abs(way));
        const double fastest = std::min({maxSpeed, std::max(safe - step, 0.5 * step), std::abs(way) / world.tick()});
        speed += std::clamp(std::copysign(fastest, way) - speed, -step, step);
        if (std::abs(way) < 1e-9) speed = 0;
        world.surfaceVelocity(geom, {speed, 0, 0});
    }

    void sense(trundle::Sensing& world) override {
        if (world.time() > 0) now += speed * world.tick();
        travel.set(now);
        busy.set(std::abs(speed) > 0);
    }

private:
    std::string geomPath;
    double pitch = 0.5, maxSpeed = 0.5, maxAcceleration = 1; // m, m/s, m/s^2
    trundle::GeomId geom;
    double speed = 0, now = 0; // m/s, m
    trundle::CommandSlot<int> steps;
    trundle::OutputSlot<double> travel;
    trundle::OutputSlot<bool> busy;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.device<IndexConveyor>("IndexConveyor"); }
