// The line diff of the recovery preview.

#include <QtTest>

#include "editor/shell/dialogs/line_diff.h"

using namespace trundle;

class LineDiffTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void diffShowsContextLines() {
        QCOMPARE(shown("a\nb\nc\nd\ne\nf\ng\n", "a\nb\nc\nX\ne\nf\ng\n", 1), QStringLiteral("~| c|-d|+X| e|~"));
    }
    /// Between two changes: all lines where their contexts meet, else those next to each.
    void contextOfTwoChanges() {
        const char* before = "a\nb\nc\nd\ne\nf\ng\n";
        QCOMPARE(shown(before, "a\nX\nc\nd\ne\nY\ng\n", 1), QStringLiteral(" a|-b|+X| c|~| e|-f|+Y| g"));
        QCOMPARE(shown(before, "a\nX\nc\nd\nY\nf\ng\n", 1), QStringLiteral(" a|-b|+X| c| d|-e|+Y| f|~"));
        QCOMPARE(shown(before, "X\nb\nc\nd\ne\nf\nY\n", 2), QStringLiteral("-a|+X| b| c|~| e| f|-g|+Y"));
    }

private:
    static QString shown(const char* before, const char* after, int context) {
        const auto lines = diffLines(before, after, context);
        QStringList shown;
        for (const DiffLine& line : lines) {
            const char* mark = line.kind == DiffLine::Kind::Added     ? "+"
                               : line.kind == DiffLine::Kind::Removed ? "-"
                               : line.kind == DiffLine::Kind::Gap     ? "~"
                                                                      : " ";
            shown << QLatin1String(mark) + line.text;
        }
        return shown.join(u'|');
    }

private Q_SLOTS:
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
