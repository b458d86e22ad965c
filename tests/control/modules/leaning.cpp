// Links a library that is in the same folder.
#include <trundle/controller.h>

extern "C" int trundleTestBeside();

namespace {
struct Leaning : trundle::Controller {
    static void describe(trundle::Describe<Leaning>& d) { d.help("Leans on " + std::to_string(trundleTestBeside()) + "."); }
    void setup(trundle::RobotPorts&) override {}
    void update(trundle::Seconds) override {}
};
} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Leaning>("Leaning"); }
