// Classes stay small enough to hold in the head: at most 300 lines of methods in all its files, and 25 public methods.

#include <QMap>
#include <QRegularExpression>
#include <QtTest>

#include "house/source_files.h"

using namespace trundle;

namespace {

constexpr int kMaxLines = 300, kMaxPublic = 25;

struct ClassSize {
    int lines = 0, publicMethods = 0;
};

/// Classes that exceed a limit, with what they may have. A number here may only shrink, and a class that keeps the limits leaves.
const QMap<QString, ClassSize>& exceptions() {
    static const QMap<QString, ClassSize> all = {
        {"editor/outline/OutlineModel", {350, 30}},
        {"editor/text/CodeEdit", {370, 36}},
    };
    return all;
}

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
            const ClassSize most = exceptions().value(it.key(), {kMaxLines, kMaxPublic});
            if (it->lines > std::max(most.lines, kMaxLines))
                large << QString("%1 has %2 lines of methods, at most %3")
                             .arg(it.key())
                             .arg(it->lines)
                             .arg(std::max(most.lines, kMaxLines));
            if (it->publicMethods > std::max(most.publicMethods, kMaxPublic))
                large << QString("%1 has %2 public methods, at most %3")
                             .arg(it.key())
                             .arg(it->publicMethods)
                             .arg(std::max(most.publicMethods, kMaxPublic));
        }
        for (const QString& line : large) qWarning("%s", qPrintable(line));
        QVERIFY(large.isEmpty());
    }

    /// A class that keeps both limits is no exception any more.
    void exceptionsAreNeeded() {
        const QMap<QString, ClassSize> sizes = measured();
        QStringList needless;
        for (auto it = exceptions().begin(); it != exceptions().end(); ++it) {
            const ClassSize now = sizes.value(it.key());
            if (now.lines <= kMaxLines && now.publicMethods <= kMaxPublic) needless << it.key();
        }
        QVERIFY2(needless.isEmpty(), qPrintable("these keep the limits now: " + needless.join(", ")));
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
