#pragma once
// The commands that write parts, mirror images and repetitions: menu Edit, Parts; and Insert, Ring of Sensors.

#include <functional>
#include <string>
#include <vector>

#include <QObject>

#include "base/result.h"
#include "project/edits/plans.h"

class QWidget;

namespace trundle {

class Actions;
class Document;
class Selection;

/// Connects the actions "parts.*" and "sensors.ring". Each is one entry of the history for the selected objects; refusals are reported by
/// Document::refused().
class PartCommands final : public QObject {
    Q_OBJECT
public:
    PartCommands(QWidget& window, Actions& actions, Document& document, Selection& selection);

private:
    using Plan = std::function<Result<EditPlan>(const LoadedProject& loaded, const std::vector<std::string>& paths)>;
    /// `name` of the entry, with %1 for the objects.
    void apply(const QString& name, const Plan& plan);
    void enable();
    void askRepeat();
    void askSensorRing();
    /// The selected objects; empty, and the reason reported, if none can be changed.
    [[nodiscard]] std::vector<std::string> chosen();

    QWidget& m_window;
    Actions& m_actions;
    Document& m_document;
    Selection& m_selection;
};

} // namespace trundle
