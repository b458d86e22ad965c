// Lines and columns of a text.
#include <QTest>

#include "base/utf8.h"

#include "lang/texts.h"

using namespace trundle;
using namespace texts;

class SourceTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void positions_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("offset");
        QTest::addColumn<int>("line");
        QTest::addColumn<int>("column");
        const auto row = [](const char* name, std::string_view text, int offset, int line, int column) {
            QTest::newRow(name) << q(text) << offset << line << column;
        };
        row("start", "abc", 0, 1, 1);
        row("end of file", "abc", 3, 1, 4);
        row("beyond the end", "abc", 99, 1, 4);
        row("LF", "a\nb", 2, 2, 1);
        row("CR LF", "a\r\nb", 3, 2, 1);
        row("on the LF of CR LF", "a\r\nb", 2, 1, 3);
        row("lone CR", "a\rb", 2, 2, 1);
        row("LF CR is two ends", "a\n\rb", 3, 3, 1);
        row("a tab is one column", "\t\tb", 2, 1, 3);
        row("a BOM is none",
            "\xEF\xBB\xBF"
            "ab",
            4, 1, 2);
        row("two bytes, one column",
            "\xC3\xA4"
            "b",
            2, 1, 2);
        row("four bytes, one column",
            "\xF0\x9F\x98\x80"
            "b",
            4, 1, 2);
        row("inside a code point",
            "\xC3\xA4"
            "b",
            1, 1, 1);
        row("a broken byte is one column",
            "\xFF\xFF"
            "b",
            2, 1, 3);
        row("after the last line end", "a\n", 2, 2, 1);
    }
    void positions() {
        QFETCH(QByteArray, text);
        QFETCH(int, offset);
        const LineColumn at = SourceText("t", text.toStdString()).position(static_cast<std::uint32_t>(offset));
        QTEST(static_cast<int>(at.line), "line");
        QTEST(static_cast<int>(at.column), "column");
    }

    void linesHaveNoLineEnds() {
        const SourceText text("t", "one\r\ntwo\rthree\n");
        QCOMPARE(text.lineCount(), 4u);
        QCOMPARE(q(text.line(1)), QByteArray("one"));
        QCOMPARE(q(text.line(2)), QByteArray("two"));
        QCOMPARE(q(text.line(3)), QByteArray("three"));
        QCOMPARE(q(text.line(4)), QByteArray(""));
        QCOMPARE(q(text.line(5)), QByteArray(""));
        QCOMPARE(q(text.line(0)), QByteArray(""));
    }

    /// Line and column are computed from sparse checkpoints and equal those counted from the beginning.
    void placesInLongTextsAreExact() {
        std::string bytes = "\xEF\xBB\xBF";
        const char* const pieces[] = {"a", "\n", "\r\n", "\r", "\xC3\xA4", "\xF0\x9F\x98\x80", "\xFF", "long words here", "\t"};
        std::uint32_t rng = 1;
        for (int i = 0; i < 12'000; ++i) bytes += pieces[((rng = rng * 1664525 + 1013904223) >> 20) % 9];
        bytes += std::string(20'000, 'x') + "\r\nend";
        const SourceText text("t", bytes);
        std::uint32_t line = 1, column = 1, begin = 0;
        for (std::uint32_t at = 3; at < bytes.size();) {
            const LineColumn place = text.position(at);
            QVERIFY2(place.line == line && place.column == column, std::to_string(at).c_str());
            const std::uint32_t length = codePointAt(bytes, at).length;
            const bool crOfCrLf = bytes[at] == '\r' && at + 1 < bytes.size() && bytes[at + 1] == '\n';
            if ((bytes[at] == '\n' || bytes[at] == '\r') && !crOfCrLf) {
                std::uint32_t end = at;
                if (bytes[at] == '\n' && end > begin && bytes[end - 1] == '\r') --end;
                QVERIFY2(text.line(line) == std::string_view(bytes).substr(begin, end - begin), std::to_string(line).c_str());
                ++line;
                column = 1;
                begin = at + 1;
            } else {
                ++column;
            }
            at += length;
        }
        QCOMPARE(text.lineCount(), line);
        QCOMPARE(text.line(line), std::string_view("end"));
    }

    void slicesStayInside() {
        const SourceText text("t", "abc");
        QCOMPARE(q(text.slice({1, 3})), QByteArray("bc"));
        QCOMPARE(q(text.slice({1, 99})), QByteArray("bc"));
        QCOMPARE(q(text.slice({99, 100})), QByteArray(""));
        SourceTable table;
        QCOMPARE(q(table.slice({7, {0, 1}})), QByteArray(""));
        const FileId file = table.add(std::make_shared<const SourceText>("t", "abc"));
        QCOMPARE(q(table.slice({file, {0, 2}})), QByteArray("ab"));
        table.replace(file, std::make_shared<const SourceText>("t", "xyz"));
        QCOMPARE(q(table.slice({file, {0, 2}})), QByteArray("xy"));
    }
};

QTEST_APPLESS_MAIN(SourceTextTest)
#include "source_text_test.moc"
