#include "editor/sensors/sensor_card.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "editor/outline/kind_icons.h"
#include "editor/sensors/battery_gauge.h"
#include "editor/sensors/heading_dial.h"
#include "editor/sensors/polar_plot.h"
#include "editor/sensors/reading_row.h"
#include "editor/sensors/sensor_image.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

/// The first number of a reading, if it has a value.
std::optional<double> numberOf(const Reading::Read& read, const LiveSnapshot& snapshot) {
    if (!read) return std::nullopt;
    double numbers[kMaxShownNumbers] = {};
    read(snapshot, numbers);
    return numbers[0];
}

} // namespace

SensorCard::SensorCard(SensorDevice device, RenderService* render, QWidget* parent)
    : QFrame(parent), m_device(std::move(device)) {
    setObjectName(QStringLiteral("sensor.") + QString::fromStdString(m_device.path));
    setFrameShape(QFrame::StyledPanel);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 6);
    column->setSpacing(4);
    addHeader();
    addPicture(render);
    for (const Reading& reading : m_device.readings) {
        m_rows.push_back(new ReadingRow(reading, this));
        column->addWidget(m_rows.back());
    }
    if (m_rows.empty()) {
        auto* none = new QLabel(tr("It has no signals."), this);
        none->setForegroundRole(QPalette::PlaceholderText);
        column->addWidget(none);
    }
    updateIcons();
}

void SensorCard::addHeader() {
    auto* header = new QHBoxLayout;
    header->setSpacing(5);
    m_icon = new QLabel(this);
    const QString kind = m_device.kind ? QString::fromStdString(m_device.kind->name) : QString();
    m_icon->setToolTip(kind);
    m_name = new QLabel(QString::fromStdString(m_device.path), this);
    m_name->setObjectName(QStringLiteral("sensorName"));
    m_name->setToolTip(QStringLiteral("%1 %2").arg(kind, m_name->text()));
    m_name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    QFont bold = m_name->font();
    bold.setWeight(QFont::DemiBold);
    m_name->setFont(bold);
    m_pin = new QToolButton(this);
    m_pin->setObjectName(QStringLiteral("sensorPin"));
    m_pin->setAutoRaise(true);
    m_pin->setCheckable(true);
    m_pin->setIconSize({14, 14});
    m_pin->setToolTip(tr("Keep it here, whatever is selected"));
    m_pin->setAccessibleName(tr("Pin"));
    connect(m_pin, &QToolButton::clicked, this, [this](bool pinned) { Q_EMIT pinRequested(m_device.path, pinned); });
    header->addWidget(m_icon);
    header->addWidget(m_name, 1);
    header->addWidget(m_pin);
    static_cast<QVBoxLayout*>(layout())->addLayout(header);
}

void SensorCard::addPicture(RenderService* render) {
    QWidget* picture = nullptr;
    switch (m_device.picture) {
    case SensorPicture::Polar:
        picture = m_polar = new PolarPlot(this);
        m_polar->setFan(m_device.fan);
        break;
    case SensorPicture::Dial: picture = m_dial = new HeadingDial(this); break;
    case SensorPicture::Battery: picture = m_gauge = new BatteryGauge(this); break;
    case SensorPicture::Camera:
        if (render) picture = m_image = new SensorImage(render, m_device.component, this);
        break;
    case SensorPicture::None: break;
    }
    if (picture) layout()->addWidget(picture);
}

void SensorCard::updateIcons() {
    m_icon->setPixmap(themedIcon(kindIcon(m_device.kind)).pixmap(16, 16));
    m_pin->setIcon(m_pin->isChecked() ? inkedIcon(QStringLiteral("pin"), Ink::Accent) : themedIcon(QStringLiteral("pin")));
}

ReadingRow* SensorCard::row(std::string_view name) const {
    const auto it = std::ranges::find_if(m_rows, [name](const ReadingRow* row) { return row->reading().name == name; });
    return it == m_rows.end() ? nullptr : *it;
}

bool SensorCard::rebind(const SensorDevice& device) {
    if (device.path != m_device.path || device.picture != m_device.picture || device.readings.size() != m_rows.size())
        return false;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (!m_rows[i]->rebind(device.readings[i])) return false;
    m_device = device;
    if (m_polar) m_polar->setFan(m_device.fan);
    return true;
}

void SensorCard::display(const RunResults& run, bool running) {
    const LiveSnapshot& snapshot = *run.snapshot;
    const bool measured = !m_device.hasReading || m_device.hasReading(snapshot);
    for (ReadingRow* row : m_rows) row->take(snapshot, measured);
    if (m_polar) {
        const auto ranges = run.layout->find(m_device.component + "/ranges");
        const bool shown = ranges && measured;
        m_polar->setDistances(shown ? snapshot.block->slots().subspan(ranges->offset, ranges->count) : std::span<const double>());
    }
    if (const ReadingRow* heading = m_dial ? row("heading") : nullptr)
        m_dial->setHeading(measured ? numberOf(heading->reading().read, snapshot) : std::nullopt,
                           m_showsTrue ? numberOf(heading->reading().readTrue, snapshot) : std::nullopt);
    if (const ReadingRow* level = m_gauge ? row("level") : nullptr) m_gauge->setLevel(numberOf(level->reading().read, snapshot));
    if (m_image) m_image->display(run, running);
}

void SensorCard::showTrue(bool shown) {
    m_showsTrue = shown;
    for (ReadingRow* row : m_rows) row->showTrue(shown);
}

void SensorCard::setPinned(bool pinned) {
    m_pin->setChecked(pinned);
    updateIcons();
}

void SensorCard::interrupt() {
    for (ReadingRow* row : m_rows) row->interrupt();
}

bool SensorCard::isSettled() const { return !m_image || m_image->isSettled(); }

void SensorCard::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_pin) updateIcons();
}

} // namespace trundle
