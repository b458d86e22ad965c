// A robot of which a side becomes a part, or a member of a Repeat, moves to the same bits as before; its mirror image is that by hand.

#include "flow/cli.h"
#include "project/edits/plan_wrap.h"
#include "project/plan_fixture.h"

using namespace trundle;

namespace {

const std::string kHead = "Duration=1\n#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/open_floor.sim\n"
                          "Static floor { Config=OpenFloor }\n";

/// A side of the robot; `s` is the sign of what a mirror image has the other way.
std::string side(const std::string& n, const std::string& s) {
    std::string text =
        "Body @nWheel { Pos=0.06,@s0.125,$r Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,@s90 Mass=0.15 Material=black "
        "Surface=rubber } }\n"
        "Body @nSkid { Pos=-0.1,@s0.08,0.03 HPR=@s10,0,0 Sphere ball { Radius=0.03 Mass=0.05 Material=darkgrey Surface=slick } "
        "}\n"
        "Hinge @nAxle { Parent=chassis Child=@nWheel Axis=0,1,0 Damping=0.001 }\n"
        "Fixed @nFoot { Parent=chassis Child=@nSkid }\n"
        "RotaryMotor @nMotor { Joint=@nAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }\n";
    for (const auto& [word, value] : {std::pair{std::string("@n"), n}, {std::string("@s"), s}})
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word))
            text.replace(at, word.size(), value);
    return text;
}
std::string robot(const std::string& right) {
    return kHead +
           "RobotConfig Kit { Param r = 0.05\nBody chassis { Pos=0,0,0.01 Box hull { Size=0.3,0.2,0.06 Pos=0,0,0.1 Mass=2 "
           "Material=orange Surface=plastic } }\n" +
           side("left", "") + right + "}\nRobot a { Config=Kit Pos=0,0,0.02 HPR=20,2,0 leftMotor.Resistance=3 }\n";
}
const std::vector<std::string> kLeft{"RobotConfig.Kit.leftWheel", "RobotConfig.Kit.leftSkid", "RobotConfig.Kit.leftAxle",
                                     "RobotConfig.Kit.leftFoot", "RobotConfig.Kit.leftMotor"};

} // namespace

class WrappedFlowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { m_fixture.options.shippedConfigs = TRUNDLE_SOURCE_DIR "/configs"; }

    void aPartMovesAsItsBlocks() {
        const std::string text = robot(side("right", "-"));
        const auto loaded = open(text);
        compare(text, m_fixture.text(loaded, planMakePart(*loaded, kLeft)));
    }
    void aRepeatMovesAsItsBlocks() {
        const std::string text = robot(side("right", "-"));
        const auto loaded = open(text);
        compare(text, m_fixture.text(loaded, planRepeat(*loaded, kLeft, 1, {0, 0.1, 0})));
    }
    void aMirrorImageMovesAsThatByHand() {
        const auto loaded = open(robot({}));
        compare(robot(side("right", "-")), m_fixture.text(loaded, planMirror(*loaded, kLeft, 'y')));
    }

private:
    std::shared_ptr<const LoadedProject> open(const std::string& text) {
        const auto loaded = m_fixture.open(text);
        if (loaded->diagnostics.hasErrors()) qCritical("%s", sample::messages(*loaded).c_str());
        return loaded;
    }
    static QByteArray hashOf(const std::string& text) {
        QTemporaryDir folder;
        const QString file = folder.filePath("robot.sim");
        if (!writeFile(file, QByteArray::fromStdString(text))) return "not written";
        const Outcome run = cli({"run", file, "--hash"});
        for (const QByteArray& line : (run.out + "\n" + run.err).split('\n'))
            if (line.contains("hash")) return line.simplified();
        return run.out + run.err + QByteArray::fromStdString(text);
    }
    static void compare(const std::string& before, const std::string& after) {
        QVERIFY(before != after);
        const QByteArray hash = hashOf(before);
        QVERIFY2(hash.contains("hash"), hash);
        QCOMPARE(hashOf(after), hash);
    }

    sample::PlanFixture m_fixture;
};

QTEST_GUILESS_MAIN(WrappedFlowTest)
#include "wrapped_test.moc"
