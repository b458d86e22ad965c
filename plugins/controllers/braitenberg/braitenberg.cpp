// Braitenberg: Vehicles, Experiments in Synthetic Psychology (1984), vehicles 2 and 3: two light sensors, each tied to one of two wheels.
#include <algorithm>
#include <cmath>

#include <trundle/controller.h>

namespace {

struct Braitenberg : trundle::Controller {
    std::string vehicle = "love";
    double speed = 0.1;
    double reference = 1000;
    double reached = 0;
    double trackWidth = 0.053;
    std::string left = "leftLight", right = "rightLight", driveName = "base";

    static void describe(trundle::Describe<Braitenberg>& d) {
        d.help("Two light sensors drive two wheels: it flees from light, attacks it, comes to rest before it or explores.")
            .independent();
        d.field("Vehicle", &Braitenberg::vehicle, trundle::oneOf("fear|aggression|love|explorer"),
                "2a: each sensor drives the wheel on its side; 2b: the other one; 3a, 3b: they slow them down instead.");
        d.field("Speed", &Braitenberg::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "Of a wheel, at most.");
        d.field("Reference", &Braitenberg::reference, trundle::unitOf("lx").above(0).atMost(1e9).live(),
                "Illuminance that drives a wheel fully, or stops it.");
        d.field("Reached", &Braitenberg::reached, trundle::unitOf("lx").within(0, 1e9).live(),
                "The run ends where it is so bright on both sides; 0: never.");
        d.field("TrackWidth", &Braitenberg::trackWidth, trundle::metres().above(0).atMost(10), "Distance of its wheels.");
        d.field("Left", &Braitenberg::left, trundle::needs("LightSensor"), "The robot's LightSensor on the left.");
        d.field("Right", &Braitenberg::right, trundle::needs("LightSensor"), "The one on the right.");
        d.field("Drive", &Braitenberg::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override {
        leftLight = robot.lightSensor(left);
        rightLight = robot.lightSensor(right);
        drive = robot.differentialDrive(driveName);
    }

    void update(trundle::Seconds) override {
        if (leftLight.time() < 0 || rightLight.time() < 0) return;
        const double onLeft = leftLight.illuminance(), onRight = rightLight.illuminance();
        if (reached > 0 && std::min(onLeft, onRight) >= reached) {
            drive.stop();
            return finish("reached the light");
        }
        const bool crossed = vehicle == "aggression" || vehicle == "explorer", slows = vehicle == "love" || vehicle == "explorer";
        const double leftWheel = wheel(crossed ? onRight : onLeft, slows), rightWheel = wheel(crossed ? onLeft : onRight, slows);
        drive.move((leftWheel + rightWheel) / 2, (rightWheel - leftWheel) / trackWidth);
    }

private:
    [[nodiscard]] double wheel(double light, bool slows) const {
        const double share = std::clamp(light / reference, 0.0, 1.0);
        return speed * (slows ? 1 - share : share);
    }

    trundle::LightPort leftLight, rightLight;
    trundle::DifferentialDrivePort drive;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Braitenberg>("Braitenberg"); }
