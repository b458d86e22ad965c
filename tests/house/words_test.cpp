// No source and no page of the guide uses a word that core/README.md#words replaces.

#include <QtTest>

#include "house/words.h"

using namespace trundle;

namespace {

QStringList shown(const QList<WordHit>& hits) {
    QStringList lines;
    for (const WordHit& hit : hits)
        lines << QString("%1:%2: '%3'; use: %4").arg(hit.path, QString::number(hit.line), hit.word, hit.instead);
    return lines;
}

} // namespace

class WordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    // The word list finds what it should; without this the next test could pass on an empty list.
    void findsWordInNamesTextsAndComments_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("found"); // the matches, in order
        QTest::newRow("a comment") << "core/x.cpp"
                                   << "int a; // the fate of a frame\n"
                                   << "fate";
        QTest::newRow("a type") << "core/x.h"
                                << "struct RadioReckoner;\n"
                                << "Reckoner";
        QTest::newRow("a constant") << "core/x.h"
                                    << "int kFates = 3;\n"
                                    << "Fates";
        QTest::newRow("a member") << "editor/x.h"
                                  << "Desk m_desk;\n"
                                  << "Desk desk";
        QTest::newRow("two words in a name") << "editor/x.h"
                                             << "void bringBack();\n"
                                             << "bringBack";
        QTest::newRow("two words in a text") << "editor/x.cpp"
                                             << "f(\"Bring back\");\n"
                                             << "Bring back";
        QTest::newRow("a text of the product") << "editor/x.cpp"
                                               << "f(\"It stands there\");\n"
                                               << "stands";
        QTest::newRow("the same in a test") << "tests/x.cpp"
                                            << "f(\"It stands there\");\n"
                                            << "";
        QTest::newRow("the same in a comment") << "editor/x.cpp"
                                               << "f(\"It\"); // stands there\n"
                                               << "";
        QTest::newRow("the guide") << "resources/guide/x.md"
                                   << "Nobody stands there.\n"
                                   << "stands Nobody";
        QTest::newRow("a raw text") << "app/x.cpp"
                                    << "f(R\"(// it\n \"knows\")\"); // knows\n"
                                    << "knows";
        QTest::newRow("part of another word") << "core/x.cpp"
                                              << "int indeed, extend, intelligent, mention1, recommended;\n"
                                              << "mention";
        QTest::newRow("what a log holds") << "core/run/logs/radio_rows.cpp"
                                          << "f(\"fate\");\n"
                                          << "";
    }
    void findsWordInNamesTextsAndComments() {
        QFETCH(QString, path);
        QFETCH(QString, text);
        QFETCH(QString, found);
        QStringList words;
        for (const WordHit& hit : forbiddenWords({path, text})) words << hit.word;
        QCOMPARE(words.join(' '), found);
    }

    void reportsLineAndReplacement() {
        const auto hits = forbiddenWords({"core/x.cpp", "/* two\n lines */\nint a;\nauto b = \"goes\"; int mended = 0;\n"});
        QCOMPARE(shown(hits).join('\n'), QString("core/x.cpp:4: 'mended'; use: fix"));
    }

    void sourcesUseNoForbiddenWord() {
        QStringList found;
        int files = 0;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app", "plugins", "tests", "resources/guide"},
                                                  {".h", ".cpp", ".hpp", ".inl", ".c", ".md"})) {
            const bool guide = file.path.startsWith("resources/guide/");
            if (file.path.endsWith(".md") != guide) continue;
            if (file.path.startsWith("tests/data/") || file.path.startsWith("tests/house/words")) continue;
            ++files;
            found << shown(forbiddenWords(file));
        }
        QVERIFY(files > 700);
        QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
    }
};

QTEST_APPLESS_MAIN(WordsTest)
#include "words_test.moc"
