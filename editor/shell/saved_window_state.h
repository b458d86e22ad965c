#pragma once
#include <string>

#include <QObject>
#include <QTimer>

#include "editor/document/document.h"
#include "editor/outline/object_marks.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

/// View state of an experiment that is saved between starts and is not in its text: hidden and locked objects, pinned values and sensors,
/// and the viewports' cameras. One small file per experiment in the user's own folder; the oldest are removed.
class SavedWindowState final : public QObject {
    Q_OBJECT
public:
    /// Create it before the objects that clear the marks when another project is opened, so that it can save them first. All
    /// outlive this.
    SavedWindowState(Document& document, ObjectMarks& marks, ViewportPanel& viewport, PinnedValues& sensorPins, QObject* parent);

    void start(); ///< nothing is restored or saved before
    void save() const;

private:
    void onOpened();
    void onChanged();
    void restore();

    Document& m_document;
    ObjectMarks& m_marks;
    ViewportPanel& m_viewport;
    PinnedValues& m_sensorPins;
    QTimer m_saveSoon;
    std::string m_path; // the experiment that marks and viewports belong to; "" if it is not saved to a file
    bool m_on = false;
    bool m_fresh = false; // opened, and its state is not restored yet
};

} // namespace trundle
