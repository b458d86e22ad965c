#pragma once
// Collects the edits of one plan, by file. Private to core/project.

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "project/edits/block_comments.h"
#include "project/edits/plans.h"
#include "project/objects/name_references.h"

namespace trundle {

class EditBuilder {
public:
    explicit EditBuilder(const LoadedProject& loaded) : m_loaded(loaded) {}

    /// Duplicate edits and edits without effect are ignored.
    void add(TextEdit edit);
    /// Adds an edit that precedes all others at the same position.
    void addFirst(TextEdit edit);
    /// Removes an item, with its line if nothing else is on it; adjacent items of one line are removed together.
    void removeItem(SourceRange item);
    void addItem(FileId file, const BlockItem* block, const std::string& text);
    void addAssignment(FileId file, const BlockItem* block, const std::string& key, const std::string& value);
    /// Sets the name of a block, which may be unnamed.
    void name(const BlockItem& block, FileId file, const std::string& name);

    /// The complete plan. Fails if a file has syntax errors that the edits would make worse, or if a name would lead nowhere after
    /// them, see checkNames().
    [[nodiscard]] Result<EditPlan> plan(std::vector<std::string> selects);

private:
    void placeRemovals(FileId file, std::vector<TextRange> items);
    [[nodiscard]] Status check(FileId file, const std::vector<TextEdit>& edits) const;

    const LoadedProject& m_loaded;
    FileEdits m_edits, m_first;
    std::map<FileId, std::vector<TextRange>> m_removed;                     ///< items
    std::vector<std::tuple<FileId, const BlockItem*, std::string>> m_items; ///< additions
};

/// Adds a text before a top-level block of a file and the comments above it, or at the end of the file.
void addBefore(const LoadedProject& loaded, const Part* block, FileId file, const std::string& text, EditBuilder& sheet);
/// Inserts a copy after its original: on the same line if other items share that line, else on a line of its own, after a
/// trailing comment.
[[nodiscard]] TextEdit copyBehind(const Tree& tree, TextRange item, const std::string& text);
/// A summary for messages: "Hinge leftAxle (Parent), Robot robot0 (Config) and 3 others".
[[nodiscard]] std::string usersText(const std::vector<const NameReference*>& references);
/// Reindents the inner lines of a text: one level, the width of its narrowest indent, becomes one `step`.
[[nodiscard]] std::string restepped(const std::string& text, const std::string& step);
/// A text without the common indent of all lines but the first, at most `most` characters; line ends become `
/// `.
[[nodiscard]] std::string dedented(std::string_view text, std::size_t most = std::string_view::npos);
/// The text of a block without the indent of its surroundings.
[[nodiscard]] std::string blockText(const LoadedProject& loaded, const SourceRange& block);
/// Writes the current default names of unnamed blocks of `type` among `siblings` into the text if they are referenced: adding or
/// removing a block of their kind would change their default names.
void keepNames(const std::vector<Part>& siblings, const std::string& type, const std::vector<NameReference>& references,
               const std::vector<const Part*>& except, EditBuilder& sheet);

} // namespace trundle
