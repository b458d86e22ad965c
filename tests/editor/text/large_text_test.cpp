// Texts that are too large to be shown in full, and marks that are set from outside the editor.

#include <malloc.h>

#include <QDir>
#include <QLabel>
#include <QPushButton>

#include "editor/text/pages/large_text.h"
#include "editor/text/text_fixture.h"
#include "eventually.h"
#include "project/journal/state_folder.h"

using namespace trundle;
using namespace trundle::test;

class LargeTextTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void showsLargeTextsOnRequest();
    void aLargeTextIsNotCopied();
    void typingCopiesALargeTextOnce();
    void longLinesAreNotShown();
    void aTextThatShrinksIsShown();
    void marksModelDiagnostics();
};

/// Repeats `line` until the text is larger than the limit for showing it in full.
static QByteArray largeText(const QByteArray& line) { return line.repeated(int(kLargestFullText) / int(line.size()) + 1); }

void LargeTextTest::showsLargeTextsOnRequest() {
    TextFixture window;
    const QByteArray large = "#import other.sim\n" + largeText("// what was written here once\n") + "Param p = 1\n";
    window.write("other.sim", "Param q = 1\n");
    window.open(window.write("main.sim", large));
    QVERIFY(!window.page().isTextShown());
    QVERIFY(window.edit().bytes().empty()); // no second copy of the text
    auto* notice = window.page().findChild<QWidget*>(QStringLiteral("largeText"));
    auto* open = window.page().findChild<QPushButton*>(QStringLiteral("openAsText"));
    QVERIFY(notice && notice->isVisible() && open->isVisible() && !window.edit().isVisible());
    const QString words = notice->findChild<QLabel*>(QStringLiteral("largeTextWords"))->text();
    QVERIFY(words.contains(QStringLiteral("main.sim")));
    QVERIFY2(words.count(QStringLiteral("4 MiB")) == 1, qPrintable(words)); // its size reads as larger than the limit

    const auto place = static_cast<std::uint32_t>(large.indexOf("Param"));
    window.panel.reveal(window.page().file(), {place, place + 5}); // as after a click on a diagnostic
    QTest::mouseClick(open, Qt::LeftButton);
    QVERIFY(window.page().isTextShown() && window.edit().isVisible() && !notice->isVisible());
    QVERIFY(window.edit().styling().isPlain() && !window.edit().wrapping().wraps());
    QVERIFY(window.shown() == large);
    QCOMPARE(window.edit().selection(), (TextRange{place, place + 5}));
    QTest::keyClicks(&window.edit(), QStringLiteral("x"));
    window.panel.flush();
    QByteArray typed = large;
    typed.replace(qsizetype(place), 5, "x");
    QVERIFY(window.text() == typed);
    window.document.edits().undo();
    QVERIFY(window.shown() == large);
    // Another file is shown in full, with syntax highlighting.
    window.panel.reveal(window.document.texts().files()[1], {0, 5});
    QVERIFY(window.page().isTextShown() && !window.edit().styling().isPlain());
    QCOMPARE(window.edit().styling().styleAt(0), TextStyle::Keyword);
}

/// The document, the loaded project and the disk state share the bytes; the editor converts none of them to a QString.
void LargeTextTest::aLargeTextIsNotCopied() {
    int notifications = 0; // outlives the window
    TextFixture window;
    const std::string file = window.write("main.sim", largeText("// what was written here once\n"));
    window.open(file);
    QCOMPARE(static_cast<const void*>(window.document.texts().text(file)->data()),
             static_cast<const void*>(window.document.loaded()->trees[0]->source().bytes().data()));
    connect(&window.edit(), &QsciScintillaBase::SCN_MODIFIED, this, [&] { ++notifications; });
    QTest::mouseClick(window.page().findChild<QPushButton*>(QStringLiteral("openAsText")), Qt::LeftButton);
    QVERIFY(window.page().isTextShown());
    QCOMPARE(notifications, 0);
    QTest::keyClicks(&window.edit(), QStringLiteral("x"));
    QVERIFY(notifications > 0);
}

/// The document gets the new text beside the one on disk; history, journal and names of edits store only what was typed.
void LargeTextTest::typingCopiesALargeTextOnce() {
    TextFixture window;
    const QByteArray large = largeText("// " + QByteArray(300, 'x') + "\n");
    const std::string file = window.write("main.sim", large);
    window.open(file);
    QTest::mouseClick(window.page().findChild<QPushButton*>(QStringLiteral("openAsText")), Qt::LeftButton);
    const QDir journals(QString::fromStdString(projectStateFolder(window.document.loaded()->projectFolder) + "/journal"));
    const auto bytesInUse = [] { // by malloc; always 0 with a sanitizer
        const struct mallinfo2 now = mallinfo2();
        return double(now.uordblks) + double(now.hblkhd);
    };
    const double before = bytesInUse();
    for (const char* word : {"one", " two", " three"}) {
        QTest::keyClicks(&window.edit(), QLatin1String(word));
        window.panel.flush();
    }
    EVENTUALLY(!journals.entryList(QDir::Files).isEmpty());
    const double copies = (bytesInUse() - before) / double(large.size());
    QVERIFY2(copies < 2, qPrintable(QString::number(copies)));
    QCOMPARE(window.document.edits().history().entries().back().name, QStringLiteral("Type “three” at main.sim:1"));
    QVERIFY(window.text() == "one two three" + large);
    // What is typed faster than it is flushed is one entry.
    const auto entries = window.document.edits().history().entries().size();
    QTest::keyClicks(&window.edit(), QStringLiteral("four five"));
    window.panel.flush();
    QVERIFY(window.document.edits().history().entries().size() <= entries + 1);
    while (window.document.edits().history().canUndo()) window.document.edits().undo();
    QVERIFY(window.text() == large && window.shown() == large);
}

void LargeTextTest::longLinesAreNotShown() {
    TextFixture window;
    const QByteArray line(int(kLongestShownLine) + 1, 'a');
    window.open(window.write("main.sim", "Param p = 1\n//" + line + "\n"));
    QVERIFY(!window.page().isTextShown());
    QVERIFY(!window.page().findChild<QPushButton*>(QStringLiteral("openAsText"))->isVisible());
    QVERIFY(window.page()
                .findChild<QLabel*>(QStringLiteral("largeTextWords"))
                ->text()
                .startsWith(QStringLiteral("Line 2 of main.sim")));
}

void LargeTextTest::aTextThatShrinksIsShown() {
    TextFixture window;
    const QByteArray large = largeText("// what was written here once\n");
    const std::string file = window.write("main.sim", large);
    window.open(file);
    QVERIFY(!window.page().isTextShown());
    QVERIFY(window.document.edits().replaceText(QStringLiteral("Shorter"), file, "Param p = 1\n").ok());
    QVERIFY(window.page().isTextShown() && !window.edit().styling().isPlain());
    QCOMPARE(window.shown(), QByteArray("Param p = 1\n"));
    window.document.edits().undo();
    QVERIFY(!window.page().isTextShown() && window.edit().bytes().empty());
    QVERIFY(window.text() == large);
}

void LargeTextTest::marksModelDiagnostics() {
    constexpr unsigned long kWarningMark = 9; // the Scintilla indicator of warnings
    TextFixture window;
    window.open(window.write("main.sim", "Tick = 0.01\nDuration = 1\n"));
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = Code::StartOverlap;
    warning.range = {0, {12, 20}};
    window.panel.setModelProblems(window.document.loaded(), {warning});
    const auto marked = [&](long at) {
        return window.edit().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, kWarningMark, at) != 0;
    };
    QVERIFY(marked(12) && marked(19) && !marked(11) && !marked(20));
    QCOMPARE(window.page().problems().size(), std::size_t(1)); // hover and Alt+Enter use these
    QVERIFY(
        window.document.edits().replaceText(QStringLiteral("Other"), window.page().file(), "Tick = 0.02\nDuration = 1\n").ok());
    QVERIFY(!marked(12)); // problems of other texts are not shown
    window.panel.setModelProblems(window.document.loaded(), {warning});
    QVERIFY(marked(12));
}

QTEST_MAIN(LargeTextTest)
#include "large_text_test.moc"
