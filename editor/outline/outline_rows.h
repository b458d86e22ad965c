#pragma once
// The contents of the Scene tree for one loaded project, without widgets. Rows are computed on demand: a thousand robots of one
// config cost a thousand rows, without rows for their parts.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/outline/problem_counts.h"
#include "project/loading/project.h"

namespace trundle {

enum class OutlineMode { ByOwner, ByFile };

enum class OutlineGroup {
    Robots,
    Objects, ///< robots without joints, devices and controller
    Scenery,
    Joints, ///< between robots
    Regions,
    Looks,
    Radio,
    Logs,
    Modules,
    RobotConfigs,
    StaticConfigs,
    PartConfigs,
    Materials,
    Surfaces,
    Misplaced
};
inline constexpr std::size_t kOutlineGroups = 15;

struct OutlineRow {
    /// Members: robots of a Grid or Scatter, or a range of them if there are many.
    enum class Type { Experiment, Group, File, Module, Object, Members };
    Type type = Type::Object;
    std::string key;           ///< unique among its siblings and stable across reloads
    std::string path;          ///< dotted; of an Object that can be addressed; "" of the Experiment
    bool selectable = false;   ///< `path` is valid
    bool markable = false;     ///< an object of the world that can be hidden and locked
    bool hasRows = false;      ///< it has child rows
    bool matches = false;      ///< the filter matches the row or one of its ancestors
    bool leadsToMatch = false; ///< ... or one of its descendants
    std::string name, detail;  ///< "robot0", "SimpleRobot"
    OutlineGroup group = OutlineGroup::Robots;
    FileId file = kNoFile;                       ///< of a File
    const Part* part = nullptr;                  ///< of an Object
    const Part* config = nullptr;                ///< of an instance in the world: its parts are the child rows
    bool reached = false;                        ///< through an instance: the block is in the config
    bool member = false;                         ///< a robot of a Grid or Scatter, whose block is `part`
    bool passive = false;                        ///< a robot without joints, devices and controller
    std::size_t first = 0, last = 0;             ///< of Members: range [first, last) of the experiment's robots
    SourceRange range;                           ///< source range
    ProblemCounts::Count problems;               ///< including child rows
    std::optional<std::array<double, 3>> colour; ///< of a material
    std::string tip;
};

class OutlineRows {
public:
    /// `filter`: words separated by blanks, matched case-insensitively; all must be in a row's name, kind or config. Ancestors
    /// of matches are kept. `model`: path of the config that is shown alone; empty: everything is shown.
    OutlineRows(std::shared_ptr<const LoadedProject> loaded, OutlineMode mode, const std::string& filter = {},
                std::string model = {});

    [[nodiscard]] std::vector<OutlineRow> top() const;
    [[nodiscard]] std::vector<OutlineRow> below(const OutlineRow& row) const;
    /// Makes a row of an earlier load, the one at `index` below `above`, point into this load. Only after an edit that kept all
    /// objects, and without a filter: then every row has the index that it had. False: another object is there.
    [[nodiscard]] bool relink(OutlineRow& row, const OutlineRow& above, std::size_t index) const;
    /// The row of the same block with its present contents, after relink().
    [[nodiscard]] OutlineRow renewed(const OutlineRow& row, const OutlineRow& above) const;
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& loaded() const { return m_loaded; }
    [[nodiscard]] OutlineMode mode() const { return m_mode; }
    [[nodiscard]] bool filtered() const { return !m_words.empty(); }

private:
    using Rows = std::vector<OutlineRow>;
    [[nodiscard]] OutlineRow experimentRow() const;
    [[nodiscard]] OutlineRow groupRow(OutlineGroup group) const;
    [[nodiscard]] OutlineRow fileRow(FileId file) const;
    [[nodiscard]] OutlineRow partRow(const Part& part, const OutlineRow& above) const;
    void addModules(Rows& rows, const OutlineRow& above) const;
    void addParts(Rows& rows, const OutlineRow& above) const;
    void addMembers(Rows& rows, const OutlineRow& above, std::size_t first, std::size_t last) const;
    [[nodiscard]] OutlineRow membersRow(const OutlineRow& above, std::size_t first, std::size_t last, bool all) const;
    [[nodiscard]] OutlineRow memberRow(const OutlineRow& above, std::size_t member) const;
    [[nodiscard]] OutlineGroup groupOf(const Part& part) const;
    [[nodiscard]] Rows fileBlocks(const OutlineRow& above) const;
    void keep(Rows& rows, OutlineRow row, const OutlineRow& above) const;
    [[nodiscard]] bool says(std::string_view name, std::string_view detail, std::string_view kind) const;
    [[nodiscard]] bool leads(const OutlineRow& row) const;
    [[nodiscard]] bool leads(const Part& part) const;

    std::shared_ptr<const LoadedProject> m_loaded;
    OutlineMode m_mode;
    std::string m_model;              // path of the config that is shown alone; empty: none
    std::vector<std::string> m_words; // of the filter, in lower case
    ProblemCounts m_problems;
    std::array<std::vector<const Part*>, kOutlineGroups> m_groups;
    std::unordered_map<FileId, std::vector<const Part*>> m_blocks; // by file: blocks without an enclosing block in that file
    std::unordered_map<std::string_view, const MaterialSpec*> m_materials;
    std::unordered_map<const Part*, std::pair<std::size_t, std::size_t>> m_members; // by Grid or Scatter: range [first, last)
    mutable std::unordered_map<const Part*, bool> m_leads; // cache: whether something inside a part matches
};

} // namespace trundle
