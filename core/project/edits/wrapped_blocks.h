#pragma once
// Selected blocks of one config, or of the top level, that get a block around them. Private to core/project.

#include <map>
#include <string>
#include <vector>

#include "project/edits/edit_builder.h"
#include "project/edits/plan_targets.h"

namespace trundle {

class WrappedBlocks {
public:
    /// Fails if they are not in one config (for a Repeat, or all at the top level) and one file, or if a block of the kind `wrapper` cannot
    /// have them.
    [[nodiscard]] static Result<WrappedBlocks> of(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                                  const std::string& wrapper);

    [[nodiscard]] const Part* holder() const { return m_holder; }  ///< nullptr: the top level
    [[nodiscard]] const Part& config() const { return *m_holder; } ///< of what is not at the top level
    [[nodiscard]] FileId file() const { return m_blocks.front()->file; }
    [[nodiscard]] const std::vector<const Part*>& blocks() const { return m_blocks; }
    [[nodiscard]] const std::string& parentPath() const { return m_parentPath; }
    /// "left" for leftWheel, leftAxle and leftMotor; else the name of the first body, or of the first block.
    [[nodiscard]] std::string commonName() const;
    /// Takes the common name off theirs, "motor" for leftMotor: they are in `left` now. None is changed if one would not be a name, or if
    /// what refers to it cannot follow. Before text() and prefixNames().
    void shortenNames(const std::vector<NameReference>& references);
    [[nodiscard]] const std::string& nameOf(const Part& block) const; ///< after shortenNames()
    [[nodiscard]] bool contains(const SourceRange& range) const;
    /// A selected block or one inside; nullptr if it is neither.
    [[nodiscard]] const Part* find(const BlockItem* block) const;

    /// Changes text inside the blocks when text() is called.
    void change(TextEdit edit);
    /// Removes an assignment of one of the blocks.
    void remove(const Part& block, std::string_view key);
    /// Whether remove() takes a text away.
    [[nodiscard]] bool isRemoved(const SourceRange& range) const;
    /// Adds an assignment to one of the blocks.
    void add(const Part& block, std::string_view key, const std::string& value);
    /// The text of the blocks, one below the other, without the indent of their surroundings.
    [[nodiscard]] std::string text() const;
    /// Replaces the blocks by `text`, where the order of bodies, joints and devices stays as it is, if there is such a position.
    void replaceBy(const std::string& text, EditBuilder& sheet) const;

    /// Puts a prefix before each name outside of the blocks that leads into them: "left." makes `left.wheel` of `wheel`. In paths of
    /// overrides it is `ofOverrides`. Fails for a pattern that other objects fit too.
    [[nodiscard]] Status prefixNames(const std::vector<NameReference>& references, const std::string& prefix,
                                     const std::string& ofOverrides, EditBuilder& sheet) const;

private:
    explicit WrappedBlocks(const LoadedProject& loaded) : m_loaded(loaded) {}
    [[nodiscard]] std::map<const Part*, std::string> shorterNames() const;
    [[nodiscard]] Status take(const std::vector<std::string>& paths, const std::string& wrapper);
    [[nodiscard]] Status takeHolder(const Part& part, const Part* holder, const std::string& wrapper);
    [[nodiscard]] std::vector<const Part*> siblings() const;
    [[nodiscard]] const Part& position() const;

    const LoadedProject& m_loaded;
    const Part* m_holder = nullptr;
    std::string m_parentPath;
    std::vector<const Part*> m_blocks; ///< in text order
    std::map<const Part*, std::vector<TextEdit>> m_changes;
    std::vector<SourceRange> m_removed;
    std::map<const Part*, std::string> m_newNames; ///< by shortenNames()
};

} // namespace trundle
