// A robot with a directional antenna finds its way through a network of motes by what it hears: it turns once around, fits the peak of each
// mote's signal strength, drives a leg towards the mote that is nearest to the target, and repeats until the target is loud enough. It
// knows packets, RSSI, its wheels and its bumper, and no positions (after Deshpande, Grant and Henderson, IEEE Systems Journal 8(1), 2014).
#include <cmath>
#include <map>
#include <numbers>

#include <trundle/controller.h>

#include "beacon.h"
#include "sweep.h"

namespace {

constexpr double kTurn = 2 * std::numbers::pi, kDegree = std::numbers::pi / 180;

/// What both controllers have: a drive, a radio, a turn on the spot with open ears.
struct Listener : trundle::Controller {
    double turnRate = 0.5;
    std::string radioName = "radio", driveName = "base";

    template <class T> static void describeListener(trundle::Describe<T>& d) {
        d.field("TurnRate", &T::turnRate, trundle::radiansPerSecond().above(0).atMost(10), "While it listens.");
        d.field("Radio", &T::radioName, trundle::text(), "The robot's Transceiver, whose antenna looks ahead.");
        d.field("Drive", &T::driveName, trundle::text(), "The robot's DifferentialDrive.");
    }

    void bindListener(trundle::RobotPorts& robot) {
        drive = robot.differentialDrive(driveName);
        radio = robot.radio(radioName);
    }

protected:
    void beginSweep() {
        sweep.clear();
        drive.turn(turnRate, kTurn + 10 * kDegree);
    }
    /// What came in belongs to the heading at which it was sent, a tick ago.
    template <class Hear> void listen(const Hear& hear) {
        while (const auto packet = radio.receive()) hear(*packet, lastHeading);
        lastHeading = drive.odometry().heading;
    }

    trundle::DifferentialDrivePort drive;
    trundle::RadioPort radio;
    Sweep sweep;
    double lastHeading = 0;
};

/// Turns once around and says from where it hears whom.
struct BearingSweep : Listener {
    std::string fileName = "bearing.csv";

    static void describe(trundle::Describe<BearingSweep>& d) {
        d.help("Turns once on the spot, writes the RSSI of each packet over its heading, and says where each sender is.");
        d.field("File", &BearingSweep::fileName, trundle::text(), "Its samples, in the log folder.");
        describeListener(d);
    }

    void setup(trundle::RobotPorts& robot) override { bindListener(robot); }

    void update(trundle::Seconds) override {
        if (done) return;
        if (!started) {
            started = true;
            log = openLog(fileName);
            log.write("sender,heading [deg],RSSI [dBm]\n");
            beginSweep();
        }
        listen([this](const trundle::Packet& packet, double heading) {
            sweep.add(packet.from, heading, packet.rssi);
            log.write(std::to_string(packet.from) + ',' + std::to_string(heading / kDegree) + ',' + std::to_string(packet.rssi) +
                      '\n');
        });
        if (!drive.done()) return;
        done = true;
        for (const auto& [sender, samples] : sweep.samples()) {
            if (const auto bearing = sweep.bearing(sender))
                print("sender ", sender, " is at ", bearing->heading / kDegree, " deg, ", bearing->rssi, " dBm, from ",
                      samples.size(), " packets");
        }
    }

private:
    trundle::Log log;
    bool started = false, done = false;
};

struct NetworkNavigator : Listener {
    double speed = 0.3, leg = 1.5, arrivedRssi = -45, backOff = 0.3;
    std::string touchName = "frontTouch", fileName = "navigation.csv";

    static void describe(trundle::Describe<NetworkNavigator>& d) {
        d.help("Drives to the target of a network of Motes by the bearings of what it hears.");
        d.field("Speed", &NetworkNavigator::speed, trundle::metresPerSecond().above(0).atMost(10), "On its legs.");
        d.field("Leg", &NetworkNavigator::leg, trundle::metres().above(0).atMost(1000), "The longest drive between two sweeps.");
        d.field("ArrivedRssi", &NetworkNavigator::arrivedRssi, trundle::decibelMilliwatts().within(-150, 50),
                "The target is reached when it is heard with this.");
        d.field("BackOff", &NetworkNavigator::backOff, trundle::metres().above(0).atMost(100), "From what it touches.");
        d.field("Touch", &NetworkNavigator::touchName, trundle::text(), "The robot's TouchSensor in front.");
        d.field("File", &NetworkNavigator::fileName, trundle::text(), "A line for each leg, in the log folder.");
        describeListener(d);
    }

    void setup(trundle::RobotPorts& robot) override {
        bindListener(robot);
        touch = robot.touch(touchName);
    }

    void update(trundle::Seconds) override {
        listen([this](const trundle::Packet& packet, double heading) { heard(packet, heading); });
        switch (doing) {
        case Doing::Starting:
            log = openLog(fileName);
            log.write("time [s],mote,hops,cost,heading [deg],RSSI [dBm]\n");
            return begin(Doing::Sweeping);
        case Doing::Sweeping:
            if (drive.done()) choose();
            return;
        case Doing::Turning:
            if (drive.done()) driveLeg();
            return;
        case Doing::Driving:
            if (touch.pressed()) return evade();
            if (drive.done()) begin(Doing::Sweeping);
            return;
        case Doing::BackingOff:
            if (!drive.done()) return;
            drive.turn(1, (random() < 0.5 ? 1 : -1) * random(60, 110) * kDegree);
            doing = Doing::TurningAway;
            return;
        case Doing::TurningAway:
            if (drive.done()) passBy();
            return;
        case Doing::Arrived: return;
        }
    }

private:
    enum class Doing { Starting, Sweeping, Turning, Driving, BackingOff, TurningAway, Arrived };

    void heard(const trundle::Packet& packet, double heading) {
        const auto beacon = Beacon::from(packet.bytes);
        if (!beacon || !beacon->knowsTarget()) return;
        beacons[packet.from] = *beacon;
        if (doing == Doing::Sweeping) sweep.add(packet.from, heading, packet.rssi);
        if (beacon->hops == 0 && packet.rssi >= arrivedRssi && doing != Doing::Arrived) arrive(packet.rssi);
    }

    void arrive(double rssi) {
        drive.stop();
        doing = Doing::Arrived;
        print("reached the target, RSSI ", rssi, " dBm, after ", legs, " legs and ", time(), " s");
        write("arrived", {0, 0, 0}, {drive.odometry().heading, rssi});
    }

    void begin(Doing what) {
        doing = what;
        beacons.clear();
        beginSweep();
    }

    /// The mote with the least cost to the target, the hop to it counted in; of the target itself there is no better.
    void choose() {
        double least = 1e9;
        Sweep::Bearing way;
        std::uint32_t mote = 0;
        for (const auto& [sender, beacon] : beacons) {
            const auto bearing = sweep.bearing(sender);
            if (!bearing) continue;
            const double cost = beacon.cost + (beacon.hops == 0 ? 0 : 5 + std::max(0.0, -50 - bearing->rssi) / 2);
            if (cost >= least) continue;
            least = cost;
            way = *bearing;
            mote = sender;
        }
        if (mote == 0) return begin(Doing::Sweeping); // nobody is heard: perhaps later
        ++legs;
        write(std::to_string(mote), beacons[mote], way);
        near = way.rssi;
        const double turn = wrapAngle(way.heading - drive.odometry().heading);
        doing = Doing::Turning;
        if (std::abs(turn) > 0.2 * kDegree) drive.turn(1, turn);
    }

    /// Shorter where the mote is loud, so that it is not passed.
    void driveLeg() {
        const double length = near > -45 ? leg / 4 : near > -52 ? leg / 2 : leg;
        drive.drive(speed, 0, length, 0);
        doing = Doing::Driving;
    }
    void evade() {
        drive.drive(-speed, 0, -backOff, 0);
        doing = Doing::BackingOff;
    }
    void passBy() {
        drive.drive(speed, 0, leg / 3, 0);
        doing = Doing::Driving;
    }

    void write(const std::string& mote, const Beacon& beacon, const Sweep::Bearing& way) {
        log.write(std::to_string(time()) + ',' + mote + ',' + std::to_string(beacon.hops) + ',' + std::to_string(beacon.cost) +
                  ',' + std::to_string(way.heading / kDegree) + ',' + std::to_string(way.rssi) + '\n');
    }

    trundle::TouchPort touch;
    trundle::Log log;
    std::map<std::uint32_t, Beacon> beacons; ///< of this sweep
    Doing doing = Doing::Starting;
    double near = -100; ///< dBm, of the mote it drives to
    int legs = 0;
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.controller<BearingSweep>("BearingSweep");
    registry.controller<NetworkNavigator>("NetworkNavigator");
}
