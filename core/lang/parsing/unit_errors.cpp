#include "lang/parsing/unit_errors.h"

#include "base/units.h"
#include "lang/characters.h"

namespace trundle {

void UnitErrors::withoutPower(Element& e) {
    const std::string meant = unitWithPower(e.unit);
    if (meant.empty()) return;
    Diagnostic& d = error(Code::UnknownUnit, e.unitRange, "the unit `" + e.unit + "` is written " + meant);
    fix(d, meant, {edit(e.unitRange, meant)});
    e.unit = meant;
}

bool UnitErrors::behindParam(const Element& e) {
    const bool isParam = e.kind == Element::Kind::ParamRef;
    if (!isParam && (e.kind != Element::Kind::Expression || !e.expression)) return false;
    if (newLine() || kind() != TokenKind::Word || startsItem() || namedBlock() || !findUnit(text())) return false;
    const bool isName = isParam || e.expression->op == Expression::Op::Name;
    std::string body = isParam ? e.text : std::string(slice({e.range.begin + 2, e.range.end - 1}));
    if (!isName) body = "(" + body + ")";
    const std::string meant = "$(" + body + " * 1 " + std::string(text()) + ")";
    const TextRange all{e.range.begin, range().end};
    Diagnostic& d = error(Code::UnknownUnit, range(), "a unit is written behind a number only: `" + meant + "`");
    fix(d, meant, {edit(all, meant)});
    advance();
    return true;
}

/// Adds the part of a unit that begins `ahead` to `written` and returns its tokens; 0 if none begins there.
std::size_t UnitErrors::pieceAt(std::size_t ahead, std::string& written) const {
    if (newLine(ahead)) return 0;
    const auto inLine = [&](std::size_t i, TokenKind k) { return kind(ahead + i) == k && !newLine(ahead + i); };
    const bool stars = inLine(0, TokenKind::Star) && inLine(1, TokenKind::Star) && inLine(2, TokenKind::Number);
    const bool power = inLine(0, TokenKind::Caret) && inLine(1, TokenKind::Number);
    const bool times = inLine(0, TokenKind::Star) && inLine(1, TokenKind::Word);
    const bool over = inLine(0, TokenKind::Slash) && inLine(1, TokenKind::Word);
    const std::size_t count = stars ? 3 : power || times || over ? 2 : inLine(0, TokenKind::Word) && !startsItem(ahead) ? 1 : 0;
    if (count == 0) return 0;
    written += power || stars ? "^" : over ? "/" : "";
    written += text(ahead + count - 1);
    return count;
}

/// `0.3 m /s`, `9.81 m/s ^2`, `2 kg m2`: the pieces form one unit.
bool UnitErrors::inPieces(Element& e) {
    if (e.unit.empty()) return false;
    constexpr std::size_t kMaxPieces = 8;
    std::string joined = e.unit, meant;
    std::size_t count = 0, tokens = 0;
    for (std::size_t i = 0; i < kMaxPieces && count < kMaxPieces; ++i) {
        const bool product =
            kind(count) == TokenKind::Word || (kind(count) == TokenKind::Star && kind(count + 1) == TokenKind::Word);
        const std::string left = joined;
        const std::size_t piece = pieceAt(count, joined);
        if (piece == 0) break;
        count += piece;
        std::string factor = product ? joined.substr(left.size()) : std::string();
        if (product) // `m ^2`: the power belongs to the factor
            if (const std::size_t power = kind(count) == TokenKind::Caret ? pieceAt(count, factor) : 0; power > 0) {
                joined = left + factor;
                count += power;
            }
        const std::string whole = findUnit(joined) ? joined : unitWithPower(joined);
        if (whole.empty()) continue;
        if (product) { // `m s` is no ms
            const auto a = exponentsOf(left), c = exponentsOf(unitWithPower(factor).empty() ? factor : unitWithPower(factor));
            auto both = exponentsOf(whole);
            if (!a || !c || !both) break;
            for (std::size_t k = 0; k < both->size(); ++k) (*both)[k] -= (*a)[k] + (*c)[k];
            if (*both != UnitExponents{}) break;
        }
        meant = whole;
        tokens = count;
    }
    if (meant.empty()) return false;
    for (; tokens > 0; --tokens) advance();
    e.unitRange.end = e.range.end = previous().end;
    const std::string whole = std::string(slice({e.range.begin, e.unitRange.begin})) + meant;
    std::string written(slice(e.unitRange));
    std::erase_if(written, isBlank);
    const bool blanksOnly = written == meant && written.find_first_of("/^") != std::string::npos;
    Diagnostic& d = blanksOnly ? error(Code::UnknownUnit, e.range, "a unit has no blanks inside")
                               : error(Code::UnknownUnit, e.unitRange,
                                       "the unit `" + std::string(slice(e.unitRange)) + "` is written " + meant);
    fix(d, blanksOnly ? whole : meant, {edit(e.range, whole)});
    e.unit = meant;
    return true;
}

} // namespace trundle
