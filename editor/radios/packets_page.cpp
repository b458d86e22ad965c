#include "editor/radios/packets_page.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

#include "base/platform/atomic_file.h"
#include "editor/radios/outcome_bar.h"
#include "editor/radios/packet_text.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kRoomForDetails = 560, kRoomForFrames = 90;

void fillNodes(QComboBox& choice, const QString& any, const std::vector<RadioDefinition>& radios) {
    const QString chosen = choice.currentData().toString();
    const QSignalBlocker quiet(&choice);
    choice.clear();
    choice.addItem(any, QString());
    const std::vector<QString> names = shortNames(radios);
    for (std::size_t i = 0; i < radios.size(); ++i) choice.addItem(names[i], QString::fromStdString(radios[i].path));
    choice.setCurrentIndex(std::max(0, choice.findData(chosen)));
}

} // namespace

PacketsPage::PacketsPage(QWidget* parent) : QWidget(parent), m_model(new PacketModel(this)), m_outcomes(new OutcomeBar) {
    makeTools();
    makeView();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* halves = new QSplitter(Qt::Horizontal);
    halves->setChildrenCollapsible(false);
    halves->addWidget(m_view);
    halves->addWidget(makeDetails());
    halves->setStretchFactor(0, 1);
    halves->setSizes({760, 260});
    column->addWidget(m_outcomes);
    column->addWidget(halves, 1);
    connect(m_outcomes, &OutcomeBar::chosenChanged, this, &PacketsPage::applyFilter);
    m_tools->installEventFilter(this);
    showCounts();
    showDetails();
}

void PacketsPage::makeTools() {
    m_tools = new QWidget;
    auto* row = new QHBoxLayout(m_tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    m_from = makeNarrowChoice("radioFrom", tr("Only packets from this radio"), 11, m_tools);
    m_to = makeNarrowChoice("radioTo", tr("Only packets at this radio"), 11, m_tools);
    setRadios({});
    m_search = new QLineEdit(m_tools);
    m_search->setObjectName(QStringLiteral("radioSearch"));
    m_search->setPlaceholderText(tr("Name, address or bytes…"));
    m_search->setToolTip(
        tr("Packets with this in a name, an address or their payload: as characters, or as bytes in hex (b1 00)"));
    m_search->setAccessibleName(tr("Search the packets"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(90);
    m_counts = new QLabel(m_tools);
    m_counts->setObjectName(QStringLiteral("radioCounts"));
    m_counts->setForegroundRole(QPalette::PlaceholderText);
    m_export = new QToolButton(m_tools);
    m_export->setObjectName(QStringLiteral("radioExport"));
    m_export->setText(tr("Export"));
    m_export->setIcon(themedIcon(QStringLiteral("save")));
    showTextBesideIcon(*m_export);
    m_export->setPopupMode(QToolButton::InstantPopup);
    m_export->setAutoRaise(true);
    m_export->setToolTip(tr("Write all stored packets to a file"));
    auto* kinds = new QMenu(m_export);
    kinds->setObjectName(QStringLiteral("radioExportMenu"));
    kinds->addAction(tr("Packets as &CSV…"), this, [this] { Q_EMIT exportRequested(QStringLiteral("csv")); });
    kinds->addAction(tr("&Frames for Wireshark…"), this, [this] { Q_EMIT exportRequested(QStringLiteral("pcap")); });
    m_export->setMenu(kinds);
    m_clear = new QToolButton(m_tools);
    m_clear->setObjectName(QStringLiteral("radioClear"));
    m_clear->setIcon(themedIcon(QStringLiteral("delete")));
    m_clear->setToolTip(tr("Clear the packets"));
    m_clear->setAccessibleName(m_clear->toolTip());
    m_clear->setAutoRaise(true);
    row->addWidget(m_from);
    row->addWidget(m_to);
    row->addWidget(m_search, 1);
    row->addWidget(m_counts);
    row->addWidget(m_export);
    row->addWidget(m_clear);
    for (QComboBox* choice : {m_from, m_to}) connect(choice, &QComboBox::currentIndexChanged, this, &PacketsPage::applyFilter);
    connect(m_search, &QLineEdit::textChanged, this, &PacketsPage::applyFilter);
    connect(m_clear, &QToolButton::clicked, m_model, &PacketModel::clear);
}

void PacketsPage::makeView() {
    m_view = makeLineTable("radioFrames", m_model, LineFont::Interface);
    m_view->setAccessibleName(tr("Packets"));
    const QFontMetrics metrics(m_view->font());
    const auto widthOf = [&](const char* text) {
        return metrics.horizontalAdvance(QLatin1String(text)) + 24;
    }; // and the padding of cells
    const std::pair<int, const char*> widths[] = {
        {PacketModel::Time, "1234.567890"}, {PacketModel::From, "motes_1000"},      {PacketModel::To, "motes_1000"},
        {PacketModel::For, "motes_10"},     {PacketModel::Channel, "26"},           {PacketModel::Bytes, "Bytes"},
        {PacketModel::Power, "-25.0"},      {PacketModel::Rssi, "-94.0"},           {PacketModel::Lqi, "110"},
        {PacketModel::Margin, "Margin"},    {PacketModel::Outcome, "heard another"}};
    for (const auto& [column, text] : widths) m_view->setColumnWidth(column, widthOf(text));
    m_view->installEventFilter(this);
    m_hint = new QLabel(m_view->viewport());
    m_hint->setObjectName(QStringLiteral("radioHint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setMargin(12);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_view->viewport()->installEventFilter(this);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this, &PacketsPage::showMenu);
    connect(m_view, &QTableView::doubleClicked, this, &PacketsPage::requestBudget);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &PacketsPage::showDetails);

    QScrollBar* bar = m_view->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) { m_follows = value >= bar->maximum(); });
    connect(bar, &QScrollBar::rangeChanged, this, [this, bar] { // packets were added, or the height changed
        if (m_follows) bar->setValue(bar->maximum());
    });
    connect(m_model, &QAbstractItemModel::rowsRemoved, this, [this, bar](const QModelIndex&, int first, int last) {
        if (!m_follows) bar->setValue(bar->value() - (last - first + 1)); // the visible rows stay in place
    });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_follows = true;
        m_view->scrollToBottom();
        showCounts();
        showDetails();
    });
}

QWidget* PacketsPage::makeDetails() {
    m_details = new QWidget;
    auto* column = new QVBoxLayout(m_details);
    column->setContentsMargins(8, 4, 0, 0);
    column->setSpacing(2);
    m_facts = new QLabel;
    m_facts->setObjectName(QStringLiteral("radioFacts"));
    m_facts->setWordWrap(true);
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_bytes = new QPlainTextEdit;
    m_bytes->setObjectName(QStringLiteral("radioBytes"));
    m_bytes->setAccessibleName(tr("Bytes of the packet"));
    m_bytes->setReadOnly(true);
    m_bytes->setLineWrapMode(QPlainTextEdit::NoWrap);
    useMonospaceFont(*m_bytes);
    m_bytes->setTabChangesFocus(true);
    column->addWidget(m_facts);
    column->addWidget(m_bytes, 1);
    m_details->setMinimumWidth(160);
    return m_details;
}

// ---- updates ----

void PacketsPage::add(LiveRadio fresh) {
    m_outcomes->setCounts(fresh.expected, fresh.inTheAir, fresh.outcomes);
    fitOutcomes();
    m_model->add(std::move(fresh));
    showCounts();
}

void PacketsPage::clear() {
    m_model->clear();
    m_outcomes->setCounts(0, 0, {});
}

void PacketsPage::setRadios(const std::vector<RadioDefinition>& radios) {
    fillNodes(*m_from, tr("From any"), radios);
    fillNodes(*m_to, tr("At any"), radios);
    if (m_search) applyFilter();
}

void PacketsPage::setHint(const QString& words) {
    m_hintWords = words;
    showCounts();
}

void PacketsPage::applyFilter() {
    m_model->setFilter(
        {m_from->currentData().toString(), m_to->currentData().toString(), m_outcomes->chosen(), m_search->text().trimmed()});
}

void PacketsPage::showCounts() {
    const auto all = qulonglong(m_model->frameCount()), shown = qulonglong(m_model->rowCount());
    const auto gone = qulonglong(m_model->dropped());
    const QString number = QStringLiteral("%L1").arg(all), kept = gone > 0 ? tr("newest %1").arg(number) : number;
    const bool whole = shown == all;
    m_countWords.clear();
    if (all > 0 && whole) m_countWords = {tr("%1 packets").arg(kept), kept, number};
    if (all > 0 && !whole)
        m_countWords = {tr("%L1 of %2 packets").arg(shown).arg(kept), tr("%L1 of %2").arg(shown).arg(kept),
                        tr("%L1 of %2").arg(shown).arg(number)};
    m_counts->setToolTip(
        gone == 0 ? QString()
                  : tr("%L1 others were dropped: the oldest and, under heavy traffic, those that were too weak.").arg(gone));
    fitCounts();
    m_export->setEnabled(all > 0);
    m_clear->setEnabled(all > 0);
    m_hint->setText(all == 0 ? m_hintWords : tr("No packet of %L1 matches the filter.").arg(all));
    m_hint->setVisible(shown == 0);
}

/// Uses the longest text that fits next to the other tools.
void PacketsPage::fitCounts() {
    int room = m_tools->width();
    for (const QWidget* tool : {static_cast<QWidget*>(m_from), static_cast<QWidget*>(m_to), static_cast<QWidget*>(m_search),
                                static_cast<QWidget*>(m_export), static_cast<QWidget*>(m_clear)})
        room -= std::max(tool->minimumWidth(), tool->minimumSizeHint().width()) + m_tools->layout()->spacing();
    const auto fits = [&](const QString& words) { return m_counts->fontMetrics().horizontalAdvance(words) <= room; };
    const auto words = std::ranges::find_if(m_countWords, fits);
    m_counts->setVisible(words != m_countWords.end());
    m_counts->setText(words != m_countWords.end() ? *words : QString());
}

/// Shows the current packet; hidden if there is none, and in a narrow dock.
void PacketsPage::showDetails() {
    const QModelIndex current = m_view->currentIndex();
    const bool chosen = current.isValid() && m_view->selectionModel()->isRowSelected(current.row());
    m_details->setVisible(chosen && width() >= kRoomForDetails);
    if (!chosen) return;
    const FrameRecord& r = m_model->record(current.row());
    const AirFrame* frame = m_model->capturedFrame(r);
    const auto payload = frame ? payloadOf(*frame, r.ack) : std::span<const std::uint8_t>();
    const QString reason = m_model->index(current.row(), PacketModel::Reason).data().toString();
    const QString outcome = reason.isEmpty() ? outcomeText(r.outcome) : tr("%1: %2").arg(outcomeText(r.outcome), reason);
    m_facts->setText((r.ack ? tr("Acknowledgement of %1, %2 ▸ %3\n%4") : tr("Packet %1, %2 ▸ %3\n%4"))
                         .arg(r.sequence)
                         .arg(m_model->nameOf(r.from), m_model->nameOf(r.to), outcome));
    m_bytes->setVisible(!r.ack);
    m_bytes->setPlainText(frame ? dumpOf(payload) : tr("Its bytes are no longer stored."));
}

// ---- user actions ----

void PacketsPage::requestBudget() {
    const QModelIndex current = m_view->currentIndex();
    if (!current.isValid()) return;
    const FrameRecord& r = m_model->record(current.row());
    const auto path = [&](RadioId id) { return QString::fromStdString(m_model->radios()[id].path); };
    Q_EMIT budgetRequested(path(r.from), path(r.to), r.outputPower);
}

void PacketsPage::showMenu(const QPoint& at) {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("radioMenu"));
    const QModelIndex current = m_view->indexAt(at);
    if (current.isValid()) {
        const FrameRecord& r = m_model->record(current.row());
        menu.addAction(tr("Show &Link Budget"), this, &PacketsPage::requestBudget);
        const auto choose = [this](QComboBox* choice, RadioId id) {
            choice->setCurrentIndex(choice->findData(QString::fromStdString(m_model->radios()[id].path)));
        };
        menu.addAction(tr("Only &From %1").arg(m_model->nameOf(r.from)), this, [=, this, id = r.from] { choose(m_from, id); });
        menu.addAction(tr("Only &At %1").arg(m_model->nameOf(r.to)), this, [=, this, id = r.to] { choose(m_to, id); });
        menu.addSeparator();
    }
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("&Copy"), this, &PacketsPage::copySelected);
    menu.addAction(tr("&Select All"), m_view, &QTableView::selectAll);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

void PacketsPage::copySelected() {
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (!rows.isEmpty()) QApplication::clipboard()->setText(QString::fromStdString(m_model->csv(rows)));
}

void PacketsPage::exportTo(const QString& path) {
    const std::string bytes = path.endsWith(QStringLiteral(".pcap"), Qt::CaseInsensitive) ? m_model->pcap() : m_model->csv();
    const Status written = writeFileAtomically(path.toStdString(), bytes);
    Q_EMIT messageRequested(written ? tr("Wrote %1").arg(path) : QString::fromStdString(written.error().message));
}

/// The window's Copy and Select All apply to objects; with the focus here they apply to packets.
bool PacketsPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_tools && event->type() == QEvent::Resize) fitCounts();
    if (watched == m_view->viewport() && event->type() == QEvent::Resize) m_hint->setGeometry(m_view->viewport()->rect());
    if (watched == m_view && (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)) {
        auto* key = static_cast<QKeyEvent*>(event);
        const bool copies = key->matches(QKeySequence::Copy), selects = key->matches(QKeySequence::SelectAll);
        const bool plain = key->modifiers() == Qt::NoModifier, opens = plain && key->key() == Qt::Key_Return;
        const bool leaves = plain && key->key() == Qt::Key_Escape && m_view->selectionModel()->hasSelection();
        if (copies || selects || opens || leaves) {
            event->accept();
            if (event->type() == QEvent::ShortcutOverride) return true;
            if (copies) copySelected();
            else if (selects) m_view->selectAll();
            else if (leaves) m_view->clearSelection();
            else requestBudget();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

/// Hides the least important controls first in a small dock.
void PacketsPage::fitOutcomes() {
    m_outcomes->setVisible(height() - m_outcomes->sizeHint().height() >= kRoomForFrames || m_outcomes->chosen().any());
}

void PacketsPage::resizeEvent(QResizeEvent*) {
    fitOutcomes();
    m_export->setToolButtonStyle(width() >= kRoomForDetails ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    showDetails();
}

void PacketsPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || !m_clear) return;
    m_export->setIcon(themedIcon(QStringLiteral("save")));
    m_clear->setIcon(themedIcon(QStringLiteral("delete")));
}

} // namespace trundle
