// A robot with a directional antenna navigates through a network of motes by radio: it turns once around, fits the peak of each
// mote's signal strength, drives a leg towards the mote nearest to the target, and repeats until the target's signal is strong
// enough. It uses packets, RSSI, its wheels and its bumper, but no positions (after Deshpande, Grant and Henderson, IEEE Systems
// Journal 8(1), 2014).
#include <algorithm>
#include <cmath>
#include <map>

#include "beacon.h"
#include "bearing_sweep.h"

namespace {

constexpr double kStandOff = 0.7;    ///< m, distance before an intermediate mote at which a leg ends
constexpr double kLegFraction = 0.8; ///< fraction of the estimated distance to the target covered by one leg
constexpr double kShortestLeg = 0.2; ///< m
constexpr double kAtRest = 1e-5;     ///< m, largest motion per update that counts as rest
constexpr double kTurnAway = 70 * kDegree;
constexpr int kMaxOnOneSide = 6; ///< contacts evaded on one side before it tries the other

struct NetworkNavigator : Listener {
    double speed = 0.3, leg = 3, rssiAtOneMetre = -30, arrivedRssi = -28, goodRssi = -75, backOff = 0.3, detour = 0.8;
    std::string touchName = "frontTouch", fileName = "navigation.csv";

    static void describe(trundle::Describe<NetworkNavigator>& d) {
        d.help("Drives to the target of a network of Motes by the bearings of what it hears, and ends the run there.");
        d.field("Speed", &NetworkNavigator::speed, trundle::metresPerSecond().above(0).atMost(10), "On its legs.");
        d.field("Leg", &NetworkNavigator::leg, trundle::metres().above(0).atMost(1000), "The longest drive between two sweeps.");
        d.field("RssiAtOneMetre", &NetworkNavigator::rssiAtOneMetre, trundle::decibelMilliwatts().within(-150, 50),
                "Of a mote straight ahead; from it and free space it guesses how long a leg may be.");
        d.field("ArrivedRssi", &NetworkNavigator::arrivedRssi, trundle::decibelMilliwatts().within(-150, 50),
                "The target is reached when it is heard with this.");
        d.field("GoodRssi", &NetworkNavigator::goodRssi, trundle::decibelMilliwatts().within(-150, 50),
                "A mote that is heard with less must be that much nearer to the target to be chosen.");
        d.field("BackOff", &NetworkNavigator::backOff, trundle::metres().above(0).atMost(100), "From what it touches.");
        d.field("Detour", &NetworkNavigator::detour, trundle::metres().above(0).atMost(100), "Past what it touched.");
        d.field("Touch", &NetworkNavigator::touchName, trundle::needs("TouchSensor"), "The robot's TouchSensor in front.");
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
            log.write("time [s],mote,hops,cost,heading [deg],RSSI [dBm],leg [m]\n");
            return startSweep();
        case Doing::Sweeping:
            if (drive.done()) choose();
            return;
        case Doing::Turning:
            if (drive.done()) go(Doing::Driving, length);
            return;
        case Doing::Driving:
            if (touch.pressed()) return evade();
            if (drive.done()) startSweep();
            return;
        case Doing::BackingOff:
            if (drive.done()) turn(side * kTurnAway, detour);
            return;
        case Doing::Arrived: return standStill();
        }
    }

private:
    enum class Doing { Starting, Sweeping, Turning, Driving, BackingOff, Arrived };

    void heard(const trundle::Packet& packet, double heading) {
        const auto beacon = Beacon::from(packet.bytes);
        if (!beacon || !beacon->knowsTarget()) return;
        if (doing == Doing::Sweeping) {
            beacons[packet.from] = *beacon;
            sweep.add(packet.from, heading, packet.rssi);
        }
        if (beacon->hops == 0 && packet.rssi >= arrivedRssi && doing != Doing::Arrived) arrive(packet);
    }

    void arrive(const trundle::Packet& packet) {
        drive.stop();
        doing = Doing::Arrived;
        print("reached the target, RSSI ", packet.rssi, " dBm, after ", legs, " legs, ", bumps, " bumps and ", time(), " s");
        write("arrived", {}, {drive.odometry().heading, packet.rssi}, 0);
    }

    /// Ends the run when the wheels have come to rest.
    void standStill() {
        const auto now = drive.odometry();
        const double moved = std::hypot(now.x - restX, now.y - restY);
        restX = now.x;
        restY = now.y;
        if (moved < kAtRest) finish("reached");
    }

    void startSweep() {
        doing = Doing::Sweeping;
        beacons.clear();
        beginSweep();
    }

    /// Chooses the mote with the least cost to the target; a weak signal increases the cost.
    void choose() {
        double least = 1e9;
        Sweep::Bearing way;
        std::uint32_t mote = 0;
        for (const auto& [sender, beacon] : beacons) {
            const auto bearing = sweep.bearing(sender);
            if (!bearing) continue;
            const double cost = beacon.cost + std::max(0.0, goodRssi - bearing->rssi);
            if (cost >= least) continue;
            least = cost;
            way = *bearing;
            mote = sender;
        }
        if (mote == 0) return driveRandomly(); // no mote was received here
        const Beacon& beacon = beacons[mote];
        if (least < leastSoFar) {
            leastSoFar = least;
            bumpsHere = 0;
        }
        const double distance = std::pow(10, (rssiAtOneMetre - way.rssi) / 20);
        const double wanted = beacon.hops == 0 ? std::max(kShortestLeg, kLegFraction * distance) : distance - kStandOff;
        ++legs;
        write(std::to_string(mote), beacon, way, std::min(leg, wanted));
        if (wanted < kShortestLeg)
            return driveRandomly(); // it is already close to this mote and receives none nearer to the target
        turn(wrapAngle(way.heading - drive.odometry().heading), std::min(leg, wanted));
    }

    void driveRandomly() { turn(random(-180, 180) * kDegree, leg / 2); }

    /// Turns by an angle (rad), then drives a straight leg of `next` m.
    void turn(double angle, double next) {
        length = next;
        if (std::abs(angle) < 0.2 * kDegree) return go(Doing::Driving, length);
        doing = Doing::Turning;
        drive.turn(1, angle);
    }
    void go(Doing what, double metres) {
        doing = what;
        drive.drive(std::copysign(speed, metres), 0, metres, 0);
    }

    /// Evades an obstacle, always on the same side, until it is nearer to the target than ever before or the number of tries is
    /// reached.
    void evade() {
        ++bumps;
        if (bumpsHere == 0) side = random() < 0.5 ? 1 : -1;
        else if (bumpsHere % kMaxOnOneSide == 0) side = -side;
        ++bumpsHere;
        go(Doing::BackingOff, -backOff);
    }

    void write(const std::string& mote, const Beacon& beacon, const Sweep::Bearing& way, double metres) {
        log.write(std::to_string(time()) + ',' + mote + ',' + std::to_string(beacon.hops) + ',' + std::to_string(beacon.cost) +
                  ',' + std::to_string(way.heading / kDegree) + ',' + std::to_string(way.rssi) + ',' + std::to_string(metres) +
                  '\n');
    }

    trundle::TouchPort touch;
    trundle::Log log;
    std::map<std::uint32_t, Beacon> beacons; ///< of the current sweep
    Doing doing = Doing::Starting;
    double length = 0; ///< m, of the leg after the turn
    double leastSoFar = 1e9, side = 1;
    double restX = 1e9, restY = 1e9; ///< m, odometry at the previous update
    int legs = 0, bumps = 0, bumpsHere = 0;
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.controller<BearingSweep>("BearingSweep");
    registry.controller<NetworkNavigator>("NetworkNavigator");
}
