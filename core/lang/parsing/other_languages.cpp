#include "lang/parsing/other_languages.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "lang/characters.h"

namespace trundle {
namespace {

/// `key=value` as it would be in a block.
Item assigned(std::string key, Element value) {
    const TextRange place = value.range;
    AssignmentItem item;
    item.path.push_back({std::move(key), place});
    item.pathRange = item.value.range = place;
    item.value.elements.push_back(std::move(value));
    return {place, std::move(item)};
}

Item configItem(const Name& base) {
    Element element;
    element.range = base.range;
    element.text = base.text;
    return assigned("Config", std::move(element));
}

bool hasConfig(std::string_view kind) {
    return kind == "Robot" || kind == "Static" || kind == "Part" || (isCapital(kind) && kind.ends_with("Config"));
}

} // namespace

/// `Repeat wheel 3 {`, `Repeat wheel=3 {`, `Repeat 3 {`.
bool OtherLanguages::count(std::vector<Item>& out, int depth) {
    if (text() != "Repeat") return false;
    const bool named = kind(1) == TokenKind::Word;
    const std::size_t first = named ? 2 : 1, number = kind(first) == TokenKind::Equals ? first + 1 : first;
    if (newLine(number) || kind(number) != TokenKind::Number || kind(number + 1) != TokenKind::OpenBrace) return otherCount();
    const std::string name = named ? std::string(text(1)) : "name", how = "{ Count=" + std::string(text(number));
    const TextRange place{range(first).begin, range(number).end};
    Diagnostic& d = error(Code::UnexpectedText, place, "how often is written in the block: `Repeat " + name + " " + how + "`");
    if (named) fix(d, how, {edit({range(1).end, range(number + 1).end}, " " + how)});
    Element value;
    value.kind = Element::Kind::Number;
    value.range = range(number);
    const std::string_view digits = text(number);
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), value.number);
    blockWith(out, depth, number, assigned("Count", std::move(value)));
    return true;
}

/// `Repeat i in 0..4 {`, `Repeat wheel Count=3 {`: the block is skipped, since its names make no sense alone.
bool OtherLanguages::otherCount() {
    static const std::set<std::string_view> kWords{"as", "for", "from", "in", "of", "over", "times", "to", "with"};
    const std::size_t brace = braceInLine();
    bool counts = kind(2) == TokenKind::Word && kWords.contains(text(2));
    for (std::size_t i = 1; i < brace; ++i) {
        if (kind(i) == TokenKind::CloseBrace || text(i) == ":") return false;
        counts = counts || kind(i) != TokenKind::Word;
    }
    if (brace < 2 || !counts || kind(2) == TokenKind::OpenBrace) return false;
    const std::string name(kind(1) == TokenKind::Word ? text(1) : "name");
    error(Code::UnexpectedText, {range(1).begin, range(brace - 1).end},
          "how often is written in the block: `Repeat " + name + " { Count=4`, with $(index) in its values");
    for (std::size_t i = 0; i <= brace; ++i) advance();
    m_grammar.skipBlockBody();
    return true;
}

/// `chassis: Body {`, `chassis = Body {`, `Body: chassis {`, `Robot : K {`.
bool OtherLanguages::nameFirst(std::vector<Item>& out, int depth) {
    const bool colon = text(1) == ":";
    if ((!colon && kind(1) != TokenKind::Equals) || kind(2) != TokenKind::Word || kind(3) != TokenKind::OpenBrace) return false;
    if (newLine(1) || newLine(2) || newLine(3)) return false;
    const Name first = name(), second = name(2);
    const bool kindBehind = isCapital(second.text);
    if (kindBehind == isCapital(first.text)) {
        if (!colon || !kindBehind || !hasConfig(first.text)) return false;
        configFirst(out, depth);
        return true;
    }
    if (!colon && !kindBehind) return false; // `Material=red {`
    const TextRange all{first.range.begin, second.range.end};
    const std::string meant = kindBehind ? second.text + " " + first.text : first.text + " " + second.text;
    Diagnostic& d = error(Code::UnexpectedText, all,
                          kindBehind ? "a block begins with its kind: `" + meant + " {`"
                                     : "no `:` is between a kind and its name: `" + meant + " {`");
    fix(d, meant, {edit(all, meant)});
    const std::size_t before = out.size();
    m_grammar.block(out, depth, 2);
    if (out.size() == before || !out.back().as<BlockItem>()) return true;
    auto& block = std::get<BlockItem>(out.back().node);
    block.type = kindBehind ? second : first;
    block.name = kindBehind ? first : second;
    return true;
}

/// `Robot : K {`.
void OtherLanguages::configFirst(std::vector<Item>& out, int depth) {
    const Name base = name(2);
    Diagnostic& d = error(Code::UnexpectedText, {range().begin, base.range.end},
                          "a config is named in the block: `" + std::string(text()) + " name { Config=" + base.text + "`");
    fix(d, "{ Config=" + base.text, {edit({range().end, range(3).end}, " { Config=" + base.text)});
    blockWith(out, depth, 2, configItem(base));
}

/// `Part left = Wheel(r=1)`, up to its `)` or the end of the line.
bool OtherLanguages::configCalled(std::vector<Item>& out) {
    BlockItem block{name(), name(1), {}, {}, {}};
    const Name base = name(3);
    const std::uint32_t begin = range().begin, sign = range(2).begin;
    for (int i = 0; i < 5; ++i) advance();
    for (int parens = 1; parens > 0 && !atEnd() && !newLine() && kind() != TokenKind::CloseBrace; advance())
        parens += kind() == TokenKind::CloseParen ? -1 : kind() == TokenKind::OpenParen || kind() == TokenKind::ExprOpen ? 1 : 0;
    const TextRange place{sign, previous().end};
    error(Code::UnexpectedText, place,
          "a config and its Params are named in the block: `" + block.type.text + " " + block.name->text +
              " { Config=" + base.text + " ... }`");
    block.open = block.close = {place.end, place.end};
    block.items.push_back(configItem(base));
    out.push_back({{begin, place.end}, std::move(block)});
    return true;
}

/// `Body(chassis) {`.
bool OtherLanguages::nameInParens(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::OpenParen || kind(2) != TokenKind::Word || kind(3) != TokenKind::CloseParen) return false;
    if (kind(4) != TokenKind::OpenBrace || newLine(4)) return false;
    const Name own = name(2);
    const TextRange place{range(1).begin, range(3).end};
    Diagnostic& d = error(Code::UnexpectedText, place, "a name is written without parentheses");
    fix(d, own.text, {edit(place, " " + own.text)});
    const std::size_t before = out.size();
    m_grammar.block(out, depth, 3);
    if (out.size() > before && out.back().as<BlockItem>()) std::get<BlockItem>(out.back().node).name = own;
    return true;
}

/// `<link name="a">` and the tags that follow it.
bool OtherLanguages::markup() {
    const bool isTag = text() == "<" && !newLine(1) && adjacent(1) &&
                       (kind(1) == TokenKind::Word || kind(1) == TokenKind::Slash || kind(1) == TokenKind::Unknown);
    if (!isTag) return false;
    error(Code::UnexpectedText, {range().begin, range(1).end},
          "tags are of XML: here a block is written `Body name { ... }`, a property `Mass = 2`");
    const auto inTags = [this] { return !atEnd() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace; };
    do {
        while (inTags() && !text().ends_with('>')) advance();
        if (inTags()) advance();
        while (inTags() && !newLine() && text() != "<") advance();
    } while (inTags() && text() == "<");
    return true;
}

/// A block with `extra` tokens before its `{`, read as if `item` were in it.
void OtherLanguages::blockWith(std::vector<Item>& out, int depth, std::size_t extra, Item item) {
    const TextRange place = item.range;
    const std::size_t before = out.size();
    const bool named = kind(1) == TokenKind::Word;
    const Name own = name(1);
    m_grammar.block(out, depth, extra);
    if (out.size() == before || !out.back().as<BlockItem>()) return;
    auto& block = std::get<BlockItem>(out.back().node);
    block.name.reset(); // it had the tokens behind the name in it
    block.name = named ? own : Name{"unnamed" + std::to_string(place.begin), place}; // what it lacks is said already
    block.items.insert(block.items.begin(), std::move(item));
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

/// `-- text` and `% text` on a line of their own.
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

/// `RobotConfig Big : Kit {`, `RobotConfig Big extends Kit {`, `RobotConfig Big < Kit {`, `RobotConfig Big(Kit) {`,
/// `Part left = Wheel {`.
bool OtherLanguages::inheritance(std::vector<Item>& out, int depth) {
    static const std::set<std::string_view> kWords{"extends", "from", "inherits", "is"};
    if (kind(1) != TokenKind::Word || kind(3) != TokenKind::Word || newLine(2)) return false;
    if (kind(2) == TokenKind::Equals && kind(4) == TokenKind::OpenParen && hasConfig(text())) return configCalled(out);
    const bool parens = kind(2) == TokenKind::OpenParen && kind(4) == TokenKind::CloseParen;
    const bool assigns = kind(2) == TokenKind::Equals && hasConfig(text());
    if (!parens && !assigns && text(2) != ":" && text(2) != "<" && !(kind(2) == TokenKind::Word && kWords.contains(text(2))))
        return false;
    std::size_t brace = parens ? 5 : 4;
    if (text(brace) == ":") ++brace;
    if (kind(brace) != TokenKind::OpenBrace) return false;
    const Name base = name(3);
    const TextRange said{range(2).begin, range(brace - 1).end};
    Diagnostic& d = error(Code::UnexpectedText, said,
                          "a config is named in the block: `" + std::string(text()) + " " + std::string(text(1)) +
                              " { Config=" + base.text + "`");
    fix(d, "{ Config=" + base.text,
        {edit({said.begin, range(brace).end}, (adjacent(2) ? " { Config=" : "{ Config=") + base.text)});
    blockWith(out, depth, brace - 1, configItem(base)); // what the block sets is in the other one
    return true;
}

bool OtherLanguages::computedName(std::vector<Item>& out, int depth) {
    const std::size_t brace = braceInLine();
    bool isComputed = false;
    for (std::size_t i = 1; i < brace; ++i) {
        if (kind(i) == TokenKind::Equals || wrongEquals(i)) return false;
        isComputed = isComputed || kind(i) == TokenKind::ParamRef || kind(i) == TokenKind::ExprOpen || isBracedParam(text(i));
    }
    if (!isComputed) return false;
    error(Code::UnexpectedText, {range(1).begin, range(brace - 1).end},
          "a name is written out, without $: a Repeat numbers its members, a Part puts its own name before those in it");
    m_grammar.block(out, depth, brace - 1);
    return true;
}

} // namespace trundle
