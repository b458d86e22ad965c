// Every file of tests/data/broken has one error. The .expected file beside it holds the complete printed diagnostics. With
// TRUNDLE_ACCEPT=1 the expected files are rewritten; review them before committing.

#include <QTest>

#include <set>

#include "sample_project.h"

using namespace trundle;

namespace {

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> brokenFiles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(TRUNDLE_SOURCE_DIR "/tests/data/broken")) {
        const std::filesystem::path& path = entry.path();
        if (path.extension() == ".sim") names.push_back(path.filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

class BrokenTextsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { std::filesystem::current_path(TRUNDLE_SOURCE_DIR "/tests/data/broken"); }

    void eachIsExplained_data() {
        QTest::addColumn<QString>("name");
        for (const std::string& name : brokenFiles()) QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
    void eachIsExplained() {
        QFETCH(QString, name);
        sample::ProjectFixture fixture;
        const std::string path = name.toStdString();
        for (const std::string& set : setsOf(path)) fixture.options.sets.push_back(set);
        const auto loaded = fixture.openFile(path);
        QVERIFY(loaded);
        const std::string said = sample::rendered(*loaded);
        QVERIFY2(!loaded->diagnostics.all().empty(), "nothing is said about it");
        const std::filesystem::path expected = std::filesystem::path(path).replace_extension(".expected");
        if (qEnvironmentVariableIsSet("TRUNDLE_ACCEPT")) std::ofstream(expected, std::ios::binary) << said;
        QCOMPARE(QString::fromStdString(said), QString::fromStdString(contents(expected)));
        QVERIFY2(loaded->diagnostics.errorCount() <= 3, "more than two errors follow from the first");
    }

    /// Exceptions: codes that no text of the language can cause, or that have their own tests.
    void everyCodeHasAFile() {
        const std::set<Code> elsewhere{Code::TooLarge,      Code::ImportDepth,    Code::TooManyFiles, Code::FileUnreadable,
                                       Code::ImportOutside, Code::ThesisSpelling, Code::TurnRate,     Code::TooManyMistakes,
                                       Code::StartOverlap,  Code::BelowFloor,     Code::Unsupported,  Code::MassRatio,
                                       Code::WheelGeometry, Code::SpringTooFast, Code::MultipleControllers};
        const auto isOfCheck = [](Code code) {
            return code >= Code::WheelOffGround && code <= Code::MovesOtherwise;
        }; // check_model, check_trial
        std::set<Code> seen;
        for (const std::string& name : brokenFiles()) {
            sample::ProjectFixture fixture;
            for (const std::string& set : setsOf(name)) fixture.options.sets.push_back(set);
            const auto loaded = fixture.openFile(name);
            for (const Diagnostic& d : loaded->diagnostics.all()) seen.insert(d.code);
        }
        for (const CodeEntry& entry : allCodes()) {
            if (entry.code >= Code::ModuleNotFound || elsewhere.count(entry.code) || isOfCheck(entry.code)) continue;
            QVERIFY2(seen.count(entry.code), (codeName(entry.code) + " has no broken file: " + std::string(entry.title)).c_str());
        }
    }

    /// Applying a fix removes its diagnostic.
    void fixesRemoveTheirErrors() {
        for (const std::string& name : brokenFiles()) {
            sample::ProjectFixture fixture;
            if (!setsOf(name).empty()) continue;
            const auto loaded = fixture.openFile(name);
            for (const Diagnostic& d : loaded->diagnostics.all()) {
                if (d.fixes.empty()) continue;
                std::string text = contents(name);
                std::vector<TextEdit> edits = d.fixes[0].edits;
                bool here = true;
                for (const TextEdit& e : edits) here = here && e.range.file == 0;
                if (!here) continue;
                std::sort(edits.begin(), edits.end(),
                          [](const TextEdit& a, const TextEdit& b) { return a.range.range.begin > b.range.range.begin; });
                for (const TextEdit& e : edits) text.replace(e.range.range.begin, e.range.range.size(), e.text);
                const std::string repaired = "fixed_" + name + ".txt";
                std::ofstream(repaired, std::ios::binary) << text;
                const auto again = fixture.openFile(repaired);
                std::filesystem::remove(repaired);
                std::size_t before = 0, after = 0;
                for (const Diagnostic& o : loaded->diagnostics.all()) before += o.code == d.code && o.message == d.message;
                for (const Diagnostic& o : again->diagnostics.all()) after += o.code == d.code && o.message == d.message;
                QVERIFY2(after < before, (name + ": the fix '" + d.fixes[0].title + "' does not fix: " + d.message).c_str());
            }
        }
    }

private:
    /// A first line `// --set A=1 --set B=2` represents the command line.
    static std::vector<std::string> setsOf(const std::string& path) {
        std::vector<std::string> sets;
        const std::string text = contents(path);
        std::string line = text.substr(0, text.find('\n'));
        for (std::size_t at; line.starts_with("//") && (at = line.find("--set ")) != std::string::npos;) {
            line.erase(0, at + 6);
            line.insert(0, "//");
            sets.push_back(
                line.substr(2, line.find(" --set ") == std::string::npos ? std::string::npos : line.find(" --set ") - 2));
        }
        return sets;
    }
};

QTEST_APPLESS_MAIN(BrokenTextsTest)
#include "broken_texts_test.moc"
