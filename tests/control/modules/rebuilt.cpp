// Built twice, as before and after a change of the range of Pace, of the other kinds and of the printed text.
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

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
    std::string hold, state = "none";
    int updates = 0;
    static void describe(trundle::Describe<Rebuilt>& d) {
        d.field("Pace", &Rebuilt::pace, trundle::metresPerSecond().within(0, kMost).live(), "How fast.");
        d.field("Hold", &Rebuilt::hold, trundle::text(), "A file: its turn takes as long as that is there.");
        d.field("State", &Rebuilt::state, trundle::oneOf("none|saved|throws|crashes|refused"), "What becomes of its state.");
    }
    void setup(trundle::RobotPorts&) override { print(kVersion, " life ", ++trundle_test_lives, " pace ", pace); }
    std::string saveState() const override {
        if (state == "throws") throw std::runtime_error("nothing is saved");
        if (state == "crashes") std::abort();
        return state == "none" ? std::string() : std::string(kVersion) + " after " + std::to_string(updates) + '\0' + "!";
    }
    void loadState(std::string_view saved) override {
        if (state == "refused") throw std::runtime_error("too old");
        print(kVersion, " continues from ", saved.substr(0, saved.find('\0')), " of ", saved.size());
    }
    void update(trundle::Seconds) override {
        ++updates;
        std::error_code none;
        while (!hold.empty() && std::filesystem::exists(hold, none)) {}
    }
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Rebuilt>("Rebuilt"); }
