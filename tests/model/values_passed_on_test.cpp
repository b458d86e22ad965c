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
