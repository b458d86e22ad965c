#include "editor/outline/library_panel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/library_items.h"
#include "editor/outline/library_model.h"
#include "editor/outline/library_pictures.h"
#include "editor/outline/library_view.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/widgets/theme.h"
#include "project/edits/insert_positions.h"

namespace trundle {

struct LibraryPanel::Section {
    QToolButton* header = nullptr;
    LibraryList* list = nullptr;
    LibrarySectionFilter* filter = nullptr;
    bool open = true; ///< as the user set it; a search opens all sections

    void fit(bool fits, bool opened) const {
        const bool some = fits && filter->rowCount() > 0, shown = some && (open || opened);
        header->setVisible(some);
        header->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
        list->setVisible(shown);
        if (shown) list->fit();
    }
};

LibraryPanel::LibraryPanel(Document& document, Selection& selection, Application& application, RenderService* render,
                           const Locations& places, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_application(application), m_configs(places.configs),
      m_resources(places.resources), m_modules(places.modules),
      m_edits(new ObjectEdits(document, selection, *new ObjectMarks(this), this)),
      m_model(new LibraryModel([this](const LibraryItem& item) { return textOf(item); }, this)),
      m_pictures(new LibraryPictures(application, render, this)) {
    setObjectName(QStringLiteral("libraryPanel"));
    m_pool.setMaxThreadCount(1);
    build();
    connect(m_pictures, &LibraryPictures::drawn, m_model, &LibraryModel::setPicture);
    connect(&document, &Document::opened, m_search, &QLineEdit::clear);
    connect(&document, &Document::opened, this, &LibraryPanel::readFolders);
    connect(&document, &Document::changed, this, &LibraryPanel::showItems);
    connect(&document.editedModel(), &EditedModel::changed, this, &LibraryPanel::showModel);
    connect(&document.texts(), &DocumentTexts::modifiedChanged, this, [this] {
        // Unmodified again: after undo or save the files on disk may have changed.
        if (m_document.isOpen() && !m_document.texts().isModified() && lastWritten() != m_readOf) readFolders();
    });
    readFolders();
    showItems();
}

LibraryPanel::~LibraryPanel() { m_pool.waitForDone(); }

bool LibraryPanel::isSettled() const { return !isReading() && m_pictures->wanted() == 0; }

void LibraryPanel::build() {
    m_search = new QLineEdit;
    m_search->setObjectName(QStringLiteral("librarySearch"));
    m_search->setPlaceholderText(tr("Search the library"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(themedIcon(QStringLiteral("find")), QLineEdit::LeadingPosition);
    m_asList = new QToolButton;
    m_asList->setObjectName(QStringLiteral("libraryAsList"));
    m_asList->setCheckable(true);
    m_asList->setAutoRaise(true);
    m_asList->setIconSize({16, 16});
    m_asList->setIcon(themedIcon(QStringLiteral("view-list")));
    m_asList->setToolTip(tr("Show as a list with descriptions"));
    auto* top = new QHBoxLayout;
    top->setContentsMargins(6, 6, 6, 4);
    top->setSpacing(4);
    top->addWidget(m_search, 1);
    top->addWidget(m_asList);

    auto* inside = new QWidget;
    inside->setObjectName(QStringLiteral("librarySections"));
    inside->setAutoFillBackground(true);
    inside->setBackgroundRole(QPalette::Base);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(4, 0, 4, 4);
    column->setSpacing(0);
    for (int section = 0; section < kLibrarySections; ++section) addSection(static_cast<LibrarySection>(section), *column);
    column->addStretch(1);
    auto* area = new QScrollArea;
    area->setObjectName(QStringLiteral("libraryArea"));
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(inside);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addLayout(top);
    all->addWidget(area, 1);
    connect(m_search, &QLineEdit::textChanged, this, &LibraryPanel::setWords);
    connect(m_asList, &QToolButton::toggled, this, &LibraryPanel::setAsList);
    m_asList->setChecked(QSettings().value(QStringLiteral("library/asList")).toBool());
}

void LibraryPanel::addSection(LibrarySection section, QVBoxLayout& layout) {
    Section made;
    made.header = new QToolButton;
    made.header->setObjectName(QStringLiteral("librarySection.%1").arg(int(section)));
    made.header->setText(sectionTitle(section));
    made.header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made.header->setAutoRaise(true);
    made.header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    made.header->setFont(bold);
    made.filter = new LibrarySectionFilter(section, this);
    made.filter->setSourceModel(m_model);
    made.list = new LibraryList;
    made.list->setObjectName(QStringLiteral("libraryList.%1").arg(int(section)));
    made.list->setAccessibleName(sectionTitle(section));
    made.list->setModel(made.filter);
    made.open = section <= LibrarySection::RobotParts;
    layout.addWidget(made.header);
    layout.addWidget(made.list);
    const std::size_t at = m_sections.size();
    m_sections.push_back(made);
    connect(made.header, &QToolButton::clicked, this, [this, at] {
        m_sections[at].open = !m_sections[at].open;
        fitSections();
    });
    connect(made.list, &QListView::activated, this, [this, filter = made.filter](const QModelIndex& index) {
        insert(m_model->items().at(std::size_t(filter->mapToSource(index).row())));
    });
    connect(made.list, &LibraryList::leftBehind, this, [this, at](int by) { step(at, by); });
    connect(made.list->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this, at](const QItemSelection& chosen) {
        if (!chosen.isEmpty()) // one selection across all lists
            for (std::size_t i = 0; i < m_sections.size(); ++i)
                if (i != at) m_sections[i].list->clearSelection();
    });
}

/// Moves the keyboard focus to the next visible list.
void LibraryPanel::step(std::size_t from, int by) {
    for (std::size_t at = from + std::size_t(by); at < m_sections.size(); at += std::size_t(by)) {
        const Section& section = m_sections[at];
        if (!section.list->isVisibleTo(this)) continue;
        section.list->setFocus(Qt::OtherFocusReason);
        section.list->setCurrentIndex(section.filter->index(by > 0 ? 0 : section.filter->rowCount() - 1, 0));
        return;
    }
}

/// Whether the edited model can contain what a section has; without one everything can be inserted.
bool LibraryPanel::fitsModel(LibrarySection section) const {
    const EditedModel& model = m_document.editedModel();
    if (!model.isOpen() || section == LibrarySection::Shapes || section == LibrarySection::Looks) return true;
    const bool isRobot = model.config() && model.config()->kind->name == "RobotConfig";
    return isRobot &&
           (section == LibrarySection::RobotParts || section == LibrarySection::Joints || section == LibrarySection::Devices);
}

void LibraryPanel::fitSections() {
    const bool searching = !m_search->text().trimmed().isEmpty();
    for (std::size_t i = 0; i < m_sections.size(); ++i) m_sections[i].fit(fitsModel(static_cast<LibrarySection>(i)), searching);
}

/// The sections that the model is built from are open at first.
void LibraryPanel::showModel() {
    const bool isShown = m_document.editedModel().isOpen();
    if (isShown == m_openBefore.empty()) {
        m_search->clear(); // it was for something else
        std::vector<bool> before;
        for (std::size_t i = 0; i < m_sections.size(); ++i) {
            before.push_back(m_sections[i].open);
            m_sections[i].open = isShown ? static_cast<LibrarySection>(i) != LibrarySection::Looks : bool(m_openBefore[i]);
        }
        m_openBefore = isShown ? std::move(before) : std::vector<bool>();
    }
    fitSections();
}

void LibraryPanel::setWords(const QString& text) {
    const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (const Section& section : m_sections) section.filter->setWords(words);
    fitSections();
}

void LibraryPanel::setAsList(bool list) {
    QSettings().setValue(QStringLiteral("library/asList"), list);
    for (const Section& section : m_sections) section.list->setAsList(list);
    fitSections();
}

} // namespace trundle
