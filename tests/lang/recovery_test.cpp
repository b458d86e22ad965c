// Invalid texts and the complete message of each, read from recovery_cases.txt in this form:
//   ==== name
//   the text
//   ----
//   the messages

#include <QFile>
#include <QTest>

#include "lang/texts.h"
#include "lang/tree_edit.h"

using namespace trundle;
using namespace texts;

class RecoveryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cases_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("messages");
        QFile file(QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/lang/recovery_cases.txt"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray all = "\n" + file.readAll();
        int count = 0;
        for (qsizetype at = all.indexOf("\n==== "); at >= 0;) {
            const qsizetype next = all.indexOf("\n==== ", at + 1);
            const QByteArray one = all.mid(at + 6, next < 0 ? -1 : next + 1 - at - 6);
            const qsizetype nameEnd = one.indexOf('\n');
            const qsizetype middle = one.indexOf("\n----\n");
            QVERIFY2(middle > 0, one.constData());
            QTest::newRow(one.left(nameEnd).constData()) << one.mid(nameEnd + 1, middle - nameEnd - 1) << one.mid(middle + 6);
            ++count;
            at = next;
        }
        QVERIFY(count > 50);
    }
    void cases() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, messages);
        const auto tree = parsed(text.toStdString());
        const QByteArray said = q(texts::messages(*tree));
        if (said != messages) qInfo("%s", said.constData());
        QCOMPARE(said, messages);
        QVERIFY(!tree->diagnostics().empty());
        // Offered fixes must not add errors.
        for (const Diagnostic& d : tree->diagnostics()) {
            if (d.fixes.empty()) continue;
            const auto repaired = applied(*tree, d.fixes[0]);
            QVERIFY2(repaired->diagnostics().size() < tree->diagnostics().size(),
                     (q(d.message) + "\n" + q(repaired->source().bytes()) + "\n" + q(texts::messages(*repaired))).constData());
        }
    }

    void fixes_data() {
        QTest::addColumn<QByteArray>("broken");
        QTest::addColumn<QByteArray>("fixed");
        const auto row = [](const char* broken, const char* fixed) {
            QTest::newRow(broken) << QByteArray(broken) << QByteArray(fixed);
        };
        row("+$n", "$n");
        row("-$n", "$(-n)");
        row("+$(n + 1)", "$(n + 1)");
        row("-$(n + 1)", "$(-(n + 1))");
        row("2, -$n, 4", "2, $(-n), 4");
        row("- 3", "-3");
        row("+ 3 cm", "3 cm");
        row("7, - 3 cm, 8", "7, -3 cm, 8");
        row("0.3 m /s", "0.3 m/s");
        row("1, 9.81 m/s ^2, 2", "1, 9.81 m/s^2, 2");
        row("3 N /m, 4", "3 N/m, 4");
        row("0x1F", "31");
        row("0XfF, 1", "255, 1");
        row("12_345", "12345");
        row("1.5f", "1.5");
        row("(1, 2)", "1, 2");
        row("[3, 4, 5]", "3, 4, 5");
        row("{6, 7}", "6, 7");
        row("1; 2; 3", "1, 2, 3");
        row("1 2 3", "1, 2, 3");
        row("'one'", "\"one\"");
        row("a@b, d", "\"a@b\", d");
        row("2*0.05", "$(2*0.05)");
        row("1 - $n", "$(1 - n)");
        row("$n/2", "$(n/2)");
    }
    /// The fix of one mistake in a value: the text that it gives, and what was read meanwhile is what the fixed text says.
    void fixes() {
        QFETCH(QByteArray, broken);
        QFETCH(QByteArray, fixed);
        const auto tree = parsed("Param n = 1\nx = " + broken.toStdString() + "\ny = 1\n");
        QCOMPARE(tree->diagnostics().size(), std::size_t{1});
        const Diagnostic& d = tree->diagnostics()[0];
        QVERIFY(!d.fixes.empty());
        const auto repaired = applied(*tree, d.fixes[0]);
        QByteArray text = q(repaired->source().bytes());
        QCOMPARE(text.replace(", ", ",").replace(" ", ""),
                 ("Paramn=1\nx=" + QByteArray(fixed).replace(", ", ",").replace(" ", "") + "\ny=1\n"));
        QVERIFY(repaired->diagnostics().empty());
        const auto elements = [](const Tree& t) { return t.items().at(1).as<AssignmentItem>()->value.elements; };
        const std::vector<Element> before = elements(*tree), after = elements(*repaired);
        for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
            if (before[i].kind != after[i].kind) continue; // arithmetic is only read in $( )
            QCOMPARE(before[i].text, after[i].text);
            if (broken.startsWith("0")) continue; // a hexadecimal number is not read
            QCOMPARE(before[i].unit, after[i].unit);
        }
    }

    /// What is not quoted may be a list, but not where a text is.
    void aTextIsNotOfferedAsAList() {
        const auto titles = [](const char* text) {
            std::vector<std::string> all;
            const auto tree = parsed(text);
            for (const Fix& fix : tree->diagnostics().at(0).fixes) all.push_back(fix.title);
            return all;
        };
        QCOMPARE(titles("Title = abc def\n"), std::vector<std::string>{"\"abc def\""});
        QCOMPARE(titles("Title = say \"hi\"\n"), std::vector<std::string>());
        QCOMPARE(titles("Motors = abc def\n"), (std::vector<std::string>{"abc, def", "\"abc def\""}));
    }

    /// Words for numbers that are not finite, with either sign and without.
    void numbersAreFinite() {
        for (const char* word : {"inf", "INF", "infinity", "Infinity", "nan", "NaN"})
            for (const char* sign : {"-", "+"}) {
                const auto tree = parsed(std::string("x = ") + sign + word + "\n");
                QCOMPARE(tree->diagnostics().size(), std::size_t{1});
                QCOMPARE(tree->diagnostics()[0].message, std::string("numbers are finite"));
                QCOMPARE(tree->diagnostics()[0].code, Code::BadNumber);
                QCOMPARE(tree->diagnostics()[0].range.range, (TextRange{4, 5 + std::uint32_t(strlen(word))}));
            }
        QCOMPARE(parsed("x = -fast\n")->diagnostics()[0].message, std::string("a word has no sign"));
    }

    /// One error for a run of bytes that are no text, and one for the next run.
    void bytesThatAreNoText() {
        const auto tree = parsed("a = \"\xff\xfe\xff\" \n b = \"\xe2\x82 \x80\x80\"\n");
        std::vector<std::uint32_t> places;
        for (const Diagnostic& d : tree->diagnostics())
            if (d.code == Code::InvalidBytes) places.push_back(d.range.range.begin);
        QCOMPARE(places, (std::vector<std::uint32_t>{5, 17, 20}));
        QVERIFY(tree->diagnostics()[0].message.find("0xFF") != std::string::npos);
    }

    /// An error loses at most its own line: the text after it is read.
    void recoversAfterError() {
        for (const char* broken : {"Pos = 1,2,", "x",        "x y z",       "= 3",      "Pos =",    "Pos = 0 0 0",
                                   "x == 3",     "x: 3",     "@@ !!",       "#frob",    "#import",  "x = $(1 +",
                                   "x = \"abc",  "x = 'abc", "1 2 3",       "x = 1..2", "x = [1,2", "Robot r { Pos = }",
                                   "Param x",    "a.b",      "a.",          ";",        ")",        "x = 5 }",
                                   "x = -",      "{ x=1 }",  "x = { y=1 }", "x = $",    "x = 1 + "}) {
            const auto tree = parsed(std::string("First = 1\n") + broken + "\nLast = 3\nRobot last { Mass = 1 }\n");
            const std::string story = std::string(broken) + "\n" + texts::messages(*tree);
            QVERIFY2(tree->diagnostics().size() >= 1 && tree->diagnostics().size() <= 3, story.c_str());
            QVERIFY2(tree->items().size() >= 3, story.c_str());
            const auto* robot = tree->items().back().as<BlockItem>();
            QVERIFY2(robot && robot->name && robot->name->text == "last" && robot->items.size() == 1, story.c_str());
            const auto* last = tree->items()[tree->items().size() - 2].as<AssignmentItem>();
            QVERIFY2(last && last->path[0].text == "Last" && last->value.elements.size() == 1, story.c_str());
        }
    }

    void limitsErrorCount() {
        const auto tree = parsed(QByteArray("x = ;\n").repeated(5000).toStdString());
        QCOMPARE(tree->diagnostics().size(), std::size_t(101));
        QVERIFY(tree->diagnostics().back().message.find("too many mistakes") != std::string::npos);
    }

    void readsLargeErrorsPartially_data() {
        QTest::addColumn<QByteArray>("head");
        QTest::addColumn<QByteArray>("piece");
        QTest::newRow("lines of nonsense") << QByteArray() << QByteArray("a b c\n");
        QTest::newRow("keys without values") << QByteArray() << QByteArray("a=\n");
        QTest::newRow("braces") << QByteArray() << QByteArray("{");
        QTest::newRow("open blocks") << QByteArray() << QByteArray("A {");
        QTest::newRow("signs") << QByteArray() << QByteArray("@");
        QTest::newRow("a list without an end") << QByteArray("Tick=") << QByteArray("1,");
        QTest::newRow("an expression without an end") << QByteArray("Tick=$(") << QByteArray("1+");
        QTest::newRow("a path without an end") << QByteArray() << QByteArray("a.");
        QTest::newRow("bytes that are no text") << QByteArray() << QByteArray("\xff a ");
    }
    /// The memory for an error does not grow with the text; the text stays complete, and everything before the error is read.
    void readsLargeErrorsPartially() {
        QFETCH(QByteArray, head);
        QFETCH(QByteArray, piece);
        const std::string text =
            "Robot first { Mass=1 }\n" + head.toStdString() + piece.repeated(2'000'000 / int(piece.size())).toStdString();
        const auto tree = parsed(text);
        QCOMPARE(tree->extent(), Tree::Extent::Unrecoverable);
        QVERIFY(tree->readTo() > 0 && tree->readTo() < text.size());
        QVERIFY2(tree->tokens().size() < 300'000, QByteArray::number(qulonglong(tree->tokens().size())));
        QVERIFY(print(*tree) == text);
        QVERIFY(tree->diagnostics().size() <= 101);
        QVERIFY(std::any_of(tree->diagnostics().begin(), tree->diagnostics().end(), [](const Diagnostic& d) {
            return d.message.find("the rest of this file is not read") != std::string::npos;
        }));
        QVERIFY(tree->items().front().as<BlockItem>() && tree->items().front().as<BlockItem>()->items.size() == 1);
    }

    void blankLinesAreTwoTokens_data() {
        QTest::addColumn<QByteArray>("piece");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CR LF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
        QTest::newRow("with blanks") << QByteArray(" \t \n");
    }
    /// White space between two items takes constant memory, whatever its length.
    void blankLinesAreTwoTokens() {
        QFETCH(QByteArray, piece);
        const std::string text = "A=1" + piece.repeated(100'000).toStdString() + "  B=2" + piece.repeated(3).toStdString();
        const auto tree = parsed(text);
        QCOMPARE(tree->extent(), Tree::Extent::Whole);
        QCOMPARE(tree->items().size(), std::size_t(2));
        QVERIFY2(tree->tokens().size() < 20, QByteArray::number(qulonglong(tree->tokens().size())));
        QVERIFY(print(*tree) == text);
        QCOMPARE(tree->source().position(tree->items()[1].range.begin).line, 100'001u);
    }

    void manyCommentsAreFewTokens_data() {
        QTest::addColumn<QByteArray>("piece");
        QTest::newRow("lines") << QByteArray("// why\n");
        QTest::newRow("empty lines of comment") << QByteArray("//\r\n");
        QTest::newRow("blocks") << QByteArray("/**/");
        QTest::newRow("blocks over lines") << QByteArray("/* a\n b */  \n");
    }
    void manyCommentsAreFewTokens() {
        QFETCH(QByteArray, piece);
        const std::string text = "A=1 " + piece.repeated(100'000).toStdString() + "B=2";
        const auto tree = parsed(text + "\n");
        QVERIFY2(tree->diagnostics().empty(), texts::messages(*tree).c_str());
        QCOMPARE(tree->items().size(), std::size_t(2));
        QVERIFY2(tree->tokens().size() < 1100, QByteArray::number(qulonglong(tree->tokens().size())));
        QVERIFY(print(*tree) == text + "\n");
        // A directive is still first on its line, and an unterminated comment is found after all the others.
        const auto directive = parsed(piece.repeated(2000).toStdString() + "\n#import a.sim\n/* open");
        QCOMPARE(directive->diagnostics().size(), std::size_t(1));
        QCOMPARE(directive->diagnostics()[0].code, Code::UnclosedComment);
    }

    /// The parser looks ahead at each line end in an expression: scanning the same comments repeatedly would take minutes.
    void continuesExpressionAfterComments() {
        const std::string comments = QByteArray("// one more\n").repeated(200'000).toStdString();
        const auto sum = parsed("Param a = $(1\n" + comments + "+ 2)\n");
        QVERIFY2(sum->diagnostics().empty(), texts::messages(*sum).c_str());
        QCOMPARE(sum->items().size(), std::size_t(1));
        const auto cut = parsed("Param a = $(1\n" + comments + "Param b = 2\n");
        QCOMPARE(cut->items().size(), std::size_t(2));
    }

    void wordsOfAMegabyteAreNamedInShort_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("name") << QByteArray("Robot ") << QByteArray(" { }");
        QTest::newRow("key") << QByteArray() << QByteArray(" = 1");
        QTest::newRow("text") << QByteArray("Title = \"") << QByteArray("\"");
        QTest::newRow("path") << QByteArray("#import ") << QByteArray();
        QTest::newRow("unit") << QByteArray("Tick = 1") << QByteArray();
        QTest::newRow("param") << QByteArray("Tick = $") << QByteArray();
    }
    void wordsOfAMegabyteAreNamedInShort() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        const auto tree = parsed((before + QByteArray(1 << 20, 'a') + after + "\nLast = 3\n").toStdString());
        QVERIFY(!tree->diagnostics().empty());
        for (const Diagnostic& d : tree->diagnostics()) QVERIFY2(d.message.size() < 300, d.message.substr(0, 300).c_str());
        QCOMPARE(std::count_if(tree->diagnostics().begin(), tree->diagnostics().end(),
                               [](const Diagnostic& d) { return d.code == Code::TooLarge; }),
                 1);
        QVERIFY(tree->items().back().as<AssignmentItem>());
        QCOMPARE(tree->items().back().as<AssignmentItem>()->path[0].text, std::string("Last"));
    }

    void aLimitOfTokensIsNoMistake() {
        std::string text;
        for (int i = 0; i < 20'000; ++i) text += "Robot r" + std::to_string(i) + " { Mass=1 Pos=1,2,3 }\n";
        const auto source = std::make_shared<const SourceText>("t", text);
        const auto part = parse(source, 0, 50'000), whole = parse(source, 0);
        QCOMPARE(part->extent(), Tree::Extent::Limited);
        QVERIFY(part->diagnostics().empty());
        QVERIFY(part->tokens().size() < 60'000 && print(*part) == text);
        QVERIFY(part->items().size() > 1000 && part->items().size() < whole->items().size());
        QCOMPARE(whole->extent(), Tree::Extent::Whole);
        QCOMPARE(whole->items().size(), std::size_t(20'000));
    }

private:
    static std::shared_ptr<const Tree> applied(const Tree& tree, const Fix& fix) { return applyEdits(tree, fix.edits).value(); }
};

QTEST_APPLESS_MAIN(RecoveryTest)
#include "recovery_test.moc"
