// Checks the includes and links of the sources against the dependency table in core/README.md.

#include <QtTest>

#include "house/include_rules.h"
#include "house/source_files.h"

using namespace trundle;

class LayersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        const auto readme = sourceFiles({"core/README.md"}, {});
        QCOMPARE(readme.size(), 1);
        m_rules = IncludeRules::fromMarkdown(readme.first().text);
        QVERIFY(m_rules.folders().size() >= 15);
    }

    // The rules themselves reject wrong includes; without this the tests below could pass on an empty rule set.
    void detectsForbiddenIncludes_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("header");
        QTest::addColumn<bool>("inAngles");
        QTest::addColumn<bool>("allowed");
        QTest::newRow("lang uses base") << "core/lang/lexer.cpp"
                                        << "base/result.h" << false << true;
        QTest::newRow("lang knows no model") << "core/lang/lexer.cpp"
                                             << "model/experiment_spec.h" << false << false;
        QTest::newRow("lang knows no schema") << "core/lang/lexer.cpp"
                                              << "schema/kind.h" << false << false;
        QTest::newRow("base looks up to nobody") << "core/base/units.cpp"
                                                 << "lang/tree.h" << false << false;
        QTest::newRow("base has no SDK") << "core/base/units.cpp"
                                         << "trundle/geometry.h" << true << false;
        QTest::newRow("POSIX in platform") << "core/base/platform/process.cpp"
                                           << "unistd.h" << true << true;
        QTest::newRow("POSIX elsewhere") << "core/world/world.cpp"
                                         << "unistd.h" << true << false;
        QTest::newRow("ODE behind its door") << "core/world/ode/engine.cpp"
                                             << "ode/ode.h" << true << true;
        QTest::newRow("ODE outside its door") << "core/world/world.cpp"
                                              << "ode/ode.h" << true << false;
        QTest::newRow("ODE in a device") << "core/devices/motor.cpp"
                                         << "ode/ode.h" << true << false;
        QTest::newRow("Qt in the core") << "core/project/loading/project.cpp"
                                        << "QString" << true << false;
        QTest::newRow("the sources interface alone") << "core/control/catalog.cpp"
                                                     << "project/loading/sources.h" << false << true;
        QTest::newRow("the rest of project") << "core/control/catalog.cpp"
                                             << "project/loading/project.h" << false << false;
        QTest::newRow("a plugin on the SDK") << "plugins/controllers/a/a.cpp"
                                             << "trundle/controller.h" << true << true;
        QTest::newRow("a plugin in the core") << "plugins/controllers/a/a.cpp"
                                              << "base/result.h" << false << false;
        QTest::newRow("a panel on the document") << "editor/outline/a.cpp"
                                                 << "editor/document/document.h" << false << true;
        QTest::newRow("a panel on another panel") << "editor/outline/a.cpp"
                                                  << "editor/text/text_panel.h" << false << false;
        QTest::newRow("a panel on the core") << "editor/outline/a.cpp"
                                             << "project/edits/plans.h" << false << true;
        QTest::newRow("OSG in the window") << "editor/outline/a.cpp"
                                           << "osg/Node" << true << false;
        QTest::newRow("the core on the window") << "core/project/loading/project.cpp"
                                                << "editor/document/document.h" << false << false;
        QTest::newRow("an unknown library") << "core/world/world.cpp"
                                            << "boost/any.hpp" << true << false;
    }
    void detectsForbiddenIncludes() {
        QFETCH(QString, file);
        QFETCH(QString, header);
        QFETCH(bool, inAngles);
        QFETCH(bool, allowed);
        const QString violation = m_rules.violation(file, header, inAngles);
        QVERIFY2(violation.isEmpty() == allowed, qPrintable(violation));
    }

    void everyIncludeFollowsTheTable() {
        QStringList violations;
        int count = 0;
        for (const SourceFile& file :
             sourceFiles({"core", "editor", "app", "plugins"}, {".h", ".cpp", ".hpp", ".c", ".cc", ".inl"})) {
            for (const IncludeLine& include : includesOf(file.text)) {
                ++count;
                const QString violation = m_rules.violation(file.path, include.header, include.inAngles);
                if (!violation.isEmpty()) violations << QString("%1:%2: %3").arg(file.path).arg(include.line).arg(violation);
            }
        }
        QVERIFY2(violations.isEmpty(), qPrintable("\n" + violations.join('\n')));
        QVERIFY(count > 100);
    }

    void everyLinkFollowsTheTable() {
        QVERIFY(!m_rules.linkViolation("lang", "model").isEmpty());
        QVERIFY(m_rules.linkViolation("model", "lang").isEmpty());
        static const QRegularExpression library("trundle::(\\w+)");
        QStringList violations;
        for (const SourceFile& file : sourceFiles({"core"}, {"CMakeLists.txt"})) {
            const QString folder = file.path.section('/', 1, 1);
            if (folder == "CMakeLists.txt" || folder == "sdk") continue;
            for (auto match = library.globalMatch(file.text); match.hasNext();) {
                const QString violation = m_rules.linkViolation(folder, match.next().captured(1));
                if (!violation.isEmpty()) violations << file.path + ": " + violation;
            }
        }
        QVERIFY2(violations.isEmpty(), qPrintable("\n" + violations.join('\n')));
    }

    // A header and its source count as one. Two files that need each other are one class, or a third one is missing.
    void noFilesIncludeEachOtherInACircle() {
        QMap<QString, QSet<QString>> uses;
        QSet<QString> headers;
        const auto unit = [](const QString& path) { return path.section('.', 0, -2); };
        const QList<SourceFile> files = sourceFiles({"core", "editor", "app", "plugins"}, {".h", ".cpp"});
        for (const SourceFile& file : files)
            if (file.path.endsWith(".h")) headers.insert(file.path);
        for (const SourceFile& file : files) {
            for (const IncludeLine& include : includesOf(file.text)) {
                if (include.inAngles) continue;
                for (const QString& folder :
                     {QString("core/"), QString("app/"), QString(), file.path.section('/', 0, -2) + '/'}) {
                    if (!headers.contains(folder + include.header)) continue;
                    if (unit(folder + include.header) != unit(file.path))
                        uses[unit(file.path)].insert(unit(folder + include.header));
                    break;
                }
            }
        }
        QVERIFY(uses.size() > 300);
        QStringList circles;
        for (auto each = uses.cbegin(); each != uses.cend(); ++each) {
            QSet<QString> reached;
            for (QStringList open(each->begin(), each->end()); !open.isEmpty();) {
                const QString next = open.takeLast();
                if (reached.contains(next)) continue;
                reached.insert(next);
                open += uses.value(next).values();
            }
            if (reached.contains(each.key())) circles << each.key();
        }
        QVERIFY2(circles.isEmpty(), qPrintable("these reach themselves: " + circles.join(' ')));
    }

    // An include then shows which one is meant.
    void noTwoHeadersHaveOneName() {
        QMap<QString, QString> paths;
        for (const SourceFile& file : sourceFiles({"core", "editor", "app", "plugins"}, {".h"})) {
            const QString name = file.path.section('/', -1);
            QVERIFY2(!paths.contains(name), qPrintable(file.path + " and " + paths.value(name)));
            paths[name] = file.path;
        }
    }

    // A folder without files of its own may leave the rows to the folders in it.
    void everyFolderOfCoreHasARow() {
        for (const SourceFile& file : sourceFiles({"core"}, {".h", ".cpp"})) {
            const QStringList folders = file.path.section('/', 0, -2).split('/');
            bool row = false;
            for (int depth = 2; depth <= folders.size(); ++depth)
                row |= m_rules.folders().contains(folders.mid(0, depth).join('/'));
            QVERIFY2(row, qPrintable("core/README.md has no row for " + file.path));
        }
    }

    // "Where it happens": each row names a file and functions that are defined in it.
    void findsTheFunctionsOfTheReadme() {
        const QString readme = sourceFiles({"core/README.md"}, {}).first().text;
        const QString section = readme.section("## Where it happens", 1).section("\n## ", 0, 0);
        static const QRegularExpression inBackticks("`([^`]+)`");
        QStringList missing;
        QMap<QString, QString> text;
        for (const SourceFile& file : sourceFiles({"core", "editor"}, {".cpp"})) text[file.path] = file.text;
        int rows = 0;
        for (const QString& row : section.split('\n')) {
            if (!row.startsWith("| ") || row.section('|', 2, 2).count('`') != 2) continue;
            ++rows;
            const QString path = row.section('`', 1, 1);
            const QString source = text.value(path);
            for (auto match = inBackticks.globalMatch(row.section('|', 3, 3)); match.hasNext();) {
                const QString name = match.next().captured(1);
                const QRegularExpression definition("^\\S.*\\b" + name.section("::", -1) + "\\([^;]*\\{$",
                                                    QRegularExpression::MultilineOption);
                if (!definition.match(source).hasMatch()) missing << path + ": " + name;
            }
        }
        QVERIFY(rows >= 10);
        QVERIFY2(missing.isEmpty(), qPrintable("core/README.md, Where it happens: no " + missing.join(", no ")));
    }

private:
    IncludeRules m_rules;
};

QTEST_APPLESS_MAIN(LayersTest)
#include "layers_test.moc"
