// Drives until a contact, backs off, turns by a random angle and drives on.
#include <numbers>

#include <trundle/controller.h>

namespace {

struct BumpAndTurn : trundle::Controller {
    double speed = 0.3;
    double backOff = 0.2;
    double turnRate = 2;
    std::array<double, 2> turnAngle{std::numbers::pi / 3, std::numbers::pi};
    std::string touchName = "frontTouch", driveName = "base";

    static void describe(trundle::Describe<BumpAndTurn>& d) {
        d.help("Drives straight on; where it is touched it backs off and turns by a random angle to a random side.")
            .independent();
        d.field("Speed", &BumpAndTurn::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "Forwards and backing off.");
        d.field("BackOff", &BumpAndTurn::backOff, trundle::metres().above(0).atMost(100).live(), "How far it backs off.");
        d.field("TurnRate", &BumpAndTurn::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(),
                "How fast it turns.");
        d.field("TurnAngle", &BumpAndTurn::turnAngle, trundle::degrees().within(1, 360).live(),
                "Least and largest angle of a turn.");
        d.field("Touch", &BumpAndTurn::touchName, trundle::needs("TouchSensor"), "The robot's TouchSensor in front.");
        d.field("Drive", &BumpAndTurn::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override {
        drive = robot.differentialDrive(driveName);
        touch = robot.touch(touchName);
    }

    void update(trundle::Seconds) override {
        switch (doing) {
        case Doing::Driving: return goOn();
        case Doing::BackingOff:
            if (drive.done()) turn();
            return;
        case Doing::Turning:
            if (drive.done()) doing = Doing::Driving;
            return;
        }
    }

private:
    enum class Doing { Driving, BackingOff, Turning };

    void goOn() {
        if (!touch.pressed()) return drive.move(speed, 0);
        print("touched");
        drive.drive(-speed, 0, -backOff, 0);
        doing = Doing::BackingOff;
    }

    void turn() {
        const double side = random() < 0.5 ? 1 : -1;
        drive.turn(turnRate, side * random(turnAngle[0], turnAngle[1]));
        doing = Doing::Turning;
    }

    trundle::DifferentialDrivePort drive;
    trundle::TouchPort touch;
    Doing doing = Doing::Driving;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<BumpAndTurn>("BumpAndTurn"); }
