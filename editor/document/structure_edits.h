#pragma once
// Edits that insert, remove, move or rename blocks. For a config with several users the user decides whether the config
// itself or a copy is changed; the decision is kept per config until the window closes. Configs, materials, surfaces, antenna
// patterns and Params installed with Trundle are always copied.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "project/edits/edit_target.h"
#include "project/edits/value_edits.h"

namespace trundle {

class Document;

enum class ShareChoice { ChangeForAll, MakeCopy, Cancel };

/// The question about a config that has several users.
struct ShareQuestion {
    QString config;              ///< "SimpleRobot"
    QString file;                ///< that contains it, path for display
    QString copyFile;            ///< where the copy would be written
    QStringList users;           ///< files with instances of it, paths for display
    QStringList copyFor;         ///< the instances that would use the copy: "robot0"
    std::size_t instances = 0;   ///< in the opened experiment
    bool copyIsForOpened = true; ///< copyFile is the opened file
    bool isShipped = false;      ///< it came with Trundle: for all means a copy for all
    QString value;               ///< the value that is written into the config: "Resistance"; empty: its structure changes
};

class StructureEdits {
public:
    /// Maps the path of an object to its path in the project that a plan is made for: the same path, or that in the copy of
    /// its config.
    using PathMapping = std::function<std::string(const std::string& path)>;
    using Plan = std::function<Result<EditPlan>(const LoadedProject& loaded, const PathMapping& renamed)>;
    using ShareAnswer = std::function<void(ShareChoice choice)>;
    /// Must call `answer` once, now or later.
    using ShareQuestionHandler = std::function<void(const ShareQuestion& question, const ShareAnswer& answer)>;

    explicit StructureEdits(Document& document) : m_document(document) {} ///< the document owns this

    /// Without a handler no question is asked: a shared config is changed for all its users.
    void setShareQuestionHandler(ShareQuestionHandler handler) { m_questionHandler = std::move(handler); }

    /// Applies a plan as one entry of the history, after the question if one is needed; in that case a failure is reported
    /// only by Document::refused(). `paths`: the edited objects as the user selected them, through an instance or not.
    Status apply(const QString& name, const std::vector<std::string>& paths, Plan plan, const std::string& mergeKey = {});
    /// Renames an object in every reference, also in texts of the project that are not loaded; one entry of the history. After the
    /// question as in apply(), in the copy of its config instead.
    Status rename(const QString& name, const std::string& path, const std::string& to);
    /// Moves an override into its config, or into a copy of it: as apply().
    Status pushOverride(const QString& name, const std::string& propertyPath);
    /// Applies a fix of a diagnostic of the document's current texts. A config installed with Trundle gets a copy for the opened file,
    /// in which the fix is made.
    Status applyFix(const Fix& fix);
    /// Sets values, each where it is to be written; refused as a whole if one is invalid. What is installed with Trundle
    /// is copied.
    Status setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey = {});
    /// Where a value of this path would be written; see project/edits/edit_target.h.
    [[nodiscard]] EditTarget targetOf(const std::string& propertyPath);
    /// The paths where these values are set: decided once for all steps of a drag, which have the same merge key. Configs
    /// installed with Trundle are copied under that key.
    [[nodiscard]] Result<std::vector<std::string>> pathsForValues(const std::vector<std::string>& asked,
                                                                  const std::string& mergeKey);
    /// Copies a config for one instance, or, if the path is that of the config, for all instances of the opened file. Returns
    /// the copy's path.
    [[nodiscard]] Result<std::string> copyConfig(const std::string& path, const std::string& mergeKey = {});

private:
    struct PendingEdit;
    [[nodiscard]] static QString noticeOf(const PendingEdit& work);
    [[nodiscard]] std::shared_ptr<PendingEdit> startEdit(const QString& name, const std::vector<std::string>& paths, Plan plan,
                                                         const std::string& mergeKey) const;
    Status renameEverywhere(const QString& name, const std::string& path, const std::string& to);
    Status advance(const std::shared_ptr<PendingEdit>& work);
    [[nodiscard]] std::optional<Status> decide(const std::shared_ptr<PendingEdit>& work, const Part& config,
                                               bool copyForAll = false);
    Status ask(const std::shared_ptr<PendingEdit>& work, const Part& config);
    [[nodiscard]] Result<std::string> copyDefinition(const std::string& definition, const std::string& mergeKey);
    Status finish(PendingEdit& work, const EditPlan& plan);
    [[nodiscard]] QString shown(const std::string& file) const;
    Status refuse(const Error& error); ///< reports it; the document does not change

    Document& m_document;
    ShareQuestionHandler m_questionHandler;
    ConfigUsers m_users;
    std::string m_gesture;                                  ///< merge key that m_targets, m_copies and m_notice belong to
    QString m_notice;                                       ///< which copies were made; empty: none
    std::map<std::string, std::string> m_targets, m_copies; ///< requested value path -> path that is set; config -> copy
    std::map<std::string, ShareChoice> m_chosen;            ///< by file and name of the config
};

} // namespace trundle
