#include "editor/properties/editors/colour_editor.h"

#include <cmath>

#include <QColorDialog>
#include <QGridLayout>
#include <QPainter>
#include <QToolButton>

#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

constexpr int kSwatch = 18;

std::string share(float value) { return plainNumber(std::round(value * 1000) / 1000); }

QIcon swatchOf(const QColor& colour, bool mixed, double ratio) {
    QPixmap picture(QSize(kSwatch, kSwatch) * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(ink(Ink::Line));
    painter.setBrush(mixed ? QBrush(ink(Ink::Faint), Qt::BDiagPattern) : QBrush(colour));
    painter.drawRoundedRect(QRectF(0.5, 0.5, kSwatch - 1, kSwatch - 1), 3, 3);
    painter.end();
    return QIcon(picture);
}

} // namespace

ColourEditor::ColourEditor(QWidget* parent) : NumbersEditor(parent), m_swatch(new QToolButton(this)) {
    m_swatch->setObjectName(QStringLiteral("swatch"));
    m_swatch->setToolTip(tr("Choose a colour"));
    m_swatch->setAccessibleName(m_swatch->toolTip());
    m_swatch->setIconSize({kSwatch, kSwatch});
    m_swatch->setFocusPolicy(Qt::TabFocus);
    connect(m_swatch, &QToolButton::clicked, this, &ColourEditor::choose);
    layout()->setContentsMargins(m_swatch->sizeHint().width() + 4, 0, 0, 0);
}

QColor ColourEditor::colour() const {
    const std::optional<PropertyValue>& value = m_row.first().value;
    if (!value || value->numbers.size() != 3) return {};
    const auto part = [&](std::size_t i) { return static_cast<float>(std::clamp(value->numbers[i], 0.0, 1.0)); };
    return QColor::fromRgbF(part(0), part(1), part(2));
}

void ColourEditor::refresh() {
    NumbersEditor::refresh();
    m_swatch->setIcon(swatchOf(colour(), m_row.mixed() || !colour().isValid(), devicePixelRatioF()));
}

void ColourEditor::resizeEvent(QResizeEvent* event) {
    NumbersEditor::resizeEvent(event);
    const int size = m_swatch->sizeHint().height();
    m_swatch->setGeometry(0, std::max(0, (std::min(height(), focusField() ? focusField()->height() : size) - size) / 2),
                          m_swatch->sizeHint().width(), size);
}

void ColourEditor::choose() {
    auto* dialog = new QColorDialog(colour().isValid() ? colour() : QColor(Qt::lightGray), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    connect(dialog, &QColorDialog::currentColorChanged, this, &ColourEditor::set);
    connect(dialog, &QDialog::rejected, this, &RowEditor::scrubCancelled);
    connect(dialog, &QDialog::finished, this, &RowEditor::scrubEnded);
    dialog->open();
}

void ColourEditor::set(const QColor& colour) {
    const std::string r = share(colour.redF()), g = share(colour.greenF()), b = share(colour.blueF());
    commit([r, g, b](const FieldValue& v) { return joined({r, g, b}, v.separator); }, "scrub " + m_row.first().path);
}

} // namespace trundle
