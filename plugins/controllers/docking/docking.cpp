// Works until the battery is low, goes to the light on its charger, charges by touching it, leaves, and works on.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <trundle/controller.h>

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTangent = 1.1917535925942100; // of 50 degrees, by which each light sensor is turned outwards
constexpr double kSmoothing = 0.2;              // share of a new reading in the smoothed light
constexpr double kWays = 0.12;                  // m, that it drives back from what it has touched
constexpr double kProgress = 0.05;              // m, that it is to go towards the light in each
constexpr double kProgressTime = 5;             // s
constexpr double kCreep = 0.03;                 // m/s, to stay in contact

struct Docking : trundle::Controller {
    double low = 0.5, full = 0.9;
    int charges = 2;
    double speed = 0.12, turnRate = 1.5;
    double clearance = 0.04;
    double dim = 8, near = 2500;
    std::vector<std::string> rangeNames{"prox7", "prox0", "prox6", "prox1"};
    std::vector<std::string> ledNames{"led0", "led1", "led2", "led3", "led4", "led5", "led6", "led7"};
    std::string leftName = "leftLight", rightName = "rightLight", batteryName = "battery", touchName = "touch",
                driveName = "base";
    trundle::OutputSlot<int> charged;
    trundle::OutputSlot<double> worked;

    static void describe(trundle::Describe<Docking>& d) {
        using D = Docking;
        d.help("Works until its battery is low, finds its charger by the light on it, charges by touch, and works on.")
            .independent();
        d.field("Low", &D::low, trundle::number().within(0.01, 0.99).live(),
                "Share of the charge at which it looks for its charger.");
        d.field("Full", &D::full, trundle::number().within(0.02, 1).live(), "Share of the charge with which it leaves it.");
        d.field("Charges", &D::charges, trundle::number().within(0, 1e6), "The run ends at work after so many; 0: never.");
        d.field("Speed", &D::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "At most.");
        d.field("TurnRate", &D::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(), "At most.");
        d.field("Clearance", &D::clearance, trundle::metres().within(0, 10), "It turns away from what is nearer.");
        d.field("Dim", &D::dim, trundle::unitOf("lx").above(0).atMost(1e9),
                "Weaker light, above that of the room, is no charger.");
        d.field("Near", &D::near, trundle::unitOf("lx").above(0).atMost(1e9),
                "Where it is so bright, what is ahead is the charger.");
        d.field("Ranges", &D::rangeNames, trundle::needs("RangeSensor").counted(2, 100),
                "RangeSensors ahead: of the left, of the right, and so on.");
        d.field("Leds", &D::ledNames, trundle::needs("Led").counted(0, 100),
                "That show what it does: green at work, yellow on its way, blue while it charges.");
        d.field("Left", &D::leftName, trundle::needs("LightSensor"), "The robot's LightSensor on the left, turned outwards by 50 degrees.");
        d.field("Right", &D::rightName, trundle::needs("LightSensor"), "The one on the right.");
        d.field("Battery", &D::batteryName, trundle::needs("Battery"), "The robot's Battery.");
        d.field("Touch", &D::touchName, trundle::needs("TouchSensor"), "The TouchSensor of the contacts of the battery.");
        d.field("Drive", &D::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
        d.output("charged", &D::charged, "", "How often it has charged.");
        d.output("worked", &D::worked, "m", "Way that it went at work.");
    }

    void setup(trundle::RobotPorts& robot) override {
        for (const std::string& name : rangeNames) ranges.push_back(robot.rangeSensor(name));
        for (const std::string& name : ledNames) leds.push_back(robot.led(name));
        left = robot.lightSensor(leftName);
        right = robot.lightSensor(rightName);
        battery = robot.battery(batteryName);
        touch = robot.touch(touchName);
        drive = robot.differentialDrive(driveName);
    }

    void update(trundle::Seconds) override {
        if (left.time() < 0 || right.time() < 0 || ranges[0].time() < 0) return;
        if (battery.voltage() <= 0 && time() > 0) return finish("its battery is empty");
        here = drive.odometry();
        onLeft += (left.illuminance() - onLeft) * (begun ? kSmoothing : 1);
        onRight += (right.illuminance() - onRight) * (begun ? kSmoothing : 1);
        if (!begun) enter(State::Calibrate);
        begun = true;
        turned += std::abs(std::remainder(here.heading - before.heading, 2 * kPi));
        switch (state) {
        case State::Calibrate: calibrate(); break;
        case State::Work: work(); break;
        case State::Seek: seek(); break;
        case State::Search: search(); break;
        case State::BackOff: backOff(); break;
        case State::Charge: charge(); break;
        case State::Leave: leave(); break;
        }
        before = here;
    }

private:
    enum class State { Calibrate, Work, Seek, Search, BackOff, Charge, Leave };

    void enter(State next) {
        state = next;
        since = time();
        turned = 0;
        before = from = here;
        turnUntil = 0;
        if (next == State::Calibrate) room = std::min(onLeft, onRight);
        if (next == State::Work) show(0, 1, 0);
        if (next == State::Seek) show(1, 0.8, 0);
        if (next == State::Charge) show(0, 0.3, 1);
    }
    [[nodiscard]] double elapsed() const { return time() - since; } // s in this state
    [[nodiscard]] double way() const {
        return std::sqrt((here.x - from.x) * (here.x - from.x) + (here.y - from.y) * (here.y - from.y));
    }

    void show(double red, double green, double blue) {
        for (trundle::LedPort& led : leds) {
            led.setOn(true);
            led.setColor(red, green, blue);
        }
    }

    /// The light of the room is the least that it sees in one turn: that with the charger behind it.
    void calibrate() {
        room = std::min({room, onLeft, onRight});
        drive.move(0, turnRate);
        if (turned >= 2 * kPi) enter(State::Work);
    }

    /// Straight ahead, and away from what is in the way. True: it turns away.
    bool wander() {
        if (time() < turnUntil) {
            drive.move(0, turning);
            return true;
        }
        double onSide[2] = {1e9, 1e9};
        for (std::size_t i = 0; i < ranges.size(); ++i) onSide[i % 2] = std::min(onSide[i % 2], ranges[i].range());
        if (std::min(onSide[0], onSide[1]) < clearance) {
            turning = onSide[0] < onSide[1] ? -turnRate : turnRate;
            turnUntil = time() + (0.4 + random()) / turnRate;
            drive.move(0, turning);
            return true;
        }
        drive.move(speed, 0);
        return false;
    }

    void work() {
        worked.set(worked.get() +
                   std::sqrt((here.x - before.x) * (here.x - before.x) + (here.y - before.y) * (here.y - before.y)));
        wander();
        if (charges > 0 && charged.get() >= charges && elapsed() > 10) {
            drive.stop();
            return finish("it works, charged");
        }
        if (battery.level() < low) enter(State::Seek);
    }

    /// Towards the light, by the difference of its sensors.
    void seek() {
        if (battery.charging()) {
            drive.stop();
            return enter(State::Charge);
        }
        if (touch.pressed() && elapsed() > 0.5) return enter(State::BackOff);
        if (way() > kProgress) progressAt = time(), from = here;
        if (time() - std::max(progressAt, since) > kProgressTime) return leaveTheWay(0, 2 + 3 * random());
        const double l = std::max(onLeft - room, 0.0), r = std::max(onRight - room, 0.0), most = std::max(l, r);
        if (most < dim) {
            drive.move(0, turnRate);
            return;
        }
        if (most < near && wander()) return leaveTheWay(turnUntil, 1.5 + 3 * random());
        // A lamp at the bearing b gives both cos(50 deg +- b), where both see it.
        const double bearing = std::atan((l - r) / (l + r) / kTangent);
        const double turn =
            std::min(l, r) < 0.03 * most ? (l > r ? turnRate : -turnRate) : std::clamp(3 * bearing, -turnRate, turnRate);
        const double ahead = std::abs(bearing) < 0.35 ? (most < near ? speed : speed / 2) : 0;
        drive.move(ahead, turn);
    }

    /// Goes where it can for `seconds`, after it has turned until `until`: around what is in the way, or to where the light is seen.
    void leaveTheWay(double until, double seconds) {
        enter(State::Search);
        turnUntil = until;
        searchEnd = time() + seconds;
    }

    void search() {
        wander();
        if (battery.charging()) return enter(State::Charge);
        if (time() > searchEnd) enter(State::Seek);
    }

    /// What it touched is no charger.
    void backOff() {
        if (way() < kWays / 2 && elapsed() < 3) return drive.move(-speed / 2, 0);
        turning = random() < 0.5 ? -turnRate : turnRate;
        leaveTheWay(time() + (0.5 + random()) / turnRate, 3);
    }

    void charge() {
        if (battery.level() >= full) {
            charged.set(charged.get() + 1);
            print("charged for ", elapsed(), " s");
            return enter(State::Leave);
        }
        if (battery.charging()) {
            lastContact = time();
            drive.stop();
        } else {
            drive.move(kCreep, 0);
            if (time() - lastContact > 2) enter(State::Seek);
        }
    }

    void leave() {
        if (way() < kWays && elapsed() < 5) return drive.move(-speed / 2, 0);
        enter(State::Work);
        turning = random() < 0.5 ? -turnRate : turnRate;
        turnUntil = time() + (0.5 * kPi + random()) / turnRate;
    }

    std::vector<trundle::RangePort> ranges;
    std::vector<trundle::LedPort> leds;
    trundle::LightPort left, right;
    trundle::BatteryPort battery;
    trundle::TouchPort touch;
    trundle::DifferentialDrivePort drive;
    State state = State::Calibrate;
    bool begun = false;
    double since = 0;                     ///< s, when this state began
    trundle::Pose2 here, before, from;    ///< now, at the last update, and when this state began
    double turned = 0;                    ///< rad, in this state
    double onLeft = 0, onRight = 0;       ///< lx, smoothed
    double room = 0;                      ///< lx
    double progressAt = 0, searchEnd = 0; ///< s
    double turning = 0, turnUntil = 0;    ///< rad/s, s
    double lastContact = 0;               ///< s
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Docking>("Docking"); }
