// How paths are shown, what is inside a folder, and where a project begins: by whole names, not by how they start.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "lang/parser.h"
#include "model/kinds/model_kinds.h"
#include "project/loading/search.h"
#include "project/saving/named_files.h"
#include "sample_project.h"

using namespace trundle;

class SearchTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string path(const char* name) const { return canonicalPath(m_folder.filePath(QLatin1String(name)).toStdString()); }
    std::string write(const char* name) const {
        QDir(m_folder.path()).mkpath(QFileInfo(QLatin1String(name)).path());
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (!file.open(QFile::WriteOnly)) qFatal("cannot write");
        return path(name);
    }

private Q_SLOTS:
    void aProjectBeginsAtItsMark() {
        QDir(m_folder.path()).mkpath(QStringLiteral("lab/.trundle"));
        QCOMPARE(projectFolderOf(write("lab/deep/in/a.sim")), path("lab/deep/../../lab"));
        QCOMPARE(projectFolderOf(write("share/configs/robots/b.sim")), path("share/configs"));
        QCOMPARE(projectFolderOf(write("share/myconfigs/robots/b.sim")), path("share/myconfigs/robots"));
        QCOMPARE(projectFolderOf(write("alone/c.sim")), path("alone"));
    }

    /// In its project a file is shown from there, that of another project from that one; the bare name of a file elsewhere could be
    /// any file's.
    void shownFromTheirProject() {
        QDir(m_folder.path()).mkpath(QStringLiteral("lab/.trundle"));
        QDir(m_folder.path()).mkpath(QStringLiteral("other/.trundle"));
        const std::string lab = path("lab");
        QCOMPARE(shownInProject(write("lab/robots/a.sim"), lab), std::string("robots/a.sim"));
        QCOMPARE(shownInProject(write("lab/a.sim"), lab), std::string("a.sim"));
        QCOMPARE(shownInProject(write("other/robots/b.sim"), lab), std::string("robots/b.sim"));
        for (const char* name : {"alone/c.sim", "lab2/c.sim", "other/d.sim"}) {
            const std::string file = write(name);
            QCOMPARE(shownInProject(file, lab), file);
            QCOMPARE(shownInProject(file, ""), file);
        }
    }

    /// A folder whose name begins as that of another one is not inside it, nor is the folder itself.
    void insideAFolder() {
        const std::string file = write("project/a.sim"), other = write("project2/a.sim");
        QVERIFY(isInside(file, {path("project")}));
        QVERIFY(isInside(file, {path("project2"), path("project")}));
        QVERIFY(!isInside(other, {path("project")}));
        QVERIFY(!isInside(path("project"), {path("project")}));
        QVERIFY(!isInside(file, {""}));
        QCOMPARE(shownPath(other, path("project")), other);
        QCOMPARE(shownPath(other, path("project2")), std::string("a.sim"));
    }

    /// The file is not found, and the one with the ending of a text is offered, also for names too short to be a misspelling.
    void aFolderWithTheNameOfAFile() {
        write("arms/arm.sim");
        write("arms/arm.obj");
        write("arms/sub/r.sim");
        QDir(m_folder.path()).mkpath(QStringLiteral("arms/arm"));
        const std::string arms = path("arms");
        const FileSearch search({});
        const Result<std::string> found = search.find("arm", arms);
        QVERIFY(!found && found.error().code == Code::ImportNotFound);
        QCOMPARE(found.error().message,
                 "arm is not found: " + shownPath(arms + "/arm") + " is a folder; looked in " + shownPath(arms));
        QCOMPARE(search.nearest("arm", arms, "sim").front(), std::string("arm.sim"));
        QCOMPARE(search.nearest("sub/r", arms, "sim"), std::vector<std::string>{"sub/r.sim"});
        QVERIFY(search.nearest("sub/r", arms).empty());

        sample::ProjectFixture fixture;
        fixture.write("arm/hand.sim", "");
        fixture.write("arm.sim", "");
        const auto loaded = fixture.open("#import arm\n");
        QCOMPARE(loaded->diagnostics.all().at(0).fixes.at(0).title, std::string("arm.sim"));
    }

    /// A file is not offered where it would import itself.
    void aMissingImportIsNotTheFileItself() {
        sample::ProjectFixture fixture;
        fixture.write("mait.sim", "#import maip.sim\n");
        const auto loaded = fixture.open("#import mair.sim\n#import mait.sim\n");
        std::vector<Diagnostic> all = loaded->diagnostics.all();
        std::erase_if(all, [](const Diagnostic& each) { return each.code != Code::ImportNotFound; });
        QCOMPARE(all.size(), std::size_t(2));
        QCOMPARE(all[0].suggestions, std::vector<std::string>{"mait.sim"}); // not main.sim
        QVERIFY(all[1].suggestions.empty() && all[1].fixes.empty());        // both import it
    }

    /// Where texts name a file: in properties that are files, also by override, and in the Params that these have, through others;
    /// whole values, not parts of them.
    void namesOfFilesInTexts() {
        const std::string text = "Param skin = $wood { Help=\"wood.png\" }\nParam wood = wood.png\nParam other = wood.png\n"
                                 "Param list = a.png, \"wood.png\"\n"
                                 "Material m { Texture=wood.png Param p = wood.png }\nMaterial n { Texture=$skin }\n"
                                 "StaticConfig S { Param q = wood.png Mesh b { File=$q Material=wood.png }\n"
                                 "  Mesh c { File=wood.png.bak } }\n"
                                 "StaticConfig T { Mesh b { File=$(if(1 > 2, q, element(list, 1))) } }\n"
                                 "Static s { Config=S q=\"wood.png\" b.Material=wood.png }\n"
                                 "Static t { Config=S b.File=wood.png }\n";
        LoadedProject loaded;
        const auto registry = std::make_shared<Registry>();
        addModelKinds(*registry);
        loaded.registry = registry;
        loaded.trees = {parse(std::make_shared<const SourceText>("a.sim", text), 0)};
        std::vector<std::uint32_t> found, wanted;
        const FileWords all = fileWordsIn(loaded);
        for (const TextRange& range : all.at({FileId{0}, "wood.png"})) {
            const std::string_view words = loaded.trees[0]->source().slice(range);
            QVERIFY(words == "wood.png" || words == "\"wood.png\"");
            found.push_back(range.begin);
        }
        std::ranges::sort(found);
        for (const char* before : {"Param wood = ", "a.png, ", "Texture=", "Param q = ", "S q=", "b.File="})
            wanted.push_back(static_cast<std::uint32_t>(text.find(before) + std::string_view(before).size()));
        QCOMPARE(found, wanted);
    }
};

QTEST_GUILESS_MAIN(SearchTest)
#include "search_test.moc"
