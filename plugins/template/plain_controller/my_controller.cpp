// A controller that does nothing yet: a start for your own, for a robot without a drive. Once it is built, an experiment beside this
// folder uses it with
//
//     #loadModule my_controller/build/my_controller
//     Robot robot0 { Config=SimpleRobot  MyController brain { } }
//
// The guide says what a controller can do: motors, sensors, cameras, radios, values for logs, ending the run.
#include <trundle/controller.h>

struct MyController : trundle::Controller {
    static void describe(trundle::Describe<MyController>& d) { d.help("Does nothing yet."); }

    void setup(trundle::RobotPorts&) override {} // gets the robot's devices: arm = robot.servo("arm");

    void update(trundle::Seconds) override {} // reads and commands them, in each period
};

TRUNDLE_MODULE(registry) { registry.controller<MyController>("MyController"); }
