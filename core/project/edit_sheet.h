#pragma once
// Edits of one plan on their way to the texts. Private to core/project.

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "project/mentions.h"
#include "project/plans.h"

namespace trundle {

class EditSheet {
public:
    explicit EditSheet(const Loaded& loaded) : m_loaded(loaded) {}

    /// The same edit twice is one. Nothing happens where it changes nothing.
    void add(TextEdit edit);
    /// Before whatever else is put into the same place.
    void addFirst(TextEdit edit);
    /// The item goes with the line that held it; neighbours of one line go together.
    void removeItem(SourceRange item);
    void addItem(FileId file, const BlockItem* block, const std::string& text);
    void addAssignment(FileId file, const BlockItem* block, const std::string& key, const std::string& value);
    /// Names a block, which may have had none.
    void name(const BlockItem& block, FileId file, const std::string& name);

    /// The whole plan. Fails where a text is so broken that the edits would spoil it.
    [[nodiscard]] Result<EditPlan> plan(std::vector<std::string> selects);

private:
    void placeRemovals(FileId file, std::vector<TextRange> items);
    [[nodiscard]] Status check(FileId file, const std::vector<TextEdit>& edits) const;

    const Loaded& m_loaded;
    FileEdits m_edits, m_first;
    std::map<FileId, std::vector<TextRange>> m_removed;                     ///< items
    std::vector<std::tuple<FileId, const BlockItem*, std::string>> m_items; ///< to be added
};

/// "Hinge leftAxle (Parent), Robot robot0 (Config) and 3 others".
[[nodiscard]] std::string usersText(const std::vector<const Mention*>& mentions);
/// The end of the comments behind an offset, or the offset, where nothing else follows on its line.
[[nodiscard]] std::optional<std::uint32_t> endOfLineBehind(const Tree& tree, std::uint32_t offset);
/// An item that begins its line, with the comment behind it on its last one.
[[nodiscard]] SourceRange withComment(const Loaded& loaded, SourceRange item);
/// A text without the indent that all its lines but the first have, at most `most`; line ends are `\n` then.
[[nodiscard]] std::string dedented(std::string_view text, std::size_t most = std::string_view::npos);
/// The text of a block without the indent that its place gives it.
[[nodiscard]] std::string blockText(const Loaded& loaded, const SourceRange& block);
/// Gives unnamed blocks of `type` among `siblings` the names they have been given so far, where they are mentioned: another of
/// their kind comes or goes, and they would be called otherwise.
void keepNames(const std::vector<Part>& siblings, const std::string& type, const std::vector<Mention>& mentions,
               const std::vector<const Part*>& except, EditSheet& sheet);

} // namespace trundle
