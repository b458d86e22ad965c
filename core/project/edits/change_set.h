#pragma once
// What an edit changed, block by block: made once per edit and given to everything that follows the texts.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "project/loading/project.h"

namespace trundle {

/// A block that differs. The blocks inside an added or removed one are not listed.
struct PartChange {
    enum class What {
        Added,
        Removed,
        Renamed, ///< the same block under another name, and possibly edited
        Edited   ///< own values or Params
    };
    What what = What::Edited;
    std::string before, after; ///< its path as declared, "RobotConfig.Rover.chassis"; empty if it does not exist
    const Part *was = nullptr, *now = nullptr;
    std::vector<std::string> properties; ///< whose text differs: "Mass", in an instance also "leftMotor.Resistance"
    std::vector<std::string> params;     ///< Params of the block whose text differs
};

/// A comparison of two loads of one experiment. Blocks of unchanged files, and those outside the changed range of a file, are
/// recognised by their position; only the others are compared by their text.
class ChangeSet {
public:
    ChangeSet() = default; ///< nothing was open and nothing is
    /// `before` or `after` is null if nothing was open, or nothing is.
    ChangeSet(std::shared_ptr<const LoadedProject> before, std::shared_ptr<const LoadedProject> after);
    /// The same texts with other modules, meshes or search folders: everything may differ.
    [[nodiscard]] static ChangeSet ofEverything(std::shared_ptr<const LoadedProject> before,
                                                std::shared_ptr<const LoadedProject> after);

    [[nodiscard]] const std::shared_ptr<const LoadedProject>& before() const { return m_before; }
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& after() const { return m_after; }
    /// Another experiment, other files, imports or modules: everything has to be read again, and parts() may be incomplete.
    [[nodiscard]] bool isEverything() const { return m_everything; }
    [[nodiscard]] const std::vector<PartChange>& parts() const { return m_parts; }        ///< in the order of the texts
    [[nodiscard]] const std::vector<std::string>& settings() const { return m_settings; } ///< at the top level: "Tick"
    [[nodiscard]] const std::vector<std::string>& params() const { return m_params; }     ///< declared at the top level
    /// Blocks were added, removed, renamed or moved, or their kinds changed.
    [[nodiscard]] bool changesStructure() const { return m_everything || m_structure; }
    /// Only properties of blocks were given other values: nothing outside of parts(), and of what refers to them, differs.
    [[nodiscard]] bool isLocal() const;
    /// Which objects there are, what they are called or what they consist of may differ: not after an isLocal() edit, except of an
    /// instance's Config or a layout's Count.
    [[nodiscard]] bool changesObjects() const;
    /// The diagnostics differ by more than their positions.
    [[nodiscard]] bool changesProblems() const { return m_problems; }
    /// The errors that the new values have, then those elsewhere that they cause, each in text order.
    [[nodiscard]] const std::vector<const Diagnostic*>& valueErrors() const { return m_valueErrors; }
    /// Where a range that was not edited is now; nothing if it was edited.
    [[nodiscard]] std::optional<SourceRange> nowAt(const SourceRange& before) const;
    /// Whether a block of before(), or one inside it, differs.
    [[nodiscard]] bool isEdited(const Part& was) const;
    /// Number of blocks whose text was compared.
    [[nodiscard]] std::size_t compared() const { return m_compared; }

private:
    friend class PartComparison;
    /// The bytes of one file that were replaced: [begin, end) by `inserted` bytes.
    struct Splice {
        std::uint32_t begin = 0, end = 0, inserted = 0;
    };
    void readSplices();
    void compareProblems();

    std::shared_ptr<const LoadedProject> m_before, m_after;
    bool m_everything = false, m_structure = false, m_problems = false;
    std::vector<std::optional<Splice>> m_splices; ///< by FileId; none: unchanged
    std::vector<PartChange> m_parts;
    std::vector<std::string> m_settings, m_params;
    std::vector<SourceRange> m_wasAt, m_isAt; ///< of the values that differ, with their names, in either load
    std::vector<const Diagnostic*> m_valueErrors;
    std::size_t m_compared = 0;
};

} // namespace trundle
