// Untrusted text is made safe for a terminal.

#include <QtTest>

#include "base/clean_text.h"

using namespace trundle;

class CleanTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void textIsCleaned_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("clean"); // '#' represents U+FFFD
        const auto row = [](const char* name, QByteArray text, const char* clean) {
            QTest::newRow(name) << text << QByteArray(clean).replace('#', "\xEF\xBF\xBD");
        };
        row("nothing", "", "");
        row("letters of many languages", "a \xC3\xA4 \xD7\xA9 \xE4\xBD\xA0 \xF0\x9F\xA4\x96",
            "a \xC3\xA4 \xD7\xA9 \xE4\xBD\xA0 \xF0\x9F\xA4\x96");
        row("lines and tabs", "a\n\tb\n", "a\n\tb\n");
        row("line ends of others", "a\r\nb\rc\r\r\n", "a\nb\nc\n\n");
        row("an escape sequence", "\x1b[31mred\x1b[0m", "#[31mred#[0m");
        row("a title and a bell", "\x1b]0;x\x07", "#]0;x#");
        row("backspaces", "rm -rf\b\b\b\b\b\bls    ", "rm -rf######ls    ");
        row("zero and delete", QByteArray("a\0b\x7f", 4), "a#b#");
        row("C1 in UTF-8",
            "\xC2\x9B"
            "2J",
            "#2J");
        row("C1 as a byte",
            "\x9B"
            "2J",
            "#2J");
        row("a byte that begins nothing",
            "\xFF\xFE"
            "a",
            "##a");
        row("a letter cut off", "a\xC3", "a#");
        row("an overlong slash", "\xC0\xAF", "##");
        row("a surrogate", "\xED\xA0\x80", "###");
        row("text turned round",
            "\xE2\x80\xAE"
            "exe.txt\xE2\x81\xA6",
            "#exe.txt#");
        row("invisible signs",
            "a\xE2\x80\x8B"
            "b\xEF\xBB\xBF\xE2\x81\xA0\xF3\xA0\x81\xA1",
            "a#b###");
        row("joiners of a script and of an emoji", "\xD9\x85\xE2\x80\x8C\xD9\x85 \xF0\x9F\x91\xA9\xE2\x80\x8D\xF0\x9F\x94\xA7",
            "\xD9\x85\xE2\x80\x8C\xD9\x85 \xF0\x9F\x91\xA9\xE2\x80\x8D\xF0\x9F\x94\xA7");
        row("a line separator",
            "a\xE2\x80\xA8"
            "b",
            "a#b");
    }
    void textIsCleaned() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, clean);
        QCOMPARE(QByteArray::fromStdString(cleanText(text.toStdString())), clean);
        QCOMPARE(QByteArray::fromStdString(cleanLine(text.toStdString())), clean.replace('\n', ' '));
        QCOMPARE(cleanText(cleanText(text.toStdString())), cleanText(text.toStdString()));
    }
};

QTEST_APPLESS_MAIN(CleanTextTest)
#include "clean_text_test.moc"
