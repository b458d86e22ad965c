#include "lang/parsing/foreign_configs.h"

#include <algorithm>
#include <array>

#include "lang/characters.h"
#include "lang/parsing/param_errors.h"

namespace trundle {

/// The end of a default value that begins here: before the comma or the next name.
std::size_t ForeignConfigs::endOfValue(std::size_t from, std::size_t end) const {
    int open = 0;
    for (std::size_t i = from; i < end; ++i) {
        if (open == 0 && i > from && kind(i) == TokenKind::Word && kind(i + 1) == TokenKind::Equals) return i;
        if (open == 0 && kind(i) == TokenKind::Comma && kind(i + 1) == TokenKind::Word) return i;
        open += kind(i) == TokenKind::OpenParen || kind(i) == TokenKind::ExprOpen ? 1 : kind(i) == TokenKind::CloseParen ? -1 : 0;
    }
    return end;
}

/// Reads what is between a config's name and its `{`: `(r=0.05, w)`. False if it is no list of Params. `meant`: these, as they are
/// written here.
bool ForeignConfigs::readParams(std::size_t brace, std::vector<Item>& declared, std::string& meant) const {
    const std::string_view first = text(2), last = text(brace - 1);
    const bool bracket = first == "(" || first == "[" || first == "<";
    std::size_t i = bracket ? 3 : 2, end = brace;
    bool assigns = false;
    if (bracket && last != ")" && last != "]" && last != ">") return false;
    if (bracket) --end;
    while (i < end) {
        if (kind(i) == TokenKind::Comma || text(i) == "Param" || text(i) == "with" || ParamErrors::isType(text(i))) {
            ++i;
            continue;
        }
        if (kind(i) != TokenKind::Word || isCapital(text(i))) return false; // `RobotConfig Big(Kit) {`
        declared.push_back(ParamErrors::unknown(name(i)));
        meant += " Param " + std::string(text(i++)) + "=";
        if (text(i) == ":" && kind(i + 1) == TokenKind::Word) i += 2;
        const bool hasValue = kind(i) == TokenKind::Equals && i + 1 < end;
        const std::size_t next = hasValue ? endOfValue(i + 1, end) : i;
        meant += hasValue ? slice({range(i + 1).begin, range(next - 1).end}) : "0";
        assigns = assigns || hasValue;
        if (!hasValue && i < end && kind(i) != TokenKind::Comma) return false;
        i = next;
    }
    return !declared.empty() && (bracket || assigns);
}

bool ForeignConfigs::params(std::vector<Item>& out, int depth) {
    const bool isConfig = text() == "RobotConfig" || text() == "StaticConfig" || text() == "PartConfig";
    const std::size_t brace = braceInLine();
    if (!isConfig || kind(1) != TokenKind::Word || brace < 4) return false;
    std::vector<Item> declared;
    std::string meant = " {";
    if (!readParams(brace, declared, meant)) return false;
    const TextRange all{range(1).end, range(brace).end};
    Diagnostic& d =
        error(Code::UnexpectedText, {range(2).begin, range(brace - 1).end},
              "Params are in the block of their config: `" + std::string(text()) + " " + std::string(text(1)) + meant + "`");
    fix(d, meant.substr(1), {edit(all, meant)});
    const Name own = name(1);
    const std::size_t before = out.size();
    m_grammar.block(out, depth, brace - 1);
    if (out.size() == before || !out.back().as<BlockItem>()) return true;
    auto& block = std::get<BlockItem>(out.back().node);
    block.name = own;
    block.items.insert(block.items.begin(), std::make_move_iterator(declared.begin()), std::make_move_iterator(declared.end()));
    return true;
}

/// `Params { r = 0.1 }`.
bool ForeignConfigs::group(std::vector<Item>& out, int depth) {
    constexpr std::array<std::string_view, 8> kWords{"Params", "Parameters", "Parameter", "Variables",
                                                     "params", "parameters", "Constants", "Properties"};
    if (std::ranges::find(kWords, text()) == kWords.end() || kind(1) != TokenKind::OpenBrace) return false;
    if (kind(2) != TokenKind::Word || (kind(3) != TokenKind::Equals && !wrongEquals(3))) return false;
    error(Code::UnexpectedText, range(), "each named value is a line of its own: `Param " + std::string(text(2)) + " = ...`");
    std::vector<Item> read;
    m_grammar.block(read, depth, 0);
    if (read.empty() || !read.back().as<BlockItem>()) return true;
    for (const Item& item : read.back().as<BlockItem>()->items)
        if (const auto* assignment = item.as<AssignmentItem>(); assignment && assignment->path.size() == 1)
            out.push_back(ParamErrors::unknown(assignment->path[0]));
    return true;
}

bool ForeignConfigs::proto(std::vector<Item>& out) {
    if (text() != "PROTO" || kind(1) != TokenKind::Word || text(2) != "[") return false;
    BlockItem block{{"PartConfig", range()}, name(1), {}, {}, {}};
    const std::uint32_t begin = range().begin;
    Diagnostic& d = error(Code::UnexpectedText, {begin, range(1).end}, {});
    const std::size_t fault = m_report.indexOf(d);
    for (int i = 0; i < 3; ++i) advance();
    while (!atEnd() && text() != "]" && kind() != TokenKind::OpenBrace) {
        const bool isField = text() == "field" || text() == "exposedField" || text() == "unconnectedField";
        if (isField && kind(1) == TokenKind::Word && kind(2) == TokenKind::Word)
            block.items.push_back(ParamErrors::unknown(name(2)));
        advance();
    }
    if (text() == "]") advance();
    block.open = block.close = {previous().end, previous().end};
    if (kind() == TokenKind::OpenBrace) {
        advance();
        m_grammar.skipBlockBody(); // nodes of VRML
    }
    const std::string first = block.items.empty() ? "r" : block.items[0].as<ParamItem>()->name.text;
    if (fault > 0)
        m_report.at(fault).message = "a PROTO is a PartConfig here, its fields are Params: `PartConfig " + block.name->text +
                                     " { Param " + first + " = ... }`, in which `$" + first + "` is the value";
    out.push_back({{begin, previous().end}, std::move(block)});
    return true;
}

} // namespace trundle
