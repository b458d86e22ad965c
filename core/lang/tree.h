#pragma once
// The lossless syntax tree of one file. Nodes are byte ranges; tokens cover every byte, so printing the tokens restores the file
// exactly. A Tree is immutable; an edit (tree_edit.h) changes bytes and parses them into a new Tree.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "lang/source_text.h"
#include "lang/token.h"

namespace trundle {

/// A word with its source range.
struct Name {
    std::string text;
    TextRange range;
};

/// `$( ... )`. Identifiers are Param names without `$`, or `pi`; functions: min max abs sqrt sin cos tan (degrees).
struct Expression {
    enum class Op { Number, Name, Negate, Add, Subtract, Multiply, Divide, Power, Call };
    Op op = Op::Number;
    double number = 0;
    std::string name; ///< name of the Param or of the function
    TextRange range;
    std::vector<Expression> arguments;
};

/// One element of a comma-separated value.
struct Element {
    enum class Kind { Number, Word, String, Boolean, ParamRef, Expression };
    Kind kind = Kind::Word;
    TextRange range; ///< including the unit
    double number = 0;
    bool boolean = false;
    std::string text; ///< the word, the unescaped string, or the Param's name without `$`
    std::string unit; ///< empty: no unit
    TextRange unitRange;
    std::shared_ptr<const Expression> expression;
};

struct Value {
    TextRange range; ///< first to last element; if there is none, empty, at the position where one was expected
    std::vector<Element> elements;
    bool broken = false; ///< already reported by the parser: do not check its count or types again
};

struct Item;

struct ImportItem {
    std::string path;
    TextRange pathRange;
};
struct ModuleItem {
    std::string path;
    TextRange pathRange;
};
struct ParamItem {
    Name name;
    Value value;
    TextRange open, close;   ///< braces around what is said about it; empty: there are none
    std::vector<Item> items; ///< between them: Min=2 cm Help="..."
};
struct AssignmentItem {
    std::vector<Name> path;
    Value value;
    TextRange pathRange;
};
struct BlockItem {
    Name type;
    std::optional<Name> name;
    TextRange open;  ///< `{`
    TextRange close; ///< `}`; if missing, empty, at the end of the text read
    std::vector<Item> items;
};

/// One directive, assignment or block. `range` runs from its first to its last token.
struct Item {
    TextRange range;
    std::variant<ImportItem, ModuleItem, ParamItem, AssignmentItem, BlockItem> node;

    template <class T> [[nodiscard]] const T* as() const { return std::get_if<T>(&node); }
};

class Tree {
public:
    [[nodiscard]] const SourceText& source() const { return *m_source; }
    [[nodiscard]] const std::shared_ptr<const SourceText>& sharedSource() const { return m_source; }
    [[nodiscard]] const std::vector<Token>& tokens() const { return m_tokens; }
    [[nodiscard]] const std::vector<Item>& items() const { return m_items; }
    /// The parser's diagnostics; ranges have the FileId passed to parse().
    [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return m_diagnostics; }
    [[nodiscard]] FileId file() const { return m_file; }
    /// How much of the text has been parsed. The rest is one token and belongs to no item.
    enum class Extent {
        Whole,
        Unrecoverable, ///< stopped after too many errors, with a diagnostic
        Limited,       ///< stopped at the token limit passed to parse()
    };
    [[nodiscard]] Extent extent() const { return m_extent; }
    [[nodiscard]] std::uint32_t readTo() const { return m_readTo; } ///< offset; equals the text's size if all was read

private:
    friend class Parser;
    Extent m_extent = Extent::Whole;
    std::uint32_t m_readTo = 0;
    FileId m_file = kNoFile;
    std::shared_ptr<const SourceText> m_source;
    std::vector<Token> m_tokens;
    std::vector<Item> m_items;
    std::vector<Diagnostic> m_diagnostics;
};

/// Never fails: unreadable text is skipped with a diagnostic, everything else is in the tree.
/// Blocks nest at most kMaxBlockDepth deep, expressions kMaxExpressionDepth. Stops early in a large text full of errors, and
/// after about `mostTokens`, of which a long word counts as several.
[[nodiscard]] std::shared_ptr<const Tree> parse(std::shared_ptr<const SourceText> source, FileId file,
                                                std::size_t mostTokens = static_cast<std::size_t>(-1));

/// The bytes of the file, assembled from the tokens.
[[nodiscard]] std::string print(const Tree& tree);

inline constexpr int kMaxBlockDepth = 64;
inline constexpr int kMaxExpressionDepth = 100;

} // namespace trundle
