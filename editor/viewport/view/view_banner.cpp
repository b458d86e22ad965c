#include "editor/viewport/view/view_banner.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/transform_selection.h"

namespace trundle {

ViewBanner::ViewBanner(const ViewContext& context, QWidget* parent)
    : QFrame(parent), m_context(context), m_text(new QLabel), m_button(new QPushButton) {
    setObjectName(QStringLiteral("viewportBanner"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    auto* words = new QHBoxLayout(this);
    words->setContentsMargins(10, 4, 6, 4);
    m_text->setWordWrap(true);
    m_button->setObjectName(QStringLiteral("bannerButton"));
    words->addWidget(m_text, 1);
    words->addWidget(m_button);
    connect(m_button, &QPushButton::clicked, this, &ViewBanner::apply);
    hide();
}

void ViewBanner::apply() {
    Document& document = m_context.document;
    if (m_blockingLayout.empty()) return m_context.session.robots().keepPoses();
    (void)document.edits().apply(tr("Replace %1 by single instances").arg(QString::fromStdString(m_blockingLayout)),
                                 planReplaceBySingles(*document.loaded(), m_blockingLayout));
}

void ViewBanner::refresh(bool busy) {
    if (busy && !isVisible()) return;
    const ViewSettings& settings = m_context.settings;
    const RunSession& session = m_context.session;
    m_blockingLayout.clear();
    QString text, button;
    const Tool tool = settings.tool();
    const bool edits = tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
    if (edits && !m_context.selection.empty() && m_context.document.isOpen()) {
        const TransformSelection held(m_context, tool == Tool::Scale ? TransformSelection::Operation::Scale
                                                                     : TransformSelection::Operation::Move);
        text = held.refusal();
        m_blockingLayout = held.blockingLayout();
        if (!m_blockingLayout.empty()) button = tr("Replace by Single Instances");
        if (text.isEmpty() && tool == Tool::Scale) text = held.sizeRefusal();
        if (text.isEmpty() && tool == Tool::Scale && !held.empty() && held.halfExtent().isZero())
            text = m_context.world.isRunning()
                       ? tr("Sizes can only change at the start of a run.")
                       : tr("%1 has no size of its own: select a shape with repeated clicks.").arg(held.title());
    }
    if (text.isEmpty() && session.state() == RunState::Paused && edits && m_context.world.isRunning() &&
        session.robots().keepRefusal().isEmpty()) {
        text = tr("Moving objects during a run does not change their start in the text.");
        button = tr("Keep These Poses as Start");
    }
    m_text->setText(text);
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    setVisible(!text.isEmpty());
}

void ViewBanner::place(int top) {
    const int frame = layout()->minimumSize().width() - m_text->minimumSizeHint().width();
    const int wanted = frame + m_text->fontMetrics().horizontalAdvance(m_text->text()) + 4;
    const int room = parentWidget()->width(), wide = std::min(wanted, room - 24);
    setGeometry((room - wide) / 2, top, wide, heightForWidth(wide));
    raise();
}

} // namespace trundle
