// The formatter changes only white space at the start and end of lines, never the meaning.

#include <QTest>

#include "lang/formatter.h"
#include "lang/texts.h"

using namespace trundle;
using namespace texts;

namespace {

std::string formatted(const std::string& text) { return format(*parsed(text)); }

/// All tokens but blanks and line ends.
std::string substance(const std::string& text) {
    const auto tree = parsed(text);
    std::string out;
    for (const Token& token : tree->tokens()) {
        std::string piece(tree->source().slice(token.range));
        if (token.kind == TokenKind::Space || token.kind == TokenKind::LineEnd) continue;
        if (token.kind == TokenKind::LineComment)
            while (piece.find_last_of(" \t\v\f") == piece.size() - 1) piece.pop_back();
        out += piece + "\x01";
    }
    return out;
}

} // namespace

class FormatterTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cases_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        const auto row = [](const char* name, std::string_view before, std::string_view after) {
            QTest::newRow(name) << q(before) << q(after);
        };
        row("indent", "Robot r {\nBody b {\n      Mass=1\n }\n}", "Robot r {\n  Body b {\n    Mass=1\n  }\n}\n");
        row("one line stays", "Box b { A=1   B=2 }", "Box b { A=1   B=2 }\n");
        row("braces that end a line", "Body w { A=1\nBox t { B=2\nC=3 } }\nX=1",
            "Body w { A=1\n  Box t { B=2\n    C=3 } }\nX=1\n");
        row("trailing blanks", "A=1  \t\nB=2 // c  \n   \nC=3\n\n\n", "A=1\nB=2 // c\n\nC=3\n");
        row("CR LF", "A {\r\nB=1\r\n}", "A {\r\n  B=1\r\n}\r\n");
        row("lone CR", "A {\rB=1\r}\r\r", "A {\r  B=1\r}\r");
        row("BOM", "\xEF\xBB\xBF  A=1",
            "\xEF\xBB\xBF"
            "A=1\n");
        row("comments", "A {\n// c\n/* d\n      e */ B=1\n}", "A {\n  // c\n  /* d\n      e */ B=1\n}\n");
        row("a value that goes on", "A {\nPos = 1,\n      2,\n      3\nB=1\n}",
            "A {\n  Pos = 1,\n        2,\n        3\n  B=1\n}\n");
        row("a described Param", "A {\nParam r = 5 cm {\nMin=2 cm\n   Help=\"x\"\n}\nB=1\n}",
            "A {\n  Param r = 5 cm {\n    Min=2 cm\n    Help=\"x\"\n  }\n  B=1\n}\n");
        row("tabs", "A {\n\tB=1\n\tC {\n\t\tD=1\n\t}\n}\n", "A {\n  B=1\n  C {\n    D=1\n  }\n}\n");
        row("tabs in a value that goes on", "A {\n\tPos = 1,\n\t\t  2\n}", "A {\n  Pos = 1,\n        2\n}\n");
        row("braces on a line of their own", "A {\nB {\n C {\nD=1\n} } \n E=2\n}",
            "A {\n  B {\n    C {\n      D=1\n  } }\n  E=2\n}\n");
        row("braces behind an item", "A {\nB {\nC=1 } D=2\n}", "A {\n  B {\n    C=1 } D=2\n}\n");
        row("directives", "  #import a.sim  // why\nA=1", "#import a.sim  // why\nA=1\n");
        row("values untouched", "A = 1.50,2 ,$( a+1 ) , \"x  y\"\n", "A = 1.50,2 ,$( a+1 ) , \"x  y\"\n");
        row("a blank between CR and LF", "A=1\r \nB=2", "A=1\r\nB=2\r\n");
        row("blank lines with blanks", "A {\n\n  \n\t\r\n \n    B=1\n}", "A {\n\n\n\r\n\n  B=1\n}\n");
        row("empty", "", "");
        row("blank", " \n \n", "");
        row("an error", "A = \n  B {", "A = \n  B {");
    }
    void cases() {
        QFETCH(QByteArray, before);
        QTEST(q(formatted(before.toStdString())), "after");
        QFETCH(QByteArray, after);
        QCOMPARE(q(formatted(after.toStdString())), after);
    }

    void formattingKeepsMeaning() {
        RandomNumbers rng(4);
        const int count = longRun() ? 50000 : 3000;
        int sound = 0;
        const std::vector<std::string> start = examples();
        for (int i = 0; i < count; ++i) {
            const std::string text =
                i % 3 == 0 ? randomSoup(rng, 8) : mutated(rng, start[static_cast<std::size_t>(i) % start.size()]);
            const std::string once = formatted(text);
            const QByteArray story = q(text) + "\n---- becomes ----\n" + q(once);
            QVERIFY2(formatted(once) == once, (story + "\n---- and then ----\n" + q(formatted(once))).constData());
            QVERIFY2(substance(once) == substance(text), story.constData());
            sound += once != text;
        }
        QVERIFY(sound > count / 100); // otherwise nearly all texts were invalid and nothing was tested
    }
};

QTEST_APPLESS_MAIN(FormatterTest)
#include "formatter_test.moc"
