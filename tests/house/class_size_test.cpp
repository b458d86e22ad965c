// Classes stay small enough to hold in the head: at most 300 lines of methods in all its files, and 25 public methods. Functions have
// at most 50 lines.

#include <QMap>
#include <QRegularExpression>
#include <QtTest>

#include "house/source_files.h"

using namespace trundle;

namespace {

constexpr int kMaxLines = 300, kMaxPublic = 25, kMaxFunction = 50;

struct ClassSize {
    int lines = 0, publicMethods = 0;
};

/// The text without comments, strings and preprocessor lines, with the same line ends.
QString codeOf(QString text) {
    static const QRegularExpression noise(
        "R\"\\((?:.|\\n)*?\\)\"|\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])'|//[^\\n]*|/\\*(?:.|\\n)*?\\*/|^[ ]*#[^\\n]*",
        QRegularExpression::MultilineOption);
    QString code;
    qsizetype done = 0;
    for (auto it = noise.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        code += text.mid(done, match.capturedStart() - done) + QString(match.captured().count('\n'), '\n');
        done = match.capturedEnd();
    }
    return code + text.mid(done);
}

/// Lines of the methods defined in a source file, by class: from the line of `Class::method(` to its closing brace.
void countLines(const QString& folder, const QString& code, QMap<QString, ClassSize>& sizes) {
    static const QRegularExpression head("^(?:[A-Za-z_][^\\n;={}()]*?[ *&>])?"
                                         "?(\\w+)::(?:~?\\w+|operator[^(]*)\\(");
    const QStringList lines = code.split('\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const auto match = head.match(lines[i]);
        if (!match.hasMatch()) continue;
        const qsizetype first = i;
        int depth = 0;
        bool body = false;
        for (; i < lines.size(); ++i) {
            depth += int(lines[i].count('{')) - int(lines[i].count('}'));
            body = body || lines[i].contains('{');
            if ((body && depth <= 0) || (!body && lines[i].endsWith(';'))) break;
        }
        if (body) sizes[folder + "/" + match.captured(1)].lines += int(i - first + 1);
    }
}

/// Public methods of the classes declared in a header: what has parentheses, is no constructor and stands under `public`.
void countPublic(const QString& folder, const QString& code, QMap<QString, ClassSize>& sizes) {
    static const QRegularExpression open("\\bclass\\s+(\\w+)(?:\\s+final)?\\s*(?::[^;{]*)?\\{");
    for (auto it = open.globalMatch(code); it.hasNext();) {
        const auto match = it.next();
        const QString name = match.captured(1);
        bool isPublic = false;
        int depth = 0, parens = 0;
        QString statement;
        for (qsizetype i = match.capturedEnd(); i < code.size() && depth >= 0; ++i) {
            const QChar c = code[i];
            if (c == '{') ++depth;
            if (c == '}') --depth;
            if (c == '(') ++parens;
            if (c == ')') --parens;
            const bool label = c == ':' && depth == 0 && parens == 0 && code[i + 1] != ':' && code[i - 1] != ':';
            if (label) {
                const QString word = statement.simplified();
                static const QRegularExpression access(
                    "\\b(public|protected|private|Q_SIGNALS)( Q_SLOTS)?$"); // also behind Q_OBJECT
                if (const auto found = access.match(word); found.hasMatch())
                    isPublic = found.captured(1) == "public" || found.captured(1) == "Q_SIGNALS";
                if (word.contains('(')) continue; // of a constructor
                statement.clear();
                continue;
            }
            const bool ends = depth == 0 && parens == 0 && (c == ';' || c == '}');
            if (!ends) {
                if (depth == 0) statement += c;
                continue;
            }
            const QString text = statement.section('{', 0, 0).simplified();
            const QString called = text.section('(', 0, 0).trimmed().section(QRegularExpression("[ *&]"), -1);
            const bool method = text.contains('(') && !text.startsWith("using") && !text.startsWith("friend") &&
                                !text.startsWith("Q_") && called != name && called != "~" + name &&
                                !called.startsWith("operator") && !text.contains("= delete");
            if (isPublic && method) ++sizes[folder + "/" + name].publicMethods;
            statement.clear();
        }
    }
}

/// Functions that are tables, by file and what their first line has.
const QStringList kTables = {"core/scene/shaders/scene_shading.cpp: SceneShading::SceneShading()"};

struct Function {
    QString head; ///< its first line
    int lines = 0;
};

/// The functions of a formatted file: each ends with a brace as far to the left as its first line, at the margin or in a class.
QList<Function> functionsIn(const QString& code) {
    static const QRegularExpression opensClass("^(?:class|struct|union)\\b.*\\{$"), starts("^[A-Za-z_~\\[].*\\(");
    QList<Function> functions;
    const QStringList lines = code.split('\n');
    QString margin;
    qsizetype first = -1;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString line = lines[i].trimmed().isEmpty() ? QString() : lines[i];
        const QString inner = line.startsWith(margin) ? line.mid(margin.size()).trimmed() : QString();
        const bool isAtMargin = !inner.isEmpty() && line[margin.size()] != ' ';
        if (opensClass.match(line.trimmed()).hasMatch() && margin.isEmpty() && isAtMargin) margin = "    ";
        else if (line.startsWith("};")) margin.clear();
        else if (isAtMargin && inner == "}" && first >= 0) functions.append({lines[first].trimmed(), int(i - first + 1)});
        else if (isAtMargin && starts.match(inner).hasMatch()) {
            first = i;
            continue;
        } else if (!isAtMargin) continue;
        first = -1;
    }
    return functions;
}

QMap<QString, ClassSize> measured() {
    QMap<QString, ClassSize> sizes;
    for (const SourceFile& file : sourceFiles({"core", "editor", "app"}, {".cpp", ".h"})) {
        const QString folder = file.path.section('/', 0, 1), code = codeOf(file.text);
        if (file.path.endsWith(".cpp")) countLines(folder, code, sizes);
        else countPublic(folder, code, sizes);
    }
    return sizes;
}

} // namespace

class ClassSizeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void classesStaySmall() {
        QStringList large;
        const QMap<QString, ClassSize> sizes = measured();
        QVERIFY(sizes.size() > 300);
        for (auto it = sizes.begin(); it != sizes.end(); ++it) {
            if (it->lines > kMaxLines)
                large << QString("%1 has %2 lines of methods, at most %3").arg(it.key()).arg(it->lines).arg(kMaxLines);
            if (it->publicMethods > kMaxPublic)
                large << QString("%1 has %2 public methods, at most %3").arg(it.key()).arg(it->publicMethods).arg(kMaxPublic);
        }
        for (const QString& line : large) qWarning("%s", qPrintable(line));
        QVERIFY(large.isEmpty());
    }

    void functionsStayShort() {
        QStringList tooLong, tables = kTables;
        int count = 0;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app", "plugins"}, {".cpp", ".h"}))
            for (const Function& function : functionsIn(codeOf(file.text))) {
                ++count;
                if (function.lines <= kMaxFunction) continue;
                const QString name = file.path + ": " + function.head;
                if (!tables.removeOne(name)) tooLong << QString("%1 has %2 lines").arg(name).arg(function.lines);
            }
        QVERIFY(count > 5000);
        QVERIFY2(tooLong.isEmpty(), qPrintable(tooLong.join("; ")));
        QVERIFY2(tables.isEmpty(), qPrintable("these are short now: " + tables.join("; ")));
    }

    void findsFunctions() {
        const QList<Function> functions =
            functionsIn(codeOf("namespace a {\nvoid one(int a,\n         int b) {\n    if (a) {\n    }\n}\nint x = "
                               "f(1);\n\nA::A()\n    : m_x(1) {\n    go();\n}\n"
                               "class B {\npublic:\n    void two() { return; }\n    // a word\n    void three() {\n        for "
                               "(;;) {\n        }\n    }\n"
                               "};\nconst T kTable = {\n    1,\n};\nint four() {\n    return 4;\n}\n} // namespace a\n"));
        QStringList found;
        for (const Function& f : functions) found << QString("%1 %2").arg(f.head).arg(f.lines);
        QCOMPARE(found, (QStringList{"void one(int a, 5", "A::A() 4", "void three() { 4", "int four() { 3"}));
    }

    void countsWhatItSays() {
        QMap<QString, ClassSize> sizes;
        countLines(
            "f",
            codeOf("/* A::no( */\nint A::one() { return 1; }\n\nvoid A::two(int a,\n            int b) {\n    f(\"}\");\n}\n"
                   "A::A()\n    : m_x(1) {}\nint free() {\n}\nint A::later();\n"),
            sizes);
        QCOMPARE(sizes["f/A"].lines, 1 + 4 + 2);
        countPublic(
            "f",
            codeOf("class A final : public B {\npublic:\n    A();\n    ~A();\n    int one(int x = f(1)) const { return x; }\n"
                   "    void two(); // three()\n    int value = 0;\n    enum class E { a };\nprivate:\n    void hidden();\n};\n"
                   "class Forward;\n"),
            sizes);
        QCOMPARE(sizes["f/A"].publicMethods, 2);
        QVERIFY(!sizes.contains("f/Forward"));
    }
};

QTEST_APPLESS_MAIN(ClassSizeTest)
#include "class_size_test.moc"
