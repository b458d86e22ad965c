// Defines a kind whose name another module already uses.
#include <trundle/controller.h>

namespace {
struct Driver : trundle::Controller {
    static void describe(trundle::Describe<Driver>&) {}
    void setup(trundle::RobotPorts&) override {}
    void update(trundle::Seconds) override {}
};
} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Driver>("Driver"); }
