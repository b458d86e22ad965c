// Every kind and property of the language, misspelt: the message suggests the word that was meant.
#include <QTest>

#include "model_fixture.h"
#include "schema/allowed_parents.h"

using namespace trundle;
using sample::Resolved;
using sample::resolved;

namespace {

/// One letter missing, or two exchanged; a short word has one letter too many.
std::vector<std::string> misspelt(const std::string& word) {
    if (word.size() < 4) return {word + word.back()};
    const std::size_t middle = word.size() / 2;
    std::string missing = word, exchanged = word;
    missing.erase(middle, 1);
    std::swap(exchanged[middle], exchanged[middle - 1]);
    return exchanged == word ? std::vector<std::string>{missing} : std::vector<std::string>{missing, exchanged};
}

/// The text of a block in a place where its kind is allowed.
std::string placed(const Kind& kind, const std::string& block) {
    const std::vector<std::string> parents = allowedParents(kind);
    if (parents.empty() || std::ranges::find(parents, std::string()) != parents.end())
        return "Material zz { }\n" + block + "\n"; // no file of blocks for import
    for (const char* config : {"RobotConfig", "StaticConfig", "PartConfig"})
        if (isAllowedInside(kind, config)) return std::string(config) + " Outer {\n" + block + "\n}\n";
    if (isAllowedInside(kind, "Body")) return "RobotConfig Outer { Body b {\n" + block + "\n} }\n";
    return "Robot outer { Config=None\n" + block + "\n}\n";
}

/// What is suggested first for an unknown word; empty if nothing is.
std::string suggestionFor(const std::string& text, const std::string& word) {
    const Resolved r = resolved(text);
    for (const Diagnostic& d : r.diagnostics.all())
        if ((d.code == Code::UnknownKey || d.code == Code::UnknownKind) && r.slice(d.range) == word && !d.suggestions.empty())
            return d.suggestions.front();
    return {};
}

} // namespace

class MisspeltWordsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyKind() {
        int asked = 0;
        for (const Kind* kind : m_kinds->all()) {
            if (kind->role == Role::Settings || kind->role == Role::Controller)
                continue; // a controller's kind may be one to come
            for (const std::string& typo : misspelt(kind->name)) {
                if (m_kinds->find(typo)) continue;
                const std::string said = suggestionFor(placed(*kind, typo + " x { }"), typo);
                QVERIFY2(said == kind->name, (typo + " for " + kind->name + ": " + said).c_str());
                ++asked;
            }
        }
        QVERIFY(asked > 60);
    }

    void everyProperty() {
        int asked = 0;
        for (const Kind* kind : m_kinds->all()) {
            for (const Property& property : kind->properties) {
                for (const std::string& typo : misspelt(property.name)) {
                    if (kind->find(typo)) continue;
                    const bool isSetting = kind->role == Role::Settings;
                    const std::string line = typo + "=1",
                                      block = isSetting ? "Seed=1\n" + line : kind->name + " x { " + line + " }";
                    const std::string said = suggestionFor(placed(*kind, block), typo);
                    QVERIFY2(said == property.name, (typo + " for " + property.name + " of " + kind->name + ": " + said).c_str());
                    ++asked;
                }
            }
        }
        QVERIFY(asked > 300);
    }

private:
    const std::shared_ptr<const Registry> m_kinds = sample::kindsWithWalker();
};

QTEST_APPLESS_MAIN(MisspeltWordsTest)
#include "misspelt_words_test.moc"
