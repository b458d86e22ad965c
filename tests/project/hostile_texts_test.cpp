// Mutated and malicious texts: each gives diagnostics and never a crash.
// TRUNDLE_LONG sets how many mutations are tried (default 300).

#include <QTest>

#include "base/rng.h"
#include "sample_project.h"

using namespace trundle;
using sample::ProjectFixture;

namespace {

std::string scene() {
    return std::string(sample::kGoodRobot) + R"(
#loadModule walker
Tick = 0.01 Duration = 5
Param gap = 40 cm
StaticConfig Arena { Plane floor { Material=grey Surface=rubber } Box north { Size=4,0.1,0.3 Pos=0,2,0.15 Material=grey Surface=rubber } }
Static arena { Config=Arena }
Robot robot0 { Config=Rover Pos=$gap,0,0 leftMotor.Resistance=$(gap/gap*3) Walker brain { Speed=0.2 } }
Grid swarm { Config=Rover Count=3,2 Spacing=$gap Pos=0,0,1 wheelRadius=0.04 }
Scatter crowd { Config=Rover Count=5 Area=-1,-1,1,1 Pos=8,8,0 }
PoseLog path { Robot=robot0, swarm Interval=0.1 }
)";
}

class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_seed(seed) {}
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(randomBits(m_seed, 0, 0, m_index++) % n); }

private:
    std::uint64_t m_seed, m_index = 0;
};

/// Words, numbers and punctuation are removed, duplicated, swapped and replaced by other valid ones.
std::string mutated(std::string text, RandomNumbers& rng) {
    static const char* const pieces[] = {"{",
                                         "}",
                                         "=",
                                         ",",
                                         "$",
                                         "$(",
                                         ")",
                                         "0",
                                         "-1",
                                         "1e308",
                                         "1e-308",
                                         "1e9",
                                         "nan",
                                         "true",
                                         "world",
                                         "\"",
                                         "//",
                                         "/*",
                                         "\n",
                                         "Body x {",
                                         "Box",
                                         "Param",
                                         "#import main.sim\n",
                                         "#loadModule mystery\n",
                                         "swarm_0",
                                         "robot0.",
                                         "Config=Rover",
                                         "Count=400,500",
                                         "Mass=1",
                                         "Inertia=1,1,1",
                                         "Scatter",
                                         "Grid",
                                         "gap",
                                         "$gap",
                                         "cm",
                                         "kg",
                                         ".",
                                         "\xff",
                                         "\xe2\x88\x92"};
    for (std::size_t n = 1 + rng.below(4); n-- > 0;) {
        const std::size_t at = rng.below(text.size() + 1), length = std::min(rng.below(30), text.size() - at);
        switch (rng.below(5)) {
        case 0: text.erase(at, length); break;
        case 1: text.insert(rng.below(text.size() + 1), text.substr(at, length)); break;
        case 2: text.insert(at, pieces[rng.below(std::size(pieces))]); break;
        case 3: text.replace(at, length, pieces[rng.below(std::size(pieces))]); break;
        default: text.insert(rng.below(text.size() + 1), text.substr(at, std::min<std::size_t>(text.size() - at, 400))); break;
        }
    }
    return text;
}

void checkSound(const ExperimentSpec& e) {
    for (const RobotSpec& robot : e.robots) {
        QVERIFY(robot.config && !robot.config->bodies.empty());
        QVERIFY(robot.pose.position.allFinite());
        const int bodies = static_cast<int>(robot.config->bodies.size());
        for (const BodySpec& body : robot.config->bodies) {
            QVERIFY(body.isFixed || body.mass.mass > 0);
            QVERIFY(body.mass.inertia.allFinite() && (body.isFixed || body.mass.inertia.diagonal().minCoeff() > 0));
            for (const GeomSpec& geom : body.geoms)
                QVERIFY(geom.material < e.materials.size() && geom.surface < e.surfaces.size());
        }
        for (const JointSpec& joint : robot.config->joints) {
            QVERIFY(joint.child >= 0 && joint.child < bodies && joint.parent >= kWorldBody && joint.parent < bodies &&
                    joint.parent != joint.child);
            QVERIFY(std::abs(joint.axis.norm() - 1) < 1e-9);
        }
    }
}

} // namespace

class HostileTextsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theSceneItselfIsRight() {
        ProjectFixture fixture;
        QCOMPARE(sample::rendered(*fixture.open(scene())), "");
    }

    void mutations() {
        const std::string many = qEnvironmentVariable("TRUNDLE_LONG").toStdString();
        const int count = many.empty() ? 300 : std::max(std::atoi(many.c_str()), 5000);
        ProjectFixture fixture;
        for (int i = 0; i < count; ++i) {
            RandomNumbers rng(static_cast<std::uint64_t>(i));
            const std::string text = mutated(scene(), rng);
            const auto loaded = fixture.open(text);
            QVERIFY(loaded);
            QCOMPARE(print(*loaded->trees[0]), text);
            checkSound(*loaded->experiment);
            (void)sample::rendered(*loaded);
        }
    }

    void mutationsOfSets() {
        ProjectFixture fixture;
        for (int i = 0; i < 200; ++i) {
            RandomNumbers rng(static_cast<std::uint64_t>(1000 + i));
            fixture.options.sets = {mutated("robot0.leftMotor.Resistance=3", rng),
                                    mutated("RobotConfig.Rover.chassis.hull.Mass=2 kg", rng), mutated("swarm_1.Pos=1,2,3", rng)};
            checkSound(*fixture.open(scene())->experiment);
        }
    }

    void handlesManyErrorsQuickly() {
        ProjectFixture fixture;
        std::string text = "RobotConfig Big {\n";
        for (int i = 0; i < 20000; ++i)
            text += "Boddy b" + std::to_string(i) + " { }\nHinge h" + std::to_string(i) + " { Parent=x Child=y" +
                    std::to_string(i) + " }\n";
        const auto loaded = fixture.open(text + "}\n");
        QVERIFY(loaded->diagnostics.errorCount() > 20000);
        std::string paths = "RobotConfig Big {\n"; // bodies that lack a mass, with a path that has a `$`
        for (int i = 0; i < 40000; ++i) paths += "Body b" + std::to_string(i) + " { Parent=$a.b }\n";
        QVERIFY(fixture.open(paths + "}\n")->diagnostics.errorCount() > 10000);
    }

    /// What describes a Param, in another such text, and so on.
    void deepDescriptions() {
        ProjectFixture fixture;
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += "Param r = 5 cm {\n";
        const auto loaded = fixture.open(text);
        QVERIFY(sample::messages(*loaded).find("blocks nest deeper than") != std::string::npos);
        QCOMPARE(print(*loaded->trees[0]), text);
    }

    void readsLargeInvalidTextsPartially_data() {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("piece");
        QTest::newRow("unknown kinds") << QByteArray() << QByteArray("Foo x { A=1 }\n");
        QTest::newRow("unknown settings") << QByteArray() << QByteArray("a=1\n");
        QTest::newRow("settings twice") << QByteArray() << QByteArray("Tick=1\n");
        QTest::newRow("Params twice") << QByteArray() << QByteArray("Param a=1\n");
        QTest::newRow("values of a wrong type") << QByteArray() << QByteArray("Robot r { Pos=abc }\n");
        QTest::newRow("properties twice") << QByteArray("RobotConfig R { Body b {") << QByteArray(" Mass=1");
        QTest::newRow("imports of nothing") << QByteArray() << QByteArray("#import nothing.sim\n");
        QTest::newRow("behind a good text") << QByteArray::fromStdString(scene()) << QByteArray("Foo x { A=1 }\n");
    }
    /// Kept diagnostics do not grow with the text, and the last one of the file counts what was not read or listed.
    void readsLargeInvalidTextsPartially() {
        QFETCH(QByteArray, head);
        QFETCH(QByteArray, piece);
        ProjectFixture fixture;
        const auto loaded = fixture.open((head + piece.repeated(3'000'000 / int(piece.size()))).toStdString());
        const Tree& tree = *loaded->trees[0];
        QCOMPARE(tree.extent(), Tree::Extent::Limited);
        QVERIFY(tree.tokens().size() < 300'000 && tree.readTo() < tree.source().bytes().size());
        QVERIFY(loaded->diagnostics.hasErrors());
        QVERIFY(loaded->diagnostics.all().size() <= 2 * Diagnostics::kMaxOfOneFile + 2);
        QVERIFY(std::any_of(loaded->diagnostics.all().begin(), loaded->diagnostics.all().end(), [](const Diagnostic& d) {
            return d.code == Code::TooManyMistakes && d.message.find("of this file are not read") != std::string::npos;
        }));
    }

    /// A large valid text is read completely, even if definitions that it needs come last.
    void largeTextsThatAreRightAreReadWhole() {
        ProjectFixture fixture;
        std::string text = "#loadModule walker\n";
        for (int i = 0; i < 12'000; ++i) text += "Robot r" + std::to_string(i) + " { Config=Rover Pos=1,2,3 HPR=0,0,0 }\n";
        const auto loaded = fixture.open(text + sample::kGoodRobot);
        QVERIFY2(!loaded->diagnostics.hasErrors(), sample::rendered(*loaded).substr(0, 2000).c_str());
        QCOMPARE(loaded->trees[0]->extent(), Tree::Extent::Whole);
        QCOMPARE(loaded->experiment->robots.size(), std::size_t(12'000));
    }

    /// A link that leads back to itself, alone or through another one, is no missing file.
    void circlesOfLinks() {
        ProjectFixture fixture;
        std::filesystem::create_symlink("own.sim", fixture.folder() + "/own.sim");
        std::filesystem::create_symlink("there.sim", fixture.folder() + "/back.sim");
        std::filesystem::create_symlink("back.sim", fixture.folder() + "/there.sim");
        const auto loaded = fixture.open("#import own.sim\n#import back.sim\n#import lost.sim\n");
        const std::string said = sample::messages(*loaded);
        QVERIFY2(said.find("E322 own.sim is a link that leads back to itself\nE322 back.sim is a link that leads back to itself\n"
                           "E308 lost.sim is not found") == 0,
                 said.c_str());
    }

    void longChainsOfParams() {
        ProjectFixture fixture;
        std::string text = "Param p0 = 1\n", lists = "Param q0 = 1,1\n";
        for (int i = 1; i < 3000; ++i) text += "Param p" + std::to_string(i) + " = $(p" + std::to_string(i - 1) + "+1)\n";
        for (int i = 1; i < 60; ++i)
            lists += "Param q" + std::to_string(i) + " = $q" + std::to_string(i - 1) + ", $q" + std::to_string(i - 1) + "\n";
        (void)fixture.open("Tick = $p2999\n" + text);
        (void)fixture.open("Gravity = $q59\n" + lists);
    }

    void hugeNumbers() {
        ProjectFixture fixture;
        for (const char* n : {"1e308", "-1e308", "1e-308", "4e18", "99999999999999999999"}) {
            const auto loaded =
                fixture.open(scene() + "Robot x { Config=Rover Pos=" + n + "," + n + "," + n + " HPR=" + n +
                             ",0,0 wheelRadius=" + n + " leftMotor.GearRatio=" + n + " }\nGrid g { Config=Rover Count=" + n +
                             " Spacing=" + n + " }\nSeed=" + n + "\nIterations=" + n + "\n");
            checkSound(*loaded->experiment);
        }
    }
};

QTEST_APPLESS_MAIN(HostileTextsTest)
#include "hostile_texts_test.moc"
