#include "editor/radios/radios_panel.h"

#include <algorithm>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>
#include <QTabBar>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/radios/budget_page.h"
#include "editor/radios/packets_page.h"
#include "editor/running/session.h"
#include "editor/widgets/empty_page.h"
#include "editor/widgets/save_question.h"
#include "model/dotted_path.h"
#include "scene/queries/radio_model.h"

namespace trundle {
namespace {

constexpr int kPauseMs = 120; // about eight updates a second
constexpr int kRoomForOneRow = 720;

/// Whether a path is that of a radio, "robot0.left.radio", or of the Part or robot that it is in.
bool holdsRadio(std::string_view path, const RadioNode& node) {
    const std::string_view radio = std::string_view(node.radio.path).substr(node.robot.size() + 1);
    return !path.empty() && startsWithPath(pathInside(node.robot, radio), path);
}

} // namespace

RadiosPanel::RadiosPanel(Document& document, Selection& selection, RunSession& session, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_session(session) {
    setObjectName(QStringLiteral("RadiosPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_pages = new QStackedWidget(this);
    column->addWidget(m_pages);
    m_empty = new QLabel;
    styleEmptyPage(*m_empty, "radiosEmpty");
    m_pages->addWidget(m_empty);
    m_pages->addWidget(makeWork());

    m_next.setSingleShot(true);
    m_next.setInterval(kPauseMs);
    connect(&m_next, &QTimer::timeout, this, &RadiosPanel::updatePages);
    connect(&document, &Document::opened, this, [this] {
        m_packets->clear();
        m_expected = 0;
    });
    connect(&document, &Document::changed, this, &RadiosPanel::markStale);
    connect(&session, &RunSession::experimentChanged, this, &RadiosPanel::markStale);
    connect(&session, &RunSession::stateChanged, this, &RadiosPanel::markStale);
    connect(&session, &RunSession::advanced, this, &RadiosPanel::markStale);
    connect(&selection, &Selection::changed, this, [this] {
        m_chosen = false;
        markStale();
    });
    follow();
}

QWidget* RadiosPanel::makeWork() {
    auto* work = new QWidget;
    m_packets = new PacketsPage;
    m_budget = new BudgetPage;
    m_budget->setLastPower([this](const QString& radio) { return m_packets->model().lastPower(radio); });
    m_tabs = new QTabBar;
    m_tabs->setObjectName(QStringLiteral("radioPages"));
    m_tabs->setAccessibleName(tr("What the panel shows"));
    m_tabs->setExpanding(false);
    m_tabs->addTab(tr("Packets"));
    m_tabs->addTab(tr("Link Budget"));
    m_tools = new QStackedWidget;
    m_tools->addWidget(m_packets->tools());
    m_tools->addWidget(m_budget->tools());
    m_tools->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_parts = new QStackedWidget;
    m_parts->addWidget(m_packets);
    m_parts->addWidget(m_budget);
    m_top = new QBoxLayout(QBoxLayout::LeftToRight);
    m_top->setContentsMargins(6, 3, 6, 3);
    m_top->setSpacing(10);
    m_top->addWidget(m_tabs);
    m_top->addWidget(m_tools, 1);
    auto* rows = new QVBoxLayout(work);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addLayout(m_top);
    rows->addWidget(m_parts, 1);
    connect(m_tabs, &QTabBar::currentChanged, this, [this](int page) {
        m_tools->setCurrentIndex(page);
        m_parts->setCurrentIndex(page);
        m_budget->refresh();
    });
    connect(m_packets, &PacketsPage::budgetRequested, this, [this](const QString& from, const QString& to, double power) {
        m_budget->choose(from, to, power);
        showPage(Budget);
    });
    connect(m_packets, &PacketsPage::exportRequested, this, &RadiosPanel::askAndExport);
    connect(m_packets, &PacketsPage::messageRequested, this, &RadiosPanel::messageRequested);
    return work;
}

void RadiosPanel::showPage(Page page) { m_tabs->setCurrentIndex(page); }

// ---- update schedule ----

bool RadiosPanel::isSeen() const { return isVisible() && !visibleRegion().isEmpty(); }

void RadiosPanel::markStale() {
    m_stale = true;
    if (!m_next.isActive() && isSeen()) m_next.start();
}

void RadiosPanel::updatePages() {
    if (!m_stale || !isSeen()) return;
    m_stale = false;
    follow();
}

void RadiosPanel::showEvent(QShowEvent*) {
    m_session.enable(RunSession::Extra::Radio, true);
    markStale();
}

void RadiosPanel::hideEvent(QHideEvent*) { m_session.enable(RunSession::Extra::Radio, false); }

void RadiosPanel::resizeEvent(QResizeEvent*) {
    const bool narrow = width() < kRoomForOneRow;
    m_top->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_top->setSpacing(narrow ? 2 : 10);
}

/// Updates when the panel becomes visible behind another tab.
void RadiosPanel::paintEvent(QPaintEvent*) {
    if (m_stale && !m_next.isActive()) m_next.start();
}

// ---- content ----

void RadiosPanel::follow() {
    const bool runs = m_session.results().experiment && m_session.results().poses;
    const std::shared_ptr<const ExperimentSpec> experiment = runs                  ? m_session.results().experiment
                                                             : m_document.isOpen() ? m_document.loaded()->experiment
                                                                                   : nullptr;
    if (experiment != m_experiment) useExperiment(experiment);
    placeNodes();
    fetchPackets();
    followSelection();
    m_budget->refresh();
}

void RadiosPanel::useExperiment(std::shared_ptr<const ExperimentSpec> experiment) {
    m_experiment = std::move(experiment);
    m_nodes = m_experiment ? std::make_shared<RadioNodes>(m_experiment->medium, radioNodesOf(*m_experiment)) : nullptr;
    m_objects = m_experiment && m_experiment->medium.wallLoss > 0 ? std::make_shared<const ObjectIndex>(m_experiment) : nullptr;
    std::vector<RadioDefinition> radios;
    if (m_nodes)
        for (const RadioNode& node : m_nodes->all()) radios.push_back(node.radio);
    m_packets->setRadios(radios);
    placeNodes();
    m_budget->setNodes(m_nodes);
    m_empty->setText(!m_experiment ? tr("Open an experiment to see its radios.")
                                   : tr("No robot here has a radio. Select a body of a robot, then choose Insert ▸ Sensors and "
                                        "Actuators ▸ Transceiver."));
    m_pages->setCurrentIndex(radios.empty() ? 0 : 1);
}

void RadiosPanel::placeNodes() {
    if (!m_nodes) return;
    std::shared_ptr<const BodyPoses> poses = m_session.results().poses;
    if (!poses || m_session.results().experiment != m_experiment)
        poses = std::make_shared<const BodyPoses>(startPoses(*m_experiment));
    if (m_objects) m_nodes->setWalls(wallsBetween(m_objects, poses, m_nodes->all()));
    m_nodes->place(*poses);
}

void RadiosPanel::fetchPackets() {
    if (m_session.results().snapshot) {
        LiveRadio fresh = m_session.takeRadio();
        m_expected = fresh.expected;
        if (fresh.radios && fresh.radios != m_runRadios) {
            m_runRadios = fresh.radios;
            if (m_runRadios->size() != m_nodes->all().size()) { // modules' devices may have radios too
                m_packets->setRadios(*m_runRadios);
                m_pages->setCurrentIndex(1);
            }
        }
        m_packets->add(std::move(fresh));
    }
    showHint();
}

void RadiosPanel::showHint() {
    const RunState state = m_session.state();
    if (state == RunState::Start) m_packets->setHint(tr("Run the experiment (F5): packets appear here as they are sent."));
    else if (state == RunState::Ended && m_expected > 0)
        m_packets->setHint(tr("Packets are recorded while this panel is open. Run again (F5) to see them."));
    else if (m_expected > 0) m_packets->setHint(tr("Packets are recorded while this panel is open. New packets appear here."));
    else m_packets->setHint(tr("No packet was sent yet."));
}

/// If two radios, or objects that carry radios, are selected, shows their link; the first one is the sender.
void RadiosPanel::followSelection() {
    if (!m_nodes || std::exchange(m_chosen, true)) return;
    std::vector<QString> ends;
    for (const std::string& path : m_selection.paths()) {
        const auto& nodes = m_nodes->all();
        auto it = std::ranges::find_if(nodes, [&](const RadioNode& node) { return holdsRadio(path, node); });
        if (it == nodes.end()) // another part of a robot
            it = std::ranges::find_if(nodes, [&](const RadioNode& node) { return startsWithPath(path, node.robot); });
        if (it == nodes.end()) continue;
        const QString end = QString::fromStdString(it->radio.path);
        if (std::ranges::find(ends, end) == ends.end()) ends.push_back(end);
    }
    if (ends.size() >= 2) m_budget->choose(ends[ends.size() - 2], ends.back());
}

void RadiosPanel::askAndExport(const QString& ending) {
    const QFileInfo text(m_document.isNew() ? QString() : QString::fromStdString(m_document.path()));
    const QString name = text.completeBaseName().isEmpty() ? QStringLiteral("packets") : text.completeBaseName() + tr("_packets");
    const QString folder = m_document.isNew() ? QString() : text.path() + u'/';
    const QString path =
        askWhereToSave(this, tr("Export Packets"), folder + name + u'.' + ending,
                       ending == QStringLiteral("pcap") ? tr("Captures (*.pcap)") : tr("Comma-separated values (*.csv)"), ending);
    if (!path.isEmpty()) m_packets->exportTo(path);
}

} // namespace trundle
