// Misspelt property names and kinds in the shipped texts: the correct word is the first suggestion.

#include <set>

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
        QTemporaryDir folder;
        std::set<std::pair<std::string, std::string>> seen;
        int asked = 0, right = 0;
        QByteArray wrong;
        QStringList files = allConfigs();
        files << QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/parts_kit.sim");
        for (const QString& path : files) {
            if (path.contains("thesis") || path.endsWith(".txt")) continue;
            const QByteArray bytes = contentOf(path);
            const auto tree = parse(std::make_shared<SourceText>("t.sim", bytes.toStdString()), 0);
            std::vector<std::pair<std::string, Word>> words;
            collect(tree->items(), "", words);
            for (const auto& [inside, word] : words) {
                if (!seen.insert({inside, word.text}).second) continue;
                std::vector<std::string> typos = typosOf(word.text);
                for (std::size_t n = 0; n < perWord && !typos.empty(); ++n) {
                    const std::size_t at = randomBits(7, fnv1a64(word.text + "/" + inside), 0, n) % typos.size();
                    const std::string typo = typos[at];
                    typos.erase(typos.begin() + static_cast<std::ptrdiff_t>(at));
                    QByteArray text = bytes;
                    text.replace(int(word.range.begin), int(word.range.size()), QByteArray::fromStdString(typo));
                    const QString file = folder.filePath("typo.sim");
                    QVERIFY(writeFile(file, text));
                    const Outcome check = cli({"check", file, "--json", "-I", QStringLiteral(TRUNDLE_SOURCE_DIR "/configs")});
                    QVERIFY2(check.code == 0 || check.code == 1, shown(check));
                    const LineColumn place = tree->source().position(word.range.begin);
                    for (const QJsonValue& value : QJsonDocument::fromJson(check.out).array()) {
                        const QJsonObject d = value.toObject();
                        if (d["line"].toInt() != int(place.line) || d["column"].toInt() != int(place.column) ||
                            d["severity"].toString() != "error")
                            continue;
                        ++asked;
                        if (d["suggestions"].toArray().first().toString().toStdString() == word.text) ++right;
                        else
                            wrong += QByteArray::fromStdString("\n" + typo + " for " + word.text + " in " + inside + ": ") +
                                     QJsonDocument(d).toJson(QJsonDocument::Compact);
                        break;
                    }
                }
            }
        }
        qInfo("%d of %d misspelt words found their way back", right, asked);
        QVERIFY(asked > 100);
        QVERIFY2(right >= 0.95 * asked, wrong);
    }
};

QTEST_GUILESS_MAIN(TyposFlowTest)
#include "typos_test.moc"
