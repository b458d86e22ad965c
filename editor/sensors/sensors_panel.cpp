#include "editor/sensors/sensors_panel.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/sensors/card_columns.h"
#include "editor/sensors/sensor_card.h"
#include "editor/sensors/shown_devices.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/widgets/empty_page.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kIntervalMs = 33;
constexpr std::size_t kMaxCards = 64;

} // namespace

SensorsPanel::SensorsPanel(Document& document, Selection& selection, RunSession& session, RenderService* render, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_session(session), m_render(render),
      m_pins(std::make_unique<PinnedValues>(document)) {
    setObjectName(QStringLiteral("SensorsPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_pages = new QStackedWidget(this);
    column->addWidget(m_pages);
    m_empty = new QLabel;
    styleEmptyPage(*m_empty, "sensorsEmpty");
    m_pages->addWidget(m_empty);
    auto* work = new QWidget;
    auto* rows = new QVBoxLayout(work);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeTools());
    m_columns = new CardColumns;
    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // so that the columns keep their width
    m_scroll->setWidget(m_columns);
    rows->addWidget(m_scroll, 1);
    m_pages->addWidget(work);

    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &SensorsPanel::updateCards);
    connect(&session, &RunSession::advanced, this, &SensorsPanel::markStale);
    for (const auto changed : {&RunSession::stateChanged, &RunSession::experimentChanged})
        connect(&session, changed, this, &SensorsPanel::markChanged);
    connect(&document, &Document::changed, this, &SensorsPanel::markChanged);
    connect(&selection, &Selection::changed, this, &SensorsPanel::markChanged);
    connect(&document.editedModel(), &EditedModel::changed, this, &SensorsPanel::markChanged);
    connect(m_pins.get(), &PinnedValues::changed, this, &SensorsPanel::markChanged);
    showHint();
}

SensorsPanel::~SensorsPanel() = default;

QWidget* SensorsPanel::makeTools() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(6, 3, 6, 3);
    row->setSpacing(6);
    m_true = new QToolButton(bar);
    m_true->setObjectName(QStringLiteral("sensorsTrue"));
    m_true->setText(tr("True Values"));
    m_true->setToolTip(tr("Show the true value beside what a sensor measures, where the run has it"));
    m_true->setCheckable(true);
    m_true->setChecked(true);
    m_true->setAutoRaise(true);
    m_unpin = new QToolButton(bar);
    m_unpin->setObjectName(QStringLiteral("sensorsUnpin"));
    m_unpin->setText(tr("Unpin All"));
    m_unpin->setToolTip(tr("Show only what is selected"));
    m_unpin->setAutoRaise(true);
    m_facts = new QLabel(bar);
    m_facts->setObjectName(QStringLiteral("sensorsFacts"));
    m_facts->setForegroundRole(QPalette::PlaceholderText);
    m_facts->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_facts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_true);
    row->addWidget(m_unpin);
    row->addWidget(m_facts, 1);
    connect(m_true, &QToolButton::toggled, this, &SensorsPanel::showTrue);
    connect(m_unpin, &QToolButton::clicked, this, [this] { m_pins->setPins({}); });
    return bar;
}

void SensorsPanel::showTrue(bool shown) {
    m_true->setChecked(shown);
    for (SensorCard* card : m_cards) card->showTrue(shown);
    m_columns->arrange();
    markStale();
}

// ---- update schedule ----

bool SensorsPanel::isSeen() const { return isVisible() && !visibleRegion().isEmpty(); }

bool SensorsPanel::isSettled() const {
    const bool images = std::ranges::all_of(m_cards, [](const SensorCard* card) { return card->isSettled(); });
    return !isSeen() || (!m_stale && !m_changed && m_turnsLeft == 0 && images);
}

void SensorsPanel::markStale() {
    m_stale = true;
    m_turnsLeft = (m_cards.size() + kCardsAtOnce - 1) / kCardsAtOnce;
    if (m_next.isActive() || !isSeen()) return;
    const qint64 since = m_sinceUpdate.isValid() ? m_sinceUpdate.elapsed() : kIntervalMs;
    m_next.start(int(std::clamp<qint64>(kIntervalMs - since, 0, kIntervalMs)));
}

void SensorsPanel::markChanged() {
    m_changed = true;
    markStale();
}

void SensorsPanel::showEvent(QShowEvent*) { markStale(); }

/// Updates when the panel becomes visible behind another tab.
void SensorsPanel::paintEvent(QPaintEvent*) {
    if (m_stale && !m_next.isActive()) markStale();
}

void SensorsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && m_columns) m_columns->arrange();
}

void SensorsPanel::updateCards() {
    if (!m_stale || !isSeen()) return;
    const bool wasHidden = m_sinceUpdate.isValid() && m_sinceUpdate.elapsed() > 1000 && m_session.state() == RunState::Running;
    m_sinceUpdate.start();
    m_stale = false;
    ++m_updates;
    if (std::exchange(m_changed, false)) {
        rebuild();
        m_turnsLeft = m_cards.size(); // more than enough: new ones have shown nothing
    }
    const RunResults& run = m_session.results();
    if (m_cards.empty() || !run.snapshot) return;
    displayTurn(wasHidden);
    const QString omitted = m_omitted > 0 ? tr("%1 more devices are not shown  •  ").arg(m_omitted) : QString();
    m_facts->setText(omitted + tr("t = %1 s").arg(run.time(), 0, 'f', 2));
}

/// Every so many-th card; what a run that has paused measured last reaches all of them.
void SensorsPanel::displayTurn(bool wasHidden) {
    const std::size_t turns = (m_cards.size() + kCardsAtOnce - 1) / kCardsAtOnce, turn = m_turn++ % turns;
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        if (wasHidden) m_cards[i]->interrupt();
        if (i % turns == turn) m_cards[i]->display(m_session.results(), m_session.state() == RunState::Running);
    }
    m_turnsLeft = std::min(m_turnsLeft, turns);
    if (m_turnsLeft > 0 && --m_turnsLeft > 0) {
        m_stale = true;
        m_next.start(kIntervalMs);
    }
}

// ---- content ----

std::vector<std::string> SensorsPanel::shownPaths() {
    std::vector<std::string> paths = m_pins->paths();
    std::ranges::copy(m_selection.paths(), std::back_inserter(paths));
    const RunResults& run = m_session.results();
    std::vector<std::string> devices = devicesOf(*run.experiment, *run.built->registry, paths);
    if (const EditedModel& model = m_document.editedModel(); devices.empty() && model.isOpen()) // a test drive
        devices = devicesOf(*run.experiment, *run.built->registry, model.path());
    m_omitted = devices.size() > kMaxCards ? devices.size() - kMaxCards : 0;
    if (m_omitted > 0) devices.resize(kMaxCards);
    return devices;
}

void SensorsPanel::rebuild() {
    const RunResults& run = m_session.results();
    std::vector<SensorCard*> before = std::exchange(m_cards, {});
    if (run.experiment && run.layout && run.snapshot) {
        const bool sameRun = run.layout == m_layout;
        for (const std::string& path : shownPaths()) {
            std::optional<SensorDevice> device;
            const auto has = [&path](const SensorCard* card) { return card->device().path == path; };
            const auto old = sameRun ? std::ranges::find_if(before, has) : before.end();
            SensorCard* card = old == before.end() ? nullptr : *old;
            if (!card || run.experiment != m_experiment) device = sensorDeviceAt(run, path);
            if (!card && !device) continue;
            if (card && device && !card->rebind(*device)) card = nullptr;
            if (!card) card = makeCard(std::move(*device));
            card->setPinned(m_pins->contains(path));
            std::erase(before, card);
            m_cards.push_back(card);
        }
        m_experiment = run.experiment;
        m_layout = run.layout;
    }
    for (SensorCard* card : before) card->deleteLater();
    for (SensorCard* card : before) card->hide();
    m_columns->setCards({m_cards.begin(), m_cards.end()});
    m_unpin->setEnabled(!m_pins->pins().empty());
    showHint();
}

SensorCard* SensorsPanel::makeCard(SensorDevice device) {
    auto* card = new SensorCard(std::move(device), m_render, m_columns);
    card->showTrue(m_true->isChecked());
    connect(card, &SensorCard::pinRequested, this, [this](const std::string& path, bool pinned) { m_pins->set({path}, pinned); });
    return card;
}

void SensorsPanel::showHint() {
    m_empty->setText(hint());
    m_pages->setCurrentIndex(m_cards.empty() ? 0 : 1);
}

QString SensorsPanel::hint() const {
    if (!m_document.isOpen()) return tr("Open an experiment to see what its sensors measure.");
    if (!m_session.results().snapshot) return tr("Run the experiment (F5) to see what sensors and motors measure.");
    if (m_selection.empty() && m_pins->pins().empty()) return tr("Select a robot or one of its devices to see what it measures.");
    return tr("The selection has no devices in this run. Select a robot, or a body of it, then choose Insert ▸ Sensors and "
              "Actuators.");
}

} // namespace trundle
