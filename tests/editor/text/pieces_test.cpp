// The parts of the text editor that do not depend on a widget.

#include <limits>
#include <numbers>
#include <random>
#include <set>

#include <QTest>

#include "editor/text/code/line_edits.h"
#include "editor/text/code/splice.h"
#include "editor/text/code/token_styles.h"
#include "editor/text/pages/typing_merger.h"
#include "editor/text/search/text_search.h"
#include "editor/text/symbols/property_text.h"
#include "lang/lexer.h"

using namespace trundle;

class PiecesTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void splicesAreSmall_data();
    void splicesAreSmall();
    void splicesGiveTheOtherText();
    void aCaretStaysAtItsText();
    void mergesWhatTwoDid_data();
    void mergesWhatTwoDid();
    void stylesOfWords();
    void foldsBlocks();
    void lineCommands_data();
    void lineCommands();
    void mergesTypedWordIntoOneEntry();
    void mergesWhatIsDeletedForward();
    void defaultsAreInTheUnitOfTheProperty();
    void searches_data();
    void searches();
    void replacesGroups();
};

void PiecesTest::splicesAreSmall_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("splices"); // position-removed+text, separated by spaces
    QTest::newRow("nothing") << QByteArray("abc") << QByteArray("abc") << QByteArray("");
    QTest::newRow("one word") << QByteArray("Mass=2 Pos=1") << QByteArray("Mass=3 Pos=1") << QByteArray("5-1+3");
    QTest::newRow("at the end") << QByteArray("a") << QByteArray("ab") << QByteArray("1-0+b");
    QTest::newRow("two lines of three") << QByteArray("a1\nb\nc1\n") << QByteArray("a2\nb\nc2\n") << QByteArray("1-1+2 6-1+2");
    QTest::newRow("whole characters") << QByteArray("\xC3\xA4") << QByteArray("\xC3\xB6") << QByteArray("0-2+\xC3\xB6");
    QTest::newRow("whole line ends") << QByteArray("a\r\nb") << QByteArray("a\nb") << QByteArray("1-2+\n");
}

void PiecesTest::splicesAreSmall() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QByteArrayList reportOf;
    for (const Splice& s : splicesBetween(from.toStdString(), to.toStdString()))
        reportOf << QByteArray::number(qulonglong(s.at)) + '-' + QByteArray::number(qulonglong(s.removed)) + '+' +
                        QByteArray::fromStdString(s.text);
    QTEST(reportOf.join(' '), "splices");
}

void PiecesTest::splicesGiveTheOtherText() {
    std::mt19937 random(7);
    const std::string letters = "ab\n\r\xC3\xA4{";
    const auto text = [&] {
        std::string t(random() % 30, ' ');
        for (char& c : t) c = letters[random() % letters.size()];
        return t;
    };
    for (int i = 0; i < 3000; ++i) {
        const std::string from = text(), to = random() % 2 ? text() : from + text();
        const std::vector<Splice> splices = splicesBetween(from, to);
        QCOMPARE(QByteArray::fromStdString(spliced(from, splices)), QByteArray::fromStdString(to));
        for (std::size_t at = 0; at <= from.size(); ++at) QVERIFY(movedOffset(at, splices) <= to.size());
    }
}

/// It is behind what is inserted at it, and at the end of what replaces the text around it.
void PiecesTest::aCaretStaysAtItsText() {
    const std::vector<Splice> splices = {{2, 0, "xyz"}, {5, 3, "Q"}, {10, 1, ""}}; // 0123456789AB: 01xyz234Q89B
    QCOMPARE(spliced("0123456789AB", splices), std::string("01xyz234Q89B"));
    const std::size_t expected[] = {0, 1, 5, 6, 7, 9, 9, 9, 9, 10, 11, 11, 12};
    for (std::size_t at = 0; at < std::size(expected); ++at) QCOMPARE(movedOffset(at, splices), expected[at]);
    QCOMPARE(movedOffset(0, {{0, 0, "// "}}), std::size_t(3));
    QCOMPARE(movedOffset(4, {{4, 0, "end"}}), std::size_t(7));
    QCOMPARE(movedOffset(4, {}), std::size_t(4));
}

void PiecesTest::mergesWhatTwoDid_data() {
    QTest::addColumn<QByteArray>("base");
    QTest::addColumn<QByteArray>("ours");
    QTest::addColumn<QByteArray>("theirs");
    QTest::addColumn<QByteArray>("both");
    const auto row = [](const char* name, const char* base, const char* ours, const char* theirs, const char* both) {
        QTest::newRow(name) << QByteArray(base) << QByteArray(ours) << QByteArray(theirs) << QByteArray(both);
    };
    row("ours before theirs", "a b c", "ax b c", "a b cy", "ax b cy");
    row("theirs before ours", "a b c", "a b cx", "ay b c", "ay b cx");
    row("between two of theirs", "1\n2\n3\n", "1\n2x\n3\n", "1a\n2\n3b\n", "1a\n2x\n3b\n");
    row("only ours", "a", "ab", "a", "ab");
    row("only theirs", "a", "a", "ab", "ab");
    row("alike", "a", "ab", "ab", "ab");
    row("the same word: nothing is lost", "Mass=2", "Mass=25", "Mass=3", "Mass=35");
}

void PiecesTest::mergesWhatTwoDid() {
    QFETCH(QByteArray, base);
    QFETCH(QByteArray, ours);
    QFETCH(QByteArray, theirs);
    QTEST(QByteArray::fromStdString(merged(base.toStdString(), ours.toStdString(), theirs.toStdString())), "both");
}

void PiecesTest::stylesOfWords() {
    const std::string text = "#import a/b.sim\n"
                             "Param w = 3 cm\n"
                             "Robot r {\n"
                             "  Config=Rover  left.Mass = $w  Pos=$(2*w),-1,0 // note\n"
                             "  Visible=true Title=\"x\"\n"
                             "}\n";
    const std::string styles = stylesOf(text, Lexer(text).lex());
    QCOMPARE(styles.size(), text.size());
    const auto at = [&](const char* word, std::size_t plus = 0) {
        return static_cast<TextStyle>(styles[text.find(word) + plus]);
    };
    QCOMPARE(at("#import"), TextStyle::Directive);
    QCOMPARE(at("a/b"), TextStyle::Path);
    QCOMPARE(at("Param"), TextStyle::Keyword);
    QCOMPARE(at("w = 3"), TextStyle::Name);
    QCOMPARE(at("3 cm"), TextStyle::Number);
    QCOMPARE(at("cm"), TextStyle::Unit);
    QCOMPARE(at("Robot"), TextStyle::Kind);
    QCOMPARE(at("r {"), TextStyle::Name);
    QCOMPARE(at("Config"), TextStyle::Key);
    QCOMPARE(at("Rover"), TextStyle::Word);
    QCOMPARE(at("left"), TextStyle::Key);
    QCOMPARE(at("Mass"), TextStyle::Key);
    QCOMPARE(at("$w"), TextStyle::Param);
    QCOMPARE(at("*w", 1), TextStyle::Param);
    QCOMPARE(at("// note"), TextStyle::Comment);
    QCOMPARE(at("true"), TextStyle::Keyword);
    QCOMPARE(at("\"x\""), TextStyle::String);
}

void PiecesTest::foldsBlocks() {
    const std::string text = "Robot a {\n  Body b { Box c { } }\n  Body d {\n    x\n  }\n}\n/* two\nlines */\nopen {\n x";
    QByteArray reportOf;
    for (const FoldLine& line : foldLinesOf(text, Lexer(text).lex()))
        reportOf += QByteArray::number(line.level) + (line.opens ? "+ " : " ");
    QCOMPARE(reportOf, QByteArray("0+ 1 1+ 2 2 1 0+ 1 0+ 1 "));
}

void PiecesTest::lineCommands_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QByteArray>("before"); // | is the caret, [ the anchor
    QTest::addColumn<QByteArray>("after");
    const auto row = [](const char* name, const char* command, const char* before, const char* after) {
        QTest::newRow(name) << QString::fromLatin1(command) << QByteArray(before) << QByteArray(after);
    };
    row("comment a line", "comment", "a\n  b|c\nd", "a\n  // b|c\nd");
    row("and back", "comment", "a\n  // b|c\nd", "a\n  b|c\nd");
    row("comment lines at one column", "comment", "[  a\n    b\n|c", "[  // a\n  //   b|\nc");
    row("an empty line has no column", "comment", "[    a\n\n  \n    b|", "[    // a\n\n  \n    // b|");
    row("empty lines stay", "comment", "[a\n\nb|", "[// a\n\n// b|");
    row("comment with CR LF", "comment", "[a\r\nb|", "[// a\r\n// b|");
    row("duplicate", "duplicate", "a|b\nc", "ab\na|b\nc");
    row("duplicate the last line", "duplicate", "x\na|", "x\na\na|");
    row("duplicate lines", "duplicate", "[a\nb|\nc", "a\nb\n[a\nb|\nc");
    row("up", "up", "a\nb|c\nd", "b|c\na\nd");
    row("up with CR LF", "up", "a\r\nb|c\r\nd", "b|c\r\na\r\nd");
    row("lines up with CR LF", "up", "x\r\n[a\r\nb|\r\nc", "[a\r\nb|\r\nx\r\nc");
    row("up over an empty line with CR LF", "up", "a\r\n\r\nb|", "a\r\nb|\r\n");
    row("up at the top", "up", "a|\nb", "a|\nb");
    row("down", "down", "a|\nb\nc", "b\na|\nc");
    row("down to a last line without an end", "down", "a|\nb", "b\na|");
    row("down at the bottom", "down", "a\nb|", "a\nb|");
    row("down with CR LF", "down", "a|\r\nb", "b\r\na|");
    row("new line keeps the indent", "enter", "  a|b", "  a\n  |b");
    row("deeper after a brace", "enter", "Body b {|", "Body b {\n  |");
    row("deeper in a block begun before", "enter", "Body b { Pos=1 |", "Body b { Pos=1 \n  |");
    row("deeper behind the brace of another block", "enter", "} Body b {|", "} Body b {\n  |");
    row("not behind a closed one", "enter", "Body b { Pos=1 }|", "Body b { Pos=1 }\n|");
    row("nor a brace in a comment", "enter", "Tick=1 // {|", "Tick=1 // {\n|");
    row("the closing brace goes below", "enter", "  Body b {|}", "  Body b {\n    |\n  }");
    row("in place of the selection", "enter", "a[bc|d", "a\n|d");
    row("at the beginning", "enter", "|  a", "\n|a");
    row("closing brace", "brace", "Robot r {\n  Body b {\n    |", "Robot r {\n  Body b {\n  }|");
    row("closing brace behind something", "brace", "Robot r { a|", "Robot r { a|");
}

void PiecesTest::lineCommands() {
    QFETCH(QString, command);
    QFETCH(QByteArray, before);
    std::string text = before.toStdString();
    std::size_t caret = text.find('|');
    text.erase(caret, 1);
    std::size_t anchor = text.find('[');
    if (anchor == std::string::npos) anchor = caret;
    else {
        text.erase(anchor, 1);
        if (caret > anchor) --caret;
    }
    std::optional<LineEdit> edit;
    if (command == QLatin1String("comment")) edit = toggleComment(text, anchor, caret);
    if (command == QLatin1String("duplicate")) edit = duplicateLines(text, anchor, caret, "\n");
    if (command == QLatin1String("up")) edit = moveLines(text, anchor, caret, -1);
    if (command == QLatin1String("down")) edit = moveLines(text, anchor, caret, +1);
    if (command == QLatin1String("enter")) edit = newLine(text, anchor, caret, "\n", "  ");
    if (command == QLatin1String("brace")) edit = closeBrace(text, caret);
    if (edit) {
        text = spliced(text, std::vector<Splice>{edit->splice});
        anchor = edit->anchor;
        caret = edit->caret;
    }
    text.insert(caret, "|");
    if (anchor != caret) text.insert(anchor < caret ? anchor : anchor + 1, "[");
    QTEST(QByteArray::fromStdString(text), "after");
}

void PiecesTest::mergesWhatIsDeletedForward() {
    TypingMerger typing("f");
    std::string text = "one two three";
    const auto remove = [&](std::size_t at) {
        typing.beginAction();
        if (typing.startsEntry(at, 1, "")) typing.close(text);
        text.erase(at, 1);
        typing.changed(at, "");
    };
    for (int i = 0; i < 3; ++i) remove(4); // Delete, three times at one place
    remove(0);                             // elsewhere
    const auto entries = typing.take(text);
    QCOMPARE(entries.size(), std::size_t(2));
    QCOMPARE(entries[0].bytes, std::string("one  three"));
    QCOMPARE(entries[1].bytes, std::string("ne  three"));
}

void PiecesTest::defaultsAreInTheUnitOfTheProperty() {
    Property p;
    p.unit = "deg";
    p.scale = std::numbers::pi / 180;
    p.minimum = -std::numeric_limits<double>::infinity();
    p.maximum = std::numeric_limits<double>::infinity();
    p.defaultValue = PropertyValue{PropertyType::Number, {std::numbers::pi / 4}, {}};
    QCOMPARE(defaultText(p), std::string("45"));
    QCOMPARE(factsText(p), std::string("deg, default 45"));
    p.type = PropertyType::Boolean;
    p.defaultValue = PropertyValue{PropertyType::Boolean, {1}, {}};
    QCOMPARE(defaultText(p), std::string("true"));
}

void PiecesTest::mergesTypedWordIntoOneEntry() {
    TypingMerger typing("f");
    std::string text;
    const auto type = [&](std::size_t at, std::size_t removed, const std::string& inserted) {
        typing.beginAction();
        if (typing.startsEntry(at, removed, inserted)) typing.close(text);
        text.replace(at, removed, inserted);
        typing.changed(at, inserted);
    };
    for (const char c : std::string("one two")) type(text.size(), 0, std::string(1, c));
    type(6, 1, ""); // backspace
    type(5, 1, "");
    type(5, 0, "pasted text");
    const auto entries = typing.take(text);
    QByteArrayList reportOf;
    std::set<std::string> keys;
    for (const TypingMerger::Entry& e : entries) {
        reportOf << QByteArray::fromStdString(e.bytes);
        keys.insert(e.mergeKey);
    }
    QCOMPARE(reportOf.join('|'), QByteArray("one |one two|one t|one tpasted text"));
    QCOMPARE(keys.size(), entries.size());
    QVERIFY(!typing.pending());
    // Typing after a word that was sent already continues its merge.
    type(text.size(), 0, "x");
    const std::string key = typing.take(text).front().mergeKey;
    type(text.size(), 0, "y");
    QCOMPARE(typing.take(text).front().mergeKey, key);
    typing.endWord();
    type(text.size(), 0, "z");
    QVERIFY(typing.take(text).front().mergeKey != key);
}

void PiecesTest::searches_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("how"); // c: match case, w: whole words, r: regular expression
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("found"); // begin-end
    const auto row = [](const char* name, const char* words, const char* how, const QByteArray& text, const char* found) {
        QTest::newRow(name) << QString::fromUtf8(words) << QString::fromLatin1(how) << text << QByteArray(found);
    };
    row("any case", "mass", "", "Mass mass", "0-4 5-9");
    row("match case", "mass", "c", "Mass mass", "5-9");
    row("whole words", "mass", "w", "mass masses _mass", "0-4");
    row("signs are signs", "a.b", "", "axb a.b", "4-7");
    row("behind umlauts", "x", "", "\xC3\xA4x", "2-3");
    row("behind an emoji", "x", "", "\xF0\x9F\xA4\x96x", "4-5");
    row("behind broken bytes", "x", "", "\xFF\xFEx", "2-3");
    row("line ends", "b$", "r", "b\r\nb\rb\nb", "0-1 3-4 5-6 7-8");
    row("an expression", "[0-9]+", "r", "a12b3", "1-3 4-5");
    row("whole words of an expression", "cat|do[gt]", "rw", "cat catalog hotdog dot dog", "0-3 19-22 23-26");
    row("parts of an expression", "cat|do[gt]", "r", "cats dog", "0-3 5-8");
    row("empty matches are none", "x*", "r", "axb", "1-2");
    row("no expression", "(", "r", "(", "");
    row("nothing", "", "", "abc", "");
}

void PiecesTest::searches() {
    QFETCH(QString, words);
    QFETCH(QString, how);
    QFETCH(QByteArray, text);
    const TextSearch search(
        {words, how.contains(QLatin1Char('c')), how.contains(QLatin1Char('w')), how.contains(QLatin1Char('r'))});
    QByteArrayList reportOf;
    for (const TextMatch& m : search.in(text.toStdString()))
        reportOf << QByteArray::number(m.range.begin) + '-' + QByteArray::number(m.range.end);
    QTEST(reportOf.join(' '), "found");
}

void PiecesTest::replacesGroups() {
    const TextSearch search({QStringLiteral("(\\w+)=(\\d)"), true, false, true});
    const auto found = search.in("Mass=2");
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(search.replacement(found[0], QStringLiteral("\\2 = \\1\\n\\\\")), std::string("2 = Mass\n\\"));
    QCOMPARE(search.replacement(found[0], QStringLiteral("\\2\\n"), "\r\n"), std::string("2\r\n"));
    const TextSearch plain({QStringLiteral("a"), true, false, false});
    QCOMPARE(plain.replacement(plain.in("a")[0], QStringLiteral("\\1")), std::string("\\1"));
}

QTEST_GUILESS_MAIN(PiecesTest)
#include "pieces_test.moc"
