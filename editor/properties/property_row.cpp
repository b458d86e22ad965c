#include "editor/properties/property_row.h"
#include "editor/properties/editors/editor_for_kind.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QMenu>

#include "editor/properties/editors/row_editor.h"
#include "editor/properties/editors/scrub_label.h"
#include "editor/properties/editors/value_field.h"
#include "editor/properties/origin_mark.h"
#include "editor/properties/origin_text.h"
#include "editor/properties/param_help.h"
#include "editor/properties/rows.h"
#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

/// A path that does not fit into `room` pixels in two lines, that of the object above the key; what is still too long is
/// shortened in the middle, so that it can be seen which object it is.
QString pathHtml(const QString& path, const QFontMetrics& metrics, int room) {
    if (metrics.horizontalAdvance(path) <= room) return path.toHtmlEscaped();
    const qsizetype dot = path.lastIndexOf(QLatin1Char('.'));
    const auto shortened = [&](const QString& text) { return metrics.elidedText(text, Qt::ElideMiddle, room).toHtmlEscaped(); };
    return shortened(path.left(dot)) + QStringLiteral("<br>") + shortened(path.mid(dot + 1));
}

/// The label elided to `room` pixels, followed by the unit if the row has several fields.
QString labelHtml(const Row& row, const QFontMetrics& metrics, int room) {
    const Property* p = row.property();
    const bool unit = p && row.fieldCount() > 1 && !p->unit.empty();
    if (!unit && room > 0 && row.label.contains(QLatin1Char('.'))) return pathHtml(row.label, metrics, room);
    if (!unit) return (room > 0 ? metrics.elidedText(row.label, Qt::ElideRight, room) : row.label).toHtmlEscaped();
    return QStringLiteral("%1 <span style='color:%2'>%3</span>")
        .arg(row.label.toHtmlEscaped(), ink(Ink::Faint).name(), QString::fromStdString(p->unit).toHtmlEscaped());
}

} // namespace

PropertyRow::PropertyRow(const Row& row, EditorKind kind, QWidget* parent)
    : QWidget(parent), m_row(row), m_label(new ScrubLabel(this)), m_editor(makeEditor(kind, this)), m_mark(new OriginMark(this)),
      m_now(new QLabel(this)), m_note(new QLabel(this)), m_override(new QLabel(this)) {
    setObjectName(QStringLiteral("row.") + QString::fromStdString(row.id));
    layOut();
    connectParts();
    display(row);
    watch(m_editor);
}

void PropertyRow::layOut() {
    setSizePolicy(QSizePolicy::Preferred,
                  QSizePolicy::Minimum); // in a low panel the rows scroll instead of shrinking; notes wrap
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 1, 2, 1);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_label, 0, 0, 4, 1, Qt::AlignTop); // its second line is beside what is below the editor
    grid->addWidget(m_editor, 0, 1);
    grid->addWidget(m_mark, 0, 2, Qt::AlignTop);
    grid->addWidget(m_now, 1, 0, 1, 2);
    grid->addWidget(m_note, 2, 1, 1, 2);
    grid->addWidget(m_override, 3, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    m_label->setObjectName(QStringLiteral("label"));
    m_label->setTextFormat(Qt::RichText);
    m_label->setContentsMargins(0, 5, 0, 0);
    m_mark->setObjectName(QStringLiteral("mark"));
    m_now->setObjectName(QStringLiteral("now"));
    m_now->setTextFormat(Qt::PlainText);
    useFont(*m_now, [] { return figuresFont(); });
    m_now->setAlignment(Qt::AlignRight);
    m_now->setForegroundRole(QPalette::PlaceholderText);
    m_now->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // never wider than the row
    m_note->setObjectName(QStringLiteral("note"));
    m_note->setWordWrap(true); // never wider than the row
    m_override->setObjectName(QStringLiteral("override"));
    m_override->setWordWrap(true);
    m_override->setTextFormat(Qt::RichText);
}

void PropertyRow::connectParts() {
    connect(m_override, &QLabel::linkActivated, this, [this](const QString& link) {
        Q_EMIT entered();
        if (link == QLatin1String("reset")) Q_EMIT resetRequested();
        else Q_EMIT pushRequested();
    });
    connect(m_label, &ScrubLabel::dragged, this, [this](double steps) { m_editor->scrub(steps); });
    connect(m_label, &ScrubLabel::ended, m_editor, &RowEditor::scrubEnded);
    connect(m_label, &ScrubLabel::cancelled, this, [this] {
        Q_EMIT m_editor->scrubCancelled();
        Q_EMIT m_editor->scrubEnded();
    });
    connect(m_label, &ScrubLabel::clicked, this, [this] {
        if (QWidget* field = m_editor->focusField()) field->setFocus(Qt::MouseFocusReason);
    });
    connect(m_editor, &RowEditor::scrubEnded, this, &PropertyRow::scrubEnded);
    connect(m_editor, &RowEditor::scrubCancelled, this, &PropertyRow::scrubCancelled);
    connect(m_editor, &RowEditor::refusedChanged, this, [this](const QString& reason) {
        m_refusal = reason;
        Q_EMIT refusedChanged();
    });
    connect(m_mark, &QToolButton::clicked, this, [this] {
        Q_EMIT entered();
        Q_EMIT menuRequested(m_mark->mapToGlobal(QPoint(0, m_mark->height())), nullptr);
    });
}

void PropertyRow::watch(QWidget* widget) {
    widget->installEventFilter(this);
    for (QWidget* child : widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) watch(child);
}

void PropertyRow::display(const Row& row) {
    m_row = row;
    m_problem = problemInText();
    m_editor->display(row);
    showLabel();
    setNow(row.now ? row.now() : QString());
    showNote();
    showOverride();
    const FieldValue& v = row.first();
    ValueOrigin strongest = v.origin;
    for (const FieldValue& other : row.values)
        if (other.origin == ValueOrigin::Override) strongest = ValueOrigin::Override;
    m_mark->display(strongest, v.formula && !row.mixed(), row.afterReset);
    const QString place = v.given() ? placeWords(*row.loaded, v.place) : QString();
    const QString waits =
        row.afterReset ? tr("Takes effect after a reset") : QString(); // a tooltip: a line below would move the rows
    QStringList tip{waits, originWords(v), place};
    tip.removeAll(QString());
    m_mark->setToolTip(tip.join(QLatin1Char('\n')));
    m_mark->setAccessibleName(tr("%1: %2").arg(row.label, waits.isEmpty() ? originWords(v) : waits));
}

void PropertyRow::showLabel() {
    const FieldValue& v = m_row.first();
    const bool override = std::any_of(m_row.values.begin(), m_row.values.end(),
                                      [](const FieldValue& value) { return value.origin == ValueOrigin::Override; });
    QFont font = this->font();
    if (override) font.setWeight(QFont::DemiBold);
    const QString html = labelHtml(m_row, QFontMetrics(font), m_labelWidth);
    m_label->setText(QStringLiteral("<span style='font-weight:%1; color:%2'>%3</span>")
                         .arg(override ? 600 : 400)
                         .arg(ink(m_problem.isEmpty() ? Ink::Text : Ink::Error).name(), html));
    const QString range = rangeOf(v);
    const QString help = v.property ? QString::fromStdString(v.property->help) : paramHelp(*m_row.loaded, v.path);
    m_label->setToolTip(m_row.label + (range.isEmpty() ? QString() : QStringLiteral(" – ") + range) +
                        (help.isEmpty() ? QString() : QStringLiteral("\n") + help));
    m_label->setScrubbing(m_editor->canScrub());
    if (QWidget* field = m_editor->focusField()) {
        field->setAccessibleName(m_row.label);
        field->setAccessibleDescription(help);
    }
}

/// The first diagnostic inside a value. A diagnostic with an empty range counts for the character after it.
QString PropertyRow::problemInText() const {
    for (const FieldValue& v : m_row.values)
        for (const Diagnostic& d : m_row.loaded->diagnostics.all())
            if (v.given() && d.severity == Severity::Error && d.range.file == v.place.file &&
                d.range.range.begin < v.place.range.end &&
                v.place.range.begin < std::max(d.range.range.end, d.range.range.begin + 1))
                return QString::fromStdString(d.message);
    return {};
}

void PropertyRow::setNow(const QString& text) {
    m_now->setText(text);
    if (m_now->isHidden() != text.isEmpty()) m_now->setVisible(!text.isEmpty());
}

void PropertyRow::showNote() {
    m_note->setText(m_problem);
    m_note->setVisible(!m_problem.isEmpty());
    const QString sheet =
        QStringLiteral("color: %1;").arg(ink(Ink::Error).name()); // a palette would be overridden by the window's style sheet
    if (!m_problem.isEmpty() && m_note->styleSheet() != sheet) m_note->setStyleSheet(sheet);
}

/// Shows the value that an override replaces, and links to remove the override or move it into the config.
void PropertyRow::showOverride() {
    const auto isOverride = [](const FieldValue& v) { return v.origin == ValueOrigin::Override; };
    const auto count = std::count_if(m_row.values.begin(), m_row.values.end(), isOverride);
    m_override->setVisible(count > 0);
    if (count == 0) return m_override->clear();
    const bool one = m_row.values.size() == 1;
    const auto link = [](const char* name, const QString& shown) {
        return QStringLiteral("<a href='%1' style='color:%2; text-decoration:none'>%3</a>")
            .arg(QLatin1String(name), ink(Ink::Accent).name(), QString(shown).replace(QLatin1Char(' '), QChar(QChar::Nbsp)));
    };
    // A gap may end a line, but not begin one.
    QString text = QStringLiteral("<span style='color:%1'>%2</span>&nbsp; ")
                       .arg(ink(Ink::Faint).name(),
                            (one ? overrideWords(m_row.first()) : tr("override in %1 of %2").arg(count).arg(m_row.values.size()))
                                .toHtmlEscaped());
    QStringList links, tips; // the links stay in one line
    if (canReset(m_row)) {
        links << link("reset", tr("Reset"));
        tips << (one ? tr("Reset takes the override out") : tr("Reset takes the overrides out"));
    }
    if (one && m_row.first().setForAll.empty()) {
        links << link("push", tr("Push Up"));
        tips << tr("Push Up writes the value into %1").arg(QString::fromStdString(m_row.first().config));
    }
    m_override->setText(text + links.join(QStringLiteral("&nbsp;&nbsp;")));
    m_override->setToolTip(tips.join(QStringLiteral("; ")));
}

int PropertyRow::wantedLabelWidth() const {
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    const Property* p = m_row.property();
    const bool unit = p && m_row.fieldCount() > 1;
    return QFontMetrics(bold).horizontalAdvance(m_row.label +
                                                (unit ? QLatin1Char(' ') + QString::fromStdString(p->unit) : QString())) +
           2;
}

void PropertyRow::setLabelWidth(int width) {
    m_labelWidth = width;
    m_label->setFixedWidth(width);
    showLabel();
}

bool PropertyRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) Q_EMIT entered();
    if (event->type() == QEvent::ContextMenu) {
        const auto* menu = static_cast<QContextMenuEvent*>(event);
        if (auto* field = qobject_cast<QLineEdit*>(watched)) {
            fieldMenu(field, menu->globalPos());
            return true;
        }
    }
    if (event->type() == QEvent::ChildPolished) {
        if (auto* child = qobject_cast<QWidget*>(static_cast<QChildEvent*>(event)->child())) child->installEventFilter(this);
    }
    return QWidget::eventFilter(watched, event);
}

void PropertyRow::fieldMenu(QLineEdit* field, const QPoint& place) {
    QMenu* standard = field->createStandardContextMenu();
    Q_EMIT menuRequested(place, standard);
}

void PropertyRow::contextMenuEvent(QContextMenuEvent* event) {
    Q_EMIT entered();
    Q_EMIT menuRequested(event->globalPos(), nullptr);
    event->accept();
}

} // namespace trundle
