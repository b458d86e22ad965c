// Three-way merge of texts by lines.
#include <QTest>

#include <random>

#include "lang/line_merge.h"
#include "lang/text_splice.h"

using namespace trundle;

class LineMergeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void merges_data() {
        QTest::addColumn<QString>("base");
        QTest::addColumn<QString>("mine");
        QTest::addColumn<QString>("theirs");
        QTest::addColumn<QString>("merged"); // "?": conflict
        const auto row = [](const char* name, const char* base, const char* mine, const char* theirs, const char* merged) {
            QTest::newRow(name) << base << mine << theirs << merged;
        };
        row("nothing", "a\nb\n", "a\nb\n", "a\nb\n", "a\nb\n");
        row("mine only", "a\nb\n", "x\nb\n", "a\nb\n", "x\nb\n");
        row("theirs only", "a\nb\n", "a\nb\n", "a\nx\n", "a\nx\n");
        row("far apart", "a\nb\nc\n", "x\nb\nc\n", "a\nb\ny\n", "x\nb\ny\n");
        row("same line", "a\nb\nc\n", "a\nx\nc\n", "a\ny\nc\n", "?");
        row("side by side", "a\nb\nc\n", "x\nb\nc\n", "a\ny\nc\n", "?");
        row("alike", "a\nb\nc\n", "a\nx\nc\n", "a\nx\nc\n", "a\nx\nc\n");
        row("alike and more", "a\nb\nc\nd\ne\n", "a\nx\nc\nd\ne\n", "a\nx\nc\nd\ny\n", "a\nx\nc\nd\ny\n");
        row("both append", "a\n", "a\nx\n", "a\ny\n", "?");
        row("append and prepend", "a\n", "a\nx\n", "y\na\n", "y\na\nx\n"); // one line between is enough
        row("one removes, other changes", "a\nb\nc\n", "a\nc\n", "a\ny\nc\n", "?");
        row("both remove", "a\nb\nc\n", "a\nc\n", "a\nc\n", "a\nc\n");
        row("no last line end", "a\nb\nc", "a\nb\nx", "y\nb\nc", "y\nb\nx");
        row("line ends of Windows", "a\r\nb\r\nc\r\n", "x\r\nb\r\nc\r\n", "a\r\nb\r\ny\r\n", "x\r\nb\r\ny\r\n");
        row("from nothing", "", "a\n", "", "a\n");
        row("from nothing both", "", "a\n", "b\n", "?");
        row("to nothing", "a\nb\n", "", "a\nb\n", "");
        row("repeated lines", "}\n}\n}\n}\n}\n", "}\nx\n}\n}\n}\n}\n", "}\n}\n}\n}\ny\n}\n", "}\nx\n}\n}\n}\ny\n}\n");
    }
    void merges() {
        QFETCH(QString, base);
        QFETCH(QString, mine);
        QFETCH(QString, theirs);
        QFETCH(QString, merged);
        const auto result = mergedByLines(base.toStdString(), mine.toStdString(), theirs.toStdString());
        QCOMPARE(result ? QString::fromStdString(*result) : QString("?"), merged);
        const auto other = mergedByLines(base.toStdString(), theirs.toStdString(), mine.toStdString());
        QCOMPARE(other, result);
    }

    // If only one side changed, the result is that side.
    void keepsChangeOfOneSide() {
        std::mt19937 random(7);
        for (int round = 0; round < 500; ++round) {
            const auto text = [&] {
                std::string t;
                for (std::uint32_t lines = random() % 30; lines > 0; --lines) t += std::string(1, 'a' + random() % 4) + "\n";
                return t;
            };
            const std::string base = text(), changed = text();
            QCOMPARE(mergedByLines(base, changed, base), std::optional(changed));
            QCOMPARE(mergedByLines(base, base, changed), std::optional(changed));
        }
    }

    void twoFarEditsOfALongText() {
        std::string base, mine, theirs, both;
        for (int i = 0; i < 20000; ++i) {
            const std::string line = "line " + std::to_string(i) + "\n";
            base += line;
            mine += i < 3000 ? "mine " + line : line;
            theirs += i > 15000 ? "theirs " + line : line;
            both += i < 3000 ? "mine " + line : i > 15000 ? "theirs " + line : line;
        }
        QVERIFY(mergedByLines(base, mine, theirs) == both);
    }

    void splices() {
        std::mt19937 random(3);
        for (int round = 0; round < 1000; ++round) {
            const auto text = [&] {
                std::string t;
                for (std::uint32_t bytes = random() % 12; bytes > 0; --bytes) t += static_cast<char>('a' + random() % 2);
                return t;
            };
            const std::string before = text(), after = text();
            const TextSplice splice = spliceBetween(before, after);
            QCOMPARE(spliced(before, splice), after);
            QCOMPARE(unspliced(after, splice), before);
            QCOMPARE(splice.empty(), before == after);
            const std::string last = text();
            const TextSplice both = joined(splice, spliceBetween(after, last), after);
            QCOMPARE(spliced(before, both), last);
            QCOMPARE(unspliced(last, both), before);
        }
    }
};

QTEST_APPLESS_MAIN(LineMergeTest)
#include "line_merge_test.moc"
