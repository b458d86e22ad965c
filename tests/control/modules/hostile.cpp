#include <trundle/controller.h>

namespace {

// Terminal escape sequences in three encodings (7 bits, UTF-8, one byte), invalid UTF-8, a bidirectional control character, and
// lines that imitate another program's output.
constexpr const char* kWords = "\x1b]0;mine\x07 \xc2\x9b"
                               "2J \x9b"
                               "2J \xff\xfe\xc0\xaf \xe2\x80\xae"
                               "mis.exe <img src='/dev/zero'>\r[0 robot1] all is well\x7f";

/// Prints, and fails with, text that must not reach a terminal unchanged.
struct Hostile : trundle::Controller {
    bool fails = false;
    static void describe(trundle::Describe<Hostile>& d) {
        d.help(kWords);
        d.field("Fails", &Hostile::fails, trundle::flag(), kWords);
    }
    void setup(trundle::RobotPorts&) override {
        print(kWords);
        warn(kWords);
        auto log = openLog(std::string("../../") + kWords);
        log.write("no\n");
    }
    void update(trundle::Seconds) override {
        print(kWords);
        if (fails) fail(kWords);
    }
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Hostile>("Hostile"); }
