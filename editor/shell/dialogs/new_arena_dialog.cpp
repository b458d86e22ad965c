#include "editor/shell/dialogs/new_arena_dialog.h"

#include <utility>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/module_template.h"
#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kPreview = 240; // pixels of a side

Property lengthProperty(const QString& name, double least, double most) {
    Property property;
    property.name = name.toStdString();
    property.unit = "m";
    property.minimum = least;
    property.maximum = most;
    return property;
}

} // namespace

NewArenaDialog::NewArenaDialog(Locations locations, const QString& folder, QWidget* parent)
    : QDialog(parent), m_locations(std::move(locations)), m_file(new QLineEdit), m_name(new QLineEdit(QStringLiteral("Office"))),
      m_folder(new QLineEdit(folder)), m_width(new AmountField(lengthProperty(tr("The width of the plan"), 0.1, 10000))),
      m_height(new AmountField(lengthProperty(tr("The height of the walls"), 0.01, 100))),
      m_threshold(new QSlider(Qt::Horizontal)), m_light(new QCheckBox(tr("&Light parts are walls"))), m_preview(new QLabel),
      m_result(new ResultLabel("arenaResult")) {
    setObjectName(QStringLiteral("newArena"));
    setWindowTitle(tr("New Arena from Floor Plan"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_file->setObjectName(QStringLiteral("arenaPicture"));
    m_file->setPlaceholderText(tr("PNG, JPEG, BMP, PGM or PPM"));
    m_file->setMinimumWidth(scaledToFont(220));
    m_name->setObjectName(QStringLiteral("arenaName"));
    m_folder->setObjectName(QStringLiteral("arenaFolder"));
    m_width->setObjectName(QStringLiteral("arenaWidth"));
    m_height->setObjectName(QStringLiteral("arenaHeight"));
    m_threshold->setObjectName(QStringLiteral("arenaThreshold"));
    m_threshold->setRange(1, 99);
    m_threshold->setValue(50);
    m_threshold->setToolTip(tr("What is darker is wall"));
    m_light->setObjectName(QStringLiteral("arenaLight"));
    m_preview->setObjectName(QStringLiteral("arenaPreview"));
    m_preview->setFixedSize(scaledToFont(kPreview), scaledToFont(kPreview));
    m_preview->setAlignment(Qt::AlignCenter);
    m_preview->setFrameShape(QFrame::StyledPanel);
    makeLayout();
    m_width->setValue(10);
    m_height->setValue(0.5);
    connect(m_file, &QLineEdit::textChanged, this, &NewArenaDialog::readPicture);
    for (QLineEdit* field : {m_name, m_folder}) connect(field, &QLineEdit::textChanged, this, &NewArenaDialog::check);
    for (AmountField* field : {m_width, m_height}) {
        connect(field, &AmountField::changed, this, &NewArenaDialog::check);
        connect(field, &AmountField::submitted, m_create, [this] { m_create->click(); });
    }
    connect(m_threshold, &QSlider::valueChanged, this, &NewArenaDialog::check);
    connect(m_light, &QCheckBox::toggled, this, &NewArenaDialog::check);
    readPicture();
}

void NewArenaDialog::makeLayout() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    const auto add = [&](const QString& text, QWidget* row, QWidget* field) {
        auto* label = new QLabel(text);
        label->setBuddy(field);
        form->addRow(label, row);
    };
    add(tr("&Picture"), withButton(m_file, tr("Choose the picture"), &NewArenaDialog::choosePicture), m_file);
    form->addRow(m_width->makeLabel(tr("&Width")), m_width);
    add(tr("&Threshold"), m_threshold, m_threshold);
    form->addRow(QString(), m_light);
    form->addRow(m_height->makeLabel(tr("Wall &height")), m_height);
    add(tr("&Name"), m_name, m_name);
    add(tr("&Folder"), withButton(m_folder, tr("Choose the folder"), &NewArenaDialog::chooseFolder), m_folder);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_create = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    m_create->setObjectName(QStringLiteral("arenaCreate"));
    m_create->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QWidget* NewArenaDialog::withButton(QLineEdit* field, const QString& tip, void (NewArenaDialog::*choose)()) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* browse = new QToolButton;
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tip);
    connect(browse, &QToolButton::clicked, this, choose);
    layout->addWidget(field, 1);
    layout->addWidget(browse);
    return row;
}

void NewArenaDialog::choosePicture() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Floor Plan"), m_folder->text(),
                                                      tr("Pictures (*.png *.jpg *.jpeg *.bmp *.pgm *.ppm);;All files (*)"));
    if (!file.isEmpty()) m_file->setText(file);
}

void NewArenaDialog::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the Arena"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(folder);
}

void NewArenaDialog::readPicture() {
    m_map.reset();
    m_unreadable.clear();
    if (const QString file = m_file->text().trimmed(); QFileInfo(file).isFile()) {
        auto read = readPlanPicture(QFileInfo(file).absoluteFilePath().toStdString(), m_locations);
        if (read) m_map = std::move(read).value();
        else m_unreadable = toQString(read.error().message);
    } else if (!file.isEmpty()) {
        m_unreadable = tr("There is no file %1.").arg(file);
    }
    check();
}

/// Makes the plan; why it cannot be made otherwise.
QString NewArenaDialog::planFault() {
    m_plan.reset();
    if (!m_map) return m_unreadable;
    for (const AmountField* field : {m_width, m_height})
        if (!field->value()) return field->fault();
    FloorPlanOptions options;
    options.threshold = m_threshold->value() / 100.;
    options.isInverted = m_light->isChecked();
    options.width = *m_width->value();
    Result<FloorPlan> plan = floorPlanFrom(*m_map, options);
    if (!plan) return toQString(plan.error().message);
    m_plan = std::move(plan).value();
    return {};
}

QString NewArenaDialog::placeFault() const {
    const std::string name = m_name->text().trimmed().toStdString();
    if (const std::string fault = arenaNameFault(name); !fault.empty()) return toQString(fault);
    const QFileInfo folder(QDir::cleanPath(m_folder->text().trimmed()));
    if (!folder.isDir()) return tr("There is no folder %1.").arg(folder.filePath());
    if (!folder.isWritable()) return tr("The folder %1 is not writable.").arg(folder.filePath());
    const QString made = folder.filePath() + QLatin1Char('/') + toQString(moduleNameFor(name));
    return QFileInfo::exists(made) ? tr("%1 exists already.").arg(made) : QString();
}

/// The walls as they will be, with the place of the robot.
void NewArenaDialog::showPlan() {
    if (!m_plan) return m_preview->setText(tr("Black is wall."));
    const FloorPlan& plan = *m_plan;
    const double scale = (m_preview->width() - 8.) / std::max(plan.columns, plan.rows);
    QPixmap picture(QSizeF(plan.columns * scale, plan.rows * scale).toSize().expandedTo({1, 1}));
    picture.fill(themePalette().color(QPalette::Base));
    QPainter p(&picture);
    for (const PlanBox& wall : plan.walls)
        p.fillRect(QRectF(wall.x * scale, wall.y * scale, wall.width * scale, wall.height * scale), ink(Ink::Text));
    const QPointF robot((plan.freest[0] / plan.cell + plan.columns / 2.) * scale,
                        (plan.rows / 2. - plan.freest[1] / plan.cell) * scale);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(ink(Ink::Accent));
    p.drawEllipse(robot, 4, 4);
    p.end();
    m_preview->setPixmap(picture);
}

/// Shows the walls, and says what will be written, or why nothing can be.
void NewArenaDialog::check() {
    QString fault = planFault();
    showPlan();
    if (fault.isEmpty() && m_plan) fault = placeFault();
    m_create->setEnabled(fault.isEmpty() && m_plan);
    if (!fault.isEmpty()) return m_result->show(fault, true);
    if (!m_plan) return m_result->show(tr("Choose the picture of a floor plan, for which you know its width."), false);
    const FloorPlan& plan = *m_plan;
    const auto metres = [&](std::uint32_t cells) { return QString::number(cells * plan.cell, 'g', 4); };
    QString text = tr("%1 walls, %2 m × %3 m.").arg(QString::number(plan.walls.size()), metres(plan.columns), metres(plan.rows));
    if (plan.step > 1)
        text += QLatin1Char(' ') + tr("Made coarser, %1 pixels to a cell, since more boxes would be needed.").arg(plan.step);
    const QString name = toQString(moduleNameFor(m_name->text().trimmed().toStdString()));
    m_result->show(text + QLatin1Char(' ') +
                       tr("Writes %1/%1.sim, and the experiment %1_drive.sim with a robot at the blue dot.").arg(name),
                   false);
}

void NewArenaDialog::accept() {
    if (!m_plan) return;
    Result<NewArena> made =
        makePlanArena(m_name->text().trimmed().toStdString(), *m_plan, *m_height->value(), m_file->text().trimmed().toStdString(),
                      QDir::cleanPath(m_folder->text().trimmed()).toStdString());
    if (!made) return m_result->show(toQString(made.error().message), true);
    m_made = std::move(made).value();
    QDialog::accept();
}

} // namespace trundle
