// A wrong value is reported where it is given, however many Params pass it on: at the instance, the variant, the path or the default.
#include <QTest>

#include "reported.h"

using sample::reported;

namespace {

/// A sphere that takes its radius by two Params, with what is said about the inner one.
std::string passedOn(const std::string& described, const std::string& given, const std::string& rest) {
    return "Material g { } Surface s { }\n"
           "PartConfig Tip { Param size = 2 cm " +
           described +
           " Body t { Sphere ball { Radius=$size Mass=1 Material=g Surface=s } } Fixed f { Parent=$to Child=t } }\n"
           "PartConfig Mid { Param ts = 2 cm  Part tip { Config=Tip to=$to size=$ts } }\n"
           "RobotConfig R { Param d = " +
           given + "  Body b { Box x { Size=0.2,0.2,0.1 Mass=3 Material=g Surface=s } }  Part l { Config=Mid to=b ts=$d } }\n" +
           rest;
}

/// Parts of W, which variants and Parts around them exchange for Other.
std::string exchanged(const std::string& rest) {
    const std::string box = "{ Box x { Size=0.2,0.2,0.1 Mass=3 Material=g Surface=s } }";
    const auto arm = [&](const std::string& name, const std::string& tip) {
        return "PartConfig " + name + " { Body elbow " + box + " Fixed f { Parent=$to Child=elbow } Part tip { Config=" + tip +
               " to=elbow } }\n";
    };
    return "Material g { } Surface s { }\n"
           "PartConfig W { Param r = 5 cm Body wheel { Sphere tyre { Radius=$r Mass=1 Material=g Surface=s } } "
           "Fixed f { Parent=$to Child=wheel } }\n"
           "PartConfig Other { Param q = 3 cm Body ball { Sphere skin { Radius=$q Mass=1 Material=g Surface=s } } "
           "Fixed f { Parent=$to Child=ball } }\n" +
           arm("Arm", "W") + arm("Hook", "Other") + "RobotConfig A { Body b " + box +
           " Part l { Config=W to=b } Repeat few { Count=2 Part l { Config=W to=b } } }\n"
           "RobotConfig D { Config=A l.Config=Other }\n"
           "RobotConfig K { Body b " +
           box + " Part m { Config=Arm to=b tip.r=0.2 } }\nRobotConfig N { Body b " + box +
           " Part m { Config=Arm to=b tip.Config=Other } }\n" + rest;
}

} // namespace

class ValuesPassedOnTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void place_data() {
        QTest::addColumn<QString>("given");
        QTest::addColumn<QString>("rest");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* given, const char* rest, const char* place) {
            QTest::newRow(name) << given << rest << place;
        };
        row("an instance", "2 cm", "Robot a { Config=R d=7 m }", "7 m");
        row("a variant", "2 cm", "RobotConfig V { Config=R d=7 m }\nRobot a { Config=V }", "7 m");
        row("a variant of a variant", "2 cm",
            "RobotConfig V { Config=R }\nRobotConfig W { Config=V d=7 m }\nRobot a { Config=W }", "7 m");
        row("an instance of a variant", "2 cm", "RobotConfig V { Config=R d=3 cm }\nRobot a { Config=V d=7 m }", "7 m");
        row("the default of what the part is in", "7 m", "Robot a { Config=R }", "7 m");
        row("a path", "2 cm", "Robot a { Config=R l.ts=7 m }", "7 m");
        row("a path to the end", "2 cm", "Robot a { Config=R l.tip.size=7 m }", "7 m");
        row("a path of a variant", "2 cm", "RobotConfig V { Config=R l.ts=7 m }\nRobot a { Config=V }", "7 m");
        row("an expression", "2 cm", "Robot a { Config=R d=$(3.5*2 m) }", "$(3.5*2 m)");
        row("a grid", "2 cm", "Grid a { Config=R Count=2 Spacing=9 d=7 m }", "7 m");
    }
    void place() {
        QFETCH(QString, given);
        QFETCH(QString, rest);
        QFETCH(QString, place);
        const std::string text = passedOn("{ Min=1 cm Max=4 cm }", given.toStdString(), rest.toStdString());
        const QStringList said = reported(sample::resolved(text)).split(u'\n');
        QCOMPARE(said.size(), 1);
        const QStringList parts = said[0].split(QStringLiteral(" | "));
        QCOMPARE(parts[0], QStringLiteral("E203 size is 7 m, it must be from 1 to 4 cm"));
        QCOMPARE(parts[1], place);
    }

    /// Also where the property that takes it has the limit.
    void placeOfAProperty_data() { place_data(); }
    void placeOfAProperty() {
        QFETCH(QString, given);
        QFETCH(QString, rest);
        QFETCH(QString, place);
        const auto negative = [](QString text) { return text.replace(u"7 m"_qs, u"-7 m"_qs).replace(u"3.5"_qs, u"-3.5"_qs); };
        const std::string text = passedOn({}, negative(given).toStdString(), negative(rest).toStdString());
        const QStringList said = reported(sample::resolved(text)).split(u'\n');
        QCOMPARE(said.size(), 1);
        const QStringList parts = said[0].split(QStringLiteral(" | "));
        QCOMPARE(parts[0], QStringLiteral("E203 Radius is -7 m, it must be above 0"));
        QCOMPARE(parts[1], negative(place));
        QVERIFY2(parts[2].startsWith(u"it is used here"), qPrintable(said[0]));
    }

    void withoutAnInstance() {
        const std::string text = passedOn({}, "2 cm", "RobotConfig V { Config=R d=-7 m }");
        const QStringList parts = reported(sample::resolved(text)).split(QStringLiteral(" | "));
        QCOMPARE(parts.value(0), QStringLiteral("E203 Radius is -7 m, it must be above 0"));
        QCOMPARE(parts.value(1), QStringLiteral("-7 m"));
    }

    /// A Part with a Config that depends on a Param or on the number of a member takes values by path like any other.
    void intoAComputedConfig_data() {
        QTest::addColumn<QString>("inside");
        QTest::newRow("of a list") << "Param kinds=Big,Small Repeat r { Count=2 Part w { Config=$(element(kinds,index)) to=b } }";
        QTest::newRow("a Param of the Repeat") << "Repeat r { Count=2 Param kind=Small Part w { Config=$kind to=b } }";
        QTest::newRow("a Param of the config") << "Param kind=Big Repeat r { Count=2 Part w { Config=$kind to=b } }";
    }
    void intoAComputedConfig() {
        QFETCH(QString, inside);
        const std::string wheel =
            " Body t { Sphere tyre { Radius=$d Mass=1 Material=g Surface=s } } Fixed f { Parent=$to Child=t } }\n";
        const auto with = [&](const std::string& values) {
            return sample::resolved("Material g { } Surface s { }\n"
                                    "PartConfig Big { Param d = 5 cm" +
                                    wheel + "PartConfig Small { Param d = 2 cm" + wheel +
                                    "RobotConfig R { Body b { Sphere x { Radius=0.2 Mass=3 Material=g Surface=s } } " +
                                    inside.toStdString() + " }\nRobot a { Config=R " + values + " }\n");
        };
        const auto radius = [](const sample::Resolved& r, std::size_t body) {
            return r.config().bodies.at(body).geoms.at(0).radius;
        };
        const sample::Resolved one = with("r_1.w.t.tyre.Radius=0.2"), all = with("r.w.t.tyre.Radius=0.2 r_0.w.d=0.3");
        QCOMPARE(reported(one), QString());
        QCOMPARE(radius(one, 2), 0.2);
        QVERIFY(radius(one, 1) < 0.1);
        QCOMPARE(reported(all), QString());
        QCOMPARE(radius(all, 1), 0.2);
        const QString wrong = reported(with("r_1.w.t.tire.Radius=0.2")), wrongParam = reported(with("r.w.dd=0.2"));
        QVERIFY2(wrong.startsWith(u"E314 Body t has no tire; it has tyre | tire"), qPrintable(wrong));
        QVERIFY2(wrongParam.contains(u" has no dd; it has d") && wrongParam.count(u'\n') == 0, qPrintable(wrongParam));
    }

    /// Which config it is, and so what a path leads to, is known with the Params of the robot.
    void intoTheConfigThatAParamGives() {
        const auto with = [&](const std::string& values) {
            return sample::resolved("Material g { } Surface s { }\n"
                                    "PartConfig Ball { Body t { Sphere ball { Radius=0.1 Mass=1 Material=g Surface=s } } }\n"
                                    "PartConfig Cube { Body t { Box cube { Size=1,1,1 Mass=1 Material=g Surface=s } } }\n"
                                    "RobotConfig R { Param kind=Ball Part w { Config=$kind } }\nRobot a { Config=R " +
                                    values + " }\n");
        };
        const sample::Resolved r = with("kind=Cube w.t.cube.Mass=7");
        QCOMPARE(reported(r), QString());
        QCOMPARE(r.config().bodies.at(0).mass.mass, 7.0);
        const QString wrong = reported(with("kind=Cube w.t.ball.Mass=7"));
        QVERIFY2(wrong.startsWith(u"E314 Body t has no ball; it has cube | ball"), qPrintable(wrong));
    }

    /// What a path leads to where a block further in has exchanged the config of a Part.
    void intoAnExchangedConfig_data() {
        QTest::addColumn<QString>("rest");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const char* rest, const char* message) { QTest::newRow(name) << rest << message; };
        row("a Param", "Robot a { Config=D l.q=0.3 }", "");
        row("a body", "Robot a { Config=D l.ball.Pos=3,0,0 }", "");
        row("of a variant", "RobotConfig E { Config=D l.q=0.2 l.ball.skin.Mass=2 }\nRobot a { Config=E }", "");
        row("of a grid", "Grid a { Config=D Count=2 Spacing=9 l.ball.Pos=0,0,3 }", "");
        row("of a Part in a Part", "Robot a { Config=N m.tip.q=0.2 m.tip.ball.skin.Mass=2 }", "");
        row("of one member", "RobotConfig E { Config=A few_1.l.Config=Other }\nRobot a { Config=E few_1.l.q=0.2 few_0.l.r=0.2 }",
            "");
        row("a Param of the first config", "Robot a { Config=D l.r=7 }", "E314 PartConfig Other has no r; it has q and to | r");
        row("a body of the first config", "Robot a { Config=D l.wheel.tyre.Radius=3 }",
            "E314 PartConfig Other has no wheel; it has ball and f | wheel");
        row("of a variant, for the first config", "RobotConfig E { Config=D l.r=0.2 }",
            "E314 PartConfig Other has no r; it has q and to | r");
        row("of a Part in a Part, for the first config", "Robot a { Config=N m.tip.r=0.2 }",
            "E314 PartConfig Other has no r; it has q and to | r | used here by Part m: m");
        row("of one member, for the other ones",
            "RobotConfig E { Config=A few_1.l.Config=Other }\nRobot a { Config=E few_0.l.q=1 }",
            "E314 PartConfig W has no q; it has r and to | q");
        row("of one that is not exchanged", "Robot a { Config=A l.q=0.3 }", "E314 PartConfig W has no q; it has r and to | q");
        row("in a body of one that is not exchanged", "Robot a { Config=A l.wheel.skin.Mass=1 }",
            "E314 Body wheel has no skin; it has tyre | skin");
        row("exchanged once more further out", "RobotConfig E { Config=D l.q=0.2 }\nRobot a { Config=E l.Config=W l.r=0.1 }", "");
        row("exchanged further out than a variant", "RobotConfig E { Config=A l.r=0.2 }\nRobot a { Config=E l.Config=Other }",
            "");
        row("exchanged further out than a Part", "Robot a { Config=K m.tip.Config=Other m.tip.q=0.1 }", "");
        row("in what is exchanged around it", "Robot a { Config=K m.Config=Hook }", "");
    }
    void intoAnExchangedConfig() {
        QFETCH(QString, rest);
        QTEST(reported(sample::resolved(exchanged(rest.toStdString()))), "message");
    }

    void valuesOfAnExchangedConfigHold() {
        const auto radius = [](const sample::Resolved& r) { return r.config().bodies.at(1).geoms.at(0).radius; };
        QCOMPARE(radius(sample::resolved(exchanged("Robot a { Config=D l.q=0.3 }"))), 0.3);
        const sample::Resolved set = sample::resolved(exchanged("Robot a { Config=D }"), {"a.l.ball.skin.Radius=0.4"});
        QCOMPARE(reported(set), QString());
        QCOMPARE(radius(set), 0.4);
        const sample::Resolved one = sample::resolved(exchanged("Robot a { Config=A }"), {"a.l.Config=Other", "a.l.q=0.5"});
        QCOMPARE(reported(one), QString());
        QCOMPARE(radius(one), 0.5);
    }

    /// What a variant gives is from outside also where an expression uses it.
    void throughAnExpression() {
        const std::string text = "Material g { } Surface s { }\nRobotConfig R { Param d = 2 cm "
                                 "Body b { Sphere x { Radius=$(d/2) Mass=3 Material=g Surface=s } } }\n"
                                 "RobotConfig V { Config=R d=-2 m }\nRobot a { Config=V }";
        QCOMPARE(reported(sample::resolved(text)),
                 QStringLiteral("E203 Radius is -1 m, it must be above 0 | -2 m | it is used here: $(d/2)"));
    }
};

QTEST_APPLESS_MAIN(ValuesPassedOnTest)
#include "values_passed_on_test.moc"
