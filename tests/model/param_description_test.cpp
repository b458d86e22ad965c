// What a text says about its Params: limits, choices, help; where a value that they forbid is reported.
#include <QTest>

#include "model/params.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;

namespace {

const char* const kLooks = "Material red { ColorRGB=1,0,0 }\nSurface rubber { Friction=1 }\n";

Resolved resolved(const std::string& text) { return sample::resolved(kLooks + text); }

/// The messages, each once: a config is resolved for itself and for its instances.
QString messagesOf(const Resolved& read) {
    QStringList lines = QString::fromStdString(read.messages()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    lines.removeDuplicates();
    return lines.join(QLatin1Char('\n'));
}

/// A robot whose ball has the radius r and the mass m.
std::string kit(const std::string& params, const std::string& robots) {
    return "RobotConfig Kit { " + params + " Body b { Sphere s { Radius=$r Mass=$m Material=red Surface=rubber } } }\n" + robots;
}

const char* const kParams = "Param r = 5 cm { Min=2 cm Max=20 cm Help=\"of the ball\" } Param m = 1 { Choices=1,2,4 }";

} // namespace

class ParamDescriptionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void values_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* value, const char* said) { QTest::newRow(value) << value << said; };
        row("r=2 cm", "");
        row("r=0.02", "");
        row("r=20 cm", "");
        row("r=0.2", "");
        row("r=200 mm", "");
        row("m=4", "");
        row("m=4 r=0.07", "");
        row("r=$(0.1+0.1)", "");
        row("r=0.2001", "E203 r is 0.2001 m, it must be from 2 to 20 cm");
        row("r=1.9 cm", "E203 r is 1.9 cm, it must be from 2 to 20 cm");
        row("r=-5 cm", "E203 r is -5 cm, it must be from 2 to 20 cm");
        row("r=5 kg", "E206 r is 5 kg, it must be in cm");
        row("r=red", "E202 r is red, it must be a number");
        row("m=3", "E207 m is 3, it must be 1, 2 or 4");
        row("m=two", "E207 m is two, it must be 1, 2 or 4");
        row("r=1 m=3", "E207 m is 3, it must be 1, 2 or 4\nE203 r is 1 m, it must be from 2 to 20 cm");
    }
    void values() {
        QFETCH(QString, value);
        const std::string robot = "Robot a { Config=Kit Pos=0,0,1 " + value.toStdString() + " }";
        const Resolved read = resolved(kit(kParams, robot));
        QTEST(messagesOf(read), "said");
        for (const Diagnostic& d : read.diagnostics.all()) // at the instance, which names the description
            QVERIFY(read.texts->slice(d.range).size() < 12 && d.range.range.begin > (kLooks + kit(kParams, "")).size());
        for (const Diagnostic& d : read.diagnostics.all()) QCOMPARE(d.notes.back().first, std::string(kDescribedHere));
    }

    void aVariantAndAGridAreComparedToo() {
        const std::string text = kit(kParams, "RobotConfig Big { Config=Kit r=0.3 }\nGrid g { Config=Kit Count=2,1 Spacing=1,1 "
                                              "Pos=0,0,1 r=$(0.15+0.1*index) }");
        const Resolved read = resolved(text);
        QCOMPARE(messagesOf(read),
                 QStringLiteral("E203 r is 0.3 m, it must be from 2 to 20 cm\nE203 r is 0.25 m, it must be from 2 to 20 cm"));
    }

    void ownValuesAreCompared() {
        const Resolved read = resolved("Param n = 7 { Min=1 Max=4 }");
        QCOMPARE(messagesOf(read), QStringLiteral("E203 n is 7, it must be from 1 to 4"));
    }

    /// Limits without a unit are in that of the Param's value, a plain number counts as it does in a value.
    void limitsWithoutAUnit_data() {
        QTest::addColumn<QString>("param");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* param, const char* said) { QTest::newRow(param) << param << said; };
        row("30 cm { Min=0.2 Max=0.4 }", "");
        row("50 cm { Min=0.2 Max=0.4 }", "E203 n is 50 cm, it must be from 20 to 40 cm");
        row("0.5 { Min=0.2 Max=40 cm }", "E203 n is 0.5 m, it must be from 20 to 40 cm");
        row("0.5 { Min=200 mm Max=40 cm }", "E203 n is 0.5 m, it must be from 200 to 400 mm");
        row("5 % { Max=0.04 }", "E203 n is 5 %, it must be at most 0.04");
        row("5 { Max=4 }", "E203 n is 5, it must be at most 4");
        row("5 { Max=4 % }", "E203 n is 5, it must be at most 0.04");
        row("400 { Max=1 rad }", "E203 n is 400 deg, it must be at most 1 rad");
        row("5 { Choices=5 mm,10 mm }", "E207 n is 5 m, it must be 5 mm or 10 mm");
        row("5 kg { Choices=5,10 }", "");
        row("5 kg { Choices=5 m,10 m }", "E207 n is 5 kg, it must be 5 m or 10 m");
        row("5 { Choices=5 %,10 % }", "E207 n is 5, it must be 5 % or 10 %");
    }
    void limitsWithoutAUnit() {
        QFETCH(QString, param);
        QTEST(messagesOf(resolved("Param n = " + param.toStdString())), "said");
    }

    void lists() {
        QCOMPARE(messagesOf(resolved("Param l = 1,5,2 { Max=4 }")),
                 QStringLiteral("E203 l is 5, it must be at most 4"));
    }

    void mistakes_data() {
        QTest::addColumn<QString>("description");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* text, const char* said) { QTest::newRow(text) << text << said; };
        row("{ }", "");
        row("{ Min=4 Max=2 }", "E203 Max is 2, it must be at least Min, 4");
        row("{ Minn=1 }", "E201 there is no Minn of a Param; there are Min, Max, Choices and Help");
        row("{ Min=1 Min=2 }", "E210 Min is set twice in one block");
        row("{ Min=1 cm Max=1 kg }", "E206 Max is in kg, the other values of n are in cm");
        row("{ Min=1 furlong }", "E205 there is no unit furlong");
        row("{ Min=red }", "E202 Min is red, it must be a number");
        row("{ Min=1,2 }", "E204 Min has 2 elements, it takes a number");
        row("{ Min=$k }", "E202 Min of a Param is written out, without $");
        row("{ Help=wheel }", "E202 Help is wheel, it must be a text in double quotes");
        row("{ Box b { } }", "E302 what describes a Param are Min, Max, Choices and Help, nothing else");
        row("{ a.Min=1 }", "E201 there is no a.Min of a Param; there are Min, Max, Choices and Help");
    }
    void mistakes() {
        QFETCH(QString, description);
        const Resolved read = resolved("Param n = 3 " + description.toStdString());
        QTEST(messagesOf(read), "said");
    }

    void aDescribedParamHoldsLimitsAndHelp() {
        const Resolved read = resolved(kit(kParams, ""));
        const Part* config = read.outline->configs.find("Kit");
        QVERIFY(config);
        const SourceParam* r = config->param("r");
        QVERIFY(r && r->description);
        QCOMPARE(r->description->property.help, std::string("of the ball"));
        QCOMPARE(r->description->limits(), std::string("from 2 to 20 cm"));
        QCOMPARE(config->param("m")->description->limits(), std::string("1, 2 or 4"));
    }

    /// A value that is wrong where it is used, of a Param without description, is reported at the instance that gives it.
    void wrongValuesInExpressionsAreReportedAtTheInstance_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("said");
        QTest::newRow("negative") << "r=-1" << "E203 Radius is -0.5, it must be above 0";
        QTest::newRow("of another dimension") << "r=5 kg" << "E206 Radius is a length (m), kg is a mass";
        QTest::newRow("a word") << "r=red" << "E213 Param r is red, an expression takes numbers";
    }
    void wrongValuesInExpressionsAreReportedAtTheInstance() {
        QFETCH(QString, value);
        const std::string config = "RobotConfig Kit { Param r = 1 Param half = $(r/2) "
                                   "Body b { Sphere s { Radius=$half Mass=1 Material=red Surface=rubber } } }\n";
        const Resolved read = resolved(config + "Robot a { Config=Kit Pos=0,0,1 " + value.toStdString() + " }");
        QTEST(messagesOf(read), "said");
        const Diagnostic& d = read.diagnostics.all().front();
        QCOMPARE(read.texts->slice(d.range), std::string_view(value.toStdString()).substr(2));
    }

    void elementsOfLists_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<double>("radius");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* value, double radius, const char* message = "") {
            QTest::newRow(value) << value << radius << message;
        };
        row("$(element(sizes, 0))", 0.1);
        row("$(element(sizes, 1))", 2);
        row("$(2 * element(sizes, 3-1) + 1 m)", 1.6);
        row("$(element(sizes, 3))", 0, "E213 Param sizes has the elements 0 to 2, not 3");
        row("$(element(sizes, -1))", 0, "E213 Param sizes has the elements 0 to 2, not -1");
        row("$(element(sizes, 0.5))", 0, "E213 Param sizes has the elements 0 to 2, not 0.5");
        row("$(element(colours, 1) + 1)", 0, "E213 Param colours is red, an expression takes numbers");
        row("$(element(3, 0))", 0, "E213 element takes the name of a Param that is a list, and a number from 0");
        row("$(element(missing, 0))", 0, "E211 there is no Param missing; there are colours and sizes");
    }
    void elementsOfLists() {
        QFETCH(QString, value);
        QFETCH(double, radius);
        const Resolved read = resolved("Param sizes = 10 cm, 2, 30 cm  Param colours = green,red\nRobotConfig Kit { Body b { Sphere s { "
                                       "Radius=" +
                                       value.toStdString() +
                                       " Mass=1 Material=$(element(colours, 1)) Surface=rubber } } }\nRobot a { Config=Kit Pos=0,0,1 }");
        const QString first = messagesOf(read).section(QLatin1Char('\n'), 0, 0);
        QTEST(first, "message");
        if (!first.isEmpty()) return;
        const GeomSpec& ball = read.config().bodies.at(0).geoms.at(0);
        QCOMPARE(ball.radius, radius);
        QCOMPARE(read.experiment->materials.at(ball.material).name, std::string("red"));
    }
};

QTEST_APPLESS_MAIN(ParamDescriptionTest)
#include "param_description_test.moc"
