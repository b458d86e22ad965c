// What an edit of the document does to a running world: which commands are sent, and what waits for a reset.
#include <QtTest>

#include "editor/running/live_edits.h"
#include "model/sample_kinds.h"
#include "project/plan_fixture.h"

using namespace trundle;
using sample::PlanFixture;

namespace {

const std::string kText = R"(Surface rubber { Friction=0.9 }
Surface rubber2 { Friction=0.8 }
Material red { ColorRGB=1,0,0 }
RobotConfig Cart {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Mass=2 Material=red Surface=rubber } }
  Body wheel { Pos=0,0.1,0 Sphere tyre { Radius=0.05 Mass=0.1 Material=red Surface=rubber2 } }
  Hinge axle { Parent=chassis Child=wheel Axis=0,1,0 }
  RotaryMotor motor { Joint=axle TorqueConstant=1 BackEmfConstant=1 Resistance=2 MaxVoltage=12 }
  RotaryMotor motor1 { Joint=axle TorqueConstant=1 BackEmfConstant=1 Resistance=3 MaxVoltage=12 }
}
Robot robot1 { Config=Cart }
Robot robot10 { Config=Cart Pos=3,0,0 motor.Resistance=4 }
)";

std::string edited(const std::string& from, const std::string& to) {
    std::string text = kText;
    return text.replace(text.find(from), from.size(), to);
}

std::string commandText(const decltype(Command::what)& what) {
    const auto number = [](double value) { return QByteArray::number(value).toStdString(); };
    if (const auto* s = std::get_if<SurfaceCommand>(&what))
        return s->surface.name + " " + number(s->surface.friction) + " " + number(s->surface.restitution) + " " +
               number(s->surface.rollingFriction) + " " + number(s->surface.softness) + " " +
               number(s->surface.friction2.value_or(-1)) + " " + number(s->surface.frictionHeading);
    if (const auto* p = std::get_if<PropertyCommand>(&what))
        return p->object + "." + p->property + "=" + number(p->value.numbers.at(0));
    if (const auto* s = std::get_if<SwapCommand>(&what))
        return s->robot + ": " + (s->controller.empty() ? "none" : s->controller) + " becomes " +
               (s->to ? s->to->kind + " " + s->to->name : "none") + (s->library.empty() ? "" : " of a module");
    return "another command";
}

} // namespace

class LiveEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void textsOfEdits_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("commands");
        QTest::addColumn<QStringList>("waiting");
        const auto row = [](const char* name, const std::string& text, const char* commands, const char* waiting = "") {
            const auto list = [](const char* words) {
                return QString::fromLatin1(words).split(QLatin1Char('|'), Qt::SkipEmptyParts);
            };
            QTest::newRow(name) << QString::fromStdString(text) << list(commands) << list(waiting);
        };
        row("nothing", kText, "");
        row("comment", kText + "// more\n", "");
        row("Friction", edited("Friction=0.9", "Friction=0.5"), "rubber 0.5 0 0 0 -1 0");
        row("Restitution", edited("Friction=0.9", "Friction=0.9 Restitution=0.1"), "rubber 0.9 0.1 0 0 -1 0");
        row("RollingFriction", edited("Friction=0.9", "Friction=0.9 RollingFriction=2mm"), "rubber 0.9 0 0.002 0 -1 0");
        row("Softness", edited("Friction=0.9", "Friction=0.9 Softness=0.001"), "rubber 0.9 0 0 0.001 -1 0");
        row("Friction2", edited("Friction=0.9", "Friction=0.9 Friction2=0.3"), "rubber 0.9 0 0 0 0.3 0");
        row("FrictionHeading", edited("Friction=0.9", "Friction=0.9 Friction2=0.9 FrictionHeading=90"),
            "rubber 0.9 0 0 0 0.9 1.5708");
        row("the other surface", edited("Friction=0.8", "Friction=0.5"), "rubber2 0.5 0 0 0 -1 0");
        row("a material", edited("1,0,0 }", "0,1,0 }"), "");
        row("a config", edited("Resistance=2", "Resistance=5"), "robot1/motor.Resistance=5"); // robot10 overrides it
        row("the other motor", edited("Resistance=3", "Resistance=5"), "robot1/motor1.Resistance=5|robot10/motor1.Resistance=5");
        row("an override", edited("motor.Resistance=4", "motor.Resistance=6"), "robot10/motor.Resistance=6");
        row("no live value", edited("MaxVoltage=12", "MaxVoltage=13"), "", "RobotConfig.Cart.motor.MaxVoltage");
        row("a pose", edited("Pos=3,0,0", "Pos=4,0,0"), "", "robot10.Pos");
        row("a robot less", edited("Robot robot1 { Config=Cart }\n", ""), "", "robot1");
        row("a robot less, and one whose name begins like it",
            edited("Robot robot1 { Config=Cart }\nRobot robot10 { Config=Cart Pos=3,0,0",
                   "Robot robot10 { Config=Cart Pos=4,0,0"),
            "", "robot1|robot10.Pos");
        row("a robot more", kText + "Robot robot { Config=Cart }\n", "", "robot");
        row("both at once", edited("Pos=3,0,0 motor.Resistance=4", "Pos=4,0,0 motor.Resistance=6"), "robot10/motor.Resistance=6",
            "robot10.Pos");
        row("an error elsewhere", edited("Friction=0.9", "Friction=0.5") + "Robot bad { Config=Nothing }\n", "", "bad");
        row("an error in the value", edited("Resistance=2", "Resistance=-5"), "");
        row("a syntax error", edited("Friction=0.9", "Friction=0.5") + "Tick = \n", "", "Tick");
    }
    void textsOfEdits() {
        QFETCH(QString, text);
        QFETCH(QStringList, commands);
        QFETCH(QStringList, waiting);
        PlanFixture fixture;
        const auto built = fixture.open(kText);
        QVERIFY2(!built->diagnostics.hasErrors(), sample::messages(*built).c_str());
        const auto now = fixture.open(text.toStdString());
        const LiveEdits result = edits(built, *built->experiment, now);
        QStringList sent, waits;
        for (const auto& what : result.commands) sent << QString::fromStdString(commandText(what));
        for (const std::string& path : result.waiting) waits << QString::fromStdString(path);
        QCOMPARE(sent, commands);
        QCOMPARE(waits, waiting);
        if (!sent.isEmpty()) QVERIFY(result.experiment);
        if (now->diagnostics.hasErrors()) QVERIFY(!result.experiment);
        // What was sent is not sent again.
        if (result.experiment) QVERIFY(edits(built, *result.experiment, now).commands.empty());
    }

    /// A changed block is looked at for every robot that it concerns.
    void robotsThatABlockConcerns_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QStringList>("objects");
        const auto row = [](const char* name, const char* from, const char* to, const char* objects) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromLatin1(objects).split(QLatin1Char(' '));
        };
        row("a config with a variant", "Resistance=2 ", "Resistance=5 ", "heavy/motor robot1/motor");
        row("a Static with a device", "Resistance=7", "Resistance=5", "door/opener");
        row("in a Repeat", "Resistance=11", "Resistance=5", "row_0.my_cart/motor row_1.my_cart/motor");
        row("a Grid in a Repeat", "Resistance=12", "Resistance=5",
            "row_0.swarm_0/motor row_0.swarm_1/motor row_1.swarm_0/motor row_1.swarm_1/motor");
        row("in a Repeat in a Repeat", "Resistance=13", "Resistance=5",
            "row_0.inner_0.cart/motor row_0.inner_1.cart/motor row_1.inner_0.cart/motor row_1.inner_1.cart/motor");
    }
    void robotsThatABlockConcerns() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QStringList, objects);
        const QByteArray text = QByteArray::fromStdString(kText) + R"(RobotConfig Heavy { Config=Cart }
Robot heavy { Config=Heavy Pos=0,9,0 }
StaticConfig Door {
  Body leaf { Pos=0,0,1 Box panel { Size=1,0.1,1 Mass=2 Material=red Surface=rubber } }
  Hinge hinge { Parent=world Child=leaf Axis=0,0,1 }
  RotaryMotor opener { Joint=hinge TorqueConstant=1 BackEmfConstant=1 Resistance=7 MaxVoltage=12 }
}
Static door { Config=Door Pos=0,20,0 }
Repeat row {
  Count=2 Pos=0,$(30 + 5*index),0
  Robot my_cart { Config=Cart motor.Resistance=11 }
  Grid swarm { Config=Cart Pos=5,0,0 Count=2 Spacing=1 motor.Resistance=12 }
  Repeat inner { Count=2 Pos=$(9 + index),0,0 Robot cart { Config=Cart motor.Resistance=13 } }
}
)";
        PlanFixture fixture;
        const auto built = fixture.open(text.toStdString()), now = fixture.open(QByteArray(text).replace(from, to).toStdString());
        QVERIFY2(!built->diagnostics.hasErrors(), sample::messages(*built).c_str());
        const ChangeSet changes(built, now);
        QVERIFY(changes.isLocal());
        RunComparison comparison;
        comparison.begin(built);
        const LiveEdits result = comparison.follow(changes, *built->experiment);
        QStringList sent;
        for (const auto& what : result.commands) sent << QString::fromStdString(commandText(what));
        sent.sort();
        for (QString& object : objects) object += QStringLiteral(".Resistance=5");
        QCOMPARE(sent, objects);
        QVERIFY(result.waiting.empty());
    }

    void controllersAreReplaced_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QStringList>("commands");
        QTest::addColumn<QStringList>("waiting");
        const auto row = [](const char* name, const char* from, const char* to, const char* commands, const char* waiting = "") {
            const auto list = [](const char* words) {
                return QString::fromLatin1(words).split(QLatin1Char('|'), Qt::SkipEmptyParts);
            };
            QTest::newRow(name) << QString::fromLatin1(from) << QString::fromLatin1(to) << list(commands) << list(waiting);
        };
        row("another kind", "Walker brain { Speed=1 }", "LinearMotion brain { }", "w: brain becomes LinearMotion brain of a module");
        row("another name", "Walker brain", "Walker mind", "w: brain becomes Walker mind of a module");
        row("none", "Walker brain { Speed=1 } }", "}", "w: brain becomes none");
        row("a first one", "Robot robot1 { Config=Cart }", "Robot robot1 { Config=Cart Walker own { } }",
            "robot1: none becomes Walker own of a module");
        row("a second one", "Walker brain { Speed=1 }", "Walker brain { Speed=1 } LinearMotion arm { }",
            "w: none becomes LinearMotion arm of a module");
        row("a second one before it", "Walker brain { Speed=1 }", "LinearMotion arm { } Walker brain { Speed=1 }",
            "w: none becomes LinearMotion arm of a module");
        row("a second one, and another value of the first", "Walker brain { Speed=1 }",
            "Walker brain { Speed=2 } LinearMotion arm { }", "w: none becomes LinearMotion arm of a module", "w.brain.Speed");
        row("the first of two goes", "Walker arm { } ", "", "two: arm becomes none");
        row("the first of two goes, the second is another kind", "Walker arm { } Walker legs { }", "LinearMotion legs { }",
            "two: arm becomes none|two: legs becomes LinearMotion legs of a module");
        row("another order", "Walker arm { } Walker legs { }", "Walker legs { } Walker arm { }", "");
        row("another name beside one", "Walker arm { } Walker legs { }", "Walker legs { } LinearMotion hand { }",
            "two: arm becomes LinearMotion hand of a module");
        row("one of two", "Walker legs { }", "LinearMotion legs { }", "two: legs becomes LinearMotion legs of a module");
        row("of a Grid", "Walker each { }", "LinearMotion each { }",
            "g_0: each becomes LinearMotion each of a module|g_1: each becomes LinearMotion each of a module");
        row("of a Repeat", "Walker lead { }", "LinearMotion lead { }",
            "row_0.cart: lead becomes LinearMotion lead of a module|row_1.cart: lead becomes LinearMotion lead of a module");
        row("of a Grid in a Repeat", "Walker hive { }", "LinearMotion hive { }",
            "row_0.swarm_0: hive becomes LinearMotion hive of a module|row_1.swarm_0: hive becomes LinearMotion hive of a "
            "module");
        row("a value that is not live", "Speed=1", "Speed=2", "", "w.brain.Speed");
        row("another kind and a pose", "Pos=9,0,0 Walker brain { Speed=1 }", "Pos=9,1,0 LinearMotion brain { }",
            "w: brain becomes LinearMotion brain of a module", "w.Pos");
    }
    void controllersAreReplaced() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QStringList, commands);
        QFETCH(QStringList, waiting);
        const QString text =
            QString::fromStdString("#loadModule walker\n#loadModule controllers/linear_motion\n" + kText +
                                   "Robot w { Config=Cart Pos=9,0,0 Walker brain { Speed=1 } }\n"
                                   "Robot two { Config=Cart Pos=9,5,0 Walker arm { } Walker legs { } }\n"
                                   "Grid g { Config=Cart Pos=0,5,0 Count=2 Spacing=1 Walker each { } }\n"
                                   "Repeat row { Count=2 Pos=0,$(20 + 3*index),0\n"
                                   "  Robot cart { Config=Cart Walker lead { } }\n"
                                   "  Grid swarm { Config=Cart Pos=5,0,0 Count=1 Spacing=1 Walker hive { } } }\n");
        PlanFixture fixture;
        const auto built = fixture.open(text.toStdString()), now = fixture.open(QString(text).replace(from, to).toStdString());
        QVERIFY2(!built->diagnostics.hasErrors(), sample::messages(*built).c_str());
        QVERIFY2(!now->diagnostics.hasErrors(), sample::messages(*now).c_str());
        RunComparison comparison;
        comparison.begin(built);
        const LiveEdits result = comparison.follow(ChangeSet(built, now), *built->experiment);
        QStringList sent, waits;
        for (const auto& what : result.commands) sent << QString::fromStdString(commandText(what));
        for (const std::string& path : result.waiting) waits << QString::fromStdString(path);
        QCOMPARE(sent, commands);
        QCOMPARE(waits, waiting);
        // Undone, the old one takes its place again; an edit of one that came during the run replaces it.
        if (!result.experiment) return;
        const LiveEdits undone = comparison.follow(ChangeSet(now, built), *result.experiment);
        QCOMPARE(undone.commands.size(), result.commands.size());
        QVERIFY(undone.waiting.empty());
    }

    /// Each value of a material is shown at once.
    void materials() {
        PlanFixture fixture;
        for (const std::string change :
             {"ColorRGB=1,0,0.5", "Shininess=0.5 ColorRGB=1,0,0", "Opacity=0.5 ColorRGB=1,0,0", "TextureScale=2 ColorRGB=1,0,0",
              "TextureMap=box ColorRGB=1,0,0", "Emission=0,0,1 ColorRGB=1,0,0"}) {
            const auto built = fixture.open(kText), now = fixture.open(edited("ColorRGB=1,0,0", change));
            const LiveEdits result = edits(built, *built->experiment, now);
            QVERIFY2(result.experiment && result.commands.empty() && result.waiting.empty(), change.c_str());
            QVERIFY(!edits(built, *result.experiment, now).experiment);
        }
    }

    /// Edit after edit, only what changed is looked at, with the same result as if all texts were compared.
    void followsEditAfterEdit() {
        PlanFixture fixture;
        const auto built = fixture.open(kText);
        RunComparison edits;
        edits.begin(built);
        std::shared_ptr<const LoadedProject> before = built;
        std::shared_ptr<const ExperimentSpec> running = built->experiment;
        std::string text = kText;
        const std::vector<std::pair<std::string, std::string>> steps{
            {"Friction=0.9", "Friction=0.5"},  {"MaxVoltage=12", "MaxVoltage=13"},  {"Pos=3,0,0", "Pos=4,0,0"},
            {"Resistance=2", "Resistance=-5"}, {"Resistance=3", "Resistance=5"}, // an error: nothing is sent
            {"Resistance=-5", "Resistance=2"}, {"MaxVoltage=13", "MaxVoltage=12"},  {"Robot robot1 {", "Robot rover {"},
            {"Pos=4,0,0", "Pos=3,0,0"},        {"Robot rover {", "Robot robot1 {"}, {"1,0,0 }", "0,1,0 }"},
            {"Friction=0.5", "Friction=0.9"}};
        for (const auto& [from, to] : steps) {
            text.replace(text.find(from), from.size(), to);
            const auto now = fixture.open(text);
            const LiveEdits found = edits.follow(ChangeSet(before, now), *running), all = this->edits(built, *running, now);
            QCOMPARE(found.waiting, all.waiting);
            QCOMPARE(found.commands.size(), all.commands.size());
            for (std::size_t i = 0; i < found.commands.size(); ++i)
                QCOMPARE(commandText(found.commands[i]), commandText(all.commands[i]));
            QCOMPARE(found.experiment != nullptr, all.experiment != nullptr);
            if (found.experiment) running = found.experiment;
            before = now;
        }
        QVERIFY(edits.follow(ChangeSet(before, before), *running).waiting.empty()); // all is as it was
    }

    /// One value of 2,000 blocks: one command, and no look at the others.
    void oneValueOfMany() {
        PlanFixture fixture;
        std::string text = kText;
        for (int i = 0; i < 2000; ++i)
            text += "Surface s" + std::to_string(i) + " { Friction=0.5 }\nRobot r" + std::to_string(i) + " { Config=Cart Pos=0," +
                    std::to_string(i) + ",0 motor.Resistance=4 }\n";
        const auto built = fixture.open(text);
        QVERIFY2(!built->diagnostics.hasErrors(), sample::messages(*built).c_str());
        RunComparison edits;
        edits.begin(built);
        std::string faster = text;
        faster.replace(faster.rfind("Resistance=4"), 12, "Resistance=6");
        const auto now = fixture.open(faster);
        const ChangeSet changes(built, now);
        const LiveEdits found = edits.follow(changes, *built->experiment);
        QCOMPARE(found.commands.size(), 1u);
        QCOMPARE(commandText(found.commands[0]), std::string("r1999/motor.Resistance=6"));
        QVERIFY(found.waiting.empty());
        QVERIFY2(edits.compared() <= 4, std::to_string(edits.compared()).c_str());
        std::string slippery = text; // a block that is named with its kind
        slippery.replace(slippery.rfind("Friction=0.5"), 12, "Friction=0.4");
        const auto smooth = fixture.open(slippery);
        edits.begin(built);
        const LiveEdits one = edits.follow(ChangeSet(built, smooth), *built->experiment);
        QCOMPARE(one.commands.size(), 1u);
        QVERIFY(commandText(one.commands[0]).starts_with("s1999 0.4 "));
        QVERIFY2(edits.compared() <= 8, std::to_string(edits.compared()).c_str());
        // All of it, for comparison.
        RunComparison all;
        all.begin(built);
        QCOMPARE(all.follow(ChangeSet::ofEverything(built, now), *built->experiment).commands.size(), 1u);
        QVERIFY(all.compared() > 10000);
        QElapsedTimer clock;
        clock.start();
        (void)ChangeSet(built, now);
        const auto compared = clock.nsecsElapsed();
        edits.begin(built);
        (void)edits.follow(changes, *built->experiment);
        const auto followed = clock.nsecsElapsed();
        all.begin(built);
        (void)all.follow(ChangeSet::ofEverything(built, now), *built->experiment);
        qInfo("comparison %.2f ms, commands %.2f ms, commands from all texts %.2f ms", double(compared) / 1e6,
              double(followed - compared) / 1e6, double(clock.nsecsElapsed() - followed) / 1e6);
    }

private:
    static LiveEdits edits(const std::shared_ptr<const LoadedProject>& built, const ExperimentSpec& running,
                           const std::shared_ptr<const LoadedProject>& now) {
        RunComparison edits;
        edits.begin(built);
        return edits.follow(ChangeSet::ofEverything(built, now), running);
    }
};

QTEST_APPLESS_MAIN(LiveEditsTest)
#include "live_edits_test.moc"
