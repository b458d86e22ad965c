#include "editor/viewport/view/view_header.h"

#include <QAction>
#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QWidgetAction>

#include "editor/document/document.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/view.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/theme.h"
#include "lang/number_text.h"
#include "project/edits/plans.h"

namespace trundle {
namespace {

constexpr qsizetype kMaxInMenu = 24;

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

void startTyping(QDoubleSpinBox& box) {
    box.setFocus();
    box.selectAll(); // so that a number that is typed replaces it
}

/// Tab goes to its other field, and not to another entry of the menu.
class StepsForm final : public QWidget {
protected:
    bool focusNextPrevChild(bool) override {
        for (QDoubleSpinBox* box : findChildren<QDoubleSpinBox*>())
            if (!box->hasFocus()) return startTyping(*box), true;
        return false;
    }
};

constexpr const char* kOverlays[] = {
    "view.overlayGrid",     "view.overlayShadows",  "view.overlayNames",     "view.overlayTrails",   "view.overlayJoints",
    "view.overlayMass",     "view.overlayInertia",  "view.overlaySupport",  "view.overlayFrusta",   "view.overlayBeams",     "view.overlayLobes",    "view.overlayLinks",
    "view.overlayCoverage", "view.overlayContacts", "view.overlayCollision", "view.overlayWireframe"};
constexpr const char* kViewCounts[] = {"view.one", "view.two", "view.three", "view.four"};

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
    m_button->setToolTip(tr("View direction"));
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setFocusPolicy(Qt::NoFocus);
    m_button->setCursor(Qt::ArrowCursor);
    // Painted over an image, so the colours do not depend on the theme.
    m_button->setStyleSheet(QStringLiteral(
        "QToolButton { color: #f5f6f8; background: rgba(24,27,31,170); border: none; border-radius: 4px; padding: 3px 20px 3px "
        "8px; }"
        "QToolButton:hover { background: rgba(24,27,31,225); }"));
    auto* menu = new QMenu(m_button);
    for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic, ViewKind::Top, ViewKind::Front, ViewKind::Side,
                                ViewKind::Follow, ViewKind::Chase}) {
        if (kind == ViewKind::Top || kind == ViewKind::Follow) menu->addSeparator();
        connect(menu->addAction(viewKindName(kind)), &QAction::triggered, this, [this, kind] { m_view.camera().setKind(kind); });
    }
    addNamedViews(*menu);
    auto* through = menu->addMenu(tr("Through Camera"));
    through->setObjectName(QStringLiteral("throughMenu"));
    connect(menu, &QMenu::aboutToShow, this, [this, through] {
        through->clear();
        for (const CameraModel& camera : m_view.context().world.cameras()) {
            if (through->actions().size() >= kMaxInMenu) break;
            connect(through->addAction(QString::fromStdString(camera.path)), &QAction::triggered, this,
                    [this, path = camera.path] { m_view.camera().lookThrough(path); });
        }
        through->menuAction()->setVisible(!through->isEmpty());
    });
    m_button->setMenu(menu);
    auto* layout = new QHBoxLayout(this); // resizes with the button's text and font
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    layout->addWidget(m_button);
    connect(&view.camera(), &CameraControl::kindChanged, this, &ViewCorner::show);
    move(8, 8);
    show();
}

void ViewCorner::show() {
    m_button->setText(!m_view.camera().named().empty() ? QString::fromStdString(m_view.camera().named())
                      : m_view.camera().through()      ? tr("Camera")
                                                       : viewKindName(m_view.camera().free().kind()));
}

/// Adds the View blocks of the experiment, as of the opening of the menu, and the command that creates one.
void ViewCorner::addNamedViews(QMenu& menu) {
    menu.addSeparator();
    auto* views = menu.addMenu(tr("View of the Experiment"));
    views->setObjectName(QStringLiteral("namedViews"));
    QAction* make = menu.addAction(tr("Make View from This"));
    make->setObjectName(QStringLiteral("makeView"));
    make->setToolTip(tr("Writes a View block with the camera of this view"));
    connect(make, &QAction::triggered, this, [this] {
        Document& document = m_view.context().document;
        if (document.isOpen())
            (void)document.edits().apply(tr("Make View"), planInsert(*document.loaded(), {}, m_view.camera().viewBlockText()));
    });
    connect(&menu, &QMenu::aboutToShow, this, [this, views, make] {
        views->clear();
        const auto text = m_view.camera().textOfViews();
        for (const ComponentSpec& look : text->looks)
            if (look.kind == "View" && views->actions().size() < kMaxInMenu)
                connect(views->addAction(QString::fromStdString(look.name)), &QAction::triggered, this,
                        [this, name = look.name] { m_view.camera().showNamed(name); });
        views->menuAction()->setVisible(!views->isEmpty());
        make->setEnabled(m_view.context().document.isOpen());
    });
}

ViewBar::ViewBar(ViewSettings& settings, Actions& actions, QWidget* parent) : QToolBar(parent), m_settings(settings) {
    setObjectName(QStringLiteral("viewBar"));
    setIconSize({22, 16}); // with room between icon and text; a tool bar ignores the size of its buttons
    fitFont();
    m_axes = addMenuButton("axes", tr("Axes of arrows and rings"), makeAxesMenu());
    m_steps = addMenuButton("steps", tr("Steps of moves and turns"), makeStepsMenu());
    auto* gap = new QWidget;
    gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(gap);
    QAction* overlays = addMenuButton("overlays", tr("What is drawn over the views"), menuOf(actions, kOverlays));
    overlays->setText(tr("Overlays"));
    overlays->setIcon(themedIcon(QStringLiteral("overlays")));
    QAction* views = addMenuButton("views", tr("How many views"), menuOf(actions, kViewCounts));
    views->setText(tr("Views")); // title of the overflow menu
    views->setIcon(themedIcon(QStringLiteral("views")));
    qobject_cast<QToolButton*>(widgetForAction(views))->setToolButtonStyle(Qt::ToolButtonIconOnly);
    connect(&settings, &ViewSettings::changed, this, &ViewBar::showSettings);
    showSettings();
}

QMenu* ViewBar::menuOf(Actions& actions, std::span<const char* const> ids) {
    auto* menu = new QMenu(this);
    for (const char* id : ids) menu->addAction(&actions.at(id));
    return menu;
}

QMenu* ViewBar::makeAxesMenu() {
    auto* menu = new QMenu(this);
    for (const auto& [name, axes] : {std::pair(tr("World axes"), AxesOf::World), std::pair(tr("Parent axes"), AxesOf::Parent),
                                     std::pair(tr("Local axes"), AxesOf::Local)})
        connect(menu->addAction(name), &QAction::triggered, this, [this, axes = axes] { m_settings.setAxes(axes); });
    return menu;
}

QMenu* ViewBar::makeStepsMenu() {
    auto* menu = new QMenu(this);
    auto* form = new StepsForm;
    auto* lines = new QFormLayout(form);
    auto *move = stepBox(QStringLiteral("moveStep"), m_settings.moveStep(), tr(" m"), 3),
         *turn = stepBox(QStringLiteral("turnStep"), m_settings.rotationStep(), QStringLiteral("°"), 1);
    lines->addRow(tr("Move"), move);
    lines->addRow(tr("Turn"), turn);
    const auto take = [this, move, turn] { m_settings.setSteps(move->value(), turn->value()); };
    connect(move, &QDoubleSpinBox::valueChanged, this, take);
    connect(turn, &QDoubleSpinBox::valueChanged, this, take);
    connect(&m_settings, &ViewSettings::changed, this, [this, move, turn] {
        const QSignalBlocker quietMove(move), quietTurn(turn);
        // Only if changed elsewhere, so that a number being typed is not replaced.
        if (move->value() != m_settings.moveStep()) move->setValue(m_settings.moveStep());
        if (turn->value() != m_settings.rotationStep()) turn->setValue(m_settings.rotationStep());
    });
    auto* holder = new QWidgetAction(menu);
    holder->setDefaultWidget(form);
    menu->addAction(holder);
    return menu;
}

/// Same height as the tabs of the text editor beside it.
void ViewBar::fitFont() { setFixedHeight(fontMetrics().height() + 13); }

void ViewBar::changeEvent(QEvent* event) {
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitFont();
}

QAction* ViewBar::addMenuButton(const char* name, const QString& tip, QMenu* menu) {
    QAction* action = addAction(QString());
    action->setMenu(menu);
    action->setToolTip(tip);
    auto* button = qobject_cast<QToolButton*>(widgetForAction(action));
    button->setObjectName(QLatin1String(name));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return action;
}

void ViewBar::showSettings() {
    const AxesOf axes = m_settings.axes();
    m_axes->setText(axes == AxesOf::World ? tr("World") : axes == AxesOf::Parent ? tr("Parent") : tr("Local"));
    m_steps->setText(QStringLiteral("%1 m · %2°")
                         .arg(QString::fromStdString(steppedNumber(m_settings.moveStep(), 0.001)),
                              QString::fromStdString(steppedNumber(m_settings.rotationStep(), 0.1))));
}

void ViewBar::openSteps() {
    const QWidget* button = widgetForAction(m_steps);
    m_steps->menu()->popup(button->isVisible() ? button->mapToGlobal(QPoint(0, button->height()))
                                               : mapToGlobal(QPoint(0, height())));
    startTyping(*m_steps->menu()->findChild<QDoubleSpinBox*>(QStringLiteral("moveStep")));
}

} // namespace trundle
