#include "lang/parsing/other_languages.h"

#include <algorithm>
#include <set>

namespace trundle {

/// How many tokens ahead the first `{` of this line is; 0: it has none.
std::size_t OtherLanguages::braceInLine() const {
    constexpr std::size_t kFar = 40;
    for (std::size_t i = 1; i < kFar && !newLine(i) && kind(i) != TokenKind::End; ++i)
        if (kind(i) == TokenKind::OpenBrace) return i;
    return 0;
}

/// `for i = 1 to 4 {`, `if $n > 3 {`: what it would repeat is skipped, since its names and values make no sense alone.
bool OtherLanguages::loop() {
    static const std::set<std::string_view> kLoops{"for", "foreach", "while", "repeat", "loop"};
    const std::string word(text());
    if ((!kLoops.contains(word) && word != "if") || newLine(1)) return false;
    const std::size_t brace = braceInLine();
    error(Code::UnexpectedText, range(),
          word == "if" ? "a block cannot depend on a condition, a value can: $(if(a > b, x, y))"
                       : "there is no `" + word + "`: blocks that are there several times belong in `Repeat name { Count=4 ... }`, " +
                             "with $(index) in their values");
    if (brace == 0) {
        do advance();
        while (!atEnd() && !newLine());
        return true;
    }
    for (std::size_t i = 0; i <= brace; ++i) advance();
    m_grammar.skipBlockBody();
    return true;
}

/// `RobotConfig Big : Kit {`, `RobotConfig Big extends Kit {`.
bool OtherLanguages::inheritance(std::vector<Item>& out, int depth) {
    static const std::set<std::string_view> kWords{"extends", "from", "inherits", "is"};
    if (kind(1) != TokenKind::Word || kind(3) != TokenKind::Word || kind(4) != TokenKind::OpenBrace || newLine(2)) return false;
    if (text(2) != ":" && !(kind(2) == TokenKind::Word && kWords.contains(text(2)))) return false;
    const Name base = name(3);
    const TextRange said{range(2).begin, base.range.end};
    Diagnostic& d = error(Code::UnexpectedText, said,
                          "a variant names what it is a variant of in its block: `" + std::string(text()) + " " +
                              std::string(text(1)) + " { Config=" + base.text + "`");
    fix(d, "{ Config=" + base.text, {edit({said.begin, range(4).end}, "{ Config=" + base.text)});
    AssignmentItem config; // as if it were written so: what the block sets is in the other one
    config.path.push_back({"Config", base.range});
    config.pathRange = base.range;
    Element element;
    element.range = base.range;
    element.text = base.text;
    config.value.range = base.range;
    config.value.elements.push_back(std::move(element));
    const std::size_t before = out.size();
    m_grammar.block(out, depth, 3);
    if (out.size() == before || !out.back().as<BlockItem>()) return true;
    auto& block = std::get<BlockItem>(out.back().node);
    block.items.insert(block.items.begin(), Item{base.range, std::move(config)});
    return true;
}

/// `Body $side {`, `Body wheel_$i {`, `Body wheel$(i) {`.
bool OtherLanguages::computedName(std::vector<Item>& out, int depth) {
    const std::size_t brace = braceInLine();
    bool isComputed = false;
    for (std::size_t i = 1; i < brace; ++i) {
        if (kind(i) == TokenKind::Equals || wrongEquals(i)) return false;
        isComputed = isComputed || kind(i) == TokenKind::ParamRef || kind(i) == TokenKind::ExprOpen;
    }
    if (!isComputed) return false;
    error(Code::UnexpectedText, {range(1).begin, range(brace - 1).end},
          "a name is written out, without $: a Repeat numbers its members, a Part puts its own name before those in it");
    m_grammar.block(out, depth, brace - 1);
    return true;
}

} // namespace trundle
