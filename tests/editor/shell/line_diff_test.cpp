// The line diff of the recovery preview.

#include <QtTest>

#include "editor/shell/line_diff.h"

using namespace trundle;

class LineDiffTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void diffShowsContextLines() {
        const auto lines = diffLines("a\nb\nc\nd\ne\nf\ng\n", "a\nb\nc\nX\ne\nf\ng\n", 1);
        QStringList shown;
        for (const DiffLine& line : lines) {
            const char* mark = line.kind == DiffLine::Kind::Added     ? "+"
                               : line.kind == DiffLine::Kind::Removed ? "-"
                               : line.kind == DiffLine::Kind::Gap     ? "~"
                                                                      : " ";
            shown << QLatin1String(mark) + line.text;
        }
        QCOMPARE(shown.join(u'|'), QStringLiteral("~| c|-d|+X| e|~"));
    }
    void equalTextsDifferInNothing() {
        for (const DiffLine& line : diffLines("a\r\nb", "a\r\nb")) QVERIFY(line.kind == DiffLine::Kind::Gap);
    }
    void anEmptyTextIsAllNew() {
        const auto lines = diffLines("", "a\nb\n");
        QCOMPARE(lines.size(), std::size_t(2));
        QVERIFY(lines[0].kind == DiffLine::Kind::Added);
    }
};

QTEST_APPLESS_MAIN(LineDiffTest)
#include "line_diff_test.moc"
