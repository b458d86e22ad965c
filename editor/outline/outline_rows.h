#pragma once
// What the scene tree shows of one load, row by row, made when somebody looks: a thousand robots of one config cost a thousand
// rows, not their parts. Knows no widget.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/outline/problem_counts.h"
#include "project/project.h"

namespace trundle {

enum class OutlineMode { ByOwner, ByFile };

enum class OutlineGroup {
    Robots,
    Objects, ///< robots that nothing drives
    Scenery,
    Looks,
    Radio,
    Logs,
    Modules,
    RobotConfigs,
    StaticConfigs,
    Materials,
    Surfaces,
    Misplaced
};
inline constexpr std::size_t kOutlineGroups = 12;

struct OutlineRow {
    /// Members: those of a Grid or Scatter, or a stretch of them where there are many.
    enum class Type { Experiment, Group, File, Module, Object, Members };
    Type type = Type::Object;
    std::string key;           ///< differs from its siblings' and stays the same from load to load
    std::string path;          ///< dotted; of an Object that can be reached, "" of the Experiment
    bool selectable = false;   ///< `path` means it
    bool markable = false;     ///< something in the world that can be hidden and locked
    bool hasRows = false;      ///< something is below it
    bool matches = false;      ///< the filter's words are in it or in something above it
    bool leadsToMatch = false; ///< ... or in something below it
    std::string name, detail;  ///< "robot0", "SimpleRobot"
    OutlineGroup group = OutlineGroup::Robots;
    FileId file = kNoFile;                       ///< of a File
    const Part* part = nullptr;                  ///< of an Object
    const Part* config = nullptr;                ///< of an instance in the world: its parts are shown below it
    bool reached = false;                        ///< through an instance: its block is in the config
    bool member = false;                         ///< one of a Grid or Scatter, whose block `part` is
    bool passive = false;                        ///< a robot that nothing drives
    std::size_t first = 0, last = 0;             ///< of Members: robots of the experiment, the last one behind them
    SourceRange range;                           ///< where it stands in the text
    ProblemCounts::Count problems;               ///< with those below
    std::optional<std::array<double, 3>> colour; ///< of a material
    std::string tip;
};

class OutlineRows {
public:
    /// `filter`: words, parted by blanks, that must all be in a row's name, kind or config, in any case; rows above matches stay.
    OutlineRows(std::shared_ptr<const Loaded> loaded, OutlineMode mode, const std::string& filter = {});

    [[nodiscard]] std::vector<OutlineRow> top() const;
    [[nodiscard]] std::vector<OutlineRow> below(const OutlineRow& row) const;
    [[nodiscard]] const std::shared_ptr<const Loaded>& loaded() const { return m_loaded; }
    [[nodiscard]] OutlineMode mode() const { return m_mode; }
    [[nodiscard]] bool filtered() const { return !m_words.empty(); }

private:
    using Rows = std::vector<OutlineRow>;
    [[nodiscard]] OutlineRow experimentRow() const;
    [[nodiscard]] OutlineRow groupRow(OutlineGroup group) const;
    [[nodiscard]] OutlineRow fileRow(FileId file) const;
    [[nodiscard]] OutlineRow partRow(const Part& part, const OutlineRow& above) const;
    void name(OutlineRow& row, const Part& part, const OutlineRow& above) const;
    void addModules(Rows& rows, const OutlineRow& above) const;
    void addParts(Rows& rows, const Part& part, const OutlineRow& above, bool reached) const;
    void addMembers(Rows& rows, const OutlineRow& above, std::size_t first, std::size_t last) const;
    [[nodiscard]] OutlineRow membersRow(const OutlineRow& above, std::size_t first, std::size_t last, bool all) const;
    [[nodiscard]] OutlineRow memberRow(const OutlineRow& above, std::size_t robot) const;
    void findMembers();
    [[nodiscard]] OutlineGroup groupOf(const Part& part) const;
    [[nodiscard]] Rows fileBlocks(const OutlineRow& above) const;
    void gather(const std::vector<Part>& parts, FileId around);
    void keep(Rows& rows, OutlineRow row, const OutlineRow& above) const;
    [[nodiscard]] bool says(std::string_view name, std::string_view detail, std::string_view kind) const;
    [[nodiscard]] bool leads(const OutlineRow& row) const;
    [[nodiscard]] bool leads(const Part& part) const;

    std::shared_ptr<const Loaded> m_loaded;
    OutlineMode m_mode;
    std::vector<std::string> m_words; // of the filter, in small letters
    ProblemCounts m_problems;
    std::array<std::vector<const Part*>, kOutlineGroups> m_groups;
    std::unordered_map<FileId, std::vector<const Part*>> m_blocks; // of each file, those in no other block of it
    std::unordered_map<std::string_view, const MaterialSpec*> m_materials;
    std::unordered_map<const Part*, std::pair<std::size_t, std::size_t>> m_members; // of Grids and Scatters: robots from, to
    mutable std::unordered_map<const Part*, bool> m_leads; // whether something in a part matches
};

} // namespace trundle
