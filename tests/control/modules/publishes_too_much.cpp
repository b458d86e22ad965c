#include <trundle/controller.h>
struct Wrong : trundle::Controller {
    static void describe(trundle::Describe<Wrong>& d) { d.output("picture", "", "Its whole map.", 1001); }
    void setup(trundle::RobotPorts&) override {}
    void update(trundle::Seconds) override {}
};
TRUNDLE_MODULE(registry) { registry.controller<Wrong>("Wrong"); }
