#include <stdexcept>

#include <trundle/controller.h>

namespace {
struct Thrower : trundle::Controller {
    static void describe(trundle::Describe<Thrower>&) { throw std::runtime_error("nothing to describe"); }
    void setup(trundle::RobotPorts&) override {}
    void update(trundle::Seconds) override {}
};
} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Thrower>("Thrower"); }
