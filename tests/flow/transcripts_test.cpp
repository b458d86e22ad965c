// Whole command lines with everything that they print: tests/data/transcripts. A transcript has texts and commands; after each
// command come its exit code, standard output and standard error. TRUNDLE_WRITE_TRANSCRIPTS=1 writes what the program prints now.

#include "flow/cli.h"

namespace {

const QString kFolder = QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/transcripts/");

/// "--- file NAME", "--- run ARGUMENTS" and the lines that follow.
struct Section {
    QString head;
    QByteArray body;
};

QList<Section> sectionsOf(const QByteArray& transcript) {
    QList<Section> sections;
    for (const QByteArray& line : transcript.split('\n')) {
        if (line.startsWith("--- ")) sections.append({QString::fromUtf8(line.mid(4)), {}});
        else if (!sections.isEmpty()) sections.back().body += line + '\n';
    }
    if (!sections.isEmpty()) sections.back().body.chop(1); // split() ends with an empty line
    return sections;
}

/// Replaces what differs from run to run and from machine to machine.
QByteArray masked(const QByteArray& bytes, const QString& folder) {
    QString text = QString::fromUtf8(bytes);
    text.replace(folder, "FOLDER");
    text.replace(QStringLiteral(TRUNDLE_BINARY_DIR), "BUILD").replace(QStringLiteral(TRUNDLE_SOURCE_DIR), "SOURCE");
    static const QRegularExpression took("(?m)^took .*$");
    static const QRegularExpression numbers("\"(wall_s|real_time_factor|peak_memory_kb)\": [-+.e0-9]+");
    static const QRegularExpression hash("(\"state_hash\": \"|state-hash )[0-9a-f]{16}");
    static const QRegularExpression progress("(?m)^.* s simulated, .*x real time.*\n");
    static const QRegularExpression help("(?m)^ *\"help\": \".*\",?\n"); // texts of the manual may change freely
    static const QRegularExpression deep("\n {8,}");                     // of the manual, so that a property is one line
    text.replace(took, "took #").replace(numbers, "\"\\1\": #").replace(hash, "\\1#").remove(progress).remove(help);
    if (text.contains("\"exactly_one_of\"")) text.replace(deep, " ");
    return text.toUtf8();
}

} // namespace

class TranscriptsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void printsTheSame_data() {
        QTest::addColumn<QString>("file");
        for (const QString& file : QDir(kFolder).entryList({"*.txt"})) QTest::newRow(qPrintable(file)) << file;
    }
    void printsTheSame() {
        QFETCH(QString, file);
        QTemporaryDir folder;
        QByteArray now, wrong;
        for (const Section& section : sectionsOf(contentOf(kFolder + file))) {
            QByteArray body = section.body;
            if (section.head.startsWith("file ")) {
                QVERIFY(QDir(folder.path()).mkpath(QFileInfo(section.head.mid(5)).path()));
                QVERIFY(writeFile(folder.filePath(section.head.mid(5)), section.body));
            } else {
                QVERIFY2(section.head.startsWith("run"), qPrintable(section.head));
                QString command = section.head.mid(3);
                command.replace("BUILD", QStringLiteral(TRUNDLE_BINARY_DIR))
                    .replace("SOURCE", QStringLiteral(TRUNDLE_SOURCE_DIR));
                const Outcome done = callProgram(programPath(), QProcess::splitCommand(command), folder.path());
                body = "exit " + QByteArray::number(done.code) + '\n' + masked(done.out, folder.path());
                if (!done.err.isEmpty()) body += "stderr:\n" + masked(done.err, folder.path());
                if (body != section.body) wrong += "--- " + section.head.toUtf8() + '\n' + difference(section.body, body);
            }
            now += "--- " + section.head.toUtf8() + '\n' + body;
        }
        QVERIFY(!now.isEmpty());
        if (qEnvironmentVariableIsSet("TRUNDLE_WRITE_TRANSCRIPTS")) QVERIFY(writeFile(kFolder + file, now));
        else QVERIFY2(wrong.isEmpty(), wrong.constData());
    }

private:
    /// The first line that differs, with the one that was expected.
    static QByteArray difference(const QByteArray& expected, const QByteArray& actual) {
        const QByteArrayList before = expected.split('\n'), after = actual.split('\n');
        qsizetype i = 0;
        while (i < before.size() && i < after.size() && before[i] == after[i]) ++i;
        return "line " + QByteArray::number(i + 1) + "\n  expected: " + before.value(i) + "\n  printed:  " + after.value(i) +
               '\n';
    }
};

QTEST_GUILESS_MAIN(TranscriptsTest)
#include "transcripts_test.moc"
