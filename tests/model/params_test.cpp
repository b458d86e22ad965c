// Params and expressions: numbers, units, scopes, and what is reported.
#include <QTest>

#include <cmath>
#include <numbers>

#include "model/params.h"
#include "model_fixture.h"

using namespace trundle;
using sample::Resolved;

namespace {

/// The value of the top-level assignment `x` of a text, as evaluated.
struct Evaluated {
    Resolved read;
    std::optional<GivenValue> value;
    std::string said;
};

Evaluated evaluated(const std::string& text) {
    Evaluated e;
    sample::addText(e.read, "main.sim", text);
    const BlockView view = viewOf(*e.read.texts, e.read.texts->trees[0]->items(), 0, e.read.diagnostics);
    ParamScope scope;
    scope.declare(view.params);
    Evaluator evaluator(*e.read.texts, e.read.diagnostics);
    if (const SourceAssignment* x = view.assignments.find("x")) e.value = evaluator.evaluate(*x->value, x->file, scope);
    e.said = e.read.messages();
    return e;
}

const char* const kAmounts = "Param w = 5 cm  Param h = 2 m  Param a = 30 deg  Param r = 2 rad  Param p = 50 %  Param n = 3\n";

} // namespace

class ParamsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void values_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("unit");
        const auto row = [](const char* text, double number, const char* unit = "") {
            QTest::newRow(text) << text << number << unit;
        };
        row("n + 1", 4);
        row("1 - n", -2);
        row("n - 1", 2);
        row("n * 2 ^ 3", 24);
        row("-n ^ 2", -9);
        row("8 / n / 2", 8.0 / 3 / 2);
        row("2 ^ 3 ^ 2", 512);
        row("pi", std::numbers::pi);
        row("p * 4", 2);
        // A unit is converted to the base unit of its dimension, and stays with the number.
        row("w", 0.05, "m");
        row("-w", -0.05, "m");
        row("w + h", 2.05, "m");
        row("h - w", 1.95, "m");
        row("w - h", -1.95, "m");
        row("w + 1", 1.05, "m");
        row("1 - w", 0.95, "m");
        row("w * 2", 0.1, "m");
        row("2 * w", 0.1, "m");
        row("w / 2", 0.025, "m");
        row("r", 360 / std::numbers::pi, "deg");
        row("r - a", 360 / std::numbers::pi - 30, "deg");
        row("w * h", 0.1, "m^2");
        row("w / h", 0.025);
        row("1 / w", 20, "1/m");
        row("w ^ 2", 0.0025, "m^2");
        row("sqrt(h * w * 10)", 1, "m");
        row("floor(-1.5)", -2);
        row("ceil(1.2)", 2);
        row("floor(0.3 / 0.1)", 3); // 2.9999999999999996
        row("floor(1.2 m / (40 cm))", 3);
        row("floor(3 - 1e-9)", 2);
        row("ceil((0.1 + 0.2) / 0.1)", 3); // 3.0000000000000004
        row("ceil(3 + 1e-9)", 4);
        row("round(2.5)", 3);
        row("mod(-30, 360)", 330);
        row("mod(7, -3)", -2);
        row("asin(0.5)", 30, "deg");
        row("acos(0.5)", 60, "deg");
        row("atan2(-1, 0)", -90, "deg");
        row("1 < 2", 1);
        row("2 <= 1", 0);
        row("2 >= 2", 1);
        row("1 != 1", 0);
        row("if(n == 3, 10 cm, 1 / 0)", 0.1, "m");
        row("1 m == 100 cm", 1); // a unit beside ==
        row("5cm==w", 1);
        row("h - 2 m == 0 m", 1);
        row("1 m/s == 2 m/s", 0);
        row("0.1 * n == 0.3", 1); // 0.30000000000000004
        row("0.1 * n != 0.3", 0);
        row("0.1 * n <= 0.3", 1);
        row("0.1 * n > 0.3", 0);
        row("0.3 < 0.1 * n", 0);
        row("1 + 1e-11 > 1", 1);
        row("-3 < -2", 1);
        row("500 mAh + 1", 1.5, "Ah"); // as Capacity is in Ah
        row("1 + 3600 C", 2, "Ah");
        row("2 A * 1800 s", 1, "Ah");
        row("3 Ah / (2 A)", 5400, "s");
        row("5 Ah / 500 mAh", 10);
        row("if(1 > 2, 1, (3 < 4) + 1)", 2);
        row("2cm + 30 mm", 0.05, "m");
        row("90 deg + a - a", 90, "deg");
        row("abs(w - h)", 1.95, "m");
        row("abs(h - w)", 1.95, "m");
        row("min(h, w)", 0.05, "m");
        row("max(h, w)", 2, "m");
        row("min(1, h)", 1, "m");
        // Units are those of plain values.
        row("50 % * n", 1.5);
        row("36 km/h", 10, "m/s");
        row("36 km/h * 2", 20, "m/s");
        row("90deg/s * 2 s", 180, "deg");
        row("60 rpm * w / w", 360, "deg/s");
        row("360 deg / 1 s", 360, "deg/s");
        row("60 rpm * w", 0.1 * std::numbers::pi, "m rad/s");
        row("2 Nm / 1 deg", 360 / std::numbers::pi, "m^2 kg/s^2/rad"); // a torque or a stiffness
        row("24 W / 3000 rpm", 0.24 / std::numbers::pi, "m^2 kg/s^2/rad");
        row("sqrt(3 Nm/rad / 0.12 kgm^2)", 5, "1/s");
        row("10 V/rad * 0.1 rad", 1, "V");
        row("100 N/m / 20 * 1 m * 1 m", 5, "m^2 kg/s^2");
        row("90 deg/s + 1", 90 + 180 / std::numbers::pi, "deg/s");
        row("max(1, 90 deg/s)", 90, "deg/s");
        row("1 Nm + 2 N * 3 m", 7, "Nm");
        row("1 rad/s", 180 / std::numbers::pi, "deg/s");
        row("3 kgm^2 + 1", 4, "kgm^2");
        row("2 cm^2", 2e-4, "m^2");
        row("(2 cm)^2", 4e-4, "m^2");
        row("(6 m) / h", 3);
        row("6 m / h", 3);
        row("1 m/s^2", 1, "m/s^2");
        row("round(w / 2 cm) * 2 cm", 0.06, "m");
        row("asin(1 + 1e-15)", 90, "deg");
        row("acos(-1 - 1e-15)", 180, "deg");
        row("min(h, 1)", 1, "m");
        row("max(1, h, 0.5)", 2, "m");
        row("max(n, 7, 5)", 7);
        row("min(n, 7, 1, 5)", 1);
        row("sin(a)", 0.5);
        row("cos(2 * a)", 0.5);
        row("tan(a) ^ 2", 1.0 / 3);
        row("sin(-a)", -0.5);
        row("sin(1) * 1e3", 17.452406437283512);
    }
    void values() {
        QFETCH(QString, text);
        QFETCH(double, number);
        QFETCH(QString, unit);
        const Evaluated e = evaluated(kAmounts + std::string("x = $(") + text.toStdString() + ")\n");
        QCOMPARE(e.said, std::string());
        QVERIFY(e.value && e.value->elements.size() == 1);
        QVERIFY2(std::abs(e.value->elements[0].number - number) < 1e-12 * std::max(1.0, std::abs(number)),
                 qPrintable(QString::number(e.value->elements[0].number, 'g', 17)));
        QCOMPARE(QString::fromStdString(e.value->elements[0].unit), unit);
        QVERIFY(e.value->fromParam && !e.value->elements[0].literal);
    }

    /// Multiples of a right angle are exact, whatever their sign and size.
    void rightAnglesAreExact() {
        static const double sines[] = {0, 1, 0, -1};
        for (const int quarters : {-9, -8, -7, -6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 4001, -4001}) {
            const std::string angle = std::to_string(quarters * 90);
            const double sine = sines[((quarters % 4) + 4) % 4], cosine = sines[(((quarters + 1) % 4) + 4) % 4];
            const auto of = [&](const std::string& function) { return evaluated("x = $(" + function + "(" + angle + "))\n"); };
            QCOMPARE(of("sin").value->elements[0].number, sine);
            QCOMPARE(of("cos").value->elements[0].number, cosine);
            const Evaluated tangent = of("tan");
            if (cosine != 0) QCOMPARE(tangent.value->elements[0].number, 0.0);
            else QCOMPARE(tangent.said, "E213 the tangent of " + angle + " degrees is not a number\n");
        }
    }

    void faults_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* text, const char* said) { QTest::newRow(text) << text << said; };
        row("x = $(w + a)", "E213 m and deg cannot be added\n");
        row("x = $(a - w)", "E213 deg and m cannot be added\n");
        row("x = $(min(w, a))", "E213 m and deg cannot be compared\n");
        row("x = $(max(1, a, 2, w))", "E213 deg and m cannot be compared\n");
        row("x = $(sin(w))", "E213 sin takes an angle in degrees, this is in m\n");
        row("x = $(1 / (n - 3))", "E213 division by zero\n");
        row("x = $(sqrt(-n))", "E213 the square root of -3 is not a number\n");
        row("x = $(10 ^ 400)", "E213 the result is not a number that can be used\n");
        row("x = $((0 - 8) ^ 0.5)", "E213 the result is not a number that can be used\n");
        row("x = $(w < a)", "E213 m and deg cannot be compared\n");
        row("x = $(mod(1, 0))", "E213 division by zero\n");
        row("x = $(asin(2))", "E213 asin of 2 is not a number\n");
        row("x = $(acos(w))", "E213 acos takes a number without unit, this is in m\n");
        row("x = $(if(1, 1 / 0, 2))", "E213 division by zero\n");
        row("x = $(if(1, 2, missing))", "E211 there is no Param missing; there are a, h, n, p, r and w\n");
        row("x = $(if(0, sin(missing) + 1, 2))", "E211 there is no Param missing; there are a, h, n, p, r and w\n");
        row("x = $(round(w))",
            "E213 round takes a number without unit, this is in m; divide by the step: round(x / 1 m) * 1 m\n");
        row("x = $(floor(a + 1))",
            "E213 floor takes a number without unit, this is in deg; divide by the step: floor(x / 1 deg) * 1 deg\n");
        row("x = $(1 m/s + 1 m)", "E213 m/s and m cannot be added\n");
        row("x = $(sqrt(2 m))", "E213 m to the power of 0.5 is not a unit\n");
        row("x = $(3 dB * 2 m)", "E213 dB cannot be multiplied or divided with units\n");
        row("x = $(2 ^ (1 m))", "E213 an exponent has no unit, this is in m\n");
        row("x = $(2*PI)", "E211 there is no Param PI\n");
        row("x = $(2furlong)", "E205 there is no unit furlong\n");
        row("x = $(mod(1))", "E113 `mod` takes two arguments\n");
        row("x = $(abs(1, 2))", "E113 `abs` takes one argument\n");
        row("x = $(sine(30))",
            "E113 there is no function `sine`; there are min max abs sqrt sin cos tan asin acos atan2 floor ceil round mod if element\n");
        row("Param list = 1, 2\nx = $(list + 1)", "E213 Param list is a list of 2, an expression takes numbers\n");
        row("Param word = hi\nx = $(word + 1)", "E213 Param word is hi, an expression takes numbers\n");
        row("Param odd = 3 furlong\nx = $(odd + 1)", "E213 Param odd is 3 furlong: there is no unit furlong\n");
        row("x = $missing", "E211 there is no Param missing; there are a, h, n, p, r and w\n");
        row("Param me = $me\nx = $me", "E212 Params need each other in a circle: me > me\n");
        row("Param one = $two\nParam two = $three\nParam three = $two\nx = $one",
            "E212 Params need each other in a circle: two > three > two\n");
    }
    void faults() {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const Evaluated e = evaluated(kAmounts + text.toStdString() + "\n");
        QVERIFY(!e.value);
        QCOMPARE(QString::fromStdString(e.said), said);
    }

    /// `if` chooses between Params that are words or lists as well; what it does not choose must be there.
    void ifChoosesWords() {
        const std::string params = "Param wood = oak\nParam spots = 1, 2\nParam n = 3\n";
        const auto valueOf = [&](const std::string& expression) {
            const Evaluated e = evaluated(params + "x = $(" + expression + ")\n");
            QStringList all;
            if (e.value)
                for (const GivenElement& element : e.value->elements)
                    all += element.kind == GivenElement::Kind::Number ? QString::number(element.number)
                                                                      : QString::fromStdString(element.text);
            return e.value ? all.join(", ") : QString::fromStdString(e.said);
        };
        QCOMPARE(valueOf("if(n > 2, wood, spots)"), QString("oak"));
        QCOMPARE(valueOf("if(n > 3, wood, if(n > 2, spots, n))"), QString("1, 2"));
        QCOMPARE(valueOf("if(n > 3, wood, n)"), QString("3"));
        QVERIFY(valueOf("if(n > 2, wood, red)").contains("there is no Param red"));
        QVERIFY(valueOf("if(n > 2, wood, spots) + 1").contains("an expression takes numbers"));
    }

    /// The suggestion for an unknown name in `$( )` replaces the name, not the expression.
    void suggestionInAnExpression() {
        for (const char* value : {"$(PI)", "$( Pi )", "$(2*PI)"}) {
            const Evaluated e = evaluated(std::string("x = ") + value + "\n");
            const std::vector<Diagnostic>& all = e.read.diagnostics.all();
            QCOMPARE(all.size(), std::size_t{1});
            QVERIFY(!all[0].fixes.empty());
            const TextEdit& edit = all[0].fixes[0].edits[0];
            QCOMPARE(edit.text, std::string("pi"));
            QCOMPARE(QString::fromStdString(e.read.slice(edit.range)).toLower(), QString("pi"));
        }
    }

    /// The ranges name the `$name` in the value, and the value of the Param itself.
    void rangesOfAParam() {
        const Evaluated e = evaluated("Param far = 1, 20 cm\nParam near = $far\nx = 7, $near, $(1 + 1)\n");
        QCOMPARE(e.said, std::string());
        QCOMPARE(e.value->elements.size(), std::size_t{4});
        const auto text = [&](const SourceRange& range) { return e.read.slice(range); };
        QCOMPARE(text(e.value->range), std::string("7, $near, $(1 + 1)"));
        QCOMPARE(text(e.value->elements[0].range), std::string("7"));
        QVERIFY(e.value->elements[0].literal && !e.value->elements[0].source.known());
        QCOMPARE(text(e.value->elements[2].range), std::string("$near"));
        QCOMPARE(text(e.value->elements[2].source), std::string("20 cm"));
        QCOMPARE(e.value->elements[2].unit, std::string("cm")); // a plain use keeps the number as written
        QCOMPARE(e.value->elements[2].number, 20.0);
        QCOMPARE(text(e.value->elements[3].range), std::string("$(1 + 1)"));
    }

    /// Params may be used before they are declared; a chain of them may be 100 long.
    void chains() {
        for (const int length : {99, 100, 101, 150}) {
            std::string text = "x = $p0\n";
            for (int i = 0; i + 1 < length; ++i) text += "Param p" + std::to_string(i) + " = $p" + std::to_string(i + 1) + "\n";
            text += "Param p" + std::to_string(length - 1) + " = 42\n";
            const Evaluated e = evaluated(text);
            QCOMPARE(e.value.has_value(), length <= 100);
            if (e.value) QCOMPARE(e.value->elements[0].number, 42.0);
            else QCOMPARE(e.said, std::string("E212 more than 100 Params need each other in a row\n"));
        }
    }

    /// A list that doubles with each Param ends at 100000 elements.
    void listsEnd() {
        std::string text = "Param p0 = 1, 1\n";
        for (int i = 1; i < 40; ++i)
            text += "Param p" + std::to_string(i) + " = $p" + std::to_string(i - 1) + ", $p" + std::to_string(i - 1) + "\n";
        const Evaluated e = evaluated(text + "x = $p39\n");
        QVERIFY(!e.value);
        QVERIFY(e.said.starts_with("E204 the list grows beyond 100000 elements\n"));
        const Evaluated most = evaluated(text + "x = $p15\n");
        QCOMPARE(most.value->elements.size(), std::size_t{65536});
    }

    /// The innermost declaration counts; a value from outside replaces the declaration of that block only.
    void scopes() {
        const std::string config = "RobotConfig Ball { Param size = 0.2 Param twice = $(2 * size)\n"
                                   "Body b { Param size = 0.3 Pos=$size,$twice,$outer\n"
                                   "  Sphere s { Param pi = 3 Radius=$size Mass=$(pi) Pos=$(size * 10),0,0 } } }\n";
        const Resolved r = sample::resolved("Param outer = 0.9 Param size = 0.1\n" + config +
                                                "Robot plain { Config=Ball }\nRobot set { Config=Ball size=0.5 }\n"
                                                "Robot own { Param size = 0.7 Config=Ball size=$size Pos=$size,$outer,0 }\n",
                                            {"outer=0.8"});
        SAYS(r, "E303 the name pi is taken by the number pi, which this Param replaces in $( )\n"
                "E316 Sphere s names no Material and no Surface: the built-in default is used\n");
        const auto body = [&](std::size_t robot) { return r.config(robot).bodies.at(0); };
        QCOMPARE(body(0).pose.position, Vec3(0.3, 0.4, 0.8));
        QCOMPARE(body(1).pose.position, Vec3(0.3, 1.0, 0.8));
        QCOMPARE(body(2).pose.position, Vec3(0.3, 1.4, 0.8));
        QCOMPARE(body(1).geoms[0].radius, 0.3);
        QCOMPARE(body(1).geoms[0].mass, std::optional<double>(3));
        QCOMPARE(body(1).geoms[0].pose.position.x(), 3.0);
        QCOMPARE(r.experiment->robots[2].pose.position, Vec3(0.7, 0.8, 0));
    }

    /// Unused Params are checked in every block, each once.
    void checksUnusedParams() {
        const Resolved r = sample::resolved(
            sample::with(sample::with(sample::rover("Param top = $(1 / 0)\nRobot robot0 { Param own = $nix Config=Rover }\n"),
                                      "Body chassis {", "Body chassis { Param inner = $(sqrt(-1))"),
                         "Hinge leftAxle {", "Hinge leftAxle { Param joint = $(tan(90))"));
        QCOMPARE(QString::fromStdString(r.messages()).count("E213 "), 3);
        QCOMPARE(QString::fromStdString(r.messages()).count("E211 there is no Param nix"), 1);
    }
};

QTEST_APPLESS_MAIN(ParamsTest)
#include "params_test.moc"
