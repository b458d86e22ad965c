#include "project/loading/error_limit.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "lang/characters.h"

namespace trundle {

namespace {

constexpr std::uint64_t kHopelessMistakes = 500;

using Names = std::unordered_set<std::string_view>;

/// What in the rest of the file could resolve an error in its beginning.
enum class Remedy { None, Definition, Directive, Override };

Remedy remedyOf(Code code) {
    switch (code) {
    case Code::UnknownKey:
    case Code::DuplicateKey:
    case Code::DuplicateName:
    case Code::WrongType:
    case Code::OutOfRange:
    case Code::WrongCount:
    case Code::UnknownUnit:
    case Code::WrongDimension:
    case Code::UnknownChoice:
    case Code::MissingName:
    case Code::WrongPlace:
    case Code::LooseGeom:
    case Code::ImportNotFound:
    case Code::ModuleNotFound:
    case Code::TooLarge:
    case Code::TooManyMistakes: return Remedy::None;
    case Code::UnknownParam:
    case Code::UnknownReference:
    case Code::NoSuchPath: return Remedy::Definition;
    case Code::UnknownKind: return Remedy::Directive;
    default: return Remedy::Override;
    }
}

bool isIdentifier(char c) { return isIdent(c) || static_cast<unsigned char>(c) >= 0x80; }

/// The last name in the text that a message refers to: `b` of "a.b" in quotes. For a member of a Grid or Scatter ("crowd_3"), the
/// name of the layout, which is what a file defines.
std::string_view nameIn(std::string_view text) {
    while (!text.empty() && !isIdentifier(text.back())) text.remove_suffix(1);
    std::size_t begin = text.size();
    while (begin > 0 && isIdentifier(text[begin - 1])) --begin;
    text.remove_prefix(begin);
    std::size_t end = text.size();
    while (end > 0 && (isDigit(text[end - 1]) || text[end - 1] == '_')) --end;
    const std::size_t number = text.find('_', end);
    return number == std::string_view::npos ? text : text.substr(0, number);
}

/// What the unread rest of a file may change about the part that was read. Comments are scanned as code: this can only make the
/// check more cautious.
struct UnreadText {
    Names defined; ///< the searched names that occur before `=` or `{`
    bool directives = false;
    bool overrides = false; ///< has a dotted name before `=`

    UnreadText(std::string_view text, const Names& asked) {
        for (std::size_t i = 0; i < text.size();) {
            if (text[i] == '#' && isFirstOnLine(text, i)) directives = true;
            if (!isIdentifier(text[i])) {
                ++i;
                continue;
            }
            const std::size_t begin = i;
            while (i < text.size() && isIdentifier(text[i])) ++i;
            const std::size_t end = i;
            while (i < text.size() && isBlank(text[i])) ++i;
            if (i == text.size() || (text[i] != '=' && text[i] != '{')) continue;
            const std::string_view word = text.substr(begin, end - begin);
            if (asked.contains(word)) defined.insert(word);
            overrides = overrides || (text[i] == '=' && begin > 0 && text[begin - 1] == '.');
        }
    }

private:
    static bool isFirstOnLine(std::string_view text, std::size_t i) {
        while (i > 0 && isBlank(text[i - 1])) --i;
        return i == 0 || text[i - 1] == '\n' || text[i - 1] == '\r';
    }
};

bool isError(const Diagnostic& d) { return d.severity == Severity::Error; }

std::uint64_t errorsOf(const Diagnostics& diagnostics) {
    std::uint64_t errors = 0;
    for (const Diagnostic& d : diagnostics.all()) errors += isError(d) ? 1 + d.followUps : 0;
    return errors;
}

std::string unreadSize(const Tree& tree) { return std::to_string((tree.source().bytes().size() - tree.readTo()) >> 10) + " KiB"; }

} // namespace

bool hasManyMistakes(const Diagnostics& diagnostics) {
    return errorsOf(diagnostics) >= kHopelessMistakes || diagnostics.all().size() >= Diagnostics::kMaxOfOneFile;
}

bool hasManyWarnings(const Diagnostics& diagnostics) {
    return errorsOf(diagnostics) < kHopelessMistakes && diagnostics.all().size() >= Diagnostics::kMaxOfOneFile;
}

bool hasTooManyErrors(const Tree& tree, const Diagnostics& diagnostics) {
    const std::vector<Diagnostic>& all = diagnostics.all();
    if (!hasManyMistakes(diagnostics)) return false;
    const auto nameOf = [&](const Diagnostic& d) {
        return d.range.file == tree.file() ? nameIn(tree.source().slice(d.range.range)) : std::string_view();
    };
    Names asked;
    for (const Diagnostic& d : all)
        if (remedyOf(d.code) == Remedy::Definition) asked.insert(nameOf(d));
    const UnreadText unread(tree.source().bytes().substr(tree.readTo()), asked);
    const auto remains = [&](const Diagnostic& d) {
        switch (remedyOf(d.code)) {
        case Remedy::None: return true;
        case Remedy::Definition: return !unread.directives && !nameOf(d).empty() && !unread.defined.contains(nameOf(d));
        case Remedy::Directive: return !unread.directives;
        case Remedy::Override: return !unread.directives && !unread.overrides;
        }
        return false;
    };
    std::uint64_t errors = 0, messages = 0;
    for (const Diagnostic& d : all) {
        if (!remains(d)) continue;
        ++messages;
        if (isError(d)) errors += 1 + d.followUps;
    }
    return errors >= kHopelessMistakes || messages >= Diagnostics::kMaxOfOneFile;
}

Diagnostic restUnread(const Tree& tree) {
    Diagnostic d;
    d.code = Code::TooManyMistakes;
    d.range = {tree.file(), {tree.readTo(), tree.readTo()}};
    d.message = "too many mistakes before this place: the last " + unreadSize(tree) + " of this file are not read";
    return d;
}

Diagnostics tooManyTokens(const Tree& tree, std::size_t most) {
    Diagnostics one;
    one.error(Code::TooLarge, {tree.file(), {tree.readTo(), tree.readTo()}},
              "an experiment may hold " + std::to_string(most) + " words, signs and blanks in all its texts; the last " +
                  unreadSize(tree) + " of this file are not read. For many equal objects use a Grid or a Scatter");
    return one;
}

} // namespace trundle
