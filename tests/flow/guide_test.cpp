// The guide is correct: its texts load and run, its commands work, its links resolve, and every kind and option is documented.

#include "base/units.h"
#include "flow/cli.h"

namespace {

const QString kGuide = QStringLiteral(TRUNDLE_SOURCE_DIR "/resources/guide/");

struct Fence {
    QString page;
    int line = 0;
    QStringList words; ///< "sim", "more", "E208"
    QString text;

    [[nodiscard]] QString where() const { return QStringLiteral("%1:%2").arg(page).arg(line); }
    [[nodiscard]] QString language() const { return words.value(0); }
};

QStringList pages() { return QDir(kGuide).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name); }
QString textOf(const QString& page) { return QString::fromUtf8(contentOf(kGuide + page)); }

QList<Fence> fencesOf(const QString& page) {
    QList<Fence> fences;
    bool inside = false;
    const QStringList lines = textOf(page).split('\n');
    for (int i = 0; i < lines.size(); ++i) {
        if (lines[i].startsWith("```")) {
            if (!inside) fences.append({page, i + 1, lines[i].mid(3).split(' ', Qt::SkipEmptyParts), {}});
            inside = !inside;
        } else if (inside) {
            fences.last().text += lines[i] + '\n';
        }
    }
    return fences;
}

/// The texts of a page; one marked `more` continues the previous one.
QList<Fence> textsOf(const QString& page) {
    QList<Fence> texts;
    QString before;
    for (Fence fence : fencesOf(page)) {
        if (fence.language() != "sim") continue;
        if (fence.words.contains("more")) fence.text = before + fence.text;
        texts.append(fence);
        if (fence.words.filter(QRegularExpression("^E\\d+$")).isEmpty()) before = fence.text;
    }
    return texts;
}

/// Writes the Python files of a page, each a block "python NAME". False: it has none.
bool writePython(const QString& page, const QTemporaryDir& folder) {
    bool any = false;
    for (const Fence& fence : fencesOf(page))
        if (fence.language() == "python") any = writeFile(folder.filePath(fence.words.value(1)), fence.text.toUtf8()) || any;
    return any;
}

/// The names in all comments `<!-- kinds: ... -->`.
QStringList placedKinds() {
    QStringList kinds;
    static const QRegularExpression comment(QStringLiteral("<!-- kinds: ([^>]*) -->"));
    for (const QString& page : pages())
        for (auto found = comment.globalMatch(textOf(page)); found.hasNext();)
            kinds += found.next().captured(1).split(' ', Qt::SkipEmptyParts);
    return kinds;
}

} // namespace

class GuideTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyCodeBlockHasALanguage() {
        const QStringList known{"sim", "sh", "cpp", "python"};
        int count = 0;
        for (const QString& page : pages())
            for (const Fence& fence : fencesOf(page)) {
                QVERIFY2(known.contains(fence.language()), qPrintable(fence.where()));
                ++count;
            }
        QVERIFY(count > 30);
    }

    void documentedTextsRun_data() {
        QTest::addColumn<QString>("page");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("codes");
        for (const QString& page : pages())
            for (const Fence& fence : textsOf(page))
                QTest::newRow(qPrintable(fence.where())) << page << fence.text << fence.words.filter(QRegularExpression("^E\\d+$"));
    }
    void documentedTextsRun() {
        QFETCH(QString, page);
        QFETCH(QString, text);
        QFETCH(QStringList, codes);
        QTemporaryDir folder;
        const QStringList trust = writePython(page, folder) ? QStringList{"--modules", "."} : QStringList();
        QVERIFY(writeFile(folder.filePath("text.sim"), text.toUtf8()));
        const Outcome check = cli(QStringList{"check", "text.sim", "--json"} + trust, folder.path());
        QStringList said;
        for (const QJsonValue& message : QJsonDocument::fromJson(check.out).array())
            if (message["severity"] == "error" || codes.isEmpty()) said << message["code"].toString();
        said.removeDuplicates();
        QVERIFY2(said == codes, shown(check));
        QCOMPARE(check.code, codes.isEmpty() ? 0 : 1);
        if (!codes.isEmpty()) return;
        const Outcome run = cli(QStringList{"run", "text.sim", "--duration", "0.1", "--quiet"} + trust, folder.path());
        QVERIFY2(run.code == 0, shown(run));
    }

    /// The commands of a page in order, in one folder, where the page's first text is my.sim.
    void documentedCommandsWork_data() {
        QTest::addColumn<QString>("page");
        for (const QString& page : pages())
            if (textOf(page).contains(QRegularExpression("```sh|```python \\S+ run"))) QTest::newRow(qPrintable(page)) << page;
    }
    void documentedCommandsWork() {
        QFETCH(QString, page);
        QTemporaryDir folder;
        const QList<Fence> texts = textsOf(page);
        QVERIFY2(!texts.isEmpty(), "there is no my.sim");
        QVERIFY(writeFile(folder.filePath("my.sim"), texts[0].text.toUtf8()));
        (void)writePython(page, folder);
        for (const Fence& fence : fencesOf(page)) {
            if (fence.language() != "python" || !fence.words.contains("run")) continue;
            const Outcome run = callProgram("env", {"PYTHONPATH=" TRUNDLE_SOURCE_DIR "/core/sdk/python", "TRUNDLE_CLI=" + programPath(), "python3",
                                                    "-B", fence.words.value(1)},
                                            folder.path());
            QVERIFY2(run.code == 0 && !run.out.isEmpty(), shown(run));
        }
        static const QRegularExpression expected(QStringLiteral("# exit code (\\d+)$"));
        for (const Fence& fence : fencesOf(page)) {
            if (fence.language() != "sh") continue;
            for (const QString& line : fence.text.split('\n', Qt::SkipEmptyParts)) {
                QVERIFY2(line.startsWith("trundle-cli "), qPrintable(line));
                const auto code = expected.match(line);
                const QString command = QStringLiteral("PATH='" TRUNDLE_BINARY_DIR "/bin':\"$PATH\"; ") + line;
                const Outcome run = callProgram("/bin/sh", {"-c", command}, folder.path());
                QVERIFY2(run.code == (code.hasMatch() ? code.captured(1).toInt() : 0), line.toUtf8() + "\n" + shown(run));
            }
        }
    }

    void everyCommandAndOptionIsInIt() {
        const QString chapter = textOf("command_line.md");
        static const QRegularExpression option(QStringLiteral("^  (?:-\\w,)?(--?[\\w-]+)"), QRegularExpression::MultilineOption);
        static const QRegularExpression word(QStringLiteral("^  (\\w+) "), QRegularExpression::MultilineOption);
        const QString help = QString::fromUtf8(cli({"--help"}).out);
        QStringList commands;
        for (auto found = word.globalMatch(help.section("Subcommands:", 1).section("Examples:", 0, 0)); found.hasNext();)
            commands << found.next().captured(1);
        QVERIFY2(commands.size() >= 7, qPrintable(help));
        QSet<QString> options;
        for (const QString& command : commands) {
            const QString page = QString::fromUtf8(cli({command, "--help"}).out).section("Options:", 1).section("Example", 0, 0);
            for (auto found = option.globalMatch(page); found.hasNext();) options << found.next().captured(1);
        }
        QVERIFY(options.size() > 15);
        for (const QString& name : commands + options.values())
            QVERIFY2(
                QRegularExpression("(^|[^-\\w])" + QRegularExpression::escape(name) + "($|[^-\\w])").match(chapter).hasMatch(),
                qPrintable(name));
        QTemporaryDir logs;
        const Outcome run =
            cli({"run", configPath("experiments/linear_motion.sim"), "--duration", "0", "--json", "--log-dir", logs.path()});
        const QStringList keys = QJsonDocument::fromJson(run.out).object().keys();
        QVERIFY2(keys.size() > 10, shown(run));
        for (const QString& key : keys) QVERIFY2(chapter.contains("`" + key + "`"), qPrintable(key));
        // The guide names no option that does not exist.
        static const QRegularExpression named(QStringLiteral("`trundle-cli [^`]*|\\| `(--[\\w-]+)"));
        for (auto found = named.globalMatch(chapter); found.hasNext();) {
            const QString said = found.next().captured(1);
            QVERIFY2(said.isEmpty() || options.contains(said), qPrintable(said));
        }
    }

    void everyKindHasItsPlace() {
        const QJsonArray all = QJsonDocument::fromJson(cli({"describe", "--json"}).out).array();
        QVERIFY(all.size() > 40);
        const QStringList placed = placedKinds();
        QStringList names{"controller", "device"}; // kinds of modules are listed by role
        for (const QJsonValue& kind : all) {
            names << kind["name"].toString();
            if (kind["module"].toString().isEmpty())
                QVERIFY2(placed.contains(kind["name"].toString()), qPrintable(kind["name"].toString()));
        }
        for (const QString& name : placed) QVERIFY2(names.contains(name) && placed.count(name) == 1, qPrintable(name));
    }

    void everyUnitIsInIt() {
        const QString chapter = textOf("language.md");
        QVERIFY(trundle::allUnitNames().size() > 50);
        for (const std::string& unit : trundle::allUnitNames()) {
            const QString name = QRegularExpression::escape(QString::fromStdString(unit));
            QVERIFY2(QRegularExpression("`([^`\\n]* )?" + name + "( [^`\\n]*)?`").match(chapter).hasMatch(), unit.c_str());
        }
    }

    /// The unit of a property, as help and messages name it, is written behind numbers.
    void everyUnitOfAPropertyIsOneOfThem() {
        int units = 0;
        for (const QJsonValue& kind : QJsonDocument::fromJson(cli({"describe", "--json"}).out).array())
            for (const QJsonValue& property : kind["properties"].toArray()) {
                const QString unit = property["unit"].toString();
                const QString shown = kind["name"].toString() + "." + property["name"].toString() + ": " + unit;
                QVERIFY2(unit.isEmpty() || trundle::findUnit(unit.toStdString()), qPrintable(shown));
                units += !unit.isEmpty();
            }
        QVERIFY(units > 300);
    }

    void everyColumnOfTheRadioLogsIsInIt() {
        QTemporaryDir folder;
        QVERIFY(writeFile(folder.filePath("my.sim"), textsOf("radios.md")[0].text.toUtf8()));
        const Outcome run = cli({"run", "my.sim", "--duration", "0", "--log-dir", "logs"}, folder.path());
        QVERIFY2(run.code == 0, shown(run));
        for (const char* log : {"logs/frames.csv", "logs/links.csv"}) {
            const QList<QByteArray> columns = contentOf(folder.filePath(log)).split('\n').front().split(',');
            QVERIFY2(columns.size() > 10, log);
            for (const QByteArray& column : columns) {
                const QString name = QRegularExpression::escape(QString::fromUtf8(column).section(" [", 0, 0).trimmed());
                const QRegularExpression word("[|,] " + name + "( \\||,)|the " + name);
                QVERIFY2(word.match(textOf("radios.md")).hasMatch(), column);
            }
        }
    }

    /// Each row of a table has as many cells as its heading.
    void tablesAreWhole() {
        int rows = 0;
        for (const QString& page : pages()) {
            qsizetype cells = 0;
            bool inCode = false;
            for (QString line : textOf(page).split('\n')) {
                if (line.startsWith("```")) inCode = !inCode;
                if (inCode || !line.startsWith('|')) {
                    cells = 0;
                    continue;
                }
                const qsizetype count = line.replace("\\|", "").count('|');
                QVERIFY2(cells == 0 || count == cells, qPrintable(page + ": " + line));
                cells = count;
                ++rows;
            }
        }
        QVERIFY(rows > 100);
    }

    void theIndexNamesEveryPage() {
        for (const QString& page : pages())
            if (page != "index.md") QVERIFY2(textOf("index.md").contains("](" + page + ")"), qPrintable(page));
    }
};

QTEST_GUILESS_MAIN(GuideTest)
#include "guide_test.moc"
