// Built twice, as before and after a change of the range of Pace, of the other kinds and of the printed text.
#include <filesystem>

#include <trundle/controller.h>

// A symbol with GNU unique binding (one per process), as some compilers emit for `inline` variables.
__asm__(".pushsection .data\n"
        ".globl trundle_test_lives\n"
        ".type trundle_test_lives, @gnu_unique_object\n"
        ".size trundle_test_lives, 4\n"
        "trundle_test_lives: .long 0\n"
        ".popsection\n");
extern "C" int trundle_test_lives;

namespace {

#ifdef TRUNDLE_TEST_AFTER
constexpr const char* kVersion = "after";
constexpr double kMost = 0.5;
#else
constexpr const char* kVersion = "before";
constexpr double kMost = 2;
#endif

struct Rebuilt : trundle::Controller {
    double pace = 0.2;
    std::string hold;
    static void describe(trundle::Describe<Rebuilt>& d) {
        d.field("Pace", &Rebuilt::pace, trundle::metresPerSecond().within(0, kMost).live(), "How fast.");
        d.field("Hold", &Rebuilt::hold, trundle::text(), "A file: its turn takes as long as that is there.");
    }
    void setup(trundle::RobotPorts&) override { print(kVersion, " life ", ++trundle_test_lives, " pace ", pace); }
    void update(trundle::Seconds) override {
        std::error_code none;
        while (!hold.empty() && std::filesystem::exists(hold, none)) {}
    }
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Rebuilt>("Rebuilt"); }
