// Rules for the source tree as a whole: diagnostic codes, source lists, file sizes and forbidden text.

#include <QRegularExpression>
#include <QtTest>

#include "base/codes.h"
#include "house/source_files.h"

using namespace trundle;

namespace {

constexpr int kMaxSourceLines = 450;
constexpr int kMaxHeaderLines = 200;
/// Files that may exceed the limit, each with its reason. Prefer to split a file; keep this list short.
const QStringList kTolerated = {};

const QStringList kCode = {".h", ".cpp", ".hpp", ".inl", ".c", ".cc"};

QStringList enumerators(const QString& header) {
    const qsizetype begin = header.indexOf("enum class Code"), open = header.indexOf('{', begin);
    QString body = header.mid(open + 1, header.indexOf("};", open) - open - 1);
    body.remove(QRegularExpression("//[^\\n]*")).remove(QRegularExpression("=\\s*\\d+"));
    return body.split(QRegularExpression("[\\s,]+"), Qt::SkipEmptyParts);
}

} // namespace

class TreeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyCodeHasItsRowInOrder() {
        const QStringList names = enumerators(sourceFiles({"core/base/codes.h"}, {}).first().text);
        QVERIFY(names.size() > 60);
        const auto rows = allCodes();
        QCOMPARE(rows.size(), std::size_t(names.size()));
        const QString table = sourceFiles({"core/base/codes.cpp"}, {}).first().text;
        for (const QString& name : names)
            QVERIFY2(table.contains("Code::" + name + ","), qPrintable("codes.cpp has no row for " + name));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QVERIFY2(!rows[i].title.empty(), codeName(rows[i].code).c_str());
            if (i > 0) QVERIFY2(rows[i - 1].code < rows[i].code, codeName(rows[i].code).c_str());
        }
    }

    // Each code of texts (E1xx to E3xx) has a broken file with its expected message or, where that would be huge or need many
    // files, a test that names it.
    void everyCodeOfATextIsShown() {
        QString all;
        for (const SourceFile& file : sourceFiles({"tests/data/broken"}, {".expected"})) all += file.text;
        QVERIFY(!all.isEmpty());
        for (const SourceFile& file : sourceFiles({"tests"}, {"_test.cpp"})) all += file.text;
        const QString table = sourceFiles({"core/base/codes.cpp"}, {}).first().text;
        QStringList missing;
        for (const CodeEntry& entry : allCodes()) {
            const QString name = QString::fromStdString(codeName(entry.code));
            const qsizetype row = table.indexOf(QString::fromUtf8(entry.title.data(), entry.title.size()));
            const QString enumerator = table.left(row).section("Code::", -1).section(',', 0, 0);
            if (static_cast<int>(entry.code) < 400 && !all.contains(name) && !all.contains("Code::" + enumerator))
                missing << name + " (" + QString::fromUtf8(entry.title.data(), entry.title.size()) + ")";
        }
        QVERIFY2(missing.isEmpty(), qPrintable("neither tests/data/broken nor a test shows " + missing.join(", ")));
    }

    void sourcesAreListedByName() {
        static const QRegularExpression gathering("GLOB|aux_source_directory", QRegularExpression::CaseInsensitiveOption);
        QString lists;
        for (const SourceFile& file :
             sourceFiles({"CMakeLists.txt", "core", "editor", "app", "plugins", "tests"}, {"CMakeLists.txt", ".cmake"})) {
            QVERIFY2(!file.text.contains(gathering), qPrintable(file.path + " gathers files; list them"));
            lists += file.text;
        }
        QStringList forgotten;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app", "plugins", "tests"}, {".cpp"})) {
            if (file.path.startsWith("tests/data/")) continue;
            // Listed with its ending, or without where a foreach adds the ending.
            QString stem = file.path.section('/', -1).chopped(4);
            if (stem.endsWith("_test")) stem.chop(5);
            const QString name = QRegularExpression::escape(stem);
            if (!lists.contains(QRegularExpression("(^|[\\s/(\"])" + name + "(_test)?(\\.cpp)?($|[\\s)\"])")))
                forgotten << file.path;
        }
        QVERIFY2(forgotten.isEmpty(), qPrintable("no CMakeLists.txt names " + forgotten.join(", ")));
    }

    void filesStaySmall() {
        QStringList large;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app", "plugins", "tests"}, kCode)) {
            // Headers of tests are fixtures and count as sources.
            const bool header = (file.path.endsWith(".h") || file.path.endsWith(".hpp")) && !file.path.startsWith("tests/");
            const qsizetype lines = file.text.count('\n'), most = header ? kMaxHeaderLines : kMaxSourceLines;
            if (lines > most && !kTolerated.contains(file.path))
                large << QString("%1 has %2 lines, at most %3").arg(file.path).arg(lines).arg(most);
        }
        QVERIFY2(large.isEmpty(), qPrintable("\n" + large.join('\n')));
    }

    // Paths of one machine, and leftovers. Assembled from pieces, so that this file does not match itself.
    void nothingInTheTreeBelongsToOneMachine() {
        const QList<QRegularExpression> foreign = {
            QRegularExpression(QString("/ho") + "me/\\w"),
            QRegularExpression(QString("/Us") + "ers/\\w"),
            QRegularExpression(QString("/wo") + "rk/"),
            QRegularExpression(QString("\\.\\./sha") + "red"),
            QRegularExpression(QString("^<<<") + "<<<< ", QRegularExpression::MultilineOption),
            QRegularExpression(QString("^>>>") + ">>>> ", QRegularExpression::MultilineOption)};
        QStringList found;
        const QStringList everything = {"core",      "editor",  "app",        "plugins",        "configs",
                                        "resources", "tests",   "dev",        "CMakeLists.txt", "CMakePresets.json",
                                        "README.md", ".ci/run", ".gitignore", ".clang-format",  ".clang-tidy"};
        for (const SourceFile& file : sourceFiles(everything, {})) {
            for (const QRegularExpression& word : foreign) {
                const auto hit = word.match(file.text);
                if (hit.hasMatch())
                    found << QString("%1:%2: %3")
                                 .arg(file.path)
                                 .arg(file.text.left(hit.capturedStart()).count('\n') + 1)
                                 .arg(hit.captured().trimmed());
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join('\n')));
    }

    // Qt guesses whether a text is HTML; a name from an untrusted file must not be. See editor/widgets/plain_text.h.
    void textOfOthersIsShownPlainly() {
        const QRegularExpression guessing(
            "Qt::AutoText|QToolTip::showText|mightBeRichText|QWhatsThis|setWhatsThis|QErrorMessage|QStaticText");
        const QRegularExpression html(
            "RichText|MarkdownText|[sS]etHtml|insertHtml|appendHtml|setMarkdown|HtmlToolTip|HtmlInformation");
        // The places that build HTML. All foreign text in them must be escaped by toHtmlEscaped(), or by escaped() in hover.cpp.
        // Review a new place for that, then list it here.
        const QStringList made = {"editor/outline/outline_view.cpp",          "editor/properties/help_strip.cpp",
                                  "editor/properties/object_header.cpp",      "editor/properties/property_row.cpp",
                                  "editor/shell/commands/help_commands.cpp",  "editor/shell/commands/project_questions.cpp",
                                  "editor/shell/dialogs/recovery_dialog.cpp", "editor/shell/status_line.cpp",
                                  "editor/text/text_assistance.cpp"};
        QStringList found;
        for (const SourceFile& file : sourceFiles({"editor", "app"}, kCode)) {
            if (file.path.startsWith("editor/widgets/plain_text.")) continue;
            if (const auto hit = guessing.match(file.text); hit.hasMatch()) found << file.path + " uses " + hit.captured();
            if (const auto hit = html.match(file.text); hit.hasMatch() && !made.contains(file.path))
                found << file.path + " makes HTML by " + hit.captured();
        }
        QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join('\n')));
    }

    // `.arg(name).arg(line)` substitutes the line into a file called `%2.sim`. Pass several arguments to one arg(), which
    // substitutes all at once; in a chain all arguments but the last must be numbers. Review a new chain, then list it here.
    void namesOfOthersAreNoPatterns() {
        const QStringList numbers = {"wanted.frameCount()",
                                     "pictures",
                                     "m_job.frameCount()",
                                     "instances.size()",
                                     "size",
                                     "pixelRatio",
                                     "int(currentTheme())",
                                     "selected",
                                     "count",
                                     "instances",
                                     "kMaxLiveGroups",
                                     "override ? 600 : 400",
                                     "medium.exponent",
                                     "m_nodes->all()[std::size_t(from)].radio.channel",
                                     "std::lround(r.link.wallLoss / medium.wallLoss)",
                                     "outcomes[i]",
                                     "qulonglong(at), 4, 16, QLatin1Char('0')",
                                     "hex, -int(3 * std::min(kBytesInLine, bytes.size()) - 1)",
                                     "shown",
                                     "r.sequence",
                                     "errors",
                                     "std::floor(whole / 60), 0, 'f', 0",
                                     "static_cast<int>(std::fmod(whole, 60)), 2, 10, QLatin1Char('0')",
                                     "m_found.size()",
                                     "at + 1",
                                     "total - 1",
                                     "wanted.count[0]",
                                     "total",
                                     "kMaxContacts",
                                     "kSlimMargin",
                                     "drawn"};
        const QString call = ".arg(";
        QStringList found;
        for (const SourceFile& file : sourceFiles({"editor", "app/trundle"}, kCode)) {
            for (qsizetype at = file.text.indexOf(call); at >= 0; at = file.text.indexOf(call, at + 1)) {
                qsizetype end = at + call.size();
                for (int depth = 1; depth > 0 && end < file.text.size(); ++end)
                    depth += file.text[end] == '(' ? 1 : file.text[end] == ')' ? -1 : 0;
                if (!file.text.mid(end).trimmed().startsWith(call)) continue;
                const QString argument = file.text.mid(at + call.size(), end - 1 - at - call.size()).simplified();
                if (!numbers.contains(argument)) found << file.path + ": .arg(" + argument + ").arg(...)";
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join('\n')));
    }

    // All program output goes through few functions, each of which removes terminal control sequences (base/clean_text.h).
    void terminalOutputIsCleaned() {
        const QStringList cleaned = {"app/cli/standard_streams.cpp",
                                     "app/host/main.cpp",
                                     "app/meshreader/main.cpp",
                                     "app/trundle/main.cpp",
                                     "app/trundle/problem.cpp",
                                     "core/base/assert.cpp",
                                     "core/base/platform/output_cleaner.cpp"};
        const QRegularExpression saying(
            "stderr|stdout|std::cerr|std::cout|\\bprintf\\(|\\bputs\\(|qWarning|qCritical|qInfo|qDebug");
        QStringList found;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app"}, {".cpp"})) {
            QString code = file.text;
            code.remove(QRegularExpression("//[^\\n]*"));
            if (const auto hit = saying.match(code); hit.hasMatch() && !cleaned.contains(file.path))
                found << file.path + ": " + hit.captured();
        }
        QVERIFY2(found.isEmpty(), qPrintable("\n" + found.join('\n')));
    }

    /// Two types of one name in one namespace are one for the linker, which takes the members of either.
    void typesHaveNamesOfTheirOwn() {
        const QRegularExpression anonymous("^namespace \\{\\n.*?^\\} // namespace$",
                                           QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
        const QRegularExpression type(
            "^(?:namespace ([\\w:]+) \\{|(?:template <[^;{]*> )?(?:struct|class|enum class) (\\w+)(?: final)?(?: : [^;{]*)? \\{)",
            QRegularExpression::MultilineOption);
        QMap<QString, QString> firsts;
        QStringList twice;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app"}, {".h", ".cpp"})) {
            QString text = file.text, space;
            for (auto found = type.globalMatch(text.remove(anonymous)); found.hasNext();) {
                const QRegularExpressionMatch match = found.next();
                if (match.hasCaptured(1)) space = match.captured(1);
                if (match.captured(2).isEmpty() || space.isEmpty()) continue;
                const QString name = space + "::" + match.captured(2);
                if (firsts.contains(name)) twice << name + ": " + firsts[name] + " and " + file.path;
                firsts.insert(name, file.path);
            }
        }
        QVERIFY(firsts.size() > 500);
        QVERIFY2(firsts.contains("trundle::GeomBall") && firsts.contains("trundle::RayScene"), "the search finds nothing");
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join('\n')));
    }

    void headersAreGuardedAndLiveInTheNamespace() {
        for (const SourceFile& file : sourceFiles({"core", "editor", "app"}, {".h"})) {
            if (file.path.section('/', -1).startsWith("abi")) continue; // C includes it too
            QVERIFY2(file.text.contains("#pragma once"), qPrintable(file.path));
            QVERIFY2(!file.text.contains(QRegularExpression("^using namespace ", QRegularExpression::MultilineOption)),
                     qPrintable(file.path));
        }
    }
};

QTEST_APPLESS_MAIN(TreeTest)
#include "tree_test.moc"
