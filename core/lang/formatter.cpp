// Needs: a tree without errors. Method: prints the tokens line by line and changes only the spaces at both ends of a line, so the
// parsed result is the same. Lines inside a multi-line value keep their indent relative to the value's first line.

#include "lang/formatter.h"

#include <algorithm>
#include <iterator>

#include "lang/characters.h"

namespace trundle {
namespace {

constexpr int kStep = 2;
constexpr int kTab = 4;

int widthOf(std::string_view blanks) {
    int width = 0;
    for (const char c : blanks) width += c == '\t' ? kTab : 1;
    return width;
}

class Formatter {
public:
    explicit Formatter(const Tree& tree) : m_tree(tree) { collectContinuations(tree.items()); }

    std::string run() {
        const std::vector<Token>& tokens = m_tree.tokens();
        std::size_t i = 0;
        if (!tokens.empty() && tokens[0].kind == TokenKind::Bom) m_out += text(tokens[i++]);
        while (i < tokens.size() && tokens[i].kind != TokenKind::End) i = line(i);
        finish();
        return std::move(m_out);
    }

private:
    std::string_view text(const Token& token) const { return m_tree.source().slice(token.range); }

    /// Collects the offsets of value elements that start a line after the value's first line.
    void collectContinuations(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) collectContinuations(block->items);
            else if (const auto* param = item.as<ParamItem>(); param && param->open.size()) {
                m_continued.push_back({item.range.begin, param->value.range.end});
                collectContinuations(param->items);
            } else m_continued.push_back(item.range);
        }
    }

    /// Prints one line starting at its first token; returns the index of the token after the line end.
    std::size_t line(std::size_t i) {
        const std::vector<Token>& tokens = m_tree.tokens();
        std::string_view blanks;
        if (tokens[i].kind == TokenKind::Space) blanks = text(tokens[i++]);
        std::size_t end = i;
        while (tokens[end].kind != TokenKind::LineEnd && tokens[end].kind != TokenKind::End) ++end;
        if (end > i) {
            m_out.append(static_cast<std::size_t>(indent(i, end, widthOf(blanks))), ' ');
            for (std::size_t k = i; k < end; ++k) {
                m_depth += tokens[k].kind == TokenKind::OpenBrace ? 1 : tokens[k].kind == TokenKind::CloseBrace ? -1 : 0;
                m_out += text(tokens[k]);
            }
            const TokenKind last = tokens[end - 1].kind;
            if (last == TokenKind::Space || last == TokenKind::LineComment)
                while (!m_out.empty() && isBlank(m_out.back())) m_out.pop_back();
        }
        if (tokens[end].kind == TokenKind::End) return end;
        std::ranges::copy_if(text(tokens[end]), std::back_inserter(m_out), [](char c) { return !isBlank(c); }); // of blank lines
        return end + 1;
    }

    int indent(std::size_t from, std::size_t end, int width) {
        const std::vector<Token>& tokens = m_tree.tokens();
        if (continues(tokens[from].range.begin)) return std::max(0, width + m_shift);
        int depth = m_depth;
        for (std::size_t k = from; k < end && (tokens[k].kind == TokenKind::CloseBrace || tokens[k].kind == TokenKind::Space);
             ++k)
            depth -= tokens[k].kind == TokenKind::CloseBrace ? 1 : 0;
        const int indent = kStep * std::max(depth, 0);
        m_shift = indent - width;
        return indent;
    }

    /// True inside an assignment or Param that began on an earlier line.
    bool continues(std::uint32_t offset) {
        while (m_next < m_continued.size() && m_continued[m_next].end <= offset) ++m_next;
        return m_next < m_continued.size() && m_continued[m_next].begin < offset;
    }

    void finish() {
        // Searches the output as written: after the space between them is removed, CR and LF are one line end.
        const std::size_t first = m_out.find_first_of("\r\n");
        const std::string lineEnd =
            first == std::string::npos ? "\n" : m_out.substr(first, m_out.compare(first, 2, "\r\n") == 0 ? 2 : 1);
        const std::size_t start = m_out.starts_with("\xEF\xBB\xBF") ? 3 : 0;
        std::size_t size = m_out.size();
        while (size > start && (m_out[size - 1] == '\n' || m_out[size - 1] == '\r')) --size;
        m_out.resize(size);
        if (size > start) m_out += lineEnd;
    }

    const Tree& m_tree;
    std::string m_out;
    std::vector<TextRange> m_continued;
    std::size_t m_next = 0;
    int m_depth = 0;
    int m_shift = 0; ///< change of indent of the last line that began an item
};

} // namespace

std::string format(const Tree& tree) {
    const auto& said = tree.diagnostics();
    const bool broken = std::any_of(said.begin(), said.end(), [](const Diagnostic& d) { return d.severity == Severity::Error; });
    return broken ? std::string(tree.source().bytes()) : Formatter(tree).run();
}

} // namespace trundle
