// Misspelt property names and kinds in the shipped texts: the correct word is the first suggestion.

#include <map>
#include <set>
#include <span>

#include "base/rng.h"
#include "flow/cli.h"
#include "lang/tree.h"

using namespace trundle;

namespace {

struct Word {
    std::string text;
    TextRange range;
};

void collect(const std::vector<Item>& items, const std::string& inside, std::vector<std::pair<std::string, Word>>& out) {
    for (const Item& item : items) {
        if (const auto* assignment = item.as<AssignmentItem>())
            out.push_back({inside, {assignment->path.back().text, assignment->path.back().range}});
        if (const auto* param = item.as<ParamItem>()) collect(param->items, "Param", out);
        if (const auto* block = item.as<BlockItem>()) {
            out.push_back({inside, {block->type.text, block->type.range}});
            collect(block->items, block->type.text, out);
        }
    }
}

/// All words at edit distance one: a letter removed, doubled, swapped with the next, replaced or added, and the other case.
std::vector<std::string> typosOf(const std::string& word) {
    static const std::string letters = "aeinorstxk";
    std::set<std::string> all;
    for (std::size_t i = 0; i < word.size(); ++i) {
        std::string w = word;
        all.insert(w.erase(i, 1));
        w = word;
        if (i + 1 < w.size()) std::swap(w[i], w[i + 1]), all.insert(w);
        for (const char letter : letters) {
            w = word;
            w[i] = letter;
            all.insert(w);
            w = word;
            all.insert(w.insert(i, 1, letter));
        }
        w = word;
        w[i] = static_cast<char>(std::isupper(static_cast<unsigned char>(w[i])) ? std::tolower(w[i]) : std::toupper(w[i]));
        all.insert(w);
    }
    all.erase(word);
    std::vector<std::string> words;
    for (const std::string& w : all)
        if (!w.empty() && !std::isdigit(static_cast<unsigned char>(w[0]))) words.push_back(w);
    return words;
}

} // namespace

class TyposFlowTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ranksRightWordFirst() {
        const std::size_t perWord = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 60 : 1;
        std::set<std::pair<std::string, std::string>> seen;
        QStringList files = allConfigs();
        files << QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/parts_kit.sim");
        for (const QString& path : files) {
            if (path.contains("thesis") || path.endsWith(".txt")) continue;
            const QByteArray bytes = contentOf(path);
            const auto tree = parse(std::make_shared<SourceText>("t.sim", bytes.toStdString()), 0);
            std::vector<std::pair<std::string, Word>> words;
            collect(tree->items(), "", words);
            std::vector<Misspelt> all;
            for (const auto& [inside, word] : words) {
                if (!seen.insert({inside, word.text}).second) continue;
                std::vector<std::string> typos = typosOf(word.text);
                for (std::size_t n = 0; n < perWord && !typos.empty(); ++n) {
                    const std::size_t at = randomBits(7, fnv1a64(word.text + "/" + inside), 0, n) % typos.size();
                    all.push_back({typos[at], inside, word, tree->source().position(word.range.begin)});
                    typos.erase(typos.begin() + static_cast<std::ptrdiff_t>(at));
                }
            }
            constexpr std::size_t kAtOnce = 50; // files in one call of the program, which saves its starts
            for (std::size_t first = 0; first < all.size(); first += kAtOnce)
                ask(bytes, std::span(all).subspan(first, std::min(kAtOnce, all.size() - first)));
            if (QTest::currentTestFailed()) return;
        }
        qInfo("%d of %d misspelt words found their way back", m_right, m_asked);
        QVERIFY(m_asked > 100);
        QVERIFY2(m_right >= 0.95 * m_asked, m_wrong);
    }

private:
    struct Misspelt {
        std::string typo, inside;
        Word word;
        LineColumn place;
    };

    /// Checks a text once for each typo in it.
    void ask(const QByteArray& bytes, std::span<const Misspelt> all) {
        QTemporaryDir folder;
        QStringList words{"check", "--json", "-I", QStringLiteral(TRUNDLE_SOURCE_DIR "/configs")};
        std::map<QString, const Misspelt*> byFile;
        for (const Misspelt& each : all) {
            QByteArray text = bytes;
            text.replace(int(each.word.range.begin), int(each.word.range.size()), QByteArray::fromStdString(each.typo));
            const QString file = folder.filePath(QStringLiteral("typo%1.sim").arg(byFile.size()));
            QVERIFY(writeFile(file, text));
            byFile[file] = &each;
            words << file;
        }
        const Outcome check = cli(words);
        QVERIFY2(check.code == 0 || check.code == 1, shown(check));
        for (const QJsonValue& value : QJsonDocument::fromJson(check.out).array()) {
            const QJsonObject d = value.toObject();
            const auto file = byFile.find(d["file"].toString());
            if (file == byFile.end() || d["severity"].toString() != "error") continue;
            const Misspelt& each = *file->second;
            if (d["line"].toInt() != int(each.place.line) || d["column"].toInt() != int(each.place.column)) continue;
            byFile.erase(file); // its first message counts
            ++m_asked;
            if (d["suggestions"].toArray().first().toString().toStdString() == each.word.text) ++m_right;
            else
                m_wrong += QByteArray::fromStdString("\n" + each.typo + " for " + each.word.text + " in " + each.inside + ": ") +
                           QJsonDocument(d).toJson(QJsonDocument::Compact);
        }
    }

    int m_asked = 0, m_right = 0;
    QByteArray m_wrong;
};

QTEST_GUILESS_MAIN(TyposFlowTest)
#include "typos_test.moc"
