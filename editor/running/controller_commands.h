#pragma once
#include <functional>

#include <QObject>
#include <QStringList>

#include "editor/document/document.h"
#include "editor/running/controller_edits.h"
#include "editor/running/session.h"

namespace trundle {

/// What the Controllers menu does, without its dialogs: those ask, this acts.
class ControllerCommands final : public QObject {
    Q_OBJECT
public:
    /// Gives the document the trusted folders at once.
    ControllerCommands(Document& document, RunSession& session, QObject* parent = nullptr);

    /// Whether a folder may be trusted from now on: shown the library and its folder. Without it nobody is asked and nothing trusted.
    void setAsk(std::function<bool(const QString& library, const QString& folder)> ask) { m_ask = std::move(ask); }

    /// Adds the #loadModule of a library and remembers it among the recent ones. Asks first where its folder is not trusted; false,
    /// with refused(), where it is no module or was not to be.
    bool load(const QString& library);
    /// Asks for the folder of a module that the text names already.
    bool trust(const ModuleInfo& module);
    bool unload(const ModuleInfo& module);
    /// Ends the run, so that libraries are let go, and reads what they say now.
    void reload();
    /// Loads the controller's module first where that is needed, in the same step of undo.
    bool assign(const std::vector<std::string>& robots, const ControllerChoice& choice);
    bool unassign(const std::vector<std::string>& robots);
    /// Trusted folders were changed elsewhere.
    void applyTrust();

    [[nodiscard]] std::vector<ModuleInfo> modules() const;
    [[nodiscard]] std::vector<ControllerChoice> choices() const;
    [[nodiscard]] static QStringList recent(); ///< libraries that still exist, newest first

Q_SIGNALS:
    void refused(const QString& reason);

private:
    bool refuse(const QString& reason);
    bool answer(const Status& status);
    bool edit(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey = {});
    bool mayRun(const QString& library);

    Document& m_document;
    RunSession& m_session;
    std::function<bool(const QString&, const QString&)> m_ask;
    std::vector<std::string> m_given; // folders trusted for this process, as on its command line
};

} // namespace trundle
