#include "editor/radios/budget_page.h"

#include <cmath>
#include <numbers>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>

#include "editor/radios/level_diagram.h"
#include "editor/radios/packet_model.h"
#include "editor/radios/packet_text.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"
#include "radio/ieee802154.h"

namespace trundle {
namespace {

constexpr int kRoomForDiagram = 700, kRoomForTwo = 560;

QString withUnit(double value, const QString& unit) { return QStringLiteral("%1 %2").arg(decibelText(value), unit); }

/// Direction of the other end in an antenna's own frame.
QString directionText(const AntennaPose& antenna, const AntennaPose& other) {
    const Vec3 way = antenna.pose.rotation.conjugate() * (other.pose.position - antenna.pose.position);
    if (way.norm() < 1e-9) return {};
    const double degree = 180 / std::numbers::pi;
    const int azimuth = int(std::lround(std::atan2(way.y(), way.x()) * degree));
    const int elevation = int(std::lround(std::atan2(way.z(), std::hypot(way.x(), way.y())) * degree));
    const QString side = azimuth == 0               ? BudgetPage::tr("straight ahead")
                         : std::abs(azimuth) == 180 ? BudgetPage::tr("behind")
                         : azimuth > 0              ? BudgetPage::tr("%1° left").arg(azimuth)
                                                    : BudgetPage::tr("%1° right").arg(-azimuth);
    if (elevation == 0) return side;
    return (elevation > 0 ? BudgetPage::tr("%1, %2° up") : BudgetPage::tr("%1, %2° down"))
        .arg(side, QString::number(std::abs(elevation)));
}

QString pathText(const MediumSettings& medium, double distance) {
    const QString metres = QString::number(distance, 'f', 2);
    switch (medium.model) {
    case PropagationModel::Ideal: return BudgetPage::tr("free space, %1 m").arg(metres);
    case PropagationModel::TwoRay: return BudgetPage::tr("two rays, %1 m").arg(metres);
    case PropagationModel::LogDistance: return BudgetPage::tr("exponent %1, %2 m").arg(medium.exponent).arg(metres);
    }
    return {};
}

/// "30 %"; 0 and 100 only for exact values.
QString percentText(double share) {
    if (share <= 0 || share >= 1) return share <= 0 ? QStringLiteral("0 %") : QStringLiteral("100 %");
    if (share < 1e-4) return QStringLiteral("%1 %").arg(QString::number(share * 100, 'e', 1));
    return QStringLiteral("%1 %").arg(QString::number(std::min(share * 100, 99.99), 'f', share < 0.1 || share > 0.99 ? 2 : 1));
}

} // namespace

BudgetPage::BudgetPage(QWidget* parent) : QWidget(parent) {
    makeTools();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_words = new QLabel;
    m_words->setObjectName(QStringLiteral("budgetWords"));
    m_words->setWordWrap(true);
    m_words->setMargin(6);
    column->addWidget(m_words);

    m_terms = new QWidget;
    m_halves = new QBoxLayout(QBoxLayout::LeftToRight, m_terms);
    m_halves->setContentsMargins(8, 4, 8, 4);
    m_halves->setSpacing(28);
    auto *way = new QGridLayout, *reception = new QGridLayout;
    for (QGridLayout* grid : {way, reception}) {
        grid->setHorizontalSpacing(10);
        grid->setVerticalSpacing(3);
        grid->setColumnStretch(2, 1);
        m_halves->addLayout(grid, grid == way ? 6 : 5);
    }
    addTerm(*way, 0, Output, tr("Output power"), tr("Leaves the sender"));
    addTerm(*way, 1, SendGain, tr("+ send gain"), tr("Of the sender's antenna, towards the receiver"));
    addTerm(*way, 2, PathLoss, tr("− path loss"), tr("Lost over the distance, by RadioMedium's Model"));
    addTerm(*way, 3, Shadow, tr("− shadowing"), tr("RadioMedium's Shadowing, of this pair of places"));
    addTerm(*way, 4, Walls, tr("− walls"), tr("RadioMedium's WallLoss at each solid between"));
    addTerm(*way, 5, ReceiveGain, tr("+ receive gain"), tr("Of the receiver's antenna, towards the sender"));
    addTerm(*way, 6, Received, tr("= received power"), tr("At the receiver"));
    addTerm(*reception, 0, Rssi, tr("RSSI"), tr("As the receiver reads it"));
    addTerm(*reception, 1, Lqi, tr("LQI"), tr("Link quality, 110 at best"));
    addTerm(*reception, 2, Noise, tr("Noise floor"), tr("RadioMedium's NoiseFloor"));
    addTerm(*reception, 3, Snr, tr("SINR"), tr("Received power over the noise, without other transmissions"));
    addTerm(*reception, 4, Least, tr("Sensitivity"), tr("The receiver's MinReceivePower"));
    addTerm(*reception, 5, Margin, tr("Margin"), tr("Received power over the sensitivity"));
    addTerm(*reception, 6, Loss, tr("Packet errors"), tr("Probability that a packet is lost, without other transmissions"));
    m_diagram = new LevelDiagram;
    m_halves->addWidget(m_diagram, 6);
    auto* scroll = new QScrollArea;
    scroll->setWidget(m_terms);
    scroll->setWidgetResizable(true);
    column->addWidget(scroll, 1);
    refresh();
}

void BudgetPage::addTerm(QGridLayout& grid, int row, Term term, const QString& name, const QString& help) {
    auto* title = new QLabel(name);
    title->setToolTip(help);
    m_values[term] = new QLabel;
    m_values[term]->setObjectName(QStringLiteral("budgetTerm%1").arg(int(term)));
    m_values[term]->setAccessibleName(name);
    m_values[term]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_values[term]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_notes[term] = new QLabel;
    m_notes[term]->setForegroundRole(QPalette::PlaceholderText);
    m_notes[term]->setMinimumWidth(40);
    m_notes[term]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    if (term == Received || term == Margin)
        for (QLabel* label : {title, m_values[term]}) {
            QFont bold = label->font();
            bold.setBold(true);
            label->setFont(bold);
        }
    grid.addWidget(title, row, 0);
    grid.addWidget(m_values[term], row, 1);
    grid.addWidget(m_notes[term], row, 2);
    grid.setRowStretch(row + 1, row + 1 == 7);
}

void BudgetPage::makeTools() {
    m_tools = new QWidget;
    auto* row = new QHBoxLayout(m_tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    m_from = makeNarrowChoice("budgetFrom", tr("The sender"), 12, m_tools);
    m_to = makeNarrowChoice("budgetTo", tr("The receiver"), 12, m_tools);
    m_swap = new QToolButton(m_tools);
    m_swap->setObjectName(QStringLiteral("budgetSwap"));
    m_swap->setText(QStringLiteral("⇄"));
    m_swap->setToolTip(tr("Swap sender and receiver"));
    m_swap->setAccessibleName(m_swap->toolTip());
    m_swap->setAutoRaise(true);
    m_levels = makeNarrowChoice("budgetLevel", tr("Output power: one of the sender's PowerLevels"), 12, m_tools);
    m_levels->setMinimumContentsLength(8);
    m_anyPower = new QDoubleSpinBox(m_tools);
    m_anyPower->setObjectName(QStringLiteral("budgetPower"));
    m_anyPower->setToolTip(tr("Output power"));
    m_anyPower->setAccessibleName(tr("Output power"));
    m_anyPower->setSuffix(tr(" dBm"));
    m_anyPower->setDecimals(1);
    m_payload = new QSpinBox(m_tools);
    m_payload->setObjectName(QStringLiteral("budgetPayload"));
    m_payload->setRange(0, int(kMaxPayload));
    m_payload->setValue(20);
    m_payload->setSuffix(tr(" bytes"));
    m_payload->setToolTip(tr("Payload of the packet"));
    m_payload->setAccessibleName(tr("Payload"));
    row->addWidget(m_from);
    row->addWidget(m_swap);
    row->addWidget(m_to);
    row->addSpacing(8);
    row->addWidget(m_levels);
    row->addWidget(m_anyPower);
    row->addWidget(m_payload);
    row->addStretch(1);
    connect(m_from, &QComboBox::currentIndexChanged, this, [this] {
        fillPowers();
        refresh();
    });
    connect(m_to, &QComboBox::currentIndexChanged, this, &BudgetPage::refresh);
    connect(m_levels, &QComboBox::currentIndexChanged, this, &BudgetPage::refresh);
    connect(m_anyPower, &QDoubleSpinBox::valueChanged, this, &BudgetPage::refresh);
    connect(m_payload, &QSpinBox::valueChanged, this, &BudgetPage::refresh);
    connect(m_swap, &QToolButton::clicked, this, &BudgetPage::swap);
}

// ---- selection of the link ----

void BudgetPage::setNodes(std::shared_ptr<const RadioNodes> nodes) {
    const QString from = this->from(), to = this->to();
    const double before = power();
    const bool had = !from.isEmpty();
    m_nodes = std::move(nodes);
    std::vector<RadioDefinition> radios;
    if (m_nodes)
        for (const RadioNode& node : m_nodes->all()) radios.push_back(node.radio);
    const std::vector<QString> names = shortNames(radios);
    {
        const QSignalBlocker quietFrom(m_from), quietTo(m_to);
        for (QComboBox* choice : {m_from, m_to}) {
            choice->clear();
            for (std::size_t i = 0; i < radios.size(); ++i) choice->addItem(names[i], QString::fromStdString(radios[i].path));
        }
        m_from->setCurrentIndex(std::max(0, m_from->findData(from)));
        m_to->setCurrentIndex(std::max(m_to->count() > 1 ? 1 : 0, m_to->findData(to)));
        if (const int kept = m_to->findData(to); kept >= 0) m_to->setCurrentIndex(kept);
    }
    fillPowers();
    if (had && this->from() == from) setPower(before);
    refresh();
}

QString BudgetPage::from() const { return m_from->currentData().toString(); }
QString BudgetPage::to() const { return m_to->currentData().toString(); }

void BudgetPage::choose(const QString& from, const QString& to, std::optional<double> power) {
    if (const int index = m_from->findData(from); index >= 0) m_from->setCurrentIndex(index);
    if (const int index = m_to->findData(to); index >= 0) m_to->setCurrentIndex(index);
    if (power) setPower(*power - ownOffset());
    refresh();
}

/// Power offset (dB) of the sender.
double BudgetPage::ownOffset() const {
    const int sender = m_from->currentIndex();
    return m_nodes && sender >= 0 ? m_nodes->offsets(RadioId(sender)).power : 0;
}

void BudgetPage::swap() {
    const double before = power();
    const int from = m_from->currentIndex();
    m_from->setCurrentIndex(m_to->currentIndex());
    m_to->setCurrentIndex(from);
    setPower(before);
}

/// The power levels of the sender, or any in its range.
void BudgetPage::fillPowers() {
    const QSignalBlocker quietLevels(m_levels), quietPower(m_anyPower);
    m_levels->clear();
    const int index = m_from->currentIndex();
    const RadioDefinition* sender = m_nodes && index >= 0 ? &m_nodes->all()[std::size_t(index)].radio : nullptr;
    if (sender) {
        m_anyPower->setRange(-100, std::max(sender->maxOutputPower, -100.0));
        m_anyPower->setValue(sender->maxOutputPower);
        std::vector<double> levels = sender->powerLevels;
        std::ranges::sort(levels, std::greater<>());
        for (const double level : levels)
            if (level <= sender->maxOutputPower) m_levels->addItem(tr("%1 dBm").arg(level), level);
        if (const auto last = m_lastPower ? m_lastPower(from()) : std::nullopt) setPower(*last - ownOffset());
    }
    m_levels->setVisible(m_levels->count() > 0);
    m_anyPower->setVisible(m_levels->count() == 0);
}

/// In a narrow dock the diagram is hidden.
void BudgetPage::resizeEvent(QResizeEvent*) {
    m_diagram->setVisible(width() >= kRoomForDiagram);
    const bool narrow = width() < kRoomForTwo;
    m_halves->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_halves->setSpacing(narrow ? 3 : 28);
}

void BudgetPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_diagram) refresh();
}

void BudgetPage::setPower(double dbm) {
    int nearest = -1;
    for (int i = 0; i < m_levels->count(); ++i)
        if (nearest < 0 ||
            std::abs(m_levels->itemData(i).toDouble() - dbm) < std::abs(m_levels->itemData(nearest).toDouble() - dbm))
            nearest = i;
    m_levels->setCurrentIndex(nearest);
    m_anyPower->setValue(dbm);
}

double BudgetPage::power() const { return m_levels->count() > 0 ? m_levels->currentData().toDouble() : m_anyPower->value(); }

// ---- results ----

void BudgetPage::refresh() {
    const int from = m_from->currentIndex(), to = m_to->currentIndex();
    const bool there = m_nodes && from >= 0 && to >= 0 && from != to;
    m_swap->setEnabled(there);
    m_terms->setVisible(there);
    m_report.reset();
    QString words;
    if (!there)
        words = m_nodes && m_nodes->all().size() == 1 ? tr("There is only one radio: a link needs two.")
                                                      : tr("Choose two radios, here or in the scene.");
    if (!there) m_diagram->setLevels({});
    else {
        m_report = m_nodes->link(RadioId(from), RadioId(to), power(), std::uint32_t(m_payload->value()));
        showTerms(RadioId(from), RadioId(to));
        if (!m_report->sameChannel)
            words = tr("They cannot receive each other: one is on channel %1, the other on %2.")
                        .arg(m_nodes->all()[std::size_t(from)].radio.channel)
                        .arg(m_nodes->all()[std::size_t(to)].radio.channel);
    }
    m_words->setText(words);
    m_words->setVisible(!words.isEmpty());
}

void BudgetPage::show(Term term, const QString& value, const QString& note) {
    m_values[term]->setText(value);
    m_notes[term]->setText(note);
    m_notes[term]->setToolTip(note);
}

void BudgetPage::showTerms(RadioId from, RadioId to) {
    const LinkReport& r = *m_report;
    const MediumSettings& medium = m_nodes->settings();
    const RadioDefinition &sender = m_nodes->all()[from].radio, &receiver = m_nodes->all()[to].radio;
    const AntennaPose &here = m_nodes->antenna(from), &there = m_nodes->antenna(to);
    const QString dBm = tr("dBm"), dB = tr("dB");
    const double offset = r.outputPower - outputLevel(sender, power());
    show(Output, withUnit(r.outputPower, dBm),
         std::abs(offset) > 1e-9 ? tr("Offsets: %1 dB").arg(decibelText(offset)) : QString());
    show(SendGain, withUnit(r.link.sendGain, tr("dBi")), directionText(here, there));
    show(PathLoss, withUnit(r.link.pathLoss, dB), pathText(medium, r.link.distance));
    show(Shadow, withUnit(r.link.shadow, dB), medium.shadowing > 0 ? tr("deviation %1 dB").arg(medium.shadowing) : QString());
    show(Walls, withUnit(r.link.wallLoss, dB),
         medium.wallLoss > 0 ? tr("%1 × %2 dB").arg(std::lround(r.link.wallLoss / medium.wallLoss)).arg(medium.wallLoss)
                             : QString());
    show(ReceiveGain, withUnit(r.link.receiveGain, tr("dBi")), directionText(there, here));
    show(Received, withUnit(r.link.power, dBm));
    show(Rssi, QStringLiteral("%1 %2").arg(QString::number(r.rssi, 'f', receiver.rssiStep == 1 ? 0 : 1), dBm),
         receiver.rssiStep > 0 ? tr("steps of %1 dB").arg(receiver.rssiStep) : QString());
    show(Lqi, QString::number(r.lqi));
    show(Noise, withUnit(medium.noiseFloor, dBm));
    show(Snr, withUnit(r.snr, dB));
    show(Least, withUnit(receiver.minReceivePower, dBm));
    show(Margin, withUnit(r.margin, dB), r.margin < 0 ? tr("receives nothing") : QString());
    show(Loss, percentText(r.packetLoss),
         medium.packetErrors ? tr("of %1 bytes").arg(m_payload->value()) : tr("sharp threshold"));
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText, inkForMargin(r.margin));
    m_values[Margin]->setPalette(palette);
    m_diagram->setLevels(LevelDiagram::Levels{r, receiver.minReceivePower, medium.noiseFloor});
}

} // namespace trundle
