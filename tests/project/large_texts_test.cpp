// Large texts with many errors: their cost is bounded.

#include <QTest>

#include "sample_project.h"

using namespace trundle;
using sample::ProjectFixture;

class LargeTextsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void mistakesThatStayEndTheReading_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("end");
        QTest::addColumn<bool>("whole"); ///< valid, so all of it must be read
        QTest::newRow("unknown Params") << QByteArray("Param p% = $(q%)\n") << QByteArray() << false;
        QTest::newRow("one of them is defined") << QByteArray("Param p% = $(q%)\n") << QByteArray("Param q7 = 1\n") << false;
        QTest::newRow("circles") << QByteArray("Param p% = $(p%)\n") << QByteArray() << false;
        QTest::newRow("unknown configs") << QByteArray("Robot r% { Config=c% }\n") << QByteArray() << false;
        QTest::newRow("one unknown config") << QByteArray("Robot r% { Config=c }\n") << QByteArray() << false;
        QTest::newRow("unknown kinds") << QByteArray("Foo f% { A=1 } // #%\n") << QByteArray() << false;
        QTest::newRow("modules") << QByteArray("#loadModule missing%\n") << QByteArray() << false;
        QTest::newRow("imports") << QByteArray("#import missing%\n") << QByteArray() << false;
        QTest::newRow("pictures") << QByteArray("Material m% { Texture=no% }\n") << QByteArray() << false; // warnings
        QTest::newRow("keys") << QByteArray("Light l% { Sped=1 }\n") << QByteArray() << false;
        QTest::newRow("a Param that comes last") << QByteArray("Param p% = $(q)\n") << QByteArray("Param q = 1\n") << true;
        QTest::newRow("a Param that is imported last")
            << QByteArray("Param p% = $(q)\n") << QByteArray("#import q.sim\n") << true;
        QTest::newRow("a module that comes last")
            << QByteArray("Robot r% { Config=c Pos=%,0,0 Walker w { Speed=0.1 } }\n")
            << QByteArray("#loadModule walker\nRobotConfig c { Body b { Box g { Size=1,1,1 Mass=1 } } }\n") << true;
    }
    /// The cost of a text with many errors is bounded, and reading does not stop while the rest could still make the text valid.
    void mistakesThatStayEndTheReading() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, end);
        QFETCH(bool, whole);
        ProjectFixture fixture;
        fixture.write("q.sim", "Param q = 1\n");
        std::string text;
        const int lines = line.startsWith('#')                ? 90'000
                          : line.startsWith("Robot") && whole ? 12'000
                                                              : 30'000; // beyond the first part
        for (int i = 0; i < lines; ++i) text += QByteArray(line).replace('%', QByteArray::number(i)).toStdString();
        text += end.toStdString();
        const auto loaded = fixture.open(text);
        const Tree& tree = *loaded->trees[0];
        if (whole) {
            QCOMPARE(tree.extent(), Tree::Extent::Whole);
            QVERIFY2(!loaded->diagnostics.hasErrors(), sample::messages(*loaded).substr(0, 2000).c_str());
        } else {
            QCOMPARE(tree.extent(), Tree::Extent::Limited);
            QVERIFY2(tree.tokens().size() < 300'000, QByteArray::number(qulonglong(tree.tokens().size())));
            QVERIFY(loaded->diagnostics.all().size() <= 2 * Diagnostics::kMaxOfOneFile + 2);
            QCOMPARE(loaded->diagnostics.all().back().code, Code::TooManyMistakes);
        }
    }
    /// Beyond the first missing files, folders are listed instead of looked into for each name.
    void manyMissingPicturesHideNoOther() {
        ProjectFixture fixture;
        for (const char* name : {"plain.png", "short.png", "\u00fcber.png", "sub/inner.png", "Big.PNG"}) fixture.write(name, "");
        std::string text;
        for (int i = 0; i < 300; ++i) text += "Material m" + std::to_string(i) + " { Texture=gone" + std::to_string(i) + " }\n";
        const std::string present = "Material a { Texture=plain.png }\nMaterial b { Texture=short }\n"
                                    "Material c { Texture=\"\u00fcber.png\" }\nMaterial d { Texture=\"sub/inner.png\" }\n"
                                    "Material e { Texture=\"./sub/../plain.png\" }\nMaterial f { Texture=Big.PNG }\n";
        const auto loaded = fixture.open(text + present + "Material g { Texture=\"sub/gone.png\" }\n");
        std::size_t missing = 0;
        for (const Diagnostic& d : loaded->diagnostics.all()) missing += d.code == Code::MeshUnreadable;
        QCOMPARE(missing, std::size_t(301));
    }
    /// A name that is defined, a module or a file that is imported far behind its uses, does not keep a large text from being ended.
    void farDefinitionsDoNotCount_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("end");
        const QByteArray robot = "Robot r% { Config=c Pos=%,0,0 leftMotor.Resistance=3 }\n";
        QTest::newRow("config") << robot << QByteArray("RobotConfig c { Body b { Box g { Size=1,1,1 Mass=1 } } }\n");
        QTest::newRow("import") << robot << QByteArray("#import c.sim\n");
        QTest::newRow("Param") << QByteArray("Param p% = $(q)\n") << QByteArray("Param q = 1\n");
    }
    void farDefinitionsDoNotCount() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, end);
        ProjectFixture fixture;
        std::string text;
        for (int i = 0; text.size() < (8u << 20); ++i) text += QByteArray(line).replace('%', QByteArray::number(i)).toStdString();
        const auto loaded = fixture.open(text + end.toStdString());
        QCOMPARE(loaded->trees[0]->extent(), Tree::Extent::Limited);
        QCOMPARE(loaded->diagnostics.all().back().code, Code::TooManyMistakes);
        QVERIFY2(loaded->trees[0]->tokens().size() < 1'100'000, QByteArray::number(qulonglong(loaded->trees[0]->tokens().size())));
    }
    /// Warnings, of pictures that are missing, end it sooner.
    void manyWarningsEndTheReading() {
        ProjectFixture fixture;
        std::string text;
        for (int i = 0; text.size() < (8u << 20); ++i)
            text += "Material m" + std::to_string(i) + " { Texture=no" + std::to_string(i) + " }\n";
        fixture.write("c.sim", "");
        text += "#import c.sim\n"; // could change any of them
        const auto loaded = fixture.open(text);
        QCOMPARE(loaded->trees[0]->extent(), Tree::Extent::Limited);
        QCOMPARE(loaded->diagnostics.all().back().code, Code::TooManyMistakes);
        QVERIFY2(loaded->trees[0]->tokens().size() < 550'000, QByteArray::number(qulonglong(loaded->trees[0]->tokens().size())));
    }
    /// A long word counts as several, and a name that no file can have is neither looked for nor watched.
    void longNames() {
        ProjectFixture fixture;
        const std::string letters(1200, 'n');
        std::string text, deep;
        for (int i = 0; text.size() < (16u << 20); ++i)
            text += "Material m" + std::to_string(i) + " { Texture=" + letters + std::to_string(i) + " }\n";
        const auto loaded = fixture.open(text);
        QCOMPARE(loaded->trees[0]->extent(), Tree::Extent::Limited);
        QVERIFY2(loaded->trees[0]->readTo() < 11u << 20, QByteArray::number(loaded->trees[0]->readTo()));
        QVERIFY(loaded->named.empty());
        for (int i = 0; i < 10; ++i) deep += "folder_with_quite_a_long_name_" + std::to_string(i) + "/";
        fixture.write(deep + "picture.png", "");
        for (const char* sign : {"/", "\\\\"}) {
            const std::string written = QString::fromStdString(deep + "picture").replace('/', QLatin1String(sign)).toStdString();
            const auto found =
                fixture.open("Material m { Texture=\"" + written + "\" }\nMaterial n { Texture=" + letters + " }\n");
            QVERIFY2(found->named.size() == 1, sample::messages(*found).c_str());
            QVERIFY2(!found->named.begin()->second.path.empty(), written.c_str());
            QVERIFY2(sample::messages(*found).find("no file has so long a name") != std::string::npos,
                     sample::messages(*found).substr(0, 300).c_str());
        }
    }
    /// Without mistakes, too: all texts together have a limit, and what is beyond it is the only error, at its place.
    void aTextWithoutMistakesHasALimit() {
        ProjectFixture fixture;
        std::string rows, more;
        for (int i = 0; i < 5000; ++i) rows += "Param p" + std::to_string(i) + " = 1\n"; // of 8 tokens each
        for (int i = 0; i < 5000; ++i) more += "Param q" + std::to_string(i) + " = $(p1)\n";
        fixture.write("rows.sim", rows);
        const std::string text = more + "#import rows.sim\n";
        fixture.options.mostTokens = 150'000;
        QVERIFY(!fixture.open(text)->diagnostics.hasErrors());
        fixture.options.mostTokens = 60'000; // ends in the imported file
        const auto loaded = fixture.open(text);
        QCOMPARE(loaded->diagnostics.all().size(), std::size_t{1});
        const Diagnostic& error = loaded->diagnostics.all()[0];
        QCOMPARE(error.code, Code::TooLarge);
        QVERIFY2(error.message.find("may hold 60000 words, signs and blanks") != std::string::npos, error.message.c_str());
        QVERIFY(error.range.file == 1 && error.range.range.begin > 0);
        QCOMPARE(error.range.range.begin, loaded->trees[1]->readTo());
    }
};

QTEST_APPLESS_MAIN(LargeTextsTest)
#include "large_texts_test.moc"
