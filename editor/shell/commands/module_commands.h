#pragma once
#include <string>
#include <vector>

#include <QObject>
#include <QWidget>

#include "app/module_template.h"
#include "editor/modules/module_builder.h"
#include "editor/widgets/actions.h"

namespace trundle {

class Application;
class ControllersPanel;
class Document;
class FileCommands;
class Layouts;
class NewModuleDialog;
class ProblemsPanel;
class RunSession;
class Selection;
class StatusLine;
class TextPanel;
class WorkArea;

/// Modules of the user's own: starts them from templates, builds them, and has the experiment use them.
class ModuleCommands final : public QObject {
    Q_OBJECT
public:
    struct Targets {
        Application& application;
        Document& document;
        Selection& selection;
        RunSession& session;
        FileCommands& files;
        ControllersPanel& controllers;
        ProblemsPanel& problems;
        TextPanel& text;
        WorkArea& work;
        Layouts& layouts;
        StatusLine& status;
    };
    /// All targets must outlive this object.
    ModuleCommands(QWidget& window, Actions& actions, const Targets& targets);

    [[nodiscard]] ModuleBuilder& builder() { return *m_builder; }

private:
    /// A new module that is to be used as soon as it is built.
    struct NewUse {
        std::string folder, library, kind;
        std::vector<std::string> robots; ///< empty: it is only loaded
    };
    void askForNew(bool isController);
    void create(const NewModuleDialog& dialog, const std::vector<std::string>& robots);
    [[nodiscard]] QString nameFault(ModuleTemplate what, const std::string& kind) const;
    void use(const NewUse& wanted);
    void addUse(const NewUse& wanted);
    void build();
    void start(const std::vector<std::string>& folders);
    [[nodiscard]] std::vector<std::string> foldersToBuild() const;
    void showLines(const QStringList& lines, int severity);
    void finish(const BuildResult& result);
    void showState();

    QWidget& m_window;
    Actions& m_actions;
    Targets m_targets;
    ModuleBuilder* m_builder;
    std::vector<NewUse> m_uses;
};

} // namespace trundle
