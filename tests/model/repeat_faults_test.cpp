// Mistakes with Repeats, Parts and variants: each is reported once, at its place, and nothing is silently ignored.
#include <QTest>

#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n";
const std::string kBox = "Box h { Size=0.1,0.1,0.1 Mass=1 Material=g Surface=s }";

/// The messages without notes, one a line, each with the first suggestion and the text that it is about.
QString found(const Resolved& r) {
    QString all;
    for (const Diagnostic& d : r.diagnostics.all())
        all += QString::fromStdString(codeName(d.code) + " " + d.message + (d.suggestions.empty() ? "" : " (" + d.suggestions[0] + "?)") +
                                      " | " + r.slice(d.range)) + u'\n';
    return all;
}

} // namespace

class RepeatFaultsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void faults_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("sets");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message, const QStringList& sets = {}) {
            QTest::newRow(name) << QString::fromStdString(text) << sets << message;
        };
        const std::string lane = kHead + "RobotConfig Ball { Param r = 1 Body b { Sphere s { Radius=$r Mass=1 Material=g Surface=s } } }\n"
                                         "Repeat lane { Count=2 Pos=0,$(3*index),0 Robot c { Config=Ball } }\n";
        row("a block has no value", lane, "E314 Robot c takes no value itself; set one of its properties, c. ... | c\n", {"lane.c=3"});
        row("one member", lane,
            "E323 lane_1 is one member of Repeat lane and they have one text; set lane for all of them | lane_1\n",
            {"lane_1.c.Pos=1,1,1"});
        row("no member", lane,
            "E323 lane_7 is one member of Repeat lane and they have one text; set lane for all of them | lane_7\n",
            {"lane_7.Pos=1,1,1"});
        const std::string kit = kHead + "RobotConfig Kit { Body b { Repeat o { Count=3 " + kBox + " } } }\nRobot r { Config=Kit }\n";
        row("one member of a config", kit,
            "E323 o_1 is one member of Repeat o and they have one text; set o for all of them, or set it in a robot for one | "
            "o_1\n",
            {"RobotConfig.Kit.b.o_1.h.Mass=3"});
        row("all members", kit, "", {"RobotConfig.Kit.b.o.h.Mass=3"});
        row("one member of a robot", kit, "", {"r.b.o_1.h.Mass=3"});
        row("a block of a robot has no value", kit + "Robot x { Config=Kit b.o=3 Pos=9,0,0 }\n",
            "E314 Repeat o takes no value itself; set one of its properties, o. ... | o\n");
        row("a Param of the config", lane + "Robot x { Config=Ball Param r = 2 Pos=9,0,0 }\n",
            "E303 RobotConfig Ball has a Param r already; set its value: r=... | r\n");
        row("a Param of its own", lane + "Robot x { Config=Ball Param r = 2 r=$(2*r) Pos=9,0,0 }\n", "");
        // What names something in the members of a Repeat with an error is no further mistake.
        const std::string pair =
            kHead + "RobotConfig K { SelfCollision=true NoContact=m_0.b,m_1.b Body a { " + kBox +
            " } Repeat m { Count=2 Pos=$(gap*index),0,0\n"
            "Body b { " +
            kBox + " } Repeat n { Count=2 Body d { " + kBox +
            " } } }\n"
            "Fixed f { Parent=a Child=m_0.b } Fixed g { Parent=m_0.n_1.d Child=m_1.b } }\nRobot r { Config=K }\n";
        const auto with = [&](const char* from, const char* to) {
            return QString::fromStdString(pair).replace(QLatin1String(from), QLatin1String(to)).toStdString();
        };
        row("in the place of the members", pair, "E211 there is no Param gap; there is index | gap\n");
        row("in the place of the second member", with("$(gap*index)", "$(sqrt(-index))"),
            "E213 the square root of -1 is not a number | $(sqrt(-index))\n");
        row("in their number", with("Count=2 Pos=$(gap*index)", "Count=$gap Pos=$(1*index)"),
            "E211 there is no Param gap | gap\n");
        row("in the Repeat in them",
            QString::fromStdString(with("$(gap*index)", "$(1*index)"))
                .replace(u"n { Count=2"_qs, u"n { Count=2 Pos=$gap,0,0"_qs)
                .toStdString(),
            "E211 there is no Param gap; there is index | gap\n");
        row("a member that it does not have",
            with("$(gap*index)", "$(1*index)") + "Robot q { Config=K m_2.b.Mass=3 Pos=9,9,9 }\n",
            "E314 Repeat m has no member m_2; the last one is m_1 (m_1?) | m_2\n");
        row("robots of it",
            kHead + "RobotConfig K { Body b { " + kBox +
                " } }\nRepeat c { Count=2 Pos=$(gap*index),0,0 Robot k { Config=K } }\n"
                "Ball h { Parent=c_0.k.b Child=c_1.k.b }\nRegion g { Size=1,1,1 Robots=c_1.k }\nNoContact=c_0.k,c_1.k\n",
            "E211 there is no Param gap; there is index | gap\n");
        row("a Param of the part",
            kHead + "PartConfig Leg { Param k = 1 Body b { Mass=$k " + std::string("Sphere s { Radius=1 Material=g Surface=s }") +
                " } Fixed f { Parent=$body Child=b } }\nRobotConfig K { Body a { " + kBox + " } Part l { Config=Leg body=a Param k = 2 } }\n",
            "E303 PartConfig Leg has a Param k already; set its value: k=... | k\n");
        row("a Param called index", kHead + "RobotConfig K { Body a { " + kBox + " } Repeat q { Param index = 3 Count=2 Body d { " + kBox +
                                        " } Fixed f { Parent=a Child=d } } }\n",
            "E303 index is the number of the member in $( ); give the Param another name | index\n");
        row("a default for what it is joined to, handed on",
            kHead + "PartConfig W { Param carrier = a Body w { Mass=1 Sphere s { Radius=1 Material=g Surface=s } } Fixed f { Parent=$carrier Child=w } }\n"
                    "PartConfig M { Part q { Config=W carrier=$carrier } }\nRobotConfig K { Body a { " +
                kBox + " } Part l { Config=M carrier=a } }\n",
            "");
        row("loose bodies", kHead + "StaticConfig K { Repeat p { Count=50 Pos=$index,0,0 Body b { " + kBox + " } } }\nStatic x { Config=K }\n",
            "E302 no joint holds Body p_0.b to the world: a StaticConfig holds its geoms directly, without a Body, and bodies that move on "
            "joints; what is loose is a Robot | b\n");
        row("double joints",
            kHead + "RobotConfig K { Body z { " + kBox + " } Repeat p { Count=50 Pos=$(index+1),0,0 Body b { " + kBox +
                " } Fixed h { Parent=z Child=b } Fixed k { Parent=z Child=b } } }\n",
            "E334 two joints join the same bodies, p_0.h and p_0.k: they act against each other; keep one of them | k\n");
        row("one fault of a robot",
            kHead + "RobotConfig Ball { Body b { " + kBox + " } }\nRepeat l { Count=3 Pos=$index,0,0 Robot a { Config=Ball foo=3 }\n"
                    "Fixed j { Parent=world Child=a.b } Region z { Size=1,1,1 Robots=a } PoseLog p { Robot=a } }\n",
            "E201 Robot a has no property foo; it has Config, Pos, HPR, SelfCollision and NoContact | foo\n");
        row("a geom of no member",
            kHead + "RobotConfig K { Body f { Repeat d { Count=2 " + kBox + " } } TouchSensor t { Geom=f.d_2.h } }\n",
            "E208 Geom names f.d_2.h, but there is no such geom (body.geom) (f.d_0.h?) | f.d_2.h\n");
        row("a geom of all members",
            kHead + "RobotConfig K { Body f { Repeat d { Count=2 " + kBox + " } } TouchSensor t { Geom=f.d.h } }\nRobot a { Config=K } Robot b { Config=K "
                                                                          "Pos=9,0,0 }\n",
            "E208 Geom names f.d.h, but there is no such geom (body.geom) (f.d_0.h?) | f.d.h\n");
        row("bodies that do not touch",
            kHead + "RobotConfig K { SelfCollision=true NoContact=q_7,f, f,q.d.h\n Body f { " + kBox +
                " } Repeat q { Count=2 Pos=$(1+index),0,0 Body d { " + kBox + " } Fixed j { Parent=f Child=d } } }\n",
            "E208 NoContact names q_7, but there is no such Body; there are f, q, q_0.d and q_1.d | q_7\n"
            "E208 NoContact names q.d.h, but there is no such Body; there are f, q, q_0.d and q_1.d | q.d.h\n");
    }
    void faults() {
        QFETCH(QString, text);
        QFETCH(QStringList, sets);
        QFETCH(QString, message);
        std::vector<std::string> all;
        for (const QString& set : sets) all.push_back(set.toStdString());
        QCOMPARE(found(resolved(text.toStdString(), all)), message);
    }

    /// Of a Repeat, a member or a Part all bodies in it.
    void noContactNamesWhatHoldsBodies() {
        const auto pairs = [](const char* names) {
            return resolved(kHead + "RobotConfig K { SelfCollision=true NoContact=" + names + "\n Body f { " + kBox +
                            " } Repeat q { Count=3 Pos=$(1+index),0,0 Body d { " + kBox + " } Fixed j { Parent=f Child=d } } }\nRobot r { Config=K }\n")
                .config()
                .noContact;
        };
        using Pairs = std::vector<std::pair<int, int>>;
        QCOMPARE(pairs("q,q"), (Pairs{{1, 2}, {1, 3}, {2, 3}}));
        QCOMPARE(pairs("q.d,f"), (Pairs{{0, 1}, {0, 2}, {0, 3}}));
        QCOMPARE(pairs("q_2,q_0.d, f,q_1"), (Pairs{{0, 2}, {1, 3}}));
    }

    /// link_1 is a body of its own, and no member of a link that is a body or a Part.
    void noContactKeepsNamesThatAreAlikeApart() {
        const std::string part = "PartConfig Leg { Body foot { " + kBox + " } }\n";
        const auto config = [&](const char* names, const std::string& inside) {
            return resolved(kHead + part + "RobotConfig K { SelfCollision=true NoContact=" + names + "\n Body base { " + kBox +
                            " }\n" + inside + " }\nRobot r { Config=K }\n");
        };
        using Pairs = std::vector<std::pair<int, int>>;
        const std::string bodies = "Body link { " + kBox + " } Body link_1 { " + kBox + " } Body far { " + kBox + " }";
        QCOMPARE(config("link,base", bodies).config().noContact, (Pairs{{0, 1}}));
        QCOMPARE(config("link_1,base", bodies).config().noContact, (Pairs{{0, 2}}));
        const std::string legs = "Part leg { Config=Leg } Part leg_1 { Config=Leg }";
        QCOMPARE(config("leg,base", legs).config().noContact, (Pairs{{0, 1}}));
        QCOMPARE(config("leg.foot,base", legs).config().noContact, (Pairs{{0, 1}}));
        const std::string repeat = "Repeat leg { Count=2 Body foot { " + kBox + " } }";
        QCOMPARE(config("leg.foot,base", repeat).config().noContact, (Pairs{{0, 1}, {0, 2}}));
    }

    /// Poses that count from each other: long chains in any order, and circles, end with a message.
    void chainsOfPosesAreBounded() {
        const auto bodies = [](int count, bool isBackwards, bool isCircle) {
            std::string text;
            for (int k = 0; k < count; ++k) {
                const int i = isBackwards ? count - 1 - k : k;
                const std::string in = i > 0 || isCircle ? " In=b" + std::to_string((i + count - 1) % count) : "";
                text += "Body b" + std::to_string(i) + " {" + in + " Pos=1,0,0 Mass=1 Sphere s { Radius=1 Material=g Surface=s } }\n";
            }
            return resolved(kHead + "RobotConfig K {\n" + text + "}\nRobot r { Config=K }\n");
        };
        const Resolved good = bodies(900, true, false);
        QCOMPARE(found(good), QString());
        QCOMPARE(good.config().bodies[0].pose.position.x(), 900.0);
        QVERIFY(found(bodies(20000, true, false)).startsWith("E312 poses count from each other more than 1000 deep"));
        const QString circle = found(bodies(600, false, true));
        QVERIFY2(circle.startsWith("E302 poses count from each other in a circle: b") && circle.indexOf(u'\n') < 500, qPrintable(circle));
    }
};

QTEST_APPLESS_MAIN(RepeatFaultsTest)
#include "repeat_faults_test.moc"
