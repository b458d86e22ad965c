#include "editor/properties/properties_panel.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/properties/editors/row_editor.h"
#include "editor/properties/help_strip.h"
#include "editor/properties/live_table.h"
#include "editor/properties/object_details.h"
#include "editor/properties/object_header.h"
#include "editor/properties/property_row.h"
#include "editor/properties/row_menu.h"
#include "editor/properties/rows.h"
#include "editor/properties/section.h"
#include "editor/running/session.h"
#include "editor/widgets/empty_page.h"
#include "editor/widgets/theme.h"
#include "model/robot_path.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// Those that a config uses and that are not listed yet.
void addPartConfigs(const Part* config, std::vector<const Part*>& known) {
    if (!config) return;
    eachPartUse(*config, [&](const Part& use) {
        if (use.config && std::ranges::find(known, use.config) == known.end()) known.push_back(use.config);
    });
}

constexpr std::size_t kMaxLiveGroups = 8;
constexpr int kLeastColumns = 24, kLeastLines = 8; ///< of text, in the smallest panel

/// Why a selected robot has ended; hidden without text.
QLabel* newEndedBanner(QWidget* parent) {
    auto* banner = new QLabel(parent);
    banner->setObjectName(QStringLiteral("endedBanner"));
    banner->setWordWrap(true);
    banner->setContentsMargins(10, 6, 10, 6);
    banner->hide();
    return banner;
}

void showBanner(QLabel& banner, const QString& text) {
    banner.setText(text);
    banner.setVisible(!text.isEmpty());
    const QString style = QStringLiteral("QLabel { color: %1; }").arg(ink(Ink::Error).name());
    if (!text.isEmpty() && banner.styleSheet() != style) banner.setStyleSheet(style);
}

/// Explains why values are missing, or why not all selected objects are shown.
QString liveHint(const Document& document, const Selection& selection, const RunSession& session) {
    const std::string path = selection.current();
    if (!session.results().snapshot || path.empty()) return {};
    if (const std::size_t count = selection.paths().size(); count > 1)
        return count > kMaxLiveGroups ? PropertiesPanel::tr("The first %1 of %2 selected objects.").arg(kMaxLiveGroups).arg(count)
                                      : QString();
    if (!session.values().of(path).empty()) return {};
    const auto place = placeOf(*document.loaded(), path);
    if (!place || !place->part) return {};
    if (place->part->is(Role::Layout) && !place->member)
        return PropertiesPanel::tr("Click one of its members in the 3D view to see its values.");
    if (place->instance && !session.edits().isOfRun(robotNameIn(*session.results().experiment, path)))
        return PropertiesPanel::tr("Not in this run: new or renamed since it started.");
    return {};
}

} // namespace

PropertiesPanel::PropertiesPanel(Document& document, Selection& selection, RunSession* session, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_session(session),
      m_header(new ObjectHeader(document, this)), m_ended(newEndedBanner(this)), m_scroll(new QScrollArea(this)),
      m_details(new ObjectDetails(m_scroll)), m_live(new LiveTable(this)), m_strip(new HelpStrip(this)),
      m_nothing(new QLabel(this)) {
    setObjectName(QStringLiteral("propertiesPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(m_ended);
    layout->addWidget(m_scroll, 1);
    layout->addWidget(m_live);
    layout->addWidget(m_nothing, 1);
    layout->addWidget(m_strip);
    m_scroll->setWidgetResizable(true);
    auto* holder = new QVBoxLayout(new QWidget(m_scroll->viewport()));
    holder->setContentsMargins({});
    holder->addWidget(m_details);
    holder->addStretch(1);
    m_scroll->setWidget(holder->parentWidget());
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    styleEmptyPage(*m_nothing, "nothing");
    connect(m_header, &ObjectHeader::selectRequested, this, [this](const std::string& path) {
        if (path.empty()) m_selection.clear();
        else m_selection.select(path);
    });
    connect(m_header, &ObjectHeader::jumpRequested, this, &PropertiesPanel::jump);
    connect(m_strip, &HelpStrip::jumpRequested, this, &PropertiesPanel::jump);
    m_gone.setSingleShot(true);
    connect(&m_gone, &QTimer::timeout, this, &PropertiesPanel::refresh);
    connect(&document, &Document::changed, this, &PropertiesPanel::followDocument);
    connect(&selection, &Selection::changed, this, &PropertiesPanel::refresh);
    if (session) {
        connect(session, &RunSession::stateChanged, this, &PropertiesPanel::refresh);
        connect(&session->edits(), &RunEdits::changed, this, &PropertiesPanel::refresh);
        connect(&session->values(), &RunValues::changed, this, &PropertiesPanel::showNow);
        connect(&session->robots().ended(), &EndedRobots::changed, this, &PropertiesPanel::showEnded);
    }
    showNothing(tr("Nothing is open"));
}

void PropertiesPanel::showNothing(const QString& why) {
    m_current.clear();
    dropRows();
    m_header->hide();
    m_ended->hide();
    m_scroll->hide();
    m_live->hide();
    m_strip->hide();
    m_nothing->setText(why);
    m_nothing->show();
}

void PropertiesPanel::dropRows() {
    m_shapes.clear();
    QWidget* body = std::exchange(m_body, nullptr);
    if (!body) return;
    // The rows keep their parent, since Qt restyles reparented widgets and keeps part of that memory. Without names, findChild()
    // does not return them.
    for (PropertyRow* row : std::exchange(m_rows, {})) row->setObjectName({});
    body->setObjectName({});
    // Losing the focus commits the text being typed; the document changes, and refresh() runs again.
    if (QWidget* focus = body->window()->focusWidget(); focus && body->isAncestorOf(focus)) focus->clearFocus();
    body->hide();
    m_scroll->widget()->layout()->removeWidget(body);
    body->deleteLater(); // deferred: this may be called from an editor in it
}

/// If the shown object is missing, the refresh is deferred to the event loop: after a rename the selection changes to the new
/// path before that, so the rows stay. The rows of a newly opened experiment are deferred too, after the other panels' updates.
void PropertiesPanel::followDocument(const ChangeSet& changes) {
    if (!isVisible() || !m_document.isOpen()) return refresh();
    if (changes.after() != m_document.loaded()) return; // a later edit was reported first
    if (isUnaffected(changes)) {
        m_shown = changes.after();
        return;
    }
    const bool gone = m_body && !isInUse() && m_selection.paths() == m_paths && objectsAt(m_document.loaded(), m_paths).empty();
    if (gone || !m_body) m_gone.start();
    else refresh();
}

/// Whether the rows are still right after an edit: it was elsewhere, and has not moved the text of the shown objects.
bool PropertiesPanel::isUnaffected(const ChangeSet& changes) const {
    if (!m_body || changes.before() != m_shown || !changes.isLocal() || changes.changesProblems()) return false;
    return m_selection.paths() == m_paths && !m_paths.empty() && std::ranges::all_of(m_paths, [&](const std::string& path) {
               const auto place = placeOf(*changes.before(), path);
               if (!place || !place->part) return false;
               std::vector<const Part*> involved{topOf(*place)};
               if (place->instance) involved.push_back(configOf(*changes.before(), *place->instance));
               involved.push_back(place->part->config);
               for (const Part* part : place->above)
                   if (part->is(Role::Config)) involved.push_back(part);
               for (std::size_t i = 0; i < involved.size(); ++i) addPartConfigs(involved[i], involved);
               return std::ranges::none_of(involved, [&](const Part* shown) {
                   return shown && (changes.nowAt(shown->range) != shown->range || changes.isEdited(*shown));
               });
           });
}

/// Whether a row has the focus or contains a refused text.
bool PropertiesPanel::isInUse() const {
    const QWidget* focus = QApplication::focusWidget();
    return (focus && m_body && m_body->isAncestorOf(focus)) ||
           std::ranges::any_of(m_rows, [](const PropertyRow* row) { return !row->refusal().isEmpty(); });
}

void PropertiesPanel::refresh() {
    m_gone.stop();
    if (!isVisible()) {
        m_stale = true;
        return;
    }
    m_stale = false;
    if (!m_document.isOpen()) return showNothing(tr("Nothing is open"));
    if (m_selection.paths() != m_paths) {
        m_paths = m_selection.paths();
        m_asText.clear();
        m_current.clear();
        if (isInUse()) dropRows(); // a text typed for one object must not apply to another
    }
    m_shown = m_document.loaded();
    Objects objects = objectsAt(m_document.loaded(), m_paths);
    if (objects.empty()) objects = objectsAt(m_document.loaded(), {}); // removed by undo: as if nothing is selected
    std::vector<std::string> kinds;
    for (const auto& object : objects) kinds.push_back(object->kind() ? object->kind()->name : std::string());
    if (std::exchange(m_kinds, kinds) != kinds) dropRows();
    const std::vector<Row> rows = rowsOf(objects, m_document, m_session);
    std::vector<Shape> shapes;
    for (const Row& row : rows) shapes.push_back({row.id, row.section, kindOf(row), row.fieldCount()});
    m_nothing->hide();
    m_header->display(objects);
    if (shapes != m_shapes || !m_body) build(rows, shapes);
    else {
        std::map<std::string, PropertyRow*> places;
        for (PropertyRow* row : m_rows) places[row->row().id] = row;
        for (const Row& row : rows) places[row.id]->display(row);
    }
    for (QWidget* w : std::initializer_list<QWidget*>{m_header, m_scroll, m_strip}) w->show();
    m_details->display(objects.size() == 1 ? objects[0]->shownPath() : std::string(), m_shown, m_session);
    auto* column = static_cast<QVBoxLayout*>(m_scroll->widget()->layout());
    const int place = m_details->leadsRows() ? 0 : 1;
    if (column->indexOf(m_details) != place) column->insertWidget(place, m_details);
    showHelp();
    showEnded();
    showLive();
}

void PropertiesPanel::showEnded() {
    const QString why = m_session && m_body ? m_session->robots().ended().explanation(m_selection.current()) : QString();
    showBanner(*m_ended, why);
}

/// The live values of the selected objects, of at most the first few; of the whole run if nothing is selected.
std::vector<LiveGroup> PropertiesPanel::liveGroups() const {
    const std::vector<std::string>& selected = m_selection.paths();
    if (selected.size() <= 1) {
        const auto& values = m_session->values().of(m_selection.current());
        return values.empty() ? std::vector<LiveGroup>() : std::vector<LiveGroup>{{{}, values}};
    }
    std::vector<LiveGroup> groups;
    for (std::size_t i = 0; i < std::min(selected.size(), kMaxLiveGroups); ++i)
        if (const auto& values = m_session->values().of(selected[i]); !values.empty())
            groups.push_back({QString::fromStdString(selected[i]), values});
    return groups;
}

/// The objects have changed, or a run started or ended.
void PropertiesPanel::showLive() {
    if (!m_session || !m_document.isOpen()) return m_live->hide();
    m_live->display(liveGroups(), liveHint(m_document, m_selection, *m_session));
}

/// A new tick: updates the values only.
void PropertiesPanel::showNow() {
    if (!isVisible() || !m_document.isOpen() || !m_body) return;
    if (const auto groups = liveGroups(); m_live->isHidden() != groups.empty() || !m_live->update(groups)) showLive();
    for (PropertyRow* row : m_rows) row->setNow(row->row().now ? row->row().now() : QString());
}

EditorKind PropertiesPanel::kindOf(const Row& row) const { return m_asText.count(row.id) ? EditorKind::Line : row.editor(); }

PropertyRow* PropertiesPanel::rowOf(const std::string& id) const {
    const auto it = std::find_if(m_rows.begin(), m_rows.end(), [&](const PropertyRow* row) { return row->row().id == id; });
    return it == m_rows.end() ? nullptr : *it;
}

void PropertiesPanel::build(const std::vector<Row>& rows, const std::vector<Shape>& shapes) {
    QWidget* focus = QApplication::focusWidget();
    const bool mine = focus && m_body && m_body->isAncestorOf(focus);
    const std::string focused = m_current;
    const QString field = mine ? focus->objectName() : QString();
    dropRows();
    if (m_body) return; // clearing the focus above has refreshed the panel
    m_shapes = shapes;
    m_body = new QWidget(m_scroll->widget());
    m_body->setObjectName(QStringLiteral("rows"));
    auto* layout = new QVBoxLayout(m_body);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->setSpacing(0);
    std::map<QString, Section*> sections;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Section*& section = sections[rows[i].section];
        if (!section) {
            const QString title = rows[i].section;
            section = new Section(title, !m_closed.count(title), m_body);
            layout->addWidget(section);
            connect(section, &Section::folded, this, [this, title](bool open) {
                if (open) m_closed.erase(title);
                else m_closed.insert(title);
            });
        }
        addRow(rows[i], shapes[i].kind, *section);
    }
    if (rows.empty()) {
        auto* none = new QLabel(tr("No properties"), m_body);
        none->setAlignment(Qt::AlignCenter);
        none->setForegroundRole(QPalette::PlaceholderText);
        none->setContentsMargins(0, 24, 0, 0);
        layout->addWidget(none);
    }
    alignLabels();
    static_cast<QVBoxLayout*>(m_scroll->widget()->layout())->insertWidget(0, m_body);
    m_body->show();
    if (mine) focusRow(focused, field);
}

void PropertiesPanel::addRow(const Row& row, EditorKind kind, Section& section) {
    auto* widget = new PropertyRow(row, kind, section.rows());
    section.add(widget);
    m_rows.push_back(widget);
    const std::string id = row.id;
    connect(widget, &PropertyRow::entered, this, [this, id, widget] {
        m_current = id;
        showHelp();
        m_scroll->ensureWidgetVisible(widget, 0, 4);
    });
    connect(widget, &PropertyRow::refusedChanged, this, [this, id] {
        m_current = id;
        showHelp();
    });
    connect(widget, &PropertyRow::scrubEnded, this, [this] { m_document.edits().endMerge(); });
    connect(widget, &PropertyRow::scrubCancelled, this,
            [this, widget] { m_document.edits().discardMerge("scrub " + widget->row().first().path); });
    connect(widget, &PropertyRow::resetRequested, this, [this, id, widget] {
        const Setter set = widget->row().set; // a copy: the change below replaces the row
        showFailure(id, set([](const FieldValue&) { return std::string(); }, {}));
    });
    connect(widget, &PropertyRow::pushRequested, this,
            [this, widget, id] { showFailure(id, pushOverride(m_document, std::string(widget->row().first().path))); });
    connect(widget, &PropertyRow::menuRequested, this,
            [this, widget](const QPoint& place, QMenu* under) { openMenu(widget, place, under); });
}

void PropertiesPanel::alignLabels() {
    int wide = 70;
    for (const PropertyRow* row : m_rows) wide = std::max(wide, row->wantedLabelWidth());
    const int widest = 118 * fontMetrics().height() / 16; // scaled with the height of the font
    for (PropertyRow* row : m_rows) row->setLabelWidth(std::min(wide, widest));
}

void PropertiesPanel::focusRow(const std::string& id, const QString& field) {
    PropertyRow* row = rowOf(id);
    if (!row) return;
    QWidget* same = row->editor().findChild<QWidget*>(field);
    QWidget* target = same && same->focusPolicy() != Qt::NoFocus ? same : row->editor().focusField();
    if (target) target->setFocus(Qt::OtherFocusReason);
}

void PropertiesPanel::showHelp() {
    if (const PropertyRow* row = rowOf(m_current))
        m_strip->display(row->row(), row->refusal(), m_session && m_session->state() != RunState::Start);
    else m_strip->displayText(m_header->kindHelp());
}

void PropertiesPanel::showFailure(const std::string& id, const Status& status) {
    m_current = id;
    const QString reason = status ? QString() : QString::fromStdString(status.error().message);
    if (const PropertyRow* shown = rowOf(id))
        m_strip->display(shown->row(), reason, m_session && m_session->state() != RunState::Start);
}

void PropertiesPanel::openMenu(PropertyRow* row, const QPoint& place, QMenu* under) {
    QMenu* menu = under ? under : new QMenu(this);
    menu->setObjectName(QStringLiteral("rowMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (under) menu->addSeparator();
    const std::string id = row->row().id;
    RowActions actions;
    actions.jump = [this](const SourceRange& range) { jump(range); };
    actions.editAsText = [this, id] { setAsText(id); };
    actions.failed = [this, id](const Status& status) { showFailure(id, status); };
    actions.asText = m_asText.count(id) > 0;
    fillRowMenu(*menu, row->row(), m_document, actions);
    menu->popup(place);
}

void PropertiesPanel::setAsText(const std::string& id) {
    if (!m_asText.erase(id)) m_asText.insert(id);
    m_current = id;
    refresh();
    focusRow(id, QStringLiteral("field"));
}

void PropertiesPanel::jump(const SourceRange& place) {
    const std::vector<std::string> files = m_document.texts().files();
    if (place.known() && place.file < files.size()) Q_EMIT jumpTo(files[place.file], place);
}

void PropertiesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_stale) refresh();
}

QSize PropertiesPanel::minimumSizeHint() const {
    return {fontMetrics().averageCharWidth() * kLeastColumns, fontMetrics().lineSpacing() * kLeastLines};
}

void PropertiesPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_live->setMostHeight(height() * 2 / 5);
}

void PropertiesPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && m_document.isOpen()) refresh();
    if (event->type() == QEvent::FontChange) // after the rows have received the new font
        QMetaObject::invokeMethod(this, &PropertiesPanel::alignLabels, Qt::QueuedConnection);
}

} // namespace trundle
