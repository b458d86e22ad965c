#include "editor/shell/work_area.h"

#include <QApplication>

#include "editor/text/text_panel.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

WorkArea::WorkArea(ViewportPanel& viewport, TextPanel& text, Actions& actions)
    : QSplitter(Qt::Horizontal), m_viewport(viewport), m_text(text), m_actions(actions) {
    setObjectName(QStringLiteral("work"));
    addWidget(&viewport);
    addWidget(&text);
    setChildrenCollapsible(false);
    setSizes({1000, 1000});
    connect(&m_actions.at("view.text"), &QAction::triggered, this, &WorkArea::showText);
    connect(&m_actions.at("view.viewport"), &QAction::triggered, this, &WorkArea::showViewport);
    m_actions.at("view.text").setChecked(true);
    m_actions.at("view.viewport").setChecked(true);
    for (const char* id : {"edit.findInFiles", "edit.replace"})
        connect(&m_actions.at(id), &QAction::triggered, this, [this] { showText(true); });
}

void WorkArea::showText(bool shown) {
    if (!shown) m_viewport.show();
    const bool hadFocus = m_text.isAncestorOf(QApplication::focusWidget());
    m_text.setVisible(shown);
    if (!shown && hadFocus) m_viewport.views().current().setFocus(); // else a value of Properties would get the next keys
    m_actions.at("view.text").setChecked(shown);
    m_actions.at("view.viewport").setChecked(m_viewport.isVisibleTo(this));
}

void WorkArea::showViewport(bool shown) {
    if (!shown) m_text.show();
    m_viewport.setVisible(shown);
    m_actions.at("view.viewport").setChecked(shown);
    m_actions.at("view.text").setChecked(m_text.isVisibleTo(this));
}

bool WorkArea::useView(const QString& name) {
    const bool textAlone = name.compare(QStringLiteral("text"), Qt::CaseInsensitive) == 0;
    if (textAlone) showViewport(false);
    return name.isEmpty() || textAlone || m_viewport.views().showView(name);
}

void WorkArea::changeLayout(Layout before, Layout now) {
    if (before == now) return;
    if (before == Layout::Edit) m_textForEditing = m_text.isVisibleTo(this);
    showViewport(true);
    showText(now == Layout::Edit && m_textForEditing);
}

} // namespace trundle
