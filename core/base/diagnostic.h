#pragma once
// Diagnostics: severity, code, message, source range and, where the correction is obvious, a fix.

#include <map>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/code_place.h"
#include "base/codes.h"
#include "base/source_range.h"
#include "base/text_edit.h"

namespace trundle {

enum class Severity { Error, Warning, Hint };

/// A set of edits with a title, applied together.
struct Fix {
    std::string title; ///< the replacement text itself where it is short: "3cm"
    std::vector<TextEdit> edits;
};

struct Diagnostic {
    Severity severity = Severity::Error;
    Code code = Code::Internal;
    std::string message; ///< one line, without full stop, code or position
    SourceRange range;
    std::vector<std::string> suggestions; ///< replacement words, best match first
    std::vector<Fix> fixes;
    std::vector<std::pair<std::string, SourceRange>> notes; ///< "first defined here"
    std::uint64_t more = 0; ///< how many omitted diagnostics this one stands for; see Diagnostics::summarize()
    std::uint64_t followUps = 0; ///< further places with the same mistake that are not reported
    // Of a run, the robot that it is about, and which of its controllers: the range is the same for all robots of one block.
    std::optional<std::size_t> robot = {}; ///< index in the experiment
    std::string controller = {};           ///< its name; empty: the robot itself
    CodePlace place = {};                  ///< of a fault in the source of a module; the range is that of the block that uses it
};

/// Collects diagnostics; passed through every stage from text to model. Per file it keeps at most kMaxOfOneFile errors and as
/// many warnings and hints, without duplicates; the rest are only counted. Long names in messages are shortened.
class Diagnostics {
public:
    static constexpr std::size_t kMaxOfOneFile = 1000; ///< errors; the same number of warnings and hints
    static constexpr std::size_t kMaxOfAll = 5000;     ///< the same over all files together

    /// The caller may fill in the returned diagnostic until the next call; where the limit is reached it is discarded.
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
    /// Adds the counts of diagnostics that another collector omitted.
    void addOmitted(const Diagnostics& other);
    /// Adds a diagnostic that is kept even beyond the limits.
    void addLast(Diagnostic diagnostic);
    /// For each file with omitted diagnostics, appends one diagnostic with their number.
    void summarize();

    [[nodiscard]] const std::vector<Diagnostic>& all() const { return m_all; }
    [[nodiscard]] Diagnostic& at(std::size_t index) { return m_all[index]; }
    [[nodiscard]] bool hasErrors() const { return m_errors > 0; }
    /// Errors added, including omitted ones.
    [[nodiscard]] std::size_t errorCount() const { return m_errors; }

private:
    struct Count {
        std::size_t errors = 0, others = 0; ///< number kept
        std::uint64_t omittedErrors = 0, omittedOthers = 0;
        SourceRange firstOmitted;
    };
    [[nodiscard]] bool isRepeated(const Diagnostic& diagnostic);
    Diagnostic& take(Diagnostic diagnostic);

    std::vector<Diagnostic> m_all;
    Diagnostic m_omitted; ///< returned by add() where the diagnostic is not kept
    std::map<FileId, Count> m_counts;
    Count m_total;
    std::unordered_set<std::uint64_t> m_fingerprints; ///< of messages added so far
    std::size_t m_errors = 0;
};

/// A text in which long words, and the text itself if it is long, are shortened in the middle: "aaaa…zzz". UTF-8 characters are
/// not split.
[[nodiscard]] std::string shortenedMessage(std::string text);

} // namespace trundle
