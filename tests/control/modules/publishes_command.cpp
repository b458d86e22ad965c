#include <trundle/controller.h>
struct Wrong : trundle::Controller {
    static void describe(trundle::Describe<Wrong>& d) { d.command("speed", "m/s", "Nobody could give it."); }
    void setup(trundle::RobotPorts&) override {}
    void update(trundle::Seconds) override {}
};
TRUNDLE_MODULE(registry) { registry.controller<Wrong>("Wrong"); }
