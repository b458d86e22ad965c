// The trees of valid texts, written out.

#include <QTest>

#include "lang/texts.h"

using namespace trundle;
using namespace texts;

namespace {

std::string shown(const Expression& e) {
    const auto pair = [&](const char* sign) { return "(" + shown(e.arguments[0]) + sign + shown(e.arguments[1]) + ")"; };
    switch (e.op) {
    case Expression::Op::Number: return QByteArray::number(e.number).toStdString();
    case Expression::Op::Name: return e.name;
    case Expression::Op::Negate: return "(-" + shown(e.arguments[0]) + ")";
    case Expression::Op::Add: return pair("+");
    case Expression::Op::Subtract: return pair("-");
    case Expression::Op::Multiply: return pair("*");
    case Expression::Op::Divide: return pair("/");
    case Expression::Op::Power: return pair("^");
    case Expression::Op::Call: break;
    }
    std::string call = e.name + "(";
    for (std::size_t i = 0; i < e.arguments.size(); ++i) call += (i ? "," : "") + shown(e.arguments[i]);
    return call + ")";
}

std::string shown(const Value& v) {
    std::string out;
    for (const Element& e : v.elements) {
        if (!out.empty()) out += ",";
        switch (e.kind) {
        case Element::Kind::Number:
            out += QByteArray::number(e.number, 'g', 12).toStdString() + (e.unit.empty() ? "" : " " + e.unit);
            break;
        case Element::Kind::Word: out += e.text; break;
        case Element::Kind::String: out += "\"" + e.text + "\""; break;
        case Element::Kind::Boolean: out += e.boolean ? "yes" : "no"; break;
        case Element::Kind::ParamRef: out += "$" + e.text; break;
        case Element::Kind::Expression: out += "$" + shown(*e.expression); break;
        }
    }
    return out;
}

/// `Type name{...}`, `a.b=value`, each followed by `;`.
std::string shown(const std::vector<Item>& items) {
    std::string out;
    for (const Item& item : items) {
        if (const auto* i = item.as<ImportItem>()) out += "#import " + i->path;
        if (const auto* m = item.as<ModuleItem>()) out += "#loadModule " + m->path;
        if (const auto* p = item.as<ParamItem>()) {
            out += "Param " + p->name.text + "=" + shown(p->value);
            if (p->open.size()) out += "{" + shown(p->items) + "}";
        }
        if (const auto* b = item.as<BlockItem>())
            out += b->type.text + (b->name ? " " + b->name->text : "") + "{" + shown(b->items) + "}";
        if (const auto* a = item.as<AssignmentItem>()) {
            for (std::size_t i = 0; i < a->path.size(); ++i) out += (i ? "." : "") + a->path[i].text;
            out += "=" + shown(a->value);
        }
        out += ";";
    }
    return out;
}

} // namespace

class ParserTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// A whole number is not rounded down to the largest one that a property may have.
    void largestWholeNumber() {
        const auto number = [](const char* text) {
            return parsed(text)->items().at(0).as<AssignmentItem>()->value.elements.at(0).number;
        };
        QCOMPARE(number("x = 9007199254740992\n"), 9007199254740992.0);
        QVERIFY(number("x = 9007199254740993\n") > 9007199254740992.0);
        QVERIFY(number("x = -9007199254740993\n") < -9007199254740992.0);
    }

    void sound_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("tree");
        const auto row = [](const char* name, std::string_view text, const char* tree) {
            QTest::newRow(name) << q(text) << QByteArray(tree);
        };
        row("a list", "Pos = 0,0,0", "Pos=0,0,0;");
        row("blanks and line ends in a list", "Pos = 1 ,\n 2\n , 3\nx=1", "Pos=1,2,3;x=1;");
        row("comments in a list", "Pos = 1, // one\n /* two */ 2", "Pos=1,2;");
        row("a value on the next line", "Pos =\n  1,2\nx=1", "Pos=1,2;x=1;");
        row("several on one line", "Friction=0.2 Restitution=0.2", "Friction=0.2;Restitution=0.2;");
        row("numbers", "x = +1 y = -.5 z = 3. w = 1e3 v = 1.5E-2", "x=1;y=-0.5;z=3;w=1000;v=0.015;");
        row("a number below all doubles", "x = 1e-999 y = 0e999", "x=0;y=0;");
        row("units", "x = 3cm y = 12 cm z = 5 % w = 3% v=0.3m/s u = 9.81 m/s^2 t = 2 kg/m^3",
            "x=3 cm;y=12 cm;z=5 %;w=3 %;v=0.3 m/s;u=9.81 m/s^2;t=2 kg/m^3;");
        row("a unit that begins like a longer one", "x = 1 m y = 2 min z = 3 mm", "x=1 m;y=2 min;z=3 mm;");
        row("a unit and a comment", "x = 2 // s\ny = 2// s\nz = 2 m//s", "x=2;y=2;z=2 m;");
        row("a unit before a block", "x = 2 m Box { }", "x=2 m;Box{};");
        row("a key named like a unit", "x = 2 m = 3 s.a = 4", "x=2;m=3;s.a=4;");
        row("a kind behind a number", "Tick = 0.03 Static arena { }", "Tick=0.03;Static arena{};");
        row("no unit on the next line", "x = 2\nm = 3", "x=2;m=3;");
        row("an unknown unit stays for the resolver", "x = 2 furlongs", "x=2 furlongs;");
        row("units in lists", "Pos = 1cm, 2 mm,3", "Pos=1 cm,2 mm,3;");
        row("words", "Geom=chassis.bumper File=linear_motion.csv A=a-b B=a/b\\c",
            "Geom=chassis.bumper;File=linear_motion.csv;A=a-b;B=a/b\\c;");
        row("lists of words", "Robot = a.b, c_1 , d", "Robot=a.b,c_1,d;");
        row("a word and then a key", "Config=SimpleRobot  Pos=1", "Config=SimpleRobot;Pos=1;");
        row("a word and then a path", "Config=SimpleRobot leftMotor.R=1", "Config=SimpleRobot;leftMotor.R=1;");
        row("a word that ends with a dot", "File=a.csv. Key=3", "File=a.csv.;Key=3;");
        row("a word and then a block", "Material=red Box { }", "Material=red;Box{};");
        row("a word and then a named block", "Config=SimpleRobot LinearMotion brain { }",
            "Config=SimpleRobot;LinearMotion brain{};");
        row("a word and a comment", "A = b//c\nB = b/*c*/", "A=b;B=b;");
        row("paths", "a.b.c = 3 robot0.leftMotor.Resistance=3", "a.b.c=3;robot0.leftMotor.Resistance=3;");
        row("strings", "a = \"x y\" b = \"\\\"q\\\"\" c = \"1\\n2\" d = \"\\\\\" e = \"// no comment\"",
            "a=\"x y\";b=\"\"q\"\";c=\"1\n2\";d=\"\\\";e=\"// no comment\";");
        row("booleans", "a = true b = false c = True", "a=yes;b=no;c=True;");
        row("a described param", "Param r = 5 cm { Min=2 cm Max=20 cm Help=\"wheel\" } x = 1",
            "Param r=5 cm{Min=2 cm;Max=20 cm;Help=\"wheel\";};x=1;");
        row("a described word", "Param look = red { Choices=red,blue }", "Param look=red{Choices=red,blue;};");
        row("a described list", "Param l = a,b\n{\n  Help=\"x\"\n}\nBox c { }", "Param l=a,b{Help=\"x\";};Box c{};");
        row("a block behind a param", "Param n = 3 Box { } Param m = 2 Box b { }", "Param n=3;Box{};Param m=2;Box b{};");
        row("params", "Param w = 0.25 x = $w y = 1, $w, 2 cm", "Param w=0.25;x=$w;y=1,$w,2 cm;");
        row("expressions", "x = $(a+2*b) y = $((a+2)*b) z = $(-a^2) w = $(2^3^2) v = $(2^-1)",
            "x=$(a+(2*b));y=$((a+2)*b);z=$(-(a^2));w=$(2^(3^2));v=$(2^(-1));");
        row("minus is left to right", "x = $(a-b-c) y = $(a/b*c)", "x=$((a-b)-c);y=$((a/b)*c);");
        row("calls", "x = $(min(a, 2, b)) y = $( sqrt( a ) )", "x=$min(a,2,b);y=$sqrt(a);");
        row("an expression over lines", "x = $(a +\n  b\n  * c)\ny = 1", "x=$(a+(b*c));y=1;");
        row("blocks", "Robot r { Body b { } Box { } }", "Robot r{Body b{};Box{};};");
        row("the brace on the next line", "Robot r\n{\n}\nBox\n{ }", "Robot r{};Box{};");
        row("directives", "#import common/a.sim // c\n  #import \"a b.sim\"\n#loadModule Controllers\\My.dll\n#import a//b.sim",
            "#import common/a.sim;#import a b.sim;#loadModule Controllers\\My.dll;#import a//b.sim;");
        row("a directive in a block", "Static s {\n#import a.sim\n}", "Static s{#import a.sim;};");
        row("a comment before a directive", "/* c */ #import a.sim", "#import a.sim;");
        row("lone CRs", "x = 1\ry = 2\r#import a.sim\r", "x=1;y=2;#import a.sim;");
        row("BOM and CR LF", "\xEF\xBB\xBFx = 1\r\n#import a.sim\r\n", "x=1;#import a.sim;");
        row("world as a value", "Parent = world", "Parent=world;");
    }
    void sound() {
        QFETCH(QByteArray, text);
        const auto tree = parsed(text.toStdString());
        QCOMPARE(q(messages(*tree)), QByteArray());
        QTEST(q(shown(tree->items())), "tree");
    }

    void theExamplesAreSound() {
        for (const std::string& text : examples()) QCOMPARE(q(messages(*parsed(text))), QByteArray());
    }

    void rangesFitTheText() {
        const auto tree = parsed("Robot r { a.b = 1, 2 cm // c\n Box { } }");
        const SourceText& source = tree->source();
        const auto& robot = *tree->items()[0].as<BlockItem>();
        const auto& set = *robot.items[0].as<AssignmentItem>();
        QCOMPARE(q(source.slice(robot.type.range)), QByteArray("Robot"));
        QCOMPARE(q(source.slice(robot.name->range)), QByteArray("r"));
        QCOMPARE(q(source.slice(robot.open)), QByteArray("{"));
        QCOMPARE(q(source.slice(robot.close)), QByteArray("}"));
        QCOMPARE(q(source.slice(tree->items()[0].range)), q(source.bytes()));
        QCOMPARE(q(source.slice(robot.items[0].range)), QByteArray("a.b = 1, 2 cm"));
        QCOMPARE(q(source.slice(set.pathRange)), QByteArray("a.b"));
        QCOMPARE(q(source.slice(set.value.range)), QByteArray("1, 2 cm"));
        QCOMPARE(q(source.slice(set.value.elements[1].range)), QByteArray("2 cm"));
        QCOMPARE(q(source.slice(set.value.elements[1].unitRange)), QByteArray("cm"));
        QCOMPARE(q(source.slice(robot.items[1].range)), QByteArray("Box { }"));
    }

    void readsTypographicMinusAndOffersFix() {
        const auto tree = parsed("Pos = \xE2\x88\x92"
                                 "1.5, $(a \xE2\x88\x92 1)");
        QCOMPARE(q(shown(tree->items())), QByteArray("Pos=-1.5,$(a-1);"));
        QCOMPARE(tree->diagnostics().size(), std::size_t(2));
        QCOMPARE(tree->diagnostics()[0].severity, Severity::Warning);
        QCOMPARE(q(tree->diagnostics()[0].fixes[0].edits[0].text), QByteArray("-"));
    }

    void depthIsBounded() {
        std::string deep;
        for (int i = 0; i < kMaxBlockDepth; ++i) deep += "A {";
        std::string closed = deep;
        for (int i = 0; i < kMaxBlockDepth; ++i) closed += "}";
        QCOMPARE(q(messages(*parsed(closed))), QByteArray());
        const auto tooDeep = parsed(deep + "B { x=1 C { } }" + closed.substr(deep.size()) + "\ny=1");
        QCOMPARE(tooDeep->diagnostics().size(), std::size_t(1));
        QCOMPARE(tooDeep->diagnostics()[0].code, Code::TooDeep);
        QCOMPARE(tooDeep->items().size(), std::size_t(2)); // the item after it is read

        const auto parens = [](int n) {
            return "x = $(" + std::string(static_cast<std::size_t>(n), '(') + "1" +
                   std::string(static_cast<std::size_t>(n), ')') + ")";
        };
        QCOMPARE(q(messages(*parsed(parens(90)))), QByteArray());
        QCOMPARE(parsed(parens(200))->diagnostics()[0].code, Code::TooDeep);
        std::string sum = "x = $(1";
        for (int i = 0; i < 500; ++i) sum += "+1";
        QCOMPARE(parsed(sum + ")")->diagnostics()[0].code, Code::TooDeep);
        for (const char* step : {"1^", "-", "+", "1^-", "abs("}) { // operators that can be repeated count towards the depth
            std::string row = "x = $(";
            for (int i = 0; i < 200'000; ++i) row += step;
            const auto tree = parsed(row + "1)");
            QVERIFY2(!tree->diagnostics().empty() && tree->diagnostics()[0].code == Code::TooDeep, step);
        }
    }
};

QTEST_APPLESS_MAIN(ParserTest)
#include "parser_test.moc"
