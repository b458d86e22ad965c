#include "editor/widgets/widget_text.h"

#include <memory>

#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMetaEnum>
#include <QMetaProperty>
#include <QPainter>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTableView>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

namespace trundle {
namespace {

const QString kKept = QStringLiteral(TRUNDLE_SOURCE_DIR "/tests/data/window/");

/// Places and sizes, fonts, colours of the theme, what other properties say too, and what depends on the machine.
const QSet<QByteArray> kLeftOut{"acceptDrops",
                                "activePage",
                                "baseSize",
                                "childrenRect",
                                "cursor",
                                "cursorPosition",
                                "decimals",
                                "font",
                                "focus",
                                "frameGeometry",
                                "frameRect",
                                "frameSize",
                                "fullScreen",
                                "geometry",
                                "hasSelectedText",
                                "height",
                                "html",
                                "icon",
                                "inputMethodHints",
                                "isActiveWindow",
                                "layoutDirection",
                                "lineWidth",
                                "locale",
                                "mask",
                                "markdown",
                                "maximized",
                                "maximumHeight",
                                "maximumSize",
                                "maximumWidth",
                                "midLineWidth",
                                "minimized",
                                "minimumHeight",
                                "minimumSize",
                                "minimumSizeHint",
                                "minimumWidth",
                                "modal",
                                "normalGeometry",
                                "objectName",
                                "palette",
                                "pos",
                                "rect",
                                "scaledContents",
                                "selectedText",
                                "selectionStart",
                                "size",
                                "sizeHint",
                                "sizeIncrement",
                                "source",
                                "statusTip",
                                "styleSheet",
                                "toPlainText",
                                "totalHeight",
                                "updatesEnabled",
                                "visible",
                                "visualNavigation",
                                "whatsThis",
                                "width",
                                "windowFilePath",
                                "windowFlags",
                                "windowIcon",
                                "windowIconText",
                                "windowModality",
                                "windowModified",
                                "windowOpacity",
                                "x",
                                "y",
                                "cleanText",
                                "displayText",
                                "dateTime",
                                "sizePolicy",
                                "iconSize",
                                "autoFillBackground",
                                "undoAvailable",
                                "redoAvailable",
                                "documentTitle",
                                "blockCount",
                                "currentColor",
                                "tearOffEnabled",
                                "sliderPosition",
                                "shortcut",
                                "frameStyle",
                                "toolTipDuration",
                                "inputMask",
                                "formats",
                                "down",
                                "tabletTracking",
                                "mouseTracking"};

template <class W> const QWidget* plain() {
    static const W* const widget = new W; // never shown; lives as long as the program
    return widget;
}

/// A widget of the same Qt class as it is made, whose properties are not repeated.
const QWidget* plainOf(const QWidget& w) {
    const struct {
        const char* name;
        const QWidget* (*widget)();
    } known[] = {{"QTextBrowser", plain<QTextBrowser>},
                 {"QPlainTextEdit", plain<QPlainTextEdit>},
                 {"QCheckBox", plain<QCheckBox>},
                 {"QToolButton", plain<QToolButton>},
                 {"QPushButton", plain<QPushButton>},
                 {"QComboBox", plain<QComboBox>},
                 {"QDoubleSpinBox", plain<QDoubleSpinBox>},
                 {"QSpinBox", plain<QSpinBox>},
                 {"QLineEdit", plain<QLineEdit>},
                 {"QLabel", plain<QLabel>},
                 {"QSlider", plain<QSlider>},
                 {"QProgressBar", plain<QProgressBar>},
                 {"QTabBar", plain<QTabBar>},
                 {"QTableView", plain<QTableView>},
                 {"QTreeView", plain<QTreeView>},
                 {"QListView", plain<QListView>},
                 {"QToolBar", plain<QToolBar>},
                 {"QDockWidget", plain<QDockWidget>},
                 {"QFrame", plain<QFrame>}};
    for (const auto& one : known)
        if (w.inherits(one.name)) return one.widget();
    return plain<QWidget>();
}

QString quoted(QString text) { return u'"' + text.replace(u'\n', QStringLiteral("\\n")) + u'"'; }

QString valueText(const QMetaProperty& property, const QVariant& value) {
    if (property.isFlagType()) return QString::fromLatin1(property.enumerator().valueToKeys(value.toInt()));
    if (property.isEnumType()) return QString::fromLatin1(property.enumerator().valueToKey(value.toInt()));
    if (value.typeId() == QMetaType::QString) return quoted(value.toString());
    return value.toString();
}

/// How an icon looks: how much it covers, and its mean colour in steps.
QString iconText(const QIcon& icon) {
    if (icon.isNull()) return {};
    constexpr int kSide = 16;
    QImage image(kSide, kSide, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    icon.paint(&painter, image.rect());
    painter.end();
    int covered = 0, red = 0, green = 0, blue = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const QRgb pixel = image.pixel(i % kSide, i / kSide);
        covered += qAlpha(pixel);
        red += qRed(pixel) * qAlpha(pixel);
        green += qGreen(pixel) * qAlpha(pixel);
        blue += qBlue(pixel) * qAlpha(pixel);
    }
    if (covered == 0) return QStringLiteral("empty icon");
    const auto step = [&](int sum) { return QString::number((sum / covered + 16) / 32, 16); };
    return QStringLiteral("icon #%1%2%3 of %4").arg(step(red), step(green), step(blue)).arg((covered / 255 + 4) / 8);
}

QStringList actionTexts(const QList<QAction*>& actions, const QString& indent) {
    QStringList lines;
    for (const QAction* action : actions) {
        if (!action->isVisible()) continue;
        if (action->isSeparator()) {
            lines << indent + QStringLiteral("---");
            continue;
        }
        QString line = indent + quoted(action->text());
        if (!action->shortcut().isEmpty()) line += u' ' + action->shortcut().toString(QKeySequence::PortableText);
        if (!action->isEnabled()) line += QStringLiteral(" disabled");
        if (action->isCheckable()) line += action->isChecked() ? QStringLiteral(" checked") : QStringLiteral(" not checked");
        if (!action->icon().isNull()) line += u' ' + iconText(action->icon());
        if (action->menu() && action->menu()->toolTipsVisible()) line += QStringLiteral(" with tips");
        lines << line + u' ' + quoted(action->toolTip());
        if (action->menu()) Q_EMIT action->menu()->aboutToShow(); // some are filled then
        if (action->menu()) lines << actionTexts(action->menu()->actions(), indent + QStringLiteral("  "));
    }
    return lines;
}

QString itemText(const QModelIndex& index) {
    QStringList words{index.data().toString().isEmpty() ? QStringLiteral("-") : quoted(index.data().toString())};
    const auto add = [&](int role, const char* name) {
        if (const QVariant value = index.data(role); value.isValid() && !value.toString().isEmpty() && value != index.data())
            words << QLatin1String(name) + QLatin1Char('=') + quoted(value.toString());
    };
    add(Qt::EditRole, "edit");
    add(Qt::ToolTipRole, "tip");
    add(Qt::AccessibleTextRole, "read");
    add(Qt::CheckStateRole, "check");
    add(Qt::TextAlignmentRole, "align");
    if (const QVariant ink = index.data(Qt::ForegroundRole); ink.isValid())
        words << QStringLiteral("ink=") + ink.value<QBrush>().color().name();
    if (const QVariant back = index.data(Qt::BackgroundRole); back.isValid())
        words << QStringLiteral("back=") + back.value<QBrush>().color().name();
    if (const QVariant font = index.data(Qt::FontRole); font.isValid()) {
        const auto f = font.value<QFont>();
        words << QStringLiteral("font=") + (f.bold() ? QStringLiteral("bold ") : QString()) +
                     (f.italic() ? QStringLiteral("italic ") : QString()) +
                     (f.strikeOut() ? QStringLiteral("struck") : QString());
    }
    if (const QVariant icon = index.data(Qt::DecorationRole); icon.canConvert<QIcon>()) words << iconText(icon.value<QIcon>());
    QString flags;
    const auto flag = [&](Qt::ItemFlag which, char letter) { flags += QLatin1Char(index.flags() & which ? letter : '.'); };
    flag(Qt::ItemIsEnabled, 'n');
    flag(Qt::ItemIsSelectable, 's');
    flag(Qt::ItemIsEditable, 'e');
    flag(Qt::ItemIsUserCheckable, 'c');
    flag(Qt::ItemIsDragEnabled, 'd');
    flag(Qt::ItemIsDropEnabled, 'D');
    return words.join(u' ') + u' ' + flags;
}

void addItems(const QAbstractItemView& view, const QModelIndex& parent, const QString& indent, QStringList& lines) {
    constexpr int kMost = 60; // rows of one parent
    const QAbstractItemModel& model = *view.model();
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    const auto* table = qobject_cast<const QTableView*>(&view);
    for (int row = 0; row < std::min(model.rowCount(parent), kMost); ++row) {
        if ((tree && tree->isRowHidden(row, parent)) || (table && table->isRowHidden(row))) continue;
        QStringList cells;
        for (int column = 0; column < model.columnCount(parent); ++column) {
            if ((tree && tree->isColumnHidden(column)) || (table && table->isColumnHidden(column))) continue;
            const QModelIndex index = model.index(row, column, parent);
            const bool selected = view.selectionModel() && view.selectionModel()->isSelected(index);
            cells << (selected ? QStringLiteral("*") : QString()) + itemText(index);
        }
        const QModelIndex first = model.index(row, 0, parent);
        const bool open = !tree || tree->isExpanded(first);
        lines << indent + QStringLiteral("- ") + cells.join(QStringLiteral(" | ")) +
                     (tree && model.rowCount(first) > 0 && !open ? QStringLiteral(" closed") : QString());
        if (tree && open) addItems(view, first, indent + QStringLiteral("  "), lines);
    }
}

void addHeader(const QAbstractItemView& view, const QString& indent, QStringList& lines) {
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    const auto* table = qobject_cast<const QTableView*>(&view);
    const QHeaderView* header = tree ? tree->header() : table ? table->horizontalHeader() : nullptr;
    if (!header || header->isHidden()) return;
    QStringList columns;
    for (int i = 0; i < header->count(); ++i)
        if (!header->isSectionHidden(i)) columns << quoted(view.model()->headerData(i, Qt::Horizontal).toString());
    lines << indent + QStringLiteral("columns ") + columns.join(QStringLiteral(" | "));
}

/// Its name, texts and the properties that differ from those of a plain widget.
QString lineOf(const QWidget& w) {
    const QWidget* usual = plainOf(w);
    QStringList words{QString::fromLatin1(w.metaObject()->className()).remove(QStringLiteral("trundle::"))};
    if (!w.objectName().isEmpty() && !w.objectName().startsWith(QStringLiteral("qt_"))) words << w.objectName();
    const QMetaObject& meta = *w.metaObject();
    for (int i = 0; i < meta.propertyCount(); ++i) {
        const QMetaProperty property = meta.property(i);
        if (!property.isReadable() || kLeftOut.contains(property.name())) continue;
        const QVariant value = property.read(&w);
        const QVariant other = usual->property(property.name());
        if (!value.isValid() || value == other || (!other.isValid() && value.toString().isEmpty())) continue;
        const QString text = valueText(property, value);
        if (!text.isEmpty()) words << QLatin1String(property.name()) + QLatin1Char('=') + text;
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&w); button && !button->icon().isNull())
        words << iconText(button->icon());
    if (const auto* label = qobject_cast<const QLabel*>(&w); label && !label->pixmap(Qt::ReturnByValue).isNull())
        words << iconText(QIcon(label->pixmap(Qt::ReturnByValue)));
    if (const auto* choice = qobject_cast<const QComboBox*>(&w)) {
        QStringList items;
        for (int n = 0; n < choice->count(); ++n) items << quoted(choice->itemText(n));
        words << QStringLiteral("items=") + items.join(u',');
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(&w))
        for (int n = 0; n < tabs->count(); ++n) words << quoted(tabs->tabText(n)) + u'(' + quoted(tabs->tabToolTip(n)) + u')';
    return words.join(u' ');
}

void add(const QWidget& w, const QString& indent, QStringList& lines) {
    lines << indent + lineOf(w);
    const QString inner = indent + QStringLiteral("  ");
    if (const auto* button = qobject_cast<const QToolButton*>(&w); button && button->menu()) {
        Q_EMIT button->menu()->aboutToShow();
        lines << actionTexts(button->menu()->actions(), inner);
    }
    if (const auto* bar = qobject_cast<const QMenuBar*>(&w)) lines << actionTexts(bar->actions(), inner);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&w);
        view && view->model() && !qobject_cast<const QHeaderView*>(&w)) {
        addHeader(*view, inner, lines);
        addItems(*view, {}, inner, lines);
        return; // what it draws is in its items
    }
    if (w.inherits("QAbstractScrollArea") && !w.inherits("QScrollArea")) return;
    if (w.inherits("QComboBox") || w.inherits("QAbstractSpinBox") || w.inherits("QMenuBar") || w.inherits("QScrollBar")) return;
    for (const QObject* child : w.children())
        if (const auto* widget = qobject_cast<const QWidget*>(child);
            widget && !widget->isWindow() && widget->isVisibleTo(&w) && !widget->inherits("QScrollBar"))
            add(*widget, inner, lines);
}

} // namespace

QString describedWidget(const QWidget& root) {
    QStringList lines;
    add(root, {}, lines);
    return lines.join(u'\n') + u'\n';
}

QString differenceFromKept(const QString& name, QString description, const QString& masked, Numbers numbers) {
    if (!masked.isEmpty()) {
        description.replace(masked, QStringLiteral("FOLDER"));
        description.replace(masked.section(u'/', -1), QStringLiteral("FOLDER"));
    }
    static const QRegularExpression moment(QStringLiteral("[0-9]{1,2} [A-Z][a-z]{2} [0-9]{4} [0-9]{2}:[0-9]{2}:[0-9]{2}"));
    description.replace(moment, QStringLiteral("MOMENT"));
    static const QRegularExpression hash(QStringLiteral("projects/[0-9a-f]{16}"));
    description.replace(hash, QStringLiteral("projects/HASH"));
    static const QRegularExpression holder(QStringLiteral("process [0-9]+ on [^,]+, since [0-9:]+"));
    description.replace(holder, QStringLiteral("process NUMBER on HOST, since MOMENT"));
    description.replace(QStringLiteral(TRUNDLE_BINARY_DIR), QStringLiteral("BUILD"));
    description.replace(QStringLiteral(TRUNDLE_SOURCE_DIR), QStringLiteral("SOURCE"));
    static const QRegularExpression number(QStringLiteral("-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?"));
    if (numbers == Numbers::Hidden) description.replace(number, QStringLiteral("#"));
    QFile file(kKept + name + QStringLiteral(".txt"));
    if (qEnvironmentVariableIsSet("TRUNDLE_WRITE_WINDOW_TEXTS")) {
        QDir().mkpath(kKept);
        return file.open(QIODevice::WriteOnly) && file.write(description.toUtf8()) >= 0 ? QString() : file.errorString();
    }
    if (!file.open(QIODevice::ReadOnly)) return QStringLiteral("there is no %1").arg(file.fileName());
    const QStringList kept = QString::fromUtf8(file.readAll()).split(u'\n'), now = description.split(u'\n');
    for (qsizetype i = 0; i < std::max(kept.size(), now.size()); ++i)
        if (kept.value(i) != now.value(i))
            return QStringLiteral("%1.txt, line %2\n  kept: %3\n  now:  %4")
                .arg(name)
                .arg(i + 1)
                .arg(kept.value(i), now.value(i));
    return {};
}

} // namespace trundle
