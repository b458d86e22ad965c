#include "editor/viewport/view/viewport_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/tools/floor_drawing.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/view/joint_panel.h"
#include "editor/viewport/view/model_bar.h"
#include "editor/viewport/view/view_banner.h"
#include "editor/viewport/view/view_header.h"
#include "editor/viewport/view/viewport_actions.h"
#include "editor/widgets/actions.h"

namespace trundle {

ViewportPanel::ViewportPanel(Document& document, Selection& selection, RunSession& session, RenderService* render,
                             Actions& actions, QWidget* parent)
    : QWidget(parent), m_measurement(std::make_unique<Measurement>()),
      m_world(std::make_unique<ViewportScene>(document, session, render)), m_trails(std::make_unique<Trails>(*m_world)),
      m_radios(std::make_unique<RadioOverlays>(*m_world, selection, m_settings)),
      m_pinned(std::make_unique<PinnedValues>(document)),
      m_drawing(std::make_unique<FloorDrawing>(document, *m_world, m_settings)) {
    setObjectName(QStringLiteral("viewportPanel"));
    m_context.reset(new ViewContext{document, selection, session, *m_world, m_settings, *m_measurement, *m_drawing, render,
                                    m_trails.get(), m_radios.get(), m_pinned.get()});
    auto* bar = new ViewBar(m_settings, actions);
    m_views = new ViewGrid(*m_context);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new ModelBar(document, actions));
    column->addWidget(bar);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_views, 1);
    auto* joints = new JointPanel(*m_context);
    row->addWidget(joints);
    column->addLayout(row, 1);
    QAction& showJoints = actions.at("model.joints");
    joints->hide();
    connect(&showJoints, &QAction::toggled, joints, &QWidget::setVisible);
    connect(joints, &JointPanel::closeRequested, &showJoints, [&showJoints] { showJoints.setChecked(false); });
    m_banner = new ViewBanner(*m_context, this);
    new ViewportActions(*m_context, actions, *m_views, *bar);
    for (const auto& signal : {&ViewportScene::replaced, &ViewportScene::posed})
        connect(m_world.get(), signal, this, &ViewportPanel::updateBanner);
    connect(&selection, &Selection::changed, this, &ViewportPanel::updateBanner);
    connect(&session, &RunSession::stateChanged, this, &ViewportPanel::updateBanner);
    connect(&m_settings, &ViewSettings::changed, this, &ViewportPanel::updateBanner);
}

ViewportPanel::~ViewportPanel() {
    // The views refer to members of this panel, so they are deleted first.
    delete m_views;
}

bool ViewportPanel::isSettled() const { return !m_radios->isComputing() && m_views->isSettled(); }

void ViewportPanel::updateBanner() {
    m_banner->refresh(m_views->current().isMouseBusy());
    placeBanner();
    placeBanner(); // the height depends on the width
}

/// Over the views, so that the layout does not change when it appears; below the corner button of the first view, since axes and
/// scale bar are at the lower edge.
void ViewportPanel::placeBanner() { m_banner->place(m_views->y() + 42); }

void ViewportPanel::resizeEvent(QResizeEvent*) { placeBanner(); }

} // namespace trundle
