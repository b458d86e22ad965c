#pragma once
#include <QObject>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

class Document;
class HelpPanel;
class Layouts;
class Selection;
class TextPanel;
struct Kind;

/// The Help menu. The guide opens at what is being edited.
class HelpCommands final : public QObject {
    Q_OBJECT
public:
    struct Targets {
        Document& document;
        Selection& selection;
        TextPanel& text;
        HelpPanel& help;
        Layouts& layouts;
    };
    /// All targets must outlive this object.
    HelpCommands(QWidget& window, Actions& actions, const Targets& targets);

private:
    void showHelp();
    [[nodiscard]] const Kind* kindForHelp() const;
    void showAbout();

    QWidget& m_window;
    Targets m_targets;
};

} // namespace trundle
