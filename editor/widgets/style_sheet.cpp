#include "editor/widgets/style_sheet.h"

#include "editor/widgets/resources.h"

namespace trundle {

// Flat surfaces, hairlines between areas, one accent colour. Sizes are in logical pixels; Qt scales them. Icons named colour-*
// have a fixed colour that is visible in both themes, since a style sheet cannot colour them.
static const char* const kSheet =
    "QToolTip { background: @base; color: @text; border: 1px solid @line; padding: 4px 6px; }"
    "QMainWindow::separator { background: @line; width: 1px; height: 1px; }"
    "QMainWindow::separator:hover { background: @accent; }"
    "QMenuBar { background: @window; padding: 2px 4px; border-bottom: 1px solid @line; }"
    "QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }"
    "QMenuBar::item:selected { background: @line; }"
    "QMenu { background: @base; border: 1px solid @line; padding: 4px; }"
    "QMenu::item { padding: 5px 26px 5px 12px; border-radius: 4px; }"
    "QMenu::icon { padding-left: 8px; }"
    "QMenu::icon:checked { background: @checked; border: 1px solid @accent; border-radius: 4px; }"
    "QMenu::indicator { width: 14px; height: 14px; left: 7px; }"
    "QMenu::indicator:checked { image: url(\"@icons/colour-check.svg\"); }"
    "QMenu::indicator:checked:selected { image: url(\"@icons/colour-check-on.svg\"); }"
    "QMenu::item:selected { background: @accent; color: @onaccent; }"
    "QMenu::item:disabled { color: @disabled; background: transparent; }"
    "QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }"
    "QToolBar { background: @window; border: none; border-bottom: 1px solid @line; padding: 3px 6px; spacing: 2px; }"
    "QToolBar#viewBar { padding: 0 4px; margin: 0; }"
    "QToolBar#viewBar QToolButton { padding-top: 1px; padding-bottom: 1px; }"
    "QToolBar QToolButton#qt_toolbar_ext_button { border: none; padding: 0; image: url(\"@icons/colour-more.svg\"); "
    "qproperty-iconSize: 0px; }"
    "QToolBar::separator { background: @line; width: 1px; margin: 4px 6px; }"
    "QToolButton { border: 1px solid transparent; border-radius: 5px; padding: 3px 5px; }"
    "QToolButton:hover { background: @line; }"
    "QToolButton:checked { background: @checked; border-color: @accent; }"
    "QToolButton:pressed { background: @line; }"
    "QToolButton:focus { border-color: @accent; }"
    "QToolButton[popupMode=\"1\"], QToolButton[popupMode=\"2\"] { padding-right: 18px; }"
    "QToolButton::menu-button { border: none; width: 18px; }"
    "QToolButton::menu-arrow, QToolButton::menu-indicator { image: url(\"@icons/colour-chevron-down.svg\"); width: 10px; "
    "height: 10px; }"
    "QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: right center; right: 4px; }"
    "QDockWidget { titlebar-close-icon: url(\"@icons/colour-close.svg\"); titlebar-normal-icon: "
    "url(\"@icons/colour-float.svg\"); }"
    "QDockWidget::title { background: @window; padding: 5px 8px; }"
    "QDockWidget::close-button, QDockWidget::float-button { border: none; padding: 0; width: 18px; subcontrol-origin: margin; "
    "subcontrol-position: right center; }"
    "QDockWidget::close-button { right: 4px; }"
    "QDockWidget::float-button { right: 24px; }"
    "QStatusBar { background: @window; border-top: 1px solid @line; }"
    "QStatusBar::item { border: none; }"
    "QTabBar { qproperty-drawBase: 0; }"
    "QTabBar::tab { padding: 5px 12px; border: none; border-bottom: 2px solid transparent; color: @faint; }"
    "QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }"
    "QTabBar::tab:hover { color: @text; }"
    "QTabWidget::pane { border: none; }"
    "QTreeView, QListView, QTableView, QPlainTextEdit, QTextBrowser, QScrollArea { border: none; }"
    "QTreeView::item { padding: 2px 0; }"
    "QListView::item { padding: 4px 0; }"
    "QTableView::item { border: none; padding: 0 6px; }"
    "QListView#historyList { background: @base; padding: 4px 6px; }"
    "QHeaderView::section { background: @window; border: none; border-bottom: 1px solid @line; padding: 4px 3px; color: @faint; }"
    "QTableView QHeaderView::section { padding: 4px 9px; }" // an item's text starts 3 px after its padding
    "QLineEdit, QComboBox, QAbstractSpinBox { background: @base; border: 1px solid @line; border-radius: 4px; padding: 2px 5px; "
    "min-height: 18px; selection-background-color: @accent; }"
    "QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus { border-color: @accent; }"
    "QLineEdit:disabled, QComboBox:disabled { color: @disabled; }"
    "QComboBox QAbstractItemView { color: @text; selection-color: @onaccent; }" // also while the combo box itself is faint
    "QComboBox::drop-down { border: none; width: 20px; }"
    "QComboBox::down-arrow { image: url(\"@icons/colour-chevron-down.svg\"); width: 12px; height: 12px; }"
    "QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { border: none; width: 16px; }"
    "QAbstractSpinBox::up-arrow { image: url(\"@icons/colour-chevron-up.svg\"); width: 10px; height: 10px; }"
    "QAbstractSpinBox::down-arrow { image: url(\"@icons/colour-chevron-down.svg\"); width: 10px; height: 10px; }"
    "QCheckBox { spacing: 6px; }"
    "QCheckBox::indicator { background: @base; border: 1px solid @faint; border-radius: 3px; width: 13px; height: 13px; }"
    "QCheckBox::indicator:hover, QCheckBox::indicator:checked { border-color: @accent; }"
    "QCheckBox::indicator:checked { background: @checked; image: url(\"@icons/colour-check.svg\"); }"
    "QCheckBox::indicator:indeterminate { image: url(\"@icons/colour-dash.svg\"); }"
    "QCheckBox::indicator:focus { border: 2px solid @accent; width: 11px; height: 11px; }"
    "QCheckBox::indicator:disabled { border-color: @line; }"
    "QPushButton { background: @button; border: 1px solid @line; border-radius: 5px; padding: 4px 12px; }"
    "QPushButton:hover { border-color: @accent; }"
    "QPushButton:default { border-color: @accent; }"
    "QPushButton:focus { border: 2px solid @accent; padding: 3px 11px; outline: none; }"
    "QPushButton:pressed { background: @line; }"
    "QPushButton:disabled { color: @disabled; }"
    "QProgressBar { background: @base; color: @text; border: 1px solid @line; border-radius: 5px; text-align: center; "
    "min-height: 20px; }"
    "QProgressBar::chunk { background: @chunk; border-radius: 4px; }" // pale, so that the text above it is readable
    "QDialogButtonBox, QMessageBox { dialogbuttonbox-buttons-have-icons: 0; }"
    "QScrollBar:vertical { background: transparent; width: 11px; margin: 0; }"
    "QScrollBar:horizontal { background: transparent; height: 11px; margin: 0; }"
    "QScrollBar::handle { background: @disabled; border-radius: 4px; min-height: 24px; min-width: 24px; margin: 2px; }"
    "QScrollBar::handle:hover { background: @faint; }"
    "QScrollBar::handle:disabled { background: transparent; }"
    "QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }"
    "QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }"
    "QSplitter::handle { background: @line; }"
    "QSplitter::handle:horizontal { width: 1px; }"
    "QSplitter::handle:vertical { height: 1px; }";

QString styleSheet(const QMap<QString, QColor>& colours) {
    QString sheet = QLatin1String(kSheet);
    const QColor accent = colours.value(QStringLiteral("accent")), window = colours.value(QStringLiteral("window"));
    const auto mixed = [](const QColor& a, const QColor& b, double share) {
        return QColor::fromRgbF(float(a.redF() * share + b.redF() * (1 - share)),
                                float(a.greenF() * share + b.greenF() * (1 - share)),
                                float(a.blueF() * share + b.blueF() * (1 - share)));
    };
    sheet.replace(QStringLiteral("@checked"), mixed(accent, window, 0.22).name());
    sheet.replace(QStringLiteral("@chunk"), mixed(accent, colours.value(QStringLiteral("base")), 0.4).name());
    sheet.replace(QStringLiteral("@onaccent"), window.lightnessF() > 0.5 ? QStringLiteral("#ffffff") : QStringLiteral("#0d1117"));
    sheet.replace(QStringLiteral("@icons"), resourcePath(QStringLiteral("icons")));
    for (auto it = colours.begin(); it != colours.end(); ++it) sheet.replace(QLatin1Char('@') + it.key(), it.value().name());
    return sheet;
}

} // namespace trundle
