// needs        three texts, two of them derived from the first
// assumptions  lines end with LF; a last line without LF differs from the same line with LF
// method       changed lines of each side by the greedy shortest edit script (Myers 1986, An O(ND) difference algorithm); if a
//             side has too many differences, everything between the first and the last one counts as one change
// data         hunks: lines [begin, end) of the base replaced by lines [from, to) of a side, in order, never adjacent

#include "lang/line_merge.h"

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace trundle {

namespace {

constexpr int kMaxDifferences = 1000;

using Lines = std::vector<std::string_view>;
using Numbers = std::vector<int>; // equal lines have equal numbers

using Hunk = LineHunk;

Lines linesOf(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::size_t length = end == std::string_view::npos ? text.size() : end + 1;
        lines.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return lines;
}

Numbers numbered(const Lines& lines, std::unordered_map<std::string_view, int>& known) {
    Numbers numbers;
    numbers.reserve(lines.size());
    for (const std::string_view line : lines)
        numbers.push_back(known.emplace(line, static_cast<int>(known.size())).first->second);
    return numbers;
}

/// The shortest edit script of two ranges, with the furthest reaching points kept for each number of differences.
class EditScript {
public:
    EditScript(const Numbers& a, const Numbers& b, Hunk range) : m_a(a), m_b(b), m_range(range) {}

    std::vector<Hunk> hunks() {
        const int n = m_range.end - m_range.begin, m = m_range.to - m_range.from;
        if (n == 0 || m == 0) return n + m == 0 ? std::vector<Hunk>() : std::vector<Hunk>{m_range};
        std::vector<int> furthest(2 * kMaxDifferences + 3, 0);
        for (int d = 0; d <= kMaxDifferences; ++d) {
            m_trace.emplace_back(furthest.begin() + kMaxDifferences - d, furthest.begin() + kMaxDifferences + d + 3);
            for (int k = -d; k <= d; k += 2) {
                int& x = furthest[static_cast<std::size_t>(k + kMaxDifferences + 1)];
                const int down = (&x)[1], right = (&x)[-1];
                x = k == -d || (k != d && right < down) ? down : right + 1;
                while (x < n && x - k < m && same(x, x - k)) ++x;
                if (x >= n && x - k >= m) return walkBack(d, n, m);
            }
        }
        return {m_range};
    }

private:
    [[nodiscard]] bool same(int x, int y) const {
        return m_a[static_cast<std::size_t>(m_range.begin + x)] == m_b[static_cast<std::size_t>(m_range.from + y)];
    }

    std::vector<Hunk> walkBack(int d, int x, int y) const {
        std::vector<Hunk> hunks;
        for (; d > 0; --d) {
            const std::vector<int>& before = m_trace[static_cast<std::size_t>(d)];
            const int k = x - y;
            const auto at = [&](int diagonal) { return before[static_cast<std::size_t>(diagonal + d + 1)]; };
            const bool down = k == -d || (k != d && at(k - 1) < at(k + 1));
            const int fromK = down ? k + 1 : k - 1, fromX = at(fromK), fromY = fromX - fromK;
            addBefore(hunks, {m_range.begin + fromX, m_range.begin + fromX + (down ? 0 : 1), m_range.from + fromY,
                              m_range.from + fromY + (down ? 1 : 0)});
            x = fromX;
            y = fromY;
        }
        std::ranges::reverse(hunks);
        return hunks;
    }

    static void addBefore(std::vector<Hunk>& hunks, Hunk step) {
        if (!hunks.empty() && hunks.back().begin == step.end && hunks.back().from == step.to) {
            hunks.back().begin = step.begin;
            hunks.back().from = step.from;
        } else {
            hunks.push_back(step);
        }
    }

    const Numbers &m_a, &m_b;
    Hunk m_range;
    std::vector<std::vector<int>> m_trace;
};

std::vector<Hunk> changes(const Numbers& base, const Numbers& side) {
    Hunk whole{0, static_cast<int>(base.size()), 0, static_cast<int>(side.size())};
    while (whole.begin < whole.end && whole.from < whole.to &&
           base[static_cast<std::size_t>(whole.begin)] == side[static_cast<std::size_t>(whole.from)])
        ++whole.begin, ++whole.from;
    while (whole.begin < whole.end && whole.from < whole.to &&
           base[static_cast<std::size_t>(whole.end - 1)] == side[static_cast<std::size_t>(whole.to - 1)])
        --whole.end, --whole.to;
    return EditScript(base, side, whole).hunks();
}

std::string joined(const Lines& lines, int from, int to) {
    std::string text;
    for (int i = from; i < to; ++i) text += lines[static_cast<std::size_t>(i)];
    return text;
}

/// Replacement of the base's lines [begin, end) by one side.
struct Change {
    int begin = 0, end = 0;
    std::string text;
    bool operator==(const Change&) const = default;
};

std::vector<Change> changesOf(const Numbers& base, const Lines& lines, std::unordered_map<std::string_view, int>& known) {
    std::vector<Change> all;
    for (const Hunk& h : changes(base, numbered(lines, known))) all.push_back({h.begin, h.end, joined(lines, h.from, h.to)});
    return all;
}

} // namespace

std::vector<LineHunk> lineHunks(std::string_view before, std::string_view after) {
    std::unordered_map<std::string_view, int> known;
    const Numbers numbers = numbered(linesOf(before), known);
    return changes(numbers, numbered(linesOf(after), known));
}

std::optional<std::string> mergedByLines(std::string_view base, std::string_view mine, std::string_view theirs) {
    const Lines lines = linesOf(base);
    std::unordered_map<std::string_view, int> known;
    const Numbers numbers = numbered(lines, known);
    std::vector<Change> all = changesOf(numbers, linesOf(mine), known);
    const std::vector<Change> others = changesOf(numbers, linesOf(theirs), known);
    for (const Change& other : others)
        if (std::ranges::find(all, other) == all.end()) all.push_back(other);
    std::ranges::stable_sort(all, [](const Change& a, const Change& b) { return a.begin < b.begin; });
    std::string text;
    int done = 0;
    bool first = true;
    for (const Change& change : all) {
        if (!first && change.begin <= done) return std::nullopt;
        text += joined(lines, done, change.begin) + change.text;
        done = change.end;
        first = false;
    }
    return text + joined(lines, done, static_cast<int>(lines.size()));
}

} // namespace trundle
