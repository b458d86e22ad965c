// Rendering of diagnostics as text with line, column and caret.

#include <QTest>

#include "lang/texts.h"

using namespace trundle;
using namespace texts;

namespace {

struct Case {
    SourceTable table;
    Diagnostic d;

    explicit Case(std::string text, std::uint32_t begin = 0, std::uint32_t end = 0) {
        table.add(std::make_shared<const SourceText>("a.sim", std::move(text)));
        d.code = Code::OutOfRange;
        d.message = "wrong";
        d.range = {0, {begin, end}};
    }
    QByteArray shown() const { return q(render(d, table)); }
};

} // namespace

class RenderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theWholeMessage() {
        SourceTable table;
        const FileId experiment =
            table.add(std::make_shared<const SourceText>("experiments/e.sim", "\n\n#import robots/r.sim\n"));
        const FileId robot =
            table.add(std::make_shared<const SourceText>("robots/r.sim", "A {\n  Cylinder tyre { Radius=-3cm Length=0.03 }\n}\n"),
                      {experiment, {2, 9}});
        Diagnostic d;
        d.code = Code::OutOfRange;
        d.message = "Radius is -3 cm, it must be above 0";
        d.range = {robot, {29, 33}};
        d.fixes = {{"3cm", {}}};
        d.notes = {{"the first is here", {robot, {6, 14}}}};
        QCOMPARE(q(render(d, table)), QByteArray("robots/r.sim:2:26: error E203: Radius is -3 cm, it must be above 0\n"
                                                 "    2 |   Cylinder tyre { Radius=-3cm Length=0.03 }\n"
                                                 "      |                          ^~~~  fix: 3cm\n"
                                                 "robots/r.sim:2:3: note: the first is here\n"
                                                 "imported from experiments/e.sim:3\n"));
    }

    void suggestionsAndFixes() {
        Case c("Sise=1", 0, 4);
        c.d.suggestions = {"Size", "Side"};
        QCOMPARE(c.shown(), QByteArray("a.sim:1:1: error E203: wrong\n    1 | Sise=1\n      | ^~~~  did you mean Size?\n"));
        c.d.fixes = {{"Size", {}}};
        QCOMPARE(c.shown(), QByteArray("a.sim:1:1: error E203: wrong\n    1 | Sise=1\n      | ^~~~  fix: Size\n"));
    }

    void severities() {
        Case c("x", 0, 1);
        c.d.severity = Severity::Warning;
        QVERIFY(c.shown().startsWith("a.sim:1:1: warning E203: wrong\n"));
        c.d.severity = Severity::Hint;
        QVERIFY(c.shown().startsWith("a.sim:1:1: hint E203: wrong\n"));
    }

    void excerpts_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("begin");
        QTest::addColumn<int>("end");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char* name, std::string_view text, int begin, int end, std::string_view shown) {
            QTest::newRow(name) << q(text) << begin << end << q(shown);
        };
        row("at the end of the file", "x = ", 4, 4, "a.sim:1:5: error E203: wrong\n    1 | x =\n      |     ^\n");
        row("after the last line", "x\n", 2, 2, "a.sim:2:1: error E203: wrong\n    2 |\n      | ^\n");
        row("an empty file", "", 0, 0, "a.sim:1:1: error E203: wrong\n    1 |\n      | ^\n");
        row("an empty range", "x = y", 2, 2, "a.sim:1:3: error E203: wrong\n    1 | x = y\n      |   ^\n");
        row("the first of many lines", "ab cd\nef\n", 3, 8, "a.sim:1:4: error E203: wrong\n    1 | ab cd\n      |    ^~\n");
        row("a range of the line end", "ab\r\nef", 2, 4, "a.sim:1:3: error E203: wrong\n    1 | ab\n      |   ^\n");
        row("tabs are kept", "\tx\ty", 3, 4, "a.sim:1:4: error E203: wrong\n    1 | \tx\ty\n      | \t \t^\n");
        row("code points, not bytes", "\xC3\xA4\xC3\xB6 x", 5, 6,
            "a.sim:1:4: error E203: wrong\n    1 | \xC3\xA4\xC3\xB6 x\n      |    ^\n");
        row("a BOM takes no room", "\xEF\xBB\xBFx y", 5, 6, "a.sim:1:3: error E203: wrong\n    1 | x y\n      |   ^\n");
        row("broken and control bytes", std::string_view("\xFF\x1B\0x", 4), 3, 4,
            "a.sim:1:4: error E203: wrong\n    1 | \xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBDx\n      |    ^\n");
        row("beyond the file", "ab", 90, 95, "a.sim:1:3: error E203: wrong\n    1 | ab\n      |   ^\n");
        const std::string wide(400, 'a');
        row("a long line is cut behind", "bc " + wide, 0, 2,
            "a.sim:1:1: error E203: wrong\n    1 | bc " + wide.substr(0, 157) + "...\n      | ^~\n");
        row("a long line is cut before", wide + " bc", 401, 403,
            "a.sim:1:402: error E203: wrong\n    1 | ..." + wide.substr(0, 59) + " bc\n      | " + std::string(63, ' ') + "^~\n");
    }
    void excerpts() {
        QFETCH(QByteArray, text);
        QFETCH(int, begin);
        QFETCH(int, end);
        QTEST(Case(text.toStdString(), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)).shown(), "shown");
    }

    void largeLineNumbers() {
        const std::string text(123456, '\n');
        QCOMPARE(Case(text + "x", 123456, 123457).shown(),
                 QByteArray("a.sim:123457:1: error E203: wrong\n123457 | x\n       | ^\n"));
    }

    void withoutAPlace() {
        Case c("x");
        c.d.range = {};
        c.d.message = "two\nlines";
        QCOMPARE(c.shown(), QByteArray("error E203: two lines\n"));
        c.d.range.file = 9;
        QCOMPARE(c.shown(), QByteArray("error E203: two lines\n"));
    }

    void aCircleOfImportsEnds() {
        SourceTable table;
        table.add(std::make_shared<const SourceText>("a.sim", "x"), {1, {0, 1}});
        table.add(std::make_shared<const SourceText>("b.sim", "x"), {0, {0, 1}});
        Diagnostic d;
        d.range = {0, {0, 1}};
        QVERIFY(q(render(d, table)).count("imported from") <= 40);
    }
};

QTEST_APPLESS_MAIN(RenderTest)
#include "diagnostic_text_test.moc"
