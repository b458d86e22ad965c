#pragma once
// Paths of parts and properties: "robot0.leftMotor.Resistance". core/README.md says what a path means. Everything that takes a
// path apart does it here.

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

class DottedPath {
public:
    DottedPath() = default; ///< the top level: no word
    template <std::convertible_to<std::string_view> Text> DottedPath(const Text& text) : DottedPath(std::string_view(text), 0) {}

    [[nodiscard]] const std::string& text() const { return m_text; }
    [[nodiscard]] const std::vector<std::string>& words() const { return m_words; }
    [[nodiscard]] bool empty() const { return m_words.empty(); }
    /// False if a word is missing, as in "a..b", ".a" and "a.".
    [[nodiscard]] bool isComplete() const;

    [[nodiscard]] bool operator==(const DottedPath& other) const { return m_text == other.m_text; }

private:
    DottedPath(std::string_view text, int);

    std::string m_text;
    std::vector<std::string> m_words;
};

// The same for one question to a text, without a copy.

/// "robot0" of "robot0.leftMotor.Resistance"; the whole path if it has one word.
[[nodiscard]] std::string_view firstWord(std::string_view path);
/// "leftMotor.Resistance"; empty if there is one word.
[[nodiscard]] std::string_view withoutFirstWord(std::string_view path);
/// "Resistance"; the whole path if it has one word.
[[nodiscard]] std::string_view lastWord(std::string_view path);
/// "robot0.leftMotor"; empty if there is one word.
[[nodiscard]] std::string_view withoutLastWord(std::string_view path);
/// Whether `path` is `start` or something inside it, word by word: "robot10" is not inside "robot1".
[[nodiscard]] bool startsWithPath(std::string_view path, std::string_view start);
/// The path of something inside `path`; `word` itself at the top level.
[[nodiscard]] std::string pathInside(std::string_view path, std::string_view word);

/// The name of one of several members: "swarm_12" of a Grid, "roller_3" of a Repeat.
struct MemberName {
    std::string_view stem; ///< "swarm"
    std::size_t index = 0;
};
/// Whether a name is that of a member of something: "swarm_12" of "swarm".
[[nodiscard]] bool isMemberOf(std::string_view name, std::string_view of);
/// What follows behind the words of `name` in a path that begins with it, or with that of all the members it is one of: "hull" for
/// the name "row_3.cart" and the path "row.cart.hull". Empty: the path is not longer. Nothing if it does not begin so.
[[nodiscard]] std::optional<std::string_view> restBehind(std::string_view path, std::string_view name);
/// Nothing if a name does not have that form.
[[nodiscard]] std::optional<MemberName> memberName(std::string_view name);

} // namespace trundle
