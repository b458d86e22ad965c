#pragma once
#include <string>

#include <QObject>
#include <QTimer>

#include "editor/document/document.h"
#include "editor/outline/object_marks.h"
#include "editor/viewport/viewport_panel.h"

namespace trundle {

/// What a window keeps of an experiment from one start to the next and its text does not say: which objects are hidden and
/// locked, whose values are pinned, and where the views look from. A small file for each in the user's own folder; those of experiments long not opened go.
class WindowMemory final : public QObject {
    Q_OBJECT
public:
    /// To be made before whoever clears the marks when another project is opened. All outlive this.
    WindowMemory(Document& document, ObjectMarks& marks, ViewportPanel& viewport, QObject* parent);

    void start(); ///< before it, nothing is brought back or kept
    void save() const;

private:
    void onOpened();
    void onChanged();
    void restore();

    Document& m_document;
    ObjectMarks& m_marks;
    ViewportPanel& m_viewport;
    QTimer m_saveSoon;
    std::string m_path; // whose marks and views these are; "" where no file holds it
    bool m_on = false;
    bool m_fresh = false; // opened, and not brought back yet
};

} // namespace trundle
