#pragma once
#include <vector>

#include <QObject>

#include "editor/viewport/view/view_grid.h"
#include "editor/widgets/actions.h"

namespace trundle {

class Document;
class Layouts;
class ObjectEdits;
class RunSession;
class Selection;
class StatusLine;
class ViewportPanel;
class WorkArea;

/// The model editor: shows the model of the selected robot or scenery alone, makes new models, drives one on a plain floor or a ramp.
class ModelCommands final : public QObject {
    Q_OBJECT
public:
    struct Targets {
        Document& document;
        Selection& selection;
        RunSession& session;
        ObjectEdits& objects;
        ViewportPanel& viewport;
        WorkArea& work;
        Layouts& layouts;
        StatusLine& status;
    };
    /// All targets must outlive this object.
    ModelCommands(QWidget& window, Actions& actions, const Targets& targets);

private:
    [[nodiscard]] std::string wanted() const;
    bool open(const std::string& path);
    void edit(bool on);
    void makeNew();
    void drive(bool on);
    void endDrive();
    void showSensors();
    void hideSensors();
    void offerGrounds();
    void setRamp(double slope);
    void showState();

    Actions& m_actions;
    Targets m_targets;
    double m_ramp = 0;                     // degrees, of test drives
    std::vector<ViewState> m_views;        // before the test drive
    std::vector<QAction*> m_shownForDrive; // overlays
    QString m_front;                       // the panel in front before Sensors
    bool m_raisedSensors = false;          // the panel was hidden before
    bool m_driving = false;
    bool m_opened = false; // the test drive has opened the model
    bool m_drove = false;  // sim.drive was checked before
};

} // namespace trundle
