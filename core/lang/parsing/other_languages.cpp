#include "lang/parsing/other_languages.h"

#include <algorithm>
#include <charconv>
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
    if (word == "if") otherwise();
    return true;
}

/// `else {`, `else if a > b {` behind an `if`, which is reported for all of them.
void OtherLanguages::otherwise() {
    while (kind() == TokenKind::Word && (text() == "else" || text() == "elseif" || text() == "elif")) {
        const std::size_t brace = braceInLine();
        if (brace == 0) return;
        for (std::size_t i = 0; i <= brace; ++i) advance();
        m_grammar.skipBlockBody();
    }
}

/// `Repeat wheel 3 {`, `Repeat wheel=3 {`, `Repeat 3 {`.
bool OtherLanguages::count(std::vector<Item>& out, int depth) {
    if (text() != "Repeat") return false;
    const bool named = kind(1) == TokenKind::Word;
    const std::size_t first = named ? 2 : 1, number = kind(first) == TokenKind::Equals ? first + 1 : first;
    if (newLine(number) || kind(number) != TokenKind::Number || kind(number + 1) != TokenKind::OpenBrace) return false;
    const std::string name = named ? std::string(text(1)) : "name", how = "{ Count=" + std::string(text(number));
    const TextRange place{range(first).begin, range(number).end};
    Diagnostic& d = error(Code::UnexpectedText, place, "how often is written in the block: `Repeat " + name + " " + how + "`");
    if (named) fix(d, how, {edit({range(1).end, range(number + 1).end}, " " + how)});
    Element value;
    value.kind = Element::Kind::Number;
    value.range = range(number);
    const std::string_view digits = text(number);
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), value.number);
    blockWith(out, depth, number, "Count", std::move(value));
    return true;
}

/// A block with `extra` tokens before its `{`, read as if `key` had `value` in it.
void OtherLanguages::blockWith(std::vector<Item>& out, int depth, std::size_t extra, std::string key, Element value) {
    const TextRange place = value.range;
    AssignmentItem item;
    item.path.push_back({std::move(key), place});
    item.pathRange = item.value.range = place;
    item.value.elements.push_back(std::move(value));
    const std::size_t before = out.size();
    const bool named = kind(1) == TokenKind::Word;
    const Name own = name(1);
    m_grammar.block(out, depth, extra);
    if (out.size() == before || !out.back().as<BlockItem>()) return;
    auto& block = std::get<BlockItem>(out.back().node);
    block.name.reset(); // it had the tokens behind the name in it
    block.name = named ? own : Name{"unnamed" + std::to_string(place.begin), place}; // what it lacks is said already
    block.items.insert(block.items.begin(), Item{place, std::move(item)});
}

/// `include "robot.sim"`, `from x import y`.
bool OtherLanguages::importWithoutSign() {
    static const std::set<std::string_view> kImports{"include", "import", "from", "using", "require", "source"};
    if (!kImports.contains(text()) || newLine(1)) return false;
    if (kind(1) != TokenKind::String && kind(1) != TokenKind::Word) return false;
    if (kind(1) == TokenKind::Word && !newLine(2) && (kind(2) == TokenKind::OpenBrace || kind(2) == TokenKind::Equals))
        return false;
    Diagnostic& d = error(Code::UnexpectedText, range(), "another file is taken in by #import and its path");
    if (newLine(2) || kind(2) == TokenKind::End) fix(d, "#import", {edit(range(), "#import")});
    do advance();
    while (!atEnd() && !newLine() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace);
    return true;
}

bool OtherLanguages::comment() {
    const bool dashes = kind() == TokenKind::Minus && kind(1) == TokenKind::Minus && adjacent(1);
    if (!newLine() || !(dashes || (kind() == TokenKind::Unknown && text() == "%"))) return false;
    const TextRange sign{range().begin, range(dashes ? 1 : 0).end};
    Diagnostic& d = error(Code::UnexpectedText, sign, "a comment begins with //");
    fix(d, "//", {edit(sign, "//")});
    do advance();
    while (!atEnd() && !newLine());
    return true;
}

/// `RobotConfig Big : Kit {`, `RobotConfig Big extends Kit {`, `RobotConfig Big < Kit {`, `RobotConfig Big(Kit) {`.
bool OtherLanguages::inheritance(std::vector<Item>& out, int depth) {
    static const std::set<std::string_view> kWords{"extends", "from", "inherits", "is"};
    if (kind(1) != TokenKind::Word || kind(3) != TokenKind::Word || newLine(2)) return false;
    const bool parens = kind(2) == TokenKind::OpenParen && kind(4) == TokenKind::CloseParen;
    if (!parens && text(2) != ":" && text(2) != "<" && !(kind(2) == TokenKind::Word && kWords.contains(text(2)))) return false;
    std::size_t brace = parens ? 5 : 4;
    if (text(brace) == ":") ++brace;
    if (kind(brace) != TokenKind::OpenBrace) return false;
    const Name base = name(3);
    const TextRange said{range(2).begin, range(brace - 1).end};
    Diagnostic& d = error(Code::UnexpectedText, said,
                          "a variant names what it is a variant of in its block: `" + std::string(text()) + " " +
                              std::string(text(1)) + " { Config=" + base.text + "`");
    fix(d, "{ Config=" + base.text,
        {edit({said.begin, range(brace).end}, (adjacent(2) ? " { Config=" : "{ Config=") + base.text)});
    Element element;
    element.range = base.range;
    element.text = base.text;
    blockWith(out, depth, brace - 1, "Config", std::move(element)); // what the block sets is in the other one
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
