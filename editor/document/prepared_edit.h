#pragma once
// An edit of blocks while it is prepared: the project in memory, with the copies that were made of configs and definitions so far.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QStringList>

#include "editor/document/history.h"
#include "project/edits/plans.h"
#include "project/loading/project.h"

namespace trundle {

class Document;

class PreparedEdit {
public:
    static constexpr int kMaxCopies = 100;

    /// `paths`: the edited objects as the user selected them, through an instance or not. The document must outlive this.
    PreparedEdit(Document& document, std::vector<std::string> paths);
    /// If the document was edited meanwhile, all copies are forgotten.
    void restartIfChanged();

    [[nodiscard]] const LoadedProject& loaded() const { return *m_loaded; } ///< with the copies; valid until the next one
    /// The path of an object, in the copy of its config if there is one.
    [[nodiscard]] std::string renamed(const std::string& path) const;
    [[nodiscard]] std::string keyOf(const Part& config) const; ///< file and name
    /// The instances that a copy of the config would be for.
    [[nodiscard]] std::vector<const Part*> copyUsers(const Part& config) const;
    /// Of these, those that the edited objects were selected through; empty: they are in the config itself.
    [[nodiscard]] std::vector<const Part*> editedThrough(const Part& config) const;
    /// The instances of a shipped config that the user's own texts have, also through shipped configs.
    [[nodiscard]] std::vector<const Part*> usersInUse(const Part& config) const;
    /// Which instances use the copy of a shipped config: only those that the edited objects were selected through, or all, wherever they
    /// are. Undecided: those through which it is edited and all others of their file.
    void copyForEdited(const Part& config) { m_copyForAll[keyOf(config)] = false; }
    void copyForAll(const Part& config) { m_copyForAll[keyOf(config)] = true; }
    [[nodiscard]] bool isCopiedForAll(const Part& config) const { return copyForAllOr(config, false); }
    /// A config that a copy of `config` would change, since it has the Part that the copy would be for; those that are decided are left
    /// out. nullptr: there is none.
    [[nodiscard]] const Part* holderToDecide(const Part& config) const;

    /// Files that the edit will change; configs imported from them are copied too.
    void changesFile(const std::string& path) { m_changed.insert(path); }
    void changesFilesOf(const EditPlan& plan);

    void changeItself(const std::string& configKey) { m_decided.insert(configKey); }
    [[nodiscard]] bool isDecided(const Part& config) const { return m_decided.contains(keyOf(config)); }
    [[nodiscard]] bool isCopied(const std::string& path) const { return m_copies.contains(path); }
    [[nodiscard]] const std::string& copyOf(const std::string& path) const { return m_copies.at(path); }

    /// Before it, the shipped configs that have what the copy is for.
    [[nodiscard]] Status copy(const Part& config);
    /// A shipped material, surface, antenna pattern or Param, and the shipped configs that use it.
    [[nodiscard]] Status copyDefinition(const std::string& definition);
    /// A config of the user's own that imports shipped files inside its block: what is changed in them is written into the block.
    /// False if there is nothing of this kind.
    [[nodiscard]] Result<bool> expand(const Part& config);

    [[nodiscard]] bool hasTexts() const { return !m_texts.empty(); } ///< whether anything was copied or expanded
    /// The plan and the copies as one plan for the document.
    [[nodiscard]] Result<EditPlan> withCopies(const EditPlan& plan);
    [[nodiscard]] QString notice() const { return m_notices.join(u"; "); } ///< which copies were made; empty: none

private:
    [[nodiscard]] std::vector<std::string> editedPaths() const; ///< as they are now
    [[nodiscard]] bool copyForAllOr(const Part& config, bool undecided) const;
    [[nodiscard]] Status copyItself(const Part& config);
    [[nodiscard]] Status reload(const EditPlan& plan);
    [[nodiscard]] QString shown(const std::string& file) const;

    Document* m_document;
    std::vector<std::string> m_paths;
    std::uint64_t m_revision; ///< of the document when the edit began
    std::shared_ptr<const LoadedProject> m_loaded;
    FileTexts m_texts;                           ///< texts that differ from the document's
    std::map<std::string, std::string> m_copies; ///< path of a config or definition -> path of its copy
    std::set<std::string> m_decided;             ///< keys of configs that are changed themselves
    std::map<std::string, bool> m_copyForAll;    ///< by the key of a shipped config
    std::set<std::string> m_changed;
    QStringList m_notices;
};

} // namespace trundle
