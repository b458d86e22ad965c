// Names: of Params that Parts give, of members, of blocks of variants, and what other simulators call a kind or a property.
#include <QTest>

#include "reported.h"

using sample::reported;

namespace {

const std::string kHead = "Material g { } Surface s { }\n";
const std::string kBox = "Box h { Size=0.1,0.1,0.1 Mass=1 Material=g Surface=s }";

/// A PartConfig that `joined` joins to what is outside of it, and Parts of it.
std::string parts(const std::string& params, const std::string& joined, const std::string& uses) {
    return kHead + "PartConfig P { " + params + " Body b { " + kBox + " } " + joined + " }\nRobotConfig R { Body c { " + kBox +
           " } " + uses + " }\nRobot r { Config=R }\n";
}

} // namespace

class MeantNamesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void messages_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(text) << message;
        };
        const std::string fixed = "Fixed f { Parent=$mast Child=b }";
        row("a name like a Param that is declared", parts("Param mass = 0.3", fixed, "Part a { Config=P mast=c }"), "");
        row("one given by a path", parts("Param mass = 0.3", fixed, "Part a { Config=P } ") + "Robot q { Config=R a.mast=c }\n",
            "E209 Part a needs mast: what PartConfig P is joined to | a | it is used here: mast | fix mast=c");
        row("one that nothing gives", parts("Param mast2 = 0.3", fixed, "Part a { Config=P }"),
            "E211 there is no Param mast | mast | used here by Part a: a | fix mast2");
        row("one that all Parts spell otherwise",
            parts({}, "Fixed f { Parent=$carier Child=b }", "Part a { Config=P carrier=c } Part d { Config=P carrier=c }"),
            "E211 there is no Param carier | carier | used here by Part a: a | fix carrier");
        row("one that one of the Parts misspells",
            parts({}, "Fixed f { Parent=$carrier Child=b }", "Part a { Config=P carier=c } Part d { Config=P carrier=c }"),
            "E201 Part a has no property carier | carier | fix carrier");
        row("without its sign", parts({}, "Fixed f { Parent=to Child=b }", "Part a { Config=P to=c }"),
            "E208 Parent names to, but there is no such Body; there is world; what is outside of a PartConfig comes in by a "
            "Param, Parent=$to | to | used here by Part a: a | fix $to");
        row("in parentheses",
            parts("Param look = g",
                  "Body d { Box o { Size=1,1,1 Mass=1 Material=$(look) Surface=s } }"
                  " Fixed f { Parent=$to Child=b } Fixed e { Parent=b Child=d }",
                  "Part a { Config=P to=c }"),
            "");

        const std::string base = kHead + "RobotConfig A { Param p = 2  Body q { " + kBox + " } }\n";
        row("a Param of a variant that a block has", base + "RobotConfig B { Config=A Param q = 3 }\nRobot r { Config=B }\n",
            "E303 RobotConfig A has Body q already | q | first defined here: q");
        row("a block of a variant that a Param has",
            base + "RobotConfig B { Config=A Body p { " + kBox + " } }\nRobot r { Config=B }\n",
            "E303 RobotConfig A has a Param p already | p | first defined here: p");

        const std::string members = kHead + "RobotConfig R { Body c { " + kBox +
                                    " } Repeat m { Count=3 Pos=0,0,$index Body q { " + kBox +
                                    " } Fixed f { Parent=c Child=q } } ";
        row("a member that is not there", members + "Fixed e { Parent=c Child=m_3.q } }\nRobot r { Config=R }\n",
            "E208 Child names m_3.q, but Repeat m has no member m_3; the last one is m_2 | m_3.q | fix m_2.q");
        row("a misspelt name in a member", members + "TouchSensor t { Geom=m_1.q.hh } }\nRobot r { Config=R }\n",
            "E208 Geom names m_1.q.hh, but there is no such geom (body.geom) | m_1.q.hh | fix m_1.q.h");
        row("a member without its sign", members + "}\nRobot r { Config=R m1.q.h.Mass=2 }\n",
            "E314 RobotConfig R has no m1; it has c and m | m1 | fix m_1");
        row("a value for a block", members + "}\nRobot r { Config=R m=2 }\n",
            "E314 Repeat m takes no value itself; set one of its properties, m. ... | m");
        row("a controller with a capital letter", members + "}\nRobot r { Config=R Brain.Speed=1 Walker brain { } }\n",
            "E314 Robot r has no Brain; it has brain, c and m | Brain | fix brain");
        row("a value for a controller", members + "}\nRobot r { Config=R brain=1 Walker brain { } }\n",
            "E314 Walker brain takes no value itself; set one of its properties, brain. ... | brain");
        row("an element by its axis", members + "}\nRobot r { Config=R m.Pos.x=2 }\n",
            "E314 Pos of Repeat m has nothing in it; it is set as a whole, Pos=... | x");
        row("a body in itself", kHead + "RobotConfig R { Body c { " + kBox + " } Body d { In=dd " + kBox + " } }\n",
            "E208 In names dd, but there is no such Body; there is c | dd");
        row("a Repeat in a robot is no PartConfig",
            kHead + "RobotConfig R { Body c { " + kBox + " } Repeat m { Count=2 Body q { " + kBox +
                " } Fixed f { Parent=xyz Child=q } } }\n",
            "E208 Parent names xyz, but there is no such Body; there are c, m_0.q and world | xyz");

        const std::string two = kHead + "RobotConfig R { Body c { " + kBox + " } Body d { " + kBox + " } ";
        row("ends of a joint", two + "Hinge h { Body1=c Body2=d } }\n",
            "E201 Hinge h has no property Body1 | Body1 | fix Parent\nE201 Hinge h has no property Body2 | Body2 | fix Child");
        row("an angle of a joint", two + "Hinge h { Parent=c Child=d lower_limit=-3 } }\n",
            "E201 Hinge h has no property lower_limit | lower_limit | fix LowStop");
        row("a joint", two + "RevoluteJoint h { Parent=c Child=d } }\n",
            "E301 there is no kind RevoluteJoint | RevoluteJoint | fix Hinge");
        row("a link", kHead + "RobotConfig R { Link c { " + kBox + " } }\n", "E301 there is no kind Link | Link | fix Body");
        row("what is needed and has no name like it", two + "TouchSensor t { Contact=c } }\n",
            "E201 TouchSensor t has no property Contact; it needs Geom | Contact");
        row("numbers in quotes", kHead + "RobotConfig R { Body c { Pos=\"1 2 -3\" " + kBox + " } }\n",
            "E202 Pos is a text; numbers are written without quotes, with commas between | \"1 2 -3\" | fix 1,2,-3");
        row("a Param in quotes",
            kHead + "RobotConfig R { Param look = g  Body c { Box h { Size=1,1,1 Mass=1 Material=\"$look\" Surface=s } } }\n",
            "E208 Material names \"$look\", a text; a Param is written without quotes, $look | \"$look\" | fix $look");
    }
    void messages() {
        QFETCH(QString, text);
        QTEST(reported(sample::resolved(text.toStdString())), "message");
    }
};

QTEST_APPLESS_MAIN(MeantNamesTest)
#include "meant_names_test.moc"
