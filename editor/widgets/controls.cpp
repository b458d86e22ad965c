#include "editor/widgets/controls.h"

#include <QEvent>
#include <QFontMetrics>
#include <QHeaderView>
#include <QScreen>
#include <QToolButton>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

/// Adapts the row height of a table to its font.
class RowHeights final : public QObject {
public:
    explicit RowHeights(QTableView& table) : QObject(&table) {
        table.installEventFilter(this);
        fit(table);
    }

private:
    static void fit(QTableView& table) { table.verticalHeader()->setDefaultSectionSize(QFontMetrics(table.font()).height() + 4); }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::FontChange) fit(*static_cast<QTableView*>(watched));
        return false;
    }
};

} // namespace

QTableView* makeLineTable(const char* name, QAbstractItemModel* model, LineFont font, QWidget* parent) {
    auto* table = new QTableView(parent);
    table->setObjectName(QLatin1String(name));
    table->setModel(model);
    if (font == LineFont::Monospace) useMonospaceFont(*table);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    new RowHeights(*table);
    table->horizontalHeader()->setStretchLastSection(true);
    table->horizontalHeader()->setHighlightSections(false);
    return table;
}

QComboBox* makeNarrowChoice(const char* name, const QString& tip, int characters, QWidget* parent) {
    auto* made = new QComboBox(parent);
    made->setObjectName(QLatin1String(name));
    made->setAccessibleName(tip);
    made->setToolTip(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(characters);
    made->setMaxVisibleItems(24);
    return made;
}

void showTextBesideIcon(QToolButton& button, int size) {
    constexpr int kMargin = 3; // on both sides of the icon, which is drawn in the middle
    button.setIconSize({size + 2 * kMargin, size});
    button.setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
}

void resizeToFont(QWidget& dialog, const QSize& atDefault) {
    const QSize room =
        dialog.screen()->availableSize() - QSize(scaledToFont(24), scaledToFont(48)); // with the frame of the window
    dialog.resize(QSize(scaledToFont(atDefault.width()), scaledToFont(atDefault.height())).boundedTo(room));
}

} // namespace trundle
