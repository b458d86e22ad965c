#pragma once
#include <functional>

#include <QObject>
#include <QStringList>

#include "editor/document/document.h"
#include "editor/running/module_list.h"
#include "editor/running/session.h"
#include "project/edits/controllers.h"

namespace trundle {

/// The commands of the Controllers menu, without their dialogs.
class ControllerCommands final : public QObject {
    Q_OBJECT
public:
    /// Passes the trusted folders to the document.
    ControllerCommands(Document& document, RunSession& session, QObject* parent = nullptr);

    /// Sets the question whether a library's folder becomes trusted. Without it no folder does.
    void setAsk(std::function<bool(const QString& library, const QString& folder)> ask) { m_ask = std::move(ask); }

    /// Adds the #loadModule of a library and adds it to the recent ones. Asks first if its folder is not trusted; false, with
    /// refused(), if the file is not a module or trust was denied.
    bool load(const QString& library);
    /// Asks to trust the folder of a module that the text already loads.
    bool trust(const ModuleInfo& module);
    bool unload(const ModuleInfo& module);
    /// Whether code of a folder may run, for `file` in it; asks if the folder is not trusted.
    bool trustFolder(const QString& file, const QString& folder);
    /// The path that a #loadModule of the experiment uses for a library.
    [[nodiscard]] std::string writtenPath(const std::string& library) const;
    /// Gives the robots of a run the code as built now, where they are, if controllers have processes of their own; else ends the
    /// run, which unloads its libraries, and reads their descriptions again.
    void reload();
    /// Loads the controller's module first if necessary, in the same undo step.
    bool assign(const std::vector<std::string>& robots, const ControllerChoice& choice);
    bool unassign(const std::vector<std::string>& robots);
    /// The trusted folders were changed elsewhere: passes them to the document.
    void applyTrust();

    [[nodiscard]] std::vector<ModuleInfo> modules() const;
    [[nodiscard]] std::vector<ControllerChoice> choices() const;
    [[nodiscard]] static QStringList recent(); ///< existing libraries, newest first

Q_SIGNALS:
    void refused(const QString& reason);

private:
    bool reject(const QString& reason);
    bool edit(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey = {});
    bool isTrusted(const QString& library);

    Document& m_document;
    RunSession& m_session;
    std::function<bool(const QString&, const QString&)> m_ask;
    std::vector<std::string> m_given; // folders trusted on the command line
};

} // namespace trundle
