// A device and the controller that commands it, both made from one table of signals.
#include <trundle/controller.h>
#include <trundle/device.h>

namespace {

struct ThrusterSignals {
    static constexpr const char* kKind = "Thruster";
    trundle::CommandSlot<double> thrust;
    trundle::OutputSlot<std::array<double, 2>> speed;
    trundle::OutputSlot<bool> burning;

    template <class D> static void describe(D& d) {
        using S = ThrusterSignals;
        d.command("thrust", &S::thrust, "N", "Along x of the world.");
        d.output("speed", &S::speed, "m/s", "Along x and y of the world.");
        d.output("burning", &S::burning, "", "It pushes.");
    }
};

struct Thruster : trundle::Device, ThrusterSignals {
    std::string bodyName;
    trundle::BodyId body;
    static void describe(trundle::Describe<Thruster>& d) {
        d.help("Pushes its body along x.");
        d.field("Body", &Thruster::bodyName, trundle::reference("Body").required(), "What it pushes.");
        ThrusterSignals::describe(d);
    }
    void setup(trundle::Mount& mount) override { body = mount.body(bodyName); }
    void act(trundle::Actuation& world) override {
        const double force = thrust.read(world);
        burning.set(force != 0);
        world.bodyForce(body, {force, 0, 0}, trundle::Vec3(world.bodyState(body).position));
    }
    void sense(trundle::Sensing& world) override {
        const TrundleBodyState state = world.bodyState(body);
        speed.set(0, state.linear[0]);
        speed.set(1, state.linear[1]);
    }
};

/// Pushes until its speed is reached.
struct Pilot : trundle::Controller {
    double wanted = 1;
    trundle::Port<ThrusterSignals> thruster;
    trundle::OutputSlot<bool> arrived;
    static void describe(trundle::Describe<Pilot>& d) {
        d.field("Speed", &Pilot::wanted, trundle::metresPerSecond(), "To be reached.");
        d.output("arrived", &Pilot::arrived, "", "Its speed is reached.");
    }
    void setup(trundle::RobotPorts& robot) override { thruster = robot.port<ThrusterSignals>("thruster"); }
    void update(trundle::Seconds) override {
        if (thruster.get(&ThrusterSignals::speed) >= wanted) arrived.set(true);
        thruster.set(&ThrusterSignals::thrust, arrived.get() != 0 ? 0 : 2);
    }
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.device<Thruster>(ThrusterSignals::kKind);
    registry.controller<Pilot>("Pilot");
}
