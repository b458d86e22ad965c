#include <cstdlib>

#include <trundle/controller.h>

namespace {

/// Ends the process with exit code 0, in its third update or in setup; or aborts.
struct Exits : trundle::Controller {
    bool early = false, recurse = false;
    int turns = 0;
    static void describe(trundle::Describe<Exits>& d) {
        d.field("Early", &Exits::early, trundle::flag(), "In setup.");
        d.field("Recurse", &Exits::recurse, trundle::flag(), "Without end.");
    }
    static int deeper(int n) {
        volatile char room[4096];
        room[n % 4096] = 1;
        return n > 0 ? deeper(n + 1) + room[n % 4096] : 0; // not a tail call, so it cannot be compiled to a loop
    }
    void setup(trundle::RobotPorts&) override {
        if (early) std::exit(0);
    }
    void update(trundle::Seconds) override {
        if (recurse) turns = deeper(1);
        else if (++turns == 3) std::exit(0);
    }
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Exits>("Exits"); }
