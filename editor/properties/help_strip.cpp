#include "editor/properties/help_strip.h"

#include <QLabel>
#include <QVBoxLayout>

#include "editor/properties/origin_text.h"
#include "editor/properties/param_help.h"
#include "editor/properties/row.h"
#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

QLabel* addLabel(QVBoxLayout* layout, QWidget* parent, const char* name) {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    layout->addWidget(label);
    return label;
}

QString coloured(Ink which, const QString& text) {
    return QStringLiteral("<span style='color:%1'>%2</span>").arg(ink(which).name(), text.toHtmlEscaped());
}

QString originLine(const Row& row) {
    const FieldValue& v = row.first();
    if (row.mixed()) return coloured(Ink::Faint, QObject::tr("%1 objects, with different values").arg(row.values.size()));
    QString line = originWords(v);
    if (v.formula && !v.shown.empty()) {
        const QString unit =
            v.property && !v.property->unit.empty() ? QLatin1Char(' ') + QString::fromStdString(v.property->unit) : QString();
        line += QStringLiteral("  ·  ") + QString::fromStdString(v.text).simplified() + QStringLiteral(" = ") +
                QString::fromStdString(v.shown) + unit;
    }
    line = coloured(Ink::Faint, line);
    const QString place = placeWords(*row.loaded, v.place);
    if (place.isEmpty() || !v.given()) return line;
    return line + QStringLiteral("  <a href='place' style='color:%1; text-decoration:none'>%2</a>")
                      .arg(ink(Ink::Accent).name(), place.toHtmlEscaped());
}

} // namespace

HelpStrip::HelpStrip(QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("helpStrip"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 6, 10, 8);
    layout->setSpacing(2);
    setStyleSheet(QStringLiteral("#helpStrip { border: none; border-top: 1px solid palette(mid); }"));
    m_title = addLabel(layout, this, "helpTitle");
    m_help = addLabel(layout, this, "helpText");
    m_origin = addLabel(layout, this, "helpOrigin");
    layout->addStretch(1);
    setMinimumHeight(fontMetrics().lineSpacing() * 4 + 22);
    connect(m_origin, &QLabel::linkActivated, this, [this] { Q_EMIT jumpRequested(m_place); });
}

void HelpStrip::display(const Row& row, const QString& refusal, bool running) {
    const Property* p = row.property();
    QString title = QStringLiteral("<span style='font-weight:600'>%1</span>").arg(row.label.toHtmlEscaped());
    const QString range = rangeOf(row.first());
    if (!range.isEmpty()) title += QStringLiteral("  ") + coloured(Ink::Faint, range);
    m_title->setText(title);
    m_title->show();
    QString help = p ? QString::fromStdString(p->help) : paramHelp(*row.loaded, row.first().path);
    if (!p && help.isEmpty()) help = tr("A Param: other values may be worked out from it.");
    if (running && !help.isEmpty() && !QStringLiteral(".!?:;…").contains(help.back())) help += QLatin1Char('.');
    if (running && p && p->live) help += QLatin1Char(' ') + tr("Takes effect at once in a run.");
    else if (running) help += QLatin1Char(' ') + tr("Takes effect after a reset.");
    m_help->setText(refusal.isEmpty() ? help.toHtmlEscaped() : coloured(Ink::Error, refusal));
    m_place = row.first().place;
    m_origin->setText(originLine(row));
    m_origin->setVisible(true);
}

void HelpStrip::displayText(const QString& text) {
    m_title->hide();
    m_help->setText(coloured(Ink::Faint, text));
    m_origin->hide();
}

} // namespace trundle
