#pragma once
// What we tell a user about a text: severity, code, words, place and, where it is obvious, the edit that mends it.

#include <map>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/codes.h"
#include "base/source_range.h"
#include "base/text_edit.h"

namespace trundle {

enum class Severity { Error, Warning, Hint };

/// A titled set of edits, applied together.
struct Fix {
    std::string title; ///< the replacement itself where it is short: "3cm"
    std::vector<TextEdit> edits;
};

struct Diagnostic {
    Severity severity = Severity::Error;
    Code code = Code::Internal;
    std::string message; ///< one line, no full stop, no code, no place
    SourceRange range;
    std::vector<std::string> suggestions; ///< replacement words, best first
    std::vector<Fix> fixes;
    std::vector<std::pair<std::string, SourceRange>> notes; ///< "first defined here"
    std::uint64_t more = 0; ///< how many others it stands for that are not kept; see Diagnostics::summarize()
};

/// Collects diagnostics; passed down every stage of text → model. Of each file it keeps so many errors and as many others, each once;
/// what comes beyond is counted. Long names in messages are cut.
class Diagnostics {
public:
    static constexpr std::size_t kMostOfOneFile = 1000; ///< errors, and as many warnings and hints
    static constexpr std::size_t kMostOfAll = 5000;     ///< of all files together, likewise

    /// The result may be filled in until the next call; of one that is not kept it is forgotten.
    Diagnostic& add(Severity severity, Code code, SourceRange range, std::string message);
    Diagnostic& error(Code code, SourceRange range, std::string message) {
        return add(Severity::Error, code, range, std::move(message));
    }
    Diagnostic& warning(Code code, SourceRange range, std::string message) {
        return add(Severity::Warning, code, range, std::move(message));
    }
    Diagnostic& hint(Code code, SourceRange range, std::string message) {
        return add(Severity::Hint, code, range, std::move(message));
    }
    void append(std::vector<Diagnostic> more);
    /// Takes over what another collector counted and did not keep.
    void addUnkept(const Diagnostics& other);
    /// Adds one that is kept in any case.
    void addLast(Diagnostic diagnostic);
    /// Ends the messages of each file of which some were not kept with one that counts those.
    void summarize();

    [[nodiscard]] const std::vector<Diagnostic>& all() const { return m_all; }
    [[nodiscard]] Diagnostic& at(std::size_t index) { return m_all[index]; }
    [[nodiscard]] bool hasErrors() const { return m_errors > 0; }
    /// Errors that were added, kept or not.
    [[nodiscard]] std::size_t errorCount() const { return m_errors; }

private:
    struct Count {
        std::size_t errors = 0, others = 0; ///< kept
        std::uint64_t unkeptErrors = 0, unkeptOthers = 0;
        SourceRange firstUnkept;
    };
    [[nodiscard]] bool isRepeated(const Diagnostic& diagnostic);
    Diagnostic& take(Diagnostic diagnostic);

    std::vector<Diagnostic> m_all;
    Diagnostic m_unkept; ///< what add() gives where nothing is kept
    std::map<FileId, Count> m_counts;
    Count m_total;
    std::unordered_set<std::uint64_t> m_fingerprints; ///< of messages that were added
    std::size_t m_errors = 0;
};

/// A text with its long words, and itself where it is long, cut in the middle: "aaaa…zzz". UTF-8 stays whole.
[[nodiscard]] std::string shortenedMessage(std::string text);

} // namespace trundle
