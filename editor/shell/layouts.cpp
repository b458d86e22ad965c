#include "editor/shell/layouts.h"

#include <algorithm>
#include <span>
#include <utility>

#include <QApplication>
#include <QLayout>
#include <QScrollArea>
#include <QSettings>

namespace trundle {
namespace {

constexpr int kVersion = 4; // increase when docks are added or removed: old settings are then ignored

const QString kGuide = QStringLiteral("guide");

/// Whether the side docks do not fit next to viewport and text: for example 1600 x 1000 at scale factor 2.
bool isSmall(const QWidget& window) { return window.width() < 1000 && window.height() < 600; }

QString settingOf(Layout layout) { return QStringLiteral("layouts/") + nameOf(layout); }

constexpr std::pair<Qt::DockWidgetArea, const char*> kSides[] = {{Qt::LeftDockWidgetArea, "/left"},
                                                                 {Qt::RightDockWidgetArea, "/right"}};

/// Where a dock is in a layout at first.
struct DockPlace {
    const char* name;
    Qt::DockWidgetArea area;
    const char* tabWith; // nullptr: an area of its own
    bool shown;
};
const DockPlace kEditPlaces[] = {{"scene", Qt::LeftDockWidgetArea, "", true},
                                 {"library", Qt::LeftDockWidgetArea, "", true},
                                 {"properties", Qt::RightDockWidgetArea, "", true},
                                 {"history", Qt::RightDockWidgetArea, "properties", true},
                                 {"guide", Qt::RightDockWidgetArea, "history", false},
                                 {"problems", Qt::BottomDockWidgetArea, "", true},
                                 {"console", Qt::BottomDockWidgetArea, "problems", true},
                                 {"controllers", Qt::BottomDockWidgetArea, "console", true},
                                 {"cameras", Qt::BottomDockWidgetArea, "controllers", false},
                                 {"radios", Qt::BottomDockWidgetArea, "cameras", false},
                                 {"sensors", Qt::BottomDockWidgetArea, "radios", false}};
const DockPlace kRunPlaces[] = {{"scene", Qt::LeftDockWidgetArea, "", true},
                                {"library", Qt::LeftDockWidgetArea, "scene", false},
                                {"properties", Qt::RightDockWidgetArea, "", true},
                                {"history", Qt::RightDockWidgetArea, "properties", false},
                                {"guide", Qt::RightDockWidgetArea, "properties", false},
                                {"console", Qt::BottomDockWidgetArea, "", true},
                                {"problems", Qt::BottomDockWidgetArea, "console", true},
                                {"controllers", Qt::BottomDockWidgetArea, "problems", true},
                                {"cameras", Qt::BottomDockWidgetArea, "controllers", true},
                                {"radios", Qt::BottomDockWidgetArea, "cameras", true},
                                {"sensors", Qt::BottomDockWidgetArea, "radios", true}};

/// The keyboard goes to the topmost part of a panel that takes it with Tab; what only scrolls does not count.
void focusInto(const QWidget& panel) {
    QWidget* first = nullptr;
    const auto place = [&panel](const QWidget* part) {
        const QPoint at = part->mapTo(&panel, QPoint(0, 0));
        return std::pair(at.y(), at.x());
    };
    for (QWidget* part : panel.findChildren<QWidget*>()) {
        const bool takes = part->isVisible() && part->isEnabled() && (part->focusPolicy() & Qt::TabFocus);
        if (takes && !qobject_cast<QScrollArea*>(part) && (!first || place(part) < place(first))) first = part;
    }
    if (first) first->setFocus(Qt::ShortcutFocusReason);
}

} // namespace

QString nameOf(Layout layout) { return layout == Layout::Edit ? QStringLiteral("Edit") : QStringLiteral("Run"); }

Layouts::Layouts(QMainWindow& window) : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Panels"), &window)) {
    m_menu->setEnabled(false);
    // Side docks extend to the bottom, so that the viewport is as high as possible.
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks |
                            QMainWindow::GroupedDragging); // GroupedDragging: also by the tab, since tabbed docks have no title
    m_window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    m_window.installEventFilter(this);
}

QDockWidget* Layouts::add(QWidget* panel, const QString& title) {
    auto* dock = new QDockWidget(title, &m_window);
    dock->setObjectName(QStringLiteral("dock.") + panel->objectName());
    dock->setWidget(panel);
    m_window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    dock->hide(); // until setShown()
    m_docks[panel->objectName()] = dock;
    dock->installEventFilter(this);
    for (const auto& moved : {&QDockWidget::visibilityChanged, &QDockWidget::topLevelChanged})
        connect(dock, moved, this, &Layouts::showTitles, Qt::QueuedConnection);
    connect(dock, &QDockWidget::dockLocationChanged, this, &Layouts::showTitles, Qt::QueuedConnection);
    QAction* action = dock->toggleViewAction();
    connect(action, &QAction::triggered, dock, [dock](bool shown) {
        if (shown) dock->raise();
    });
    m_menu->addAction(action);
    const QString name = panel->objectName();
    auto* show = new QAction(tr("Show %1").arg(title), this);
    show->setObjectName(QStringLiteral("show.") + name);
    show->setEnabled(name == kGuide);
    connect(show, &QAction::triggered, this, [this, name, panel] {
        raise(name);
        focusInto(*panel);
    });
    m_raising.append(show);
    return dock;
}

void Layouts::use(Layout layout) {
    save();
    m_layout = layout;
    if (m_shown) restore();
}

void Layouts::resetCurrent() {
    QSettings().remove(settingOf(m_layout));
    for (const auto& [area, side] : kSides) QSettings().remove(settingOf(m_layout) + QLatin1String(side));
    if (m_shown) arrange(m_layout);
}

void Layouts::save() const {
    if (!m_shown || !m_savesSettings) return;
    QSettings settings;
    settings.setValue(settingOf(m_layout), m_window.saveState(kVersion));
    for (const auto& [area, side] : kSides) settings.setValue(settingOf(m_layout) + QLatin1String(side), m_widths.value(area));
}

void Layouts::restore() {
    const QByteArray kept = QSettings().value(settingOf(m_layout)).toByteArray();
    const QSize size = m_window.size();
    const bool small = isSmall(m_window);
    const bool restored = !kept.isEmpty() && m_window.restoreState(kept, kVersion);
    // A layout saved on a larger screen widens the window while it is already visible.
    const bool fits = !small || std::max(m_window.minimumSizeHint().width(), m_window.width()) <= size.width();
    for (const auto& [area, side] : kSides) m_widths[area] = QSettings().value(settingOf(m_layout) + QLatin1String(side)).toInt();
    if (!restored || !fits) arrange(m_layout);
    else widenDocks();
    if (fits) return;
    m_window.layout()->activate(); // else the docks as they were kept hold the window wide
    m_window.resize(size);
}

void Layouts::setShown(bool shown) {
    if (shown == m_shown) return;
    if (!shown) save();
    m_shown = shown;
    m_menu->setEnabled(shown);
    for (QAction* action : m_raising) action->setEnabled(shown || action->objectName().endsWith(kGuide));
    const QDockWidget* guide = m_docks.value(kGuide);
    const bool reading = guide && !guide->isHidden();
    if (shown) restore();
    else
        for (QDockWidget* dock : m_docks) dock->hide();
    if (reading && shown) raise(kGuide); // the user may be following instructions opened on the Welcome page
}

void Layouts::raise(const QString& name) {
    QDockWidget* dock = m_docks.value(name);
    if (!dock || (!m_shown && name != kGuide)) return;
    if (!m_shown) {
        m_window.addDockWidget(Qt::RightDockWidgetArea, dock);
        m_window.resizeDocks({dock}, {m_window.width() * 3 / 10}, Qt::Horizontal);
    }
    dock->show();
    dock->raise();
}

bool Layouts::isInFront(const QString& name) const {
    const QDockWidget* dock = m_docks.value(name);
    return dock && dock->isVisible() && !dock->visibleRegion().isEmpty();
}

QString Layouts::raiseOver(const QString& name) {
    QStringList before = m_docks.keys();
    before.removeIf([this](const QString& other) { return !isInFront(other); });
    raise(name);
    const QList<QDockWidget*> tabs = m_window.tabifiedDockWidgets(m_docks.value(name)); // of a hidden one Qt has none
    for (const QString& other : before)
        if (other == name || tabs.contains(m_docks.value(other))) return other;
    return {};
}

void Layouts::arrange(Layout layout) {
    for (QDockWidget* dock : m_docks) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
    }
    const bool small = isSmall(m_window); // all docks in one column of tabs
    for (const DockPlace& place :
         layout == Layout::Edit ? std::span<const DockPlace>(kEditPlaces) : std::span<const DockPlace>(kRunPlaces)) {
        QDockWidget* dock = m_docks.value(QLatin1String(place.name));
        if (!dock) continue;
        const bool aside = small && place.area != Qt::BottomDockWidgetArea;
        QString tabWith = QLatin1String(place.tabWith);
        if (aside && tabWith.isEmpty()) tabWith = QStringLiteral("scene");
        m_window.addDockWidget(aside ? Qt::LeftDockWidgetArea : place.area, dock);
        if (QDockWidget* other = m_docks.value(tabWith); other && other != dock) m_window.tabifyDockWidget(other, dock);
        dock->setVisible(place.shown);
    }
    showTitles();
    for (const char* front :
         {small ? "properties" : "scene", small ? "scene" : "properties", layout == Layout::Edit ? "problems" : "console"})
        if (QDockWidget* dock = m_docks.value(QLatin1String(front))) dock->raise();
    sizeDocks();
    // Repeated after the layout: a dock that was hidden ignores its size before that.
    QMetaObject::invokeMethod(this, &Layouts::sizeDocks, Qt::QueuedConnection);
}

/// Hides the title of tabbed docks, since the tab shows it.
void Layouts::showTitles() {
    for (QDockWidget* dock : m_docks) {
        const QList<QDockWidget*> others = m_window.tabifiedDockWidgets(dock);
        const auto isBeside = [](const QDockWidget* other) { return !other->isHidden() && !other->isFloating(); };
        const bool tabbed = !dock->isFloating() && std::any_of(others.begin(), others.end(), isBeside);
        QWidget* const before = dock->titleBarWidget();
        if (tabbed == (before != nullptr)) continue;
        dock->setTitleBarWidget(tabbed ? new QWidget(dock) : nullptr);
        delete before;
    }
}

/// A smaller window narrows the docks; Qt does not widen them with it again.
bool Layouts::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && m_shown) {
        if (watched == &m_window) widenDocks();
        else if (QApplication::mouseButtons() != Qt::NoButton) recordWidths(); // its edge is dragged
    }
    return QObject::eventFilter(watched, event);
}

QDockWidget* Layouts::widestIn(Qt::DockWidgetArea area) const {
    QDockWidget* widest = nullptr;
    for (auto it = m_docks.begin(); it != m_docks.end(); ++it) {
        QDockWidget* dock = it.value();
        if (dock->isFloating() || m_window.dockWidgetArea(dock) != area || !isInFront(it.key())) continue;
        if (!widest || dock->width() > widest->width()) widest = dock;
    }
    return widest;
}

void Layouts::recordWidths() {
    for (const auto& [area, side] : kSides)
        if (const QDockWidget* dock = widestIn(area)) m_widths[area] = dock->width();
}

void Layouts::widenDocks() {
    if (isSmall(m_window)) return;
    QList<QDockWidget*> narrow;
    QList<int> widths;
    for (const auto& [area, side] : kSides)
        if (QDockWidget* dock = widestIn(area); dock && dock->width() < m_widths.value(area)) {
            narrow += dock;
            widths += m_widths.value(area);
        }
    if (!narrow.empty()) m_window.resizeDocks(narrow, widths, Qt::Horizontal);
}

void Layouts::sizeDocks() {
    const auto dock = [this](const char* name) { return m_docks.value(QLatin1String(name)); };
    const bool edit = m_layout == Layout::Edit;
    const int width = m_window.width();
    if (isSmall(m_window)) {
        m_window.resizeDocks({dock("scene")}, {300}, Qt::Horizontal);
        return m_window.resizeDocks({dock(edit ? "problems" : "console")}, {120}, Qt::Vertical);
    }
    m_widths = {{Qt::LeftDockWidgetArea, std::clamp(width * 18 / 100, 190, 280)},
                {Qt::RightDockWidgetArea, std::clamp(width * 22 / 100, 300, 340)}};
    m_window.resizeDocks({dock("scene"), dock("properties")}, m_widths.values(), Qt::Horizontal);
    if (edit) m_window.resizeDocks({dock("scene"), dock("library")}, {430, 300}, Qt::Vertical);
    m_window.resizeDocks({dock(edit ? "problems" : "console")}, {edit ? 170 : 230}, Qt::Vertical);
}

} // namespace trundle
