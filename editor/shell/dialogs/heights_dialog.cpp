#include "editor/shell/dialogs/heights_dialog.h"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/arena_files.h"
#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"

namespace trundle {

HeightsDialog::HeightsDialog(Locations locations, const QString& folder, QWidget* parent)
    : QDialog(parent), m_locations(std::move(locations)), m_projectFolder(folder), m_file(new QLineEdit),
      m_length(makeLengthField("heightsLength", tr("The length"), 0.001, 10000, 10)),
      m_width(makeLengthField("heightsWidth", tr("The width"), 0.001, 10000, 10)),
      m_height(makeLengthField("heightsHeight", tr("The height of white"), 0.001, 10000, 1)),
      m_preview(new PlanPreview("heightsPreview")), m_result(new ResultLabel("heightsResult")) {
    setObjectName(QStringLiteral("heightsDialog"));
    setWindowTitle(tr("Height Map"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_file->setObjectName(QStringLiteral("heightsPicture"));
    m_file->setPlaceholderText(tr("PNG, JPEG, BMP, PGM or PPM"));
    m_file->setMinimumWidth(scaledToFont(200));
    makeLayout();
    connect(m_file, &QLineEdit::textChanged, this, &HeightsDialog::read);
    for (AmountField* field : {m_length, m_width, m_height}) {
        connect(field, &AmountField::changed, this, &HeightsDialog::check);
        connect(field, &AmountField::submitted, m_insert, [this] { m_insert->click(); });
    }
    read();
}

QString HeightsDialog::picture() const { return QFileInfo(m_file->text().trimmed()).absoluteFilePath(); }

std::array<double, 3> HeightsDialog::sizes() const {
    return {m_length->value().value_or(0), m_width->value().value_or(0), m_height->value().value_or(0)};
}

void HeightsDialog::makeLayout() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* browse = new QToolButton;
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose the picture"));
    connect(browse, &QToolButton::clicked, this, &HeightsDialog::choose);
    layout->addWidget(m_file, 1);
    layout->addWidget(browse);
    auto* label = new QLabel(tr("&Picture"));
    label->setBuddy(m_file);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(label, row);
    form->addRow(m_length->makeLabel(tr("&Length, along x")), m_length);
    form->addRow(m_width->makeLabel(tr("&Width, along y")), m_width);
    form->addRow(m_height->makeLabel(tr("&Height of white")), m_height);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_insert = buttons->addButton(tr("Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setObjectName(QStringLiteral("heightsInsert"));
    m_insert->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void HeightsDialog::choose() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Height Map"), m_projectFolder,
                                                      tr("Pictures (*.png *.jpg *.jpeg *.bmp *.pgm *.ppm);;All files (*)"));
    if (!file.isEmpty()) m_file->setText(file);
}

void HeightsDialog::read() {
    m_map.reset();
    m_unreadable.clear();
    if (const QString file = m_file->text().trimmed(); QFileInfo(file).isFile()) {
        auto read = readPlanPicture(picture().toStdString(), m_locations);
        if (read) m_map = std::move(read).value();
        else m_unreadable = toQString(read.error().message);
    } else if (!file.isEmpty()) {
        m_unreadable = tr("There is no file %1.").arg(file);
    }
    if (m_map) m_preview->showHeights(*m_map);
    else m_preview->setText(tr("Black is low, white is high."));
    check();
}

void HeightsDialog::check() {
    QString fault = m_unreadable;
    for (const AmountField* field : {m_length, m_width, m_height})
        if (fault.isEmpty() && !field->value()) fault = field->fault();
    m_insert->setEnabled(fault.isEmpty() && m_map);
    if (!fault.isEmpty()) return m_result->show(fault, true);
    if (!m_map) return m_result->show(tr("Choose a grey picture, also of 16 bit."), false);
    const auto [low, high] = std::ranges::minmax(m_map->heights);
    const double white = *m_height->value();
    const auto metres = [](double value) { return QString::number(value, 'g', 4); };
    QString text = tr("%1 × %2 points, from %3 m to %4 m high.")
                       .arg(QString::number(m_map->columns), QString::number(m_map->rows), metres(double(low) * white),
                            metres(double(high) * white));
    if (!picture().startsWith(m_projectFolder + QLatin1Char('/')))
        text += QLatin1Char(' ') + tr("The picture is copied to %1.").arg(m_projectFolder);
    m_result->show(text, false);
}

} // namespace trundle
