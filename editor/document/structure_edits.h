#pragma once
// Edits that insert, remove, move or rename blocks. Inside of a config that others use too the user decides, once per config as long
// as the window lives, whether all of them get the change or a copy does. A config that came with the program is always copied.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "project/edit_target.h"

namespace trundle {

class Document;

enum class ShareChoice { ChangeForAll, MakeCopy, Cancel };

/// What is asked about a config that others use too.
struct ShareQuestion {
    QString config;            ///< "SimpleRobot"
    QString file;              ///< that holds it, as shown
    QString copyFile;          ///< that would get the copy
    QStringList users;         ///< files that place it, as shown
    QStringList copyFor;       ///< the instances that would use the copy: "robot0"
    std::size_t instances = 0; ///< in the opened experiment
    bool copyIsForOpened = true; ///< copyFile is the opened one
};

class StructureEdits {
public:
    /// The path of an object in the load that a plan is made for: the same as before, or in the copy of its config.
    using Renamed = std::function<std::string(const std::string& path)>;
    using Plan = std::function<Result<EditPlan>(const Loaded& loaded, const Renamed& renamed)>;
    using Answer = std::function<void(ShareChoice choice)>;
    /// Calls the answer once, now or later.
    using Asker = std::function<void(const ShareQuestion& question, const Answer& answer)>;

    explicit StructureEdits(Document& document) : m_document(document) {} ///< which owns this

    /// Without one nobody is asked: a shared config is changed for all.
    void setAsker(Asker asker) { m_asker = std::move(asker); }

    /// Carries out a plan as one entry of the history, after the question where one is needed; then a failure comes as
    /// Document::refused() alone. `paths`: the objects that are edited, as the user selected them: through an instance or not.
    Status apply(const QString& name, const std::vector<std::string>& paths, Plan plan, const std::string& mergeKey = {});
    /// Gives an object another name. What is part of no config is renamed wherever it is named.
    Status rename(const QString& name, const std::string& path, const std::string& to);
    /// Where a value of this path would be written; see project/edit_target.h.
    [[nodiscard]] EditTarget targetOf(const std::string& propertyPath);
    /// Under which paths these values are set: decided once for all steps of a drag, which share a merge key. Configs that came with
    /// the program are copied under that key.
    [[nodiscard]] Result<std::vector<std::string>> pathsForValues(const std::vector<std::string>& asked,
                                                                  const std::string& mergeKey);
    /// Copies a config for the instance, or for all of the opened file where the path names the config. Gives the copy's path.
    [[nodiscard]] Result<std::string> copyConfig(const std::string& path, const std::string& mergeKey = {});

private:
    Status renameHere(const QString& name, const std::string& path, const std::string& to);
    struct Work;
    Status advance(const std::shared_ptr<Work>& work);
    Status ask(const std::shared_ptr<Work>& work, const Part& config);
    [[nodiscard]] Status copy(Work& work, const Part& config);
    Status finish(Work& work, const EditPlan& plan);
    [[nodiscard]] Status reload(Work& work, const EditPlan& plan);
    [[nodiscard]] std::vector<const Part*> copyUsers(const Work& work, const Part& config) const;
    [[nodiscard]] QString shown(const std::string& file) const;

    Document& m_document;
    Asker m_asker;
    ConfigUsers m_users;
    std::string m_gesture;                                  ///< merge key that the next two are kept for
    std::map<std::string, std::string> m_targets, m_copies; ///< paths of values that were asked for and are set; of configs
    std::map<std::string, ShareChoice> m_chosen;            ///< by file and name of the config
};

} // namespace trundle
