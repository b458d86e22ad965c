// Printing a tree reproduces arbitrary bytes; tokens cover each byte exactly once.

#include <QTest>

#include "lang/texts.h"

using namespace trundle;
using namespace texts;

namespace {

/// Empty when the text round-trips, otherwise what is wrong.
QByteArray faultOf(const std::string& text) {
    const auto tree = parsed(text);
    if (print(*tree) != text) return "printed text differs";
    std::uint32_t end = 0;
    for (const Token& token : tree->tokens()) {
        if (token.range.begin != end || token.range.end < token.range.begin) return "tokens do not touch";
        if (token.kind != TokenKind::End && token.range.size() == 0) return "an empty token";
        end = token.range.end;
    }
    if (end != text.size()) return "tokens stop early";
    if (tree->tokens().back().kind != TokenKind::End) return "no token at the end";
    for (const Diagnostic& d : tree->diagnostics()) {
        if (d.range.range.end < d.range.range.begin || d.range.range.end > text.size()) return "a message outside the text";
        for (const Fix& fix : d.fixes)
            for (const TextEdit& edit : fix.edits)
                if (edit.range.range.end < edit.range.range.begin || edit.range.range.end > text.size())
                    return "a fix outside the text";
    }
    if (tree->diagnostics().size() > 101) return "too many messages";
    messages(*tree);
    return {};
}

} // namespace

class LosslessTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void faultCase_data() {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, std::string_view text) { QTest::newRow(name) << q(text); };
        row("nothing", "");
        row("BOM alone", "\xEF\xBB\xBF");
        row("BOM twice", "\xEF\xBB\xBF\xEF\xBB\xBFx = 1");
        row("half a BOM", "\xEF\xBB");
        row("NUL", std::string_view("x = \0 1", 7));
        row("broken UTF-8", "x = \xC3\x28 \xFF y = 2");
        row("cut code point", "x = \xE2\x88");
        row("overlong", "\xC0\xAF = 1");
        row("surrogate", "\xED\xA0\x80");
        row("lone CRs", "x = 1\ry = 2\r\rz = 3");
        row("mixed line ends", "x = 1\r\ny = 2\nz = 3\r");
        row("LF CR", "x = 1\n\ry = 2");
        row("no final newline", "x = 1");
        row("tabs", "\tx\t=\t1\t");
        row("minus of the thesis", "x = \xE2\x88\x92"
                                   "3");
        row("open string", "x = \"abc");
        row("escape at the end", "x = \"abc\\");
        row("escaped quote at the end", "x = \"abc\\\"");
        row("open comment", "x = 1 /* abc");
        row("comment end", "x = 1 */ y");
        row("slash at the end", "x = a/");
        row("hash at the end", "#");
        row("directive at the end", "#import");
        row("directive and blanks", "#import   ");
        row("dollar", "$ $( $) $a $(a");
        row("signs", "+ - . , = { } ( ) / * ^ % & ! ? ; : < > [ ] | ~ @ ` ' \\");
        row("UTF-16", std::string_view("\xFF\xFEx\0 \0=\0", 8));
        row("vertical tab and form feed", "x\v=\f1");
    }
    void faultCase() {
        QFETCH(QByteArray, text);
        QCOMPARE(faultOf(text.toStdString()), QByteArray());
    }

    void everyBeginningOfTheExamples() {
        for (const std::string& text : examples())
            for (std::size_t end = 0; end <= text.size(); ++end) QCOMPARE(faultOf(text.substr(0, end)), QByteArray());
    }

    void mutationsOfTheExamples() {
        RandomNumbers rng(1);
        const int count = longRun() ? 20000 : 1000;
        const std::vector<std::string> start = examples();
        for (int i = 0; i < count; ++i) {
            const std::string text = mutated(rng, start[static_cast<std::size_t>(i) % start.size()]);
            const QByteArray fault = faultOf(text);
            QVERIFY2(fault.isEmpty(), (fault + ": " + q(text).toPercentEncoding(" \n")).constData());
        }
    }

    void randomBytesAndSoup() {
        RandomNumbers rng(2);
        const int count = longRun() ? 20000 : 2000;
        for (int i = 0; i < count; ++i) {
            const std::string text = i % 2 ? randomBytes(rng, 200) : randomSoup(rng, 60);
            const QByteArray fault = faultOf(text);
            QVERIFY2(fault.isEmpty(), (fault + ": " + q(text).toPercentEncoding(" \n")).constData());
        }
    }

    /// Inputs that would cost a naive parser quadratic time, or overflow its stack.
    void longShapes_data() {
        QTest::addColumn<QByteArray>("piece");
        for (const char* piece : {"{",
                                  "}",
                                  "a {\n",
                                  "a b {\n x=1\n",
                                  "(",
                                  "X=$(",
                                  "X=$((((",
                                  "-",
                                  "+1",
                                  "a.",
                                  "a . ",
                                  "1 a ",
                                  "X = a ",
                                  "X = 1 ",
                                  "min(",
                                  "\"",
                                  "x=\"",
                                  "#import \"",
                                  "'",
                                  "\xE2\x80\x9C",
                                  "/*",
                                  "/**/a ",
                                  "//",
                                  "\\",
                                  "@",
                                  "\r",
                                  "x=1*",
                                  "[",
                                  "x=[",
                                  "a:",
                                  "x=1,\n",
                                  ",",
                                  "$",
                                  "${",
                                  "\xFF",
                                  "\xFF"
                                  "a",
                                  "#",
                                  "#a\n",
                                  "a b\n",
                                  "1.",
                                  "e",
                                  "x=- "})
            QTest::newRow(piece) << QByteArray(piece);
    }
    void longShapes() {
        QFETCH(QByteArray, piece);
        const int count = longRun() ? 1000000 : 100000;
        const std::string text = ("X = $(1" + piece.repeated(count)).toStdString();
        QCOMPARE(faultOf(text), QByteArray());
        const std::string bare = piece.repeated(count).toStdString();
        QCOMPARE(faultOf(bare), QByteArray());
        QVERIFY(parsed(bare)->tokens().size() <= bare.size() + 1);
    }
};

QTEST_APPLESS_MAIN(LosslessTest)
#include "lossless_test.moc"
