#pragma once
#include <QObject>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

class Document;
class Layouts;
class ObjectEdits;
class OutlinePanel;
class Selection;
class TextPanel;
class WorkArea;

/// The Edit menu: each command applies to the text that has the focus, otherwise to the selected objects.
class EditCommands final : public QObject {
    Q_OBJECT
public:
    struct Targets {
        Document& document;
        Selection& selection;
        ObjectEdits& objects;
        OutlinePanel& outline;
        TextPanel& text;
        WorkArea& work;
        Layouts& layouts;
    };
    /// `configs`: folder of the installed configs. All targets must outlive this object.
    EditCommands(QWidget& window, Actions& actions, const Targets& targets, const std::string& configs);

private:
    void apply(const char* id);
    void selectAll();
    void showUndo();
    void showSingles();

    Actions& m_actions;
    Targets m_targets;
};

} // namespace trundle
