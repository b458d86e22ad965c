// What completion offers: texts with a caret, written `|`, and the entries that must or must not be listed there.

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/application.h"
#include "editor/text/completion/completion.h"

using namespace trundle;

namespace {

constexpr char kParts[] = R"(
Material steel { ColorRGB=0.5,0.5,0.5 }
Material red { ColorRGB=1,0,0 }
Surface rubber { Friction=1 }
RobotConfig Rover {
  Param wheelRadius = 0.05
  Body chassis { Box hull { Size=1,1,1 Mass=1 } Sphere slider { Radius=0.1 } }
  Body leftWheel { Cylinder tyre { Radius=$wheelRadius Length=0.03 Mass=1 } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
  Slider lift { Parent=chassis Child=leftWheel }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
  Encoder leftEncoder { Joint=leftAxle }
}
StaticConfig Arena { Plane ground { } }
)";

struct Listed {
    QStringList labels;
    QString text, word;
    Completions found;
};

class Texts {
public:
    /// Completes in this text as the opened file; `|` is the caret.
    Listed at(QString text) {
        const QString path = m_folder.filePath(QStringLiteral("main.sim"));
        const qsizetype bar = text.indexOf(QLatin1Char('|'));
        const auto offset = static_cast<std::uint32_t>(text.left(bar).toUtf8().size());
        text.remove(bar, 1);
        put("parts.sim", kParts);
        put("walls/maze.sim", "StaticConfig Maze { }\n");
        put("floor.png", "x");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write");
        file.write(text.toUtf8());
        file.close();
        const auto loaded = m_application->open(path.toStdString(), {});
        if (!loaded) qFatal("%s", loaded.error().message.c_str());
        Listed listed;
        listed.text = text;
        listed.found = completionsAt(*loaded.value(), 0, offset, {{}, {}, {TRUNDLE_BINARY_DIR "/lib/trundle"}});
        const TextRange word = listed.found.word;
        listed.word = QString::fromUtf8(text.toUtf8().mid(word.begin, offset - word.begin));
        for (const Completion* c : fitting(listed.found.items, listed.word.toStdString()))
            listed.labels << QString::fromStdString(c->label);
        return listed;
    }
    /// The text after `label` was chosen, with the caret as `|`, or the selected text in `[ ]`.
    QString after(const QString& text, const char* label) {
        const Listed listed = at(text);
        for (const Completion& c : listed.found.items) {
            if (c.label != label) continue;
            QByteArray insert = QByteArray::fromStdString(c.insert);
            if (c.select < c.caret)
                insert.insert(static_cast<qsizetype>(c.caret), ']').insert(static_cast<qsizetype>(c.select), '[');
            else insert.insert(static_cast<qsizetype>(c.caret), '|');
            QByteArray bytes = listed.text.toUtf8();
            bytes.replace(listed.found.word.begin, listed.found.word.size(), insert);
            return QString::fromUtf8(bytes);
        }
        return QStringLiteral("not listed");
    }

private:
    void put(const char* name, const char* text) {
        const QString path = m_folder.filePath(QLatin1String(name));
        QDir().mkpath(QFileInfo(path).path());
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)) qFatal("cannot write");
        file.write(text);
    }
    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication();
};

} // namespace

class CompletionTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void lists_data();
    void lists();
    void inserts_data();
    void inserts();
    void bestFirst();
    void offersOwnUnitFirst();
    void everyPlaceOfABrokenTextIsSafe();
    void ofVeryManyPartsTheTypedOneIsListed();

private:
    Texts m_texts;
};

void CompletionTest::lists_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("has");
    QTest::addColumn<QStringList>("hasNot");
    const auto row = [](const char* name, const char* text, const char* has, const char* hasNot) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromLatin1(has).split(QLatin1Char(' '), Qt::SkipEmptyParts)
                            << QString::fromLatin1(hasNot).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    };
    row("empty file", "|", "Tick Duration Robot Material Param Hinge #import #loadModule", "Box Body Radius");
    row("settings that are there are left out", "Tick = 0.01\n|", "Duration Seed", "Tick");
    row("typed letters", "Rob|", "Robot RobotConfig", "Static Tick");
    row("kinds of a config", "RobotConfig A {\n  |\n}", "Body Hinge RotaryMotor Encoder SelfCollision Param",
        "Box Robot Material Tick");
    row("geoms of a body", "RobotConfig A { Body b {\n |\n} }", "Box Sphere Mesh Pos Mass", "Plane Body Hinge");
    row("planes and what moves in scenery", "StaticConfig A { | }", "Plane Heightfield Box Body Hinge Belt", "Robot Material");
    row("keys not yet there", "StaticConfig A { Box w { Size=1,1,1 | } }", "Pos Material Mass", "Size");
    row("key at the caret stays", "StaticConfig A { Box w { Si|ze=1,1,1 } }", "Size", "");
    row("of alternatives one", "RobotConfig A { RotaryMotor m { SpeedConstant=5 | } }", "Resistance",
        "SpeedConstant BackEmfConstant");
    row("materials", "#import parts.sim\nStaticConfig A { Box w { Material=| } }", "steel red default", "rubber Rover");
    row("surfaces", "#import parts.sim\nStaticConfig A { Box w { Surface=r| } }", "rubber", "steel red");
    row("configs of robots", "#import parts.sim\nRobot r { Config=| }", "Rover", "Arena steel");
    row("configs of statics", "#import parts.sim\nStatic s { Config=| }", "Arena", "Rover");
    row("choices", "Solver = |", "auto exact quick", "Tick");
    row("flags", "RobotConfig A { SelfCollision=| }", "true false", "");
    row("bodies of a joint", "RobotConfig A { Body a { } Body b { }\n Hinge h { Parent=| } }", "a b world", "h");
    row("joints of a motor",
        "RobotConfig A { Body a { } Hinge h { Parent=a } Slider s { Parent=a }\n RotaryMotor m { Joint=| } }", "h", "s a");
    row("geoms of a sensor", "RobotConfig A { Body a { Box bumper { Size=1,1,1 } }\n TouchSensor t { Geom=| } }", "a.bumper",
        "a");
    row("geoms behind a dot", "RobotConfig A { Body a { Box bumper { Size=1,1,1 } }\n TouchSensor t { Geom=a.| } }", "bumper",
        "a");
    row("units touching a number", "StaticConfig A { Sphere s { Radius=3|", "cm mm m km", "deg kg Length Pos");
    row("units begun", "StaticConfig A { Sphere s { Radius=3c|", "cm", "kg deg");
    row("unit or key behind a blank", "StaticConfig A { Sphere s { Radius=3 |", "cm Pos", "deg");
    row("angles", "StaticConfig A { Box s { HPR=0,0,90 d|", "deg", "cm");
    row("no units without a dimension", "Seed = 4|", "", "cm deg Tick");
    row("Params", "#import parts.sim\nParam speed = 2\nTick = $|", "$speed", "$wheelRadius");
    row("a Param in its own value", "Param a = 2\nParam b = $|", "$a", "$b");
    row("Params of the config", "RobotConfig A { Param r = 1\n Body b { Sphere s { Radius=$| } } }", "$r", "");
    row("what describes a Param", "Param a = 2 { Min=1 | }", "Max Choices Help", "Min Box Tick");
    row("choices of a Param", "RobotConfig A { Param look = red { Choices=red,blue } Body b { } }\nRobot r { Config=A look=| }",
        "red blue", "");
    row("what a variant sets", "#import parts.sim\nRobotConfig Big { Config=Rover | }",
        "leftMotor wheelRadius SelfCollision Body", "Config");
    row("behind the dot in a variant", "#import parts.sim\nRobotConfig Big { Config=Rover leftMotor.| }", "Resistance", "Pos");
    row("configs of variants", "#import parts.sim\nRobotConfig Big { Config=| }", "Rover", "Arena");
    row("names from what it is a variant of",
        "RobotConfig A { Body a { } }\nRobotConfig B { Config=A Body b { } Hinge h { Parent=| } }", "a b world", "");
    row("in a Repeat of a robot", "RobotConfig A { Repeat r { Count=3 | } }", "Body Hinge Encoder Part Repeat Ring Pos",
        "Box Count Robot");
    row("in a Repeat of scenery", "StaticConfig A { Repeat r { Count=3 | } }", "Box Plane Part Repeat Body Hinge",
        "Robot Material");
    row("the number of a member", "RobotConfig A { Repeat r { Count=3 Pos=$(|) } }", "index index2 sin", "");
    row("no number outside", "RobotConfig A { Repeat r { Count=3 } Body b { Pos=$(|) } }", "sin", "index");
    row("members of a Grid have numbers", "#import parts.sim\nGrid g { Config=Rover Count=2 Spacing=1 wheelRadius=$(|) }",
        "index", "");
    row("bodies in a Repeat, from inside", "RobotConfig A { Body a { } Repeat r { Count=2 Body b { }\n Hinge h { Parent=| } } }",
        "a b world", "r_0.b");
    row("bodies in a Repeat, from outside", "RobotConfig A { Body a { } Repeat r { Count=2 Body b { } }\n Hinge h { Parent=| } }",
        "a r_0.b", "b");
    const std::string corner = "PartConfig Wheel { Body wheel { Sphere tyre { Radius=0.1 Mass=1 } } Hinge axle { Parent=$carrier "
                               "Child=wheel Axis=0,1,0 } RotaryMotor motor { Joint=axle TorqueConstant=0.02 SpeedConstant=50 "
                               "Resistance=2 MaxVoltage=12 } }\n"
                               "PartConfig Side { Body rail { Mass=1 Inertia=1,1,1 } Part front { Config=Wheel carrier=rail }\n"
                               "Repeat lamp { Count=2 Body bulb { Mass=1 } } ";
    const auto inSide = [&](const char* name, const char* text, const char* has, const char* hasNot) {
        row(name, (corner + text).c_str(), has, hasNot);
    };
    inSide("what is in a Part", "Hinge h { Parent=| } }", "rail lamp_0.bulb world front.wheel", "wheel front front.axle h");
    inSide("begun in a Part", "Hinge h { Parent=front.| } }", "wheel", "rail front.wheel axle");
    inSide("a geom in a Part", "TouchSensor t { Geom=front.| } }", "wheel.tyre", "wheel");
    inSide("of a member that is typed", "Hinge h { Parent=lamp_1.| } }", "bulb", "rail");
    inSide("what a Part counts from", "Part rear { Config=Wheel In=| } }", "rail front.wheel", "wheel rear.wheel");
    inSide("what a value set in a Part names", "Part rear { Config=Wheel axle.Parent=| } }", "rail front.wheel wheel", "axle");
    inSide("what a Param names", "Part rear { Config=Wheel carrier=| } }", "rail lamp_0.bulb world front.wheel",
           "wheel rear.wheel front front.axle tyre");
    inSide("what a Param names, behind a dot", "Part rear { Config=Wheel carrier=front.| } }", "wheel", "axle rail");
    inSide("what a Param names that is passed on",
           "Part inner { Config=Wheel carrier=$hull } } RobotConfig R { Body base { Mass=1 Inertia=1,1,1 } Part left { "
           "Config=Side hull=| } }",
           "base world", "rail left.rail bulb");
    inSide("choices of a Param that names",
           "Param coat = red { Choices=red,blue } Body lid { Sphere s { Radius=0.1 Mass=1 Material=$coat } } } Material red { } "
           "Material blue { } "
           "Material green { }\nRobotConfig R { Part left { Config=Side coat=| } }",
           "red blue", "green default");
    inSide("a Material that a Param names",
           "Body lid { Sphere s { Radius=0.1 Mass=1 Material=$paint } } } Material red { } Surface ice { }\n"
           "RobotConfig R { Part left { Config=Side paint=| } }",
           "red default", "ice rail left");
    row("a Material that a Param of a robot names",
        "Material red { }\nRobotConfig R { Param paint = red  Body b { Sphere s { Radius=0.1 Mass=1 Material=$paint } } }\n"
        "Robot r { Config=R paint=| }",
        "red default", "b");
    inSide("motors of Parts", "} RobotConfig R { Part left { Config=Side }\n SkidDrive d { LeftMotors=left.front.motor,| } }",
           "left.front.motor", "left.front.axle d");
    inSide("motors behind a dot", "} RobotConfig R { Part left { Config=Side }\n SkidDrive d { LeftMotors=left.| } }",
           "front.motor", "front.axle");
    inSide("Parts of Parts behind a dot",
           "} RobotConfig R { Part left { Config=Side }\n SkidDrive d { LeftMotors=left.front.| } }", "motor", "axle");
    inSide("Parts of a variant", "} RobotConfig R { Part left { Config=Side } }\nRobotConfig V { Config=R Hinge h { Parent=| } }",
           "left.rail left.front.wheel", "rail");
    inSide("signals in Parts",
           "} RobotConfig R { Part left { Config=Side } }\nRobot rover { Config=R }\nSignalLog l { "
           "Signals=\"rover/left.front.mo|\" }",
           "rover/left.front.motor/current", "rover/left.front/current");
    inSide(
        "signals in Parts of a robot that is typed",
        "} RobotConfig R { Part left { Config=Side } }\nRobot rover { Config=R }\nSignalLog l { Signals=rover/left.front.mo| }",
        "motor/current", "");
    inSide("of a joint between robots",
           "} RobotConfig R { Part left { Config=Side } }\nRobot rover { Config=R }\nHinge h { Parent=rover.left.| }",
           "rail front.wheel lamp_0.bulb", "wheel");
    row("in an expression", "Param a = 2\nTick = $(a*|)", "a sqrt sin pi", "$a Tick");
    row("a Param among values", "Param a = 2\nDuration = |", "$a", "");
    row("files to import", "#import |", "parts.sim walls/maze.sim", "main.sim floor.png");
    row("imported files are left out", "#import parts.sim\n#import |", "walls/maze.sim", "parts.sim");
    row("modules", "#loadModule |", "controllers/linear_motion", "");
    row("textures", "Material m { Texture=| }", "floor.png", "parts.sim");
    row("overrides", "#import parts.sim\nRobot r { Config=Rover | }", "leftMotor wheelRadius Pos", "Config hull");
    row("behind the dot of an override", "#import parts.sim\nRobot r { Config=Rover leftMotor.| }", "Resistance GearRatio",
        "Pos leftMotor");
    row("an override behind a number", "#import parts.sim\nRobot r { Config=Rover Pos=1,1,0 leftMotor.| }",
        "Resistance GearRatio", "Pos cm");
    row("an override begun behind a number", "#import parts.sim\nRobot r { Config=Rover Pos=1,1,0 leftMotor.Res| }", "Resistance",
        "Pos cm");
    row("value of an override", "#import parts.sim\nRobot r { Config=Rover chassis.hull.Material=| }", "steel red", "rubber");
    row("controllers of loaded modules", "#import parts.sim\n#loadModule controllers/linear_motion\nRobot r { Config=Rover | }",
        "LinearMotion", "BumpAndTurn");
    row("a second controller",
        "#import parts.sim\n#loadModule controllers/linear_motion\nRobot r { Config=Rover LinearMotion a { }\n | }",
        "Pos LinearMotion", "");
    row("robots of a log", "#import parts.sim\nRobot rob { Config=Rover }\nStatic st { Config=Arena }\nPoseLog l { Robot=| }",
        "rob", "Rover steel");
    row("signals of a log", "#import parts.sim\nRobot rob { Config=Rover }\nSignalLog l { Signals=r| }", "rob/leftEncoder/count",
        "");
    row("signals of a controller",
        "#import parts.sim\n#loadModule controllers/mote\nRobot rob { Config=Rover Mote mind { } }\nSignalLog l { Signals=r| }",
        "rob/leftEncoder/count rob/mind/hops rob/mind/cost", "");
    row("nothing in a comment", "// Ti|", "", "Tick");
    row("nothing in a block comment", "/* Ti|", "", "Tick");
    row("nothing right behind a block comment", "/* note */|", "", "Tick Duration");
    row("nothing in a text", "Title = \"Ti|\"", "", "Tick");
    row("nothing for a name", "RobotConfig A { Body | }", "", "Box Pos");
    row("behind a value begins the next", "Solver = exact Du|", "Duration", "Seed");
    row("an unclosed block", "RobotConfig A {\n  Body b {\n    Box h { Size=1,1,1 }\n    |", "Box Mass", "Tick Hinge");
    row("an unclosed block before", "StaticConfig A {\n  Box h { Size=1,1,1\n}\nRobot r { | }", "Config Pos", "Size Tick");
    row("after a stray brace", "}\nStaticConfig A { | }", "Plane", "Tick");
    row("unknown kind", "Blub b { | }", "", "Tick Size");
    row("CR LF", "RobotConfig A {\r\n  |\r\n}\r\n", "Body", "Box");
}

void CompletionTest::lists() {
    QFETCH(QString, text);
    QFETCH(QStringList, has);
    QFETCH(QStringList, hasNot);
    const Listed listed = m_texts.at(text);
    for (const QString& label : has)
        QVERIFY2(listed.labels.contains(label),
                 qPrintable(label + QStringLiteral(" is missing in ") + listed.labels.join(QLatin1Char(' '))));
    for (const QString& label : hasNot)
        QVERIFY2(!listed.labels.contains(label),
                 qPrintable(label + QStringLiteral(" is in ") + listed.labels.join(QLatin1Char(' '))));
}

void CompletionTest::inserts_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("label");
    QTest::addColumn<QString>("after");
    const auto row = [](const char* name, const char* text, const char* label, const char* after) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromLatin1(label) << QString::fromUtf8(after);
    };
    row("key as the file does it", "Tick = 0.01\nDur|", "Duration", "Tick = 0.01\nDuration = |");
    row("key as the block does it", "StaticConfig A { Box b { Size=1,1,1 Pos=0,0,0 Ma| } }", "Mass",
        "StaticConfig A { Box b { Size=1,1,1 Pos=0,0,0 Mass=| } }");
    row("the equals sign is there", "Du| = 4", "Duration", "Duration| = 4");
    row("rest of the word goes", "Du|ra = 4", "Duration", "Duration| = 4");
    row("a block on a line", "Tick=1\nMat|", "Material", "Tick=1\nMaterial [material] { }");
    row("a geom needs no name", "StaticConfig A {\n  Sph|\n}", "Sphere", "StaticConfig A {\n  Sphere { Radius = | }\n}");
    row("a large block", "Tick=1\nRob|", "Robot", "Tick=1\nRobot [robot] {\n  Config=\n}");
    row("indent of a large block", "RobotConfig A {\n  Bo|\n}", "Body", "RobotConfig A {\n  Body [body] {\n    \n  }\n}");
    row("a free name", "Material material { }\nMat|", "Material", "Material material { }\nMaterial [material2] { }");
    row("kind before its brace", "Mat| red { }", "Material", "Material| red { }");
    row("geom by its whole name", "RobotConfig A { Body a { Box b { Size=1,1,1 } }\n TouchSensor t { Geom=| } }", "a.b",
        "RobotConfig A { Body a { Box b { Size=1,1,1 } }\n TouchSensor t { Geom=a.b| } }");
    row("import", "#import wal|", "walls/maze.sim", "#import walls/maze.sim|");
    row("directive", "#im|", "#import", "#import |");
    row("CR LF is kept", "Tick=1\r\nRob|\r\n", "Robot", "Tick=1\r\nRobot [robot] {\r\n  Config=\r\n}\r\n");
}

void CompletionTest::inserts() {
    QFETCH(QString, text);
    QFETCH(QString, label);
    QFETCH(QString, after);
    QCOMPARE(m_texts.after(text, label.toLatin1().constData()), after);
}

void CompletionTest::bestFirst() {
    const auto make = [](const char* label) { return Completion{CompletionSort::Key, label, label, 0, 0, {}, {}, false}; };
    const std::vector<Completion> items{make("SpeedConstant"), make("MaxVoltage"), make("maximum"), make("RollingFriction"),
                                        make("Friction")};
    const auto labels = [&](const char* typed) {
        QStringList list;
        for (const Completion* c : fitting(items, typed)) list << QString::fromStdString(c->label);
        return list.join(QLatin1Char(' '));
    };
    QCOMPARE(labels("Max"), QStringLiteral("MaxVoltage maximum"));
    QCOMPARE(labels("max"), QStringLiteral("maximum MaxVoltage"));
    QCOMPARE(labels("fric"), QStringLiteral("Friction RollingFriction"));
    QCOMPARE(labels("MV"), QStringLiteral("MaxVoltage"));
    QCOMPARE(labels("xyz"), QString());
}

void CompletionTest::offersOwnUnitFirst() {
    QCOMPARE(m_texts.at(QStringLiteral("StaticConfig A { Box s { HPR=0,0,0.5|")).labels.first(), QStringLiteral("deg"));
    QCOMPARE(m_texts.at(QStringLiteral("StaticConfig A { Sphere s { Radius=3|")).labels.first(), QStringLiteral("m"));
}

void CompletionTest::everyPlaceOfABrokenTextIsSafe() {
    const QString text =
        QStringLiteral("#import \n#loadModule x\nParam a = $(\nRobot r { Config=  leftMotor. \"x\n  Pos=1,,2 $ # } }\n/* ");
    for (qsizetype i = 0; i <= text.size(); ++i) (void)m_texts.at(QString(text).insert(i, QLatin1Char('|')));
}

void CompletionTest::ofVeryManyPartsTheTypedOneIsListed() {
    QString text = QStringLiteral("PartConfig Wheel { Body wheel { Mass=1 } }\nPartConfig Many {\n");
    for (int i = 0; i < 1000; ++i) text += QStringLiteral("Part w%1 { Config=Wheel }\n").arg(i);
    text += QStringLiteral("}\nRobotConfig R {\n");
    for (int i = 0; i < 1000; ++i) text += QStringLiteral("Part m%1 { Config=Many }\n").arg(i);
    const QString log = QStringLiteral(" }\nRobot rover { Config=R }\nSignalLog l { Signals=");
    const Listed all = m_texts.at(text + QStringLiteral("Body own { } Hinge h { Parent=| }") + log);
    QVERIFY(all.labels.contains(QStringLiteral("own")) && all.labels.contains(QStringLiteral("m0.w0.wheel")));
    QVERIFY2(all.labels.size() < 5000, qPrintable(QString::number(all.labels.size()))); // of a million
    const Listed typed = m_texts.at(text + QStringLiteral("Hinge h { Parent=m999.w999.| }") + log);
    QCOMPARE(typed.labels, QStringList{QStringLiteral("wheel")});
    text.replace(QStringLiteral("Body wheel { Mass=1 }"), QStringLiteral("Body wheel { Mass=1 } Imu imu { Body=wheel }"));
    const Listed quoted = m_texts.at(text + log + QStringLiteral("\"rover/m999.w999.|\""));
    QVERIFY(
        std::ranges::any_of(quoted.labels, [](const QString& l) { return l.startsWith(QLatin1String("rover/m999.w999.imu/")); }));
}

QTEST_GUILESS_MAIN(CompletionTest)
#include "completion_test.moc"
