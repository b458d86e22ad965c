// Moderate random worlds: boxes, balls and jointed pairs in a room. Most that become unstable start with overlaps, which the check
// reports before the run; the others must stop with a message that says what to do. TRUNDLE_LONG: 700 of them.
#include "base/rng.h"
#include "check/check_fixture.h"

using namespace fixture;

namespace {

class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_seed(seed) {}
    double in(double low, double high) {
        return low + (high - low) * static_cast<double>(randomBits(m_seed, 0, 0, m_index++) >> 11) * 0x1p-53;
    }
    std::string number(double low, double high) { return QString::number(in(low, high), 'f', 3).toStdString(); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(in(0, static_cast<double>(n))); }

private:
    std::uint64_t m_seed, m_index = 0;
};

std::string shape(RandomNumbers& rng, const std::string& name) {
    static const char* const kinds[] = {"Box", "Sphere", "Cylinder", "Capsule"};
    const std::size_t kind = rng.below(4);
    std::string text =
        std::string(kinds[kind]) + " " + name + " { Pos=" + rng.number(-0.1, 0.1) + "," + rng.number(-0.1, 0.1) + ",0 ";
    static const char* const densities[] = {"100", "1000", "7800", "19900"};
    text += rng.below(2) ? "Mass=" + rng.number(0.1, 5) : std::string("Density=") + densities[rng.below(4)];
    if (kind == 0) text += " Size=" + rng.number(0.1, 0.5) + "," + rng.number(0.1, 0.5) + "," + rng.number(0.1, 0.5);
    else text += " Radius=" + rng.number(0.03, 0.3);
    if (kind > 1) text += " Length=" + rng.number(0.05, 0.4);
    return text + " }";
}

std::string body(RandomNumbers& rng, const std::string& name) {
    return "Body " + name + " { Pos=" + rng.number(-0.3, 0.3) + "," + rng.number(-0.3, 0.3) + "," + rng.number(-0.2, 0.2) + " " +
           shape(rng, "g") + " " + shape(rng, "h") + " } ";
}

std::string randomWorld(std::uint64_t seed) {
    RandomNumbers rng(seed);
    static const char* const joints[] = {
        "Hinge j { Parent=a Child=b Axis=0,1,0 } Hinge k { Parent=b Child=c Axis=1,0,0 }",
        "Ball j { Parent=a Child=b } Ball k { Parent=b Child=c }",
        "Fixed j { Parent=a Child=b } Hinge k { Parent=a Child=c Axis=0,0,1 }",
        "Universal j { Parent=a Child=b Axis=1,0,0 Axis2=0,1,0 } Hinge k { Parent=world Child=c Axis=0,0,1 }"};
    std::string text =
        "Tick=0.01 Duration=2 Seed=1\nStaticConfig Room { Plane ground { } Box wall { Size=4,0.1,1 Pos=0,1,0.5 } }\n"
        "Static room { Config=Room }\n";
    const std::size_t configs = 1 + rng.below(3);
    for (std::size_t c = 0; c < configs; ++c)
        text += "RobotConfig C" + std::to_string(c) + " { " + body(rng, "a") + body(rng, "b") + body(rng, "c") +
                joints[rng.below(4)] + " }\n";
    const std::size_t robots = 1 + rng.below(8);
    for (std::size_t r = 0; r < robots; ++r)
        text += "Robot r" + std::to_string(r) + " { Config=C" + std::to_string(rng.below(configs)) + " Pos=" + rng.number(-1, 1) +
                "," + rng.number(-1, 1) + "," + rng.number(-1, 1.5) + " HPR=" + rng.number(0, 360) + "," + rng.number(0, 90) +
                "," + rng.number(0, 90) + " }\n";
    return text;
}

} // namespace

class RandomWorldsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void blowUpsArePredictedOrExplained() {
        const CheckFixture fixture;
        const int worlds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 700 : 60;
        int stopped = 0, foretold = 0, warned = 0;
        for (int seed = 0; seed < worlds; ++seed) {
            const auto loaded = fixture.open(randomWorld(static_cast<std::uint64_t>(seed)));
            const Diagnostics found = CheckFixture::check(*loaded);
            QVERIFY2(!loaded->diagnostics.hasErrors(), CheckFixture::shown(*loaded, found).c_str());
            const bool warning =
                std::ranges::any_of(found.all(), [](const Diagnostic& d) { return d.severity == Severity::Warning; });
            warned += warning;
            Diagnostics problems;
            const auto runner = fixture.application->makeRunner(*loaded, {}, problems);
            QVERIFY(runner);
            const World& world = runner->world();
            const auto hasStopped = [&world] { return world.fault() || !world.robotFaults().ends.empty(); };
            for (int tick = 0; tick < 200 && !hasStopped(); ++tick) (void)runner->tick();
            if (!hasStopped()) continue;
            const Fault* fault = world.fault() ? world.fault() : &world.robotFaults().ends.front().fault;
            ++stopped;
            foretold += warning;
            const QString story = QString("world %1: %2 at %3 s: %4")
                                      .arg(seed)
                                      .arg(fault->body.c_str())
                                      .arg(fault->time)
                                      .arg(fault->reason.c_str());
            qInfo("%s%s", warning ? "" : "NOT FORETOLD ", qPrintable(story));
            QVERIFY2(!fault->body.empty() && fault->reason.find("; ") != std::string::npos, qPrintable(story));
            // A fault within the first ticks can only be caused by the start poses.
            QVERIFY2(warning || fault->time > 0.05,
                     qPrintable(story + "\n" + QString::fromStdString(randomWorld(static_cast<std::uint64_t>(seed)))));
        }
        qInfo("%d of %d worlds stopped, the check had warned of %d of them; it warned of %d in all", stopped, worlds, foretold,
              warned);
        QVERIFY(stopped > 0 && warned < worlds);
    }
};

QTEST_GUILESS_MAIN(RandomWorldsTest)
#include "random_worlds_test.moc"
