#pragma once
// The lossless syntax tree of one file. Nodes point into the bytes; tokens cover every byte, so printing the tokens gives
// the file back whatever it held. A Tree is immutable; an edit (tree_edit.h) splices bytes and makes a new Tree.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "lang/source_text.h"
#include "lang/token.h"

namespace trundle {

/// A word with its place.
struct Name {
    std::string text;
    TextRange range;
};

/// `$( ... )`. Names are bare Param names; functions: min max abs sqrt sin cos tan (degrees); `pi` is a name.
struct Expression {
    enum class Op { Number, Name, Negate, Add, Subtract, Multiply, Divide, Power, Call };
    Op op = Op::Number;
    double number = 0;
    std::string name; ///< of the Param or of the function
    TextRange range;
    std::vector<Expression> arguments;
};

/// One item of a comma-separated value.
struct Element {
    enum class Kind { Number, Word, String, Boolean, ParamRef, Expression };
    Kind kind = Kind::Word;
    TextRange range; ///< with the unit
    double number = 0;
    bool boolean = false;
    std::string text; ///< the word, the unescaped string, or the Param's name without `$`
    std::string unit; ///< empty: none written
    TextRange unitRange;
    std::shared_ptr<const Expression> expression;
};

struct Value {
    TextRange range; ///< first to last element; empty at the place where one was expected when none is there
    std::vector<Element> elements;
    bool broken = false; ///< the parser has complained about it: say nothing more of its count or types
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
    TextRange close; ///< `}`; empty at the end of what was read when it is missing
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
    /// What the parser had to say; ranges carry the FileId given to parse().
    [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return m_diagnostics; }
    [[nodiscard]] FileId file() const { return m_file; }
    /// How much of the text has been read. The rest is one token, and in no item.
    enum class Extent {
        Whole,
        Hopeless, ///< up to where the mistakes were too many; a diagnostic says so
        Limited,  ///< up to the tokens that parse() was allowed
    };
    [[nodiscard]] Extent extent() const { return m_extent; }
    [[nodiscard]] std::uint32_t readTo() const { return m_readTo; } ///< offset; the text's size where all was read

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

/// Never fails: what cannot be read is skipped with a diagnostic, everything else stands in the tree.
/// Blocks nest at most kMaxBlockDepth deep, expressions kMaxExpressionDepth. Reading ends early in a large text of mistakes, and after
/// about `mostTokens`.
[[nodiscard]] std::shared_ptr<const Tree> parse(std::shared_ptr<const SourceText> source, FileId file,
                                                std::size_t mostTokens = static_cast<std::size_t>(-1));

/// The bytes of the file, put together from the tokens.
[[nodiscard]] std::string print(const Tree& tree);

inline constexpr int kMaxBlockDepth = 64;
inline constexpr int kMaxExpressionDepth = 100;

} // namespace trundle
