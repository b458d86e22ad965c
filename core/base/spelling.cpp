#include "base/spelling.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace trundle {
namespace {

constexpr double kCaseCost = 0.3;
constexpr std::size_t kLongestWord = 64; ///< longer words are no spelling mistakes; bounds the cost

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool startsLike(std::string_view word, std::string_view start) {
    return word.size() >= start.size() &&
           std::equal(start.begin(), start.end(), word.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

double substitution(char a, char b) {
    if (a == b) return 0;
    return lower(a) == lower(b) ? kCaseCost : 1;
}

/// The largest distance at which a word of this length still counts as a misspelling.
double reach(std::size_t length) {
    if (length <= 3) return 1;
    return length <= 5 ? 2 : static_cast<double>(length) / 3 + 1;
}

} // namespace

double spellingDistance(std::string_view a, std::string_view b) {
    if (a.size() > kLongestWord || b.size() > kLongestWord) return a == b ? 0 : static_cast<double>(std::max(a.size(), b.size()));
    std::array<double, 3 * (kLongestWord + 1)> rows;
    double *before = rows.data(), *last = before + kLongestWord + 1, *row = last + kLongestWord + 1;
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<double>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<double>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + substitution(a[i - 1], b[j - 1])});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1])) {
                const double cases = substitution(a[i - 1], b[j - 2]) + substitution(a[i - 2], b[j - 1]);
                row[j] = std::min(row[j], before[j - 2] + std::min(1 + cases, 2.0));
            }
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::vector<std::string> nearestWords(std::string_view word, std::span<const std::string> candidates, std::size_t most) {
    struct Ranked {
        double distance;
        const std::string* word;
    };
    std::vector<Ranked> near;
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        const std::size_t shorter = std::min(word.size(), candidate.size());
        double distance = static_cast<double>(longer - shorter); // a lower bound of the distance
        if (distance <= reach(longer)) distance = spellingDistance(word, candidate);
        // A shortened or extended word: "Color" for ColorRGB, "Radiuses" for Radius.
        if (shorter >= 3 && startsLike(candidate, word)) distance = std::min(distance, 1.8);
        if (shorter >= 3 && startsLike(word, candidate)) distance = std::min(distance, 1.9);
        if (distance <= reach(longer) && distance < static_cast<double>(longer)) near.push_back({distance, &candidate});
    }
    std::stable_sort(near.begin(), near.end(), [](const Ranked& a, const Ranked& b) { return a.distance < b.distance; });
    std::vector<std::string> words;
    for (const Ranked& r : near) {
        if (words.size() == most) break;
        if (std::find(words.begin(), words.end(), *r.word) == words.end()) words.push_back(*r.word);
    }
    return words;
}

} // namespace trundle
