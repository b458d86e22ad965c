#pragma once
#include <QSplitter>

#include "editor/shell/layouts.h"
#include "editor/widgets/actions.h"

namespace trundle {

class TextPanel;
class ViewportPanel;

/// The centre of the window: the 3D views and the texts beside them. At least one of the two is shown.
class WorkArea final : public QSplitter {
    Q_OBJECT
public:
    /// Takes ownership of the panels. The actions must outlive this widget.
    WorkArea(ViewportPanel& viewport, TextPanel& text, Actions& actions);

    void showText(bool shown);
    void showViewport(bool shown);
    /// "perspective", "top", "front", "side", "follow", "chase", a View block, or "text": the text alone. "" does nothing. False if
    /// there is no such view.
    bool useView(const QString& name);
    /// For running the views are shown alone; for editing the text is shown as before.
    void changeLayout(Layout before, Layout now);

private:
    ViewportPanel& m_viewport;
    TextPanel& m_text;
    Actions& m_actions;
    bool m_textForEditing = true;
};

} // namespace trundle
