#include "editor/viewport/view_header.h"

#include <QAction>
#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>

#include "editor/viewport/number_text.h"
#include "editor/viewport/view.h"
#include "editor/viewport/view_settings.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

QToolButton* menuButton(const QString& name, const QString& tip) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setStyleSheet(QStringLiteral(
        "QToolButton { padding-right: 18px; }"
        "QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: right center; right: 4px; }"));
    return button;
}

QDoubleSpinBox* stepBox(const QString& name, double value, const QString& suffix, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setDecimals(decimals);
    box->setRange(decimals > 2 ? 0.001 : 0.1, decimals > 2 ? 100 : 180);
    box->setSingleStep(decimals > 2 ? 0.01 : 5);
    box->setSuffix(suffix);
    box->setValue(value);
    return box;
}

} // namespace

QString viewKindName(ViewKind kind) {
    switch (kind) {
    case ViewKind::Perspective: return ViewCorner::tr("Perspective");
    case ViewKind::Orthographic: return ViewCorner::tr("Parallel");
    case ViewKind::Top: return ViewCorner::tr("Top");
    case ViewKind::Front: return ViewCorner::tr("Front");
    case ViewKind::Side: return ViewCorner::tr("Side");
    case ViewKind::Follow: return ViewCorner::tr("Follow");
    case ViewKind::Chase: return ViewCorner::tr("Chase");
    }
    return {};
}

ViewCorner::ViewCorner(View& view) : QWidget(&view), m_view(view), m_button(new QToolButton(this)) {
    m_button->setObjectName(QStringLiteral("viewKind"));
    m_button->setToolTip(tr("Which way this view looks"));
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setFocusPolicy(Qt::NoFocus);
    m_button->setCursor(Qt::ArrowCursor);
    // Over a picture, so the same in both themes.
    m_button->setStyleSheet(QStringLiteral(
        "QToolButton { color: #f5f6f8; background: rgba(24,27,31,170); border: none; border-radius: 4px; padding: 3px 20px 3px "
        "8px; }"
        "QToolButton:hover { background: rgba(24,27,31,225); }"
        "QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: right center; right: 5px; }"));
    auto* menu = new QMenu(m_button);
    for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic, ViewKind::Top, ViewKind::Front, ViewKind::Side,
                                ViewKind::Follow, ViewKind::Chase}) {
        if (kind == ViewKind::Top || kind == ViewKind::Follow) menu->addSeparator();
        connect(menu->addAction(viewKindName(kind)), &QAction::triggered, this, [this, kind] { m_view.setKind(kind); });
    }
    m_button->setMenu(menu);
    connect(&view, &View::kindChanged, this, &ViewCorner::show);
    move(8, 8);
    show();
}

void ViewCorner::show() {
    m_button->setText(viewKindName(m_view.camera().kind()));
    m_button->adjustSize();
    resize(m_button->size());
}

ViewBar::ViewBar(ViewSettings& settings, Actions& actions, QWidget* parent) : QWidget(parent), m_settings(settings) {
    setObjectName(QStringLiteral("viewBar"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    row->setSpacing(4);

    m_axes = menuButton(QStringLiteral("axes"), tr("Along whose axes arrows and rings stand"));
    auto* axes = new QMenu(m_axes);
    const auto addAxes = [&](const QString& name, AxesOf which) {
        connect(axes->addAction(name), &QAction::triggered, this, [this, which] { m_settings.setAxes(which); });
    };
    addAxes(tr("World axes"), AxesOf::World);
    addAxes(tr("Parent axes"), AxesOf::Parent);
    addAxes(tr("Local axes"), AxesOf::Local);
    m_axes->setMenu(axes);

    auto* snap = new QToolButton;
    snap->setObjectName(QStringLiteral("snap"));
    snap->setAutoRaise(true);
    snap->setDefaultAction(&actions.at("tool.snap"));
    m_steps = menuButton(QStringLiteral("steps"), tr("Steps of moves and turns"));
    auto* steps = new QMenu(m_steps);
    auto* form = new QWidget;
    auto* lines = new QFormLayout(form);
    auto *move = stepBox(QStringLiteral("moveStep"), settings.moveStep(), tr(" m"), 3),
         *turn = stepBox(QStringLiteral("turnStep"), settings.turnStep(), QStringLiteral("°"), 1);
    lines->addRow(tr("Move"), move);
    lines->addRow(tr("Turn"), turn);
    const auto take = [this, move, turn] { m_settings.setSteps(move->value(), turn->value()); };
    connect(move, &QDoubleSpinBox::valueChanged, this, take);
    connect(turn, &QDoubleSpinBox::valueChanged, this, take);
    auto* holder = new QWidgetAction(steps);
    holder->setDefaultWidget(form);
    steps->addAction(holder);
    m_steps->setMenu(steps);

    auto* overlays = menuButton(QStringLiteral("overlays"), tr("What is drawn over the views"));
    overlays->setIcon(themedIcon(QStringLiteral("overlays")));
    overlays->setText(tr("Overlays"));
    overlays->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* overlayMenu = new QMenu(overlays);
    for (const char* id :
         {"view.overlayGrid", "view.overlayShadows", "view.overlayNames", "view.overlayTrails", "view.overlayJoints",
          "view.overlayMass", "view.overlayContacts", "view.overlayCollision", "view.overlayWireframe"})
        overlayMenu->addAction(&actions.at(id));
    overlays->setMenu(overlayMenu);

    row->addWidget(m_axes);
    row->addWidget(snap);
    row->addWidget(m_steps);
    row->addStretch();
    row->addWidget(overlays);
    for (const char* id : {"view.one", "view.two", "view.four"}) {
        auto* button = new QToolButton;
        button->setAutoRaise(true);
        button->setDefaultAction(&actions.at(id));
        row->addWidget(button);
    }
    connect(&settings, &ViewSettings::changed, this, &ViewBar::showSettings);
    showSettings();
}

void ViewBar::showSettings() {
    const AxesOf axes = m_settings.axes();
    m_axes->setText(axes == AxesOf::World ? tr("World axes") : axes == AxesOf::Parent ? tr("Parent axes") : tr("Local axes"));
    m_steps->setText(QStringLiteral("%1 m · %2°")
                         .arg(QString::fromStdString(steppedNumber(m_settings.moveStep(), 0.001)),
                              QString::fromStdString(steppedNumber(m_settings.turnStep(), 0.1))));
}

void ViewBar::openSteps() { m_steps->showMenu(); }

} // namespace trundle
