#include "editor/text/text_assistance.h"

#include <algorithm>

#include <QMenu>
#include <QToolTip>

#include "editor/document/document.h"
#include "editor/document/project_rename.h"
#include "editor/document/structure_edits.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/pages/text_pages.h"
#include "editor/text/rename_field.h"
#include "editor/text/search/results_list.h"
#include "editor/text/symbols/hover.h"
#include "editor/text/symbols/text_location.h"
#include "editor/text/symbols/text_navigation.h"
#include "editor/text/text_commands.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/plain_text.h"
#include "lang/formatter.h"
#include "project/edits/edit_target.h"

namespace trundle {
namespace {

bool isSign(char c) { return c != ' ' && c != '\t' && c != '\n' && c != '\r'; }

/// Number of non-blank characters before an offset. Formatting changes only blanks, so this identifies the offset afterwards.
std::size_t signsBefore(std::string_view text, std::size_t place) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(place, text.size())), isSign));
}
/// The offset of the character that follows this many non-blank characters.
std::size_t placeBehind(std::string_view text, std::size_t signs) {
    std::size_t at = 0;
    while (at < text.size() && (signs > 0 || !isSign(text[at])))
        if (isSign(text[at++])) --signs;
    return at;
}

} // namespace

TextAssistance::TextAssistance(Document& document, TextPages& pages, ResultsList& uses, TextCommands& commands, Actions& actions,
                               QObject* parent)
    : QObject(parent), m_document(document), m_pages(pages), m_uses(uses), m_commands(commands), m_actions(actions) {}

void TextAssistance::watch(FilePage& page) {
    CodeEdit& edit = page.edit();
    connect(&edit.pointer(), &CodePointer::hoverRequested, this,
            [this, &page](std::uint32_t at, const QPoint& pos) { showHover(page, at, pos); });
    connect(&edit.pointer(), &CodePointer::linkRequested, this, [this, &page](std::uint32_t at) { showLink(page, at); });
    connect(&edit.pointer(), &CodePointer::linkFollowed, this, &TextAssistance::goToDefinition);
    connect(&edit.pointer(), &CodePointer::menuRequested, this, [this, &page](const QPoint& pos) { showMenu(page, pos); });
}

void TextAssistance::showMessage(const QString& text) {
    Q_EMIT messageRequested(text);
    FilePage* page = m_pages.page();
    if (page)
        showToolTip(page->edit().viewport()->mapToGlobal(page->edit().geometry().placeOf(page->edit().caret())), text,
                    &page->edit());
}

void TextAssistance::showHover(FilePage& page, std::uint32_t offset, const QPoint& globalPos) {
    page.flush();
    const FileId file = page.id();
    if (offset == CodeGeometry::kNowhere || file == kNoFile) return QToolTip::hideText();
    std::vector<const Diagnostic*> problems;
    for (const Diagnostic& problem : page.problems())
        if (touches(problem.range.range, offset)) problems.push_back(&problem);
    const std::string html = hoverHtml(hoverAt(*m_document.loaded(), file, offset), problems);
    if (html.empty()) QToolTip::hideText();
    else showHtmlToolTip(globalPos, QString::fromStdString(html), page.edit().viewport());
}

void TextAssistance::showLink(FilePage& page, std::uint32_t offset) {
    TextRange link;
    if (offset != CodeGeometry::kNowhere && page.flush() && page.id() != kNoFile) {
        const auto found = definitionAt(*m_document.loaded(), page.id(), offset);
        if (found) link = found->word.range;
    }
    page.edit().marks().showLink(link);
}

const Kind* TextAssistance::kindAtCaret() {
    FilePage* page = m_pages.page();
    if (!page || !page->flush() || page->id() == kNoFile) return nullptr;
    const TextLocation place = placeAt(*m_document.loaded(), page->id(), page->edit().caret());
    const auto* block = place.item ? place.item->as<BlockItem>() : nullptr;
    const Kind* named = block ? m_document.loaded()->registry->find(block->type.text) : nullptr;
    return named ? named : place.kind;
}

QString TextAssistance::constructAtCaret() {
    FilePage* page = m_pages.page();
    if (!page || !page->flush() || page->id() == kNoFile) return {};
    const Item* item = placeAt(*m_document.loaded(), page->id(), page->edit().caret()).item;
    if (item && item->as<ImportItem>()) return QStringLiteral("#import");
    if (item && item->as<ModuleItem>()) return QStringLiteral("#loadModule");
    return item && item->as<ParamItem>() ? QStringLiteral("Param") : QString();
}

void TextAssistance::goToDefinition(std::uint32_t offset) {
    FilePage* page = m_pages.page();
    if (!page) return;
    page->flush();
    page->edit().marks().showLink({});
    if (page->id() == kNoFile) return;
    const auto found = definitionAt(*m_document.loaded(), page->id(), offset);
    if (found) m_pages.reveal(found->place, true);
    else showMessage(tr("No name at the caret"));
}

void TextAssistance::showUses(std::uint32_t offset) {
    FilePage* page = m_pages.page();
    if (!page) return;
    m_pages.flush();
    if (page->id() == kNoFile) return;
    const LoadedProject& loaded = *m_document.loaded();
    const std::vector<SourceRange> uses = usesAt(loaded, page->id(), offset);
    if (uses.empty()) return showMessage(tr("No name at the caret"));
    const auto given = definitionAt(loaded, page->id(), offset);
    std::vector<ResultsList::Row> rows;
    for (const SourceRange& use : uses) {
        const SourceText& text = loaded.trees[use.file]->source();
        const std::uint32_t line = text.position(use.range.begin).line;
        rows.push_back({loaded.paths[use.file], m_document.texts().shown(loaded.paths[use.file]), line, use.range,
                        std::string(text.line(line)), given && given->place == use});
    }
    const QString name = QString::fromStdString(given ? given->name : std::string());
    const QString title = uses.size() == 1 ? tr("Only one reference: %1").arg(name)
                                           : tr("%1 has %2 references").arg(name, QString::number(uses.size()));
    m_uses.showRows(title, std::move(rows));
}

void TextAssistance::renameAt(std::uint32_t offset) {
    FilePage* page = m_pages.page();
    if (!page) return;
    m_pages.flush();
    if (page->id() == kNoFile) return;
    const std::optional<Symbol> symbol = symbolAt(*m_document.loaded(), page->id(), offset);
    if (!symbol) return showMessage(tr("There is no name to rename here"));
    CodeEdit& edit = page->edit();
    delete m_rename;
    m_rename = new RenameField(edit.viewport());
    const QString name = QString::fromStdString(symbol->name);
    const auto renaming = std::make_shared<ProjectRename>(m_document, symbol->path, symbol->name);
    connect(m_rename, &RenameField::closed, page, [page] { page->setFocus(); });
    connect(m_rename, &RenameField::renameRequested, page,
            [this, page, renaming, name](const QString& to) { rename(*page, *renaming, name, to); });
    connect(&m_document, &Document::changed, m_rename, &QWidget::hide); // the name may have changed
    m_rename->open(edit.geometry().placeOf(symbol->word.range.begin) - QPoint(4, edit.geometry().lineHeight() + 4), name);
    offerOthers(*renaming);
}

/// References in texts of the project that are not loaded would break: counts and lists them, and offers to rename them too.
void TextAssistance::offerOthers(const ProjectRename& renaming) {
    if (renaming.usesOutside().empty()) return;
    int uses = 0;
    QStringList lines;
    for (const ProjectRename::Use& use : renaming.usesOutside()) {
        uses += static_cast<int>(use.count);
        lines += tr("%1: %2").arg(QString::fromStdString(m_document.texts().shown(use.file)), QString::number(use.count));
    }
    if (!renaming.isComplete())
        lines += tr("Others were not read: the project has more than %1 files that import it").arg(ProjectRename::kMaxTexts);
    const auto files = static_cast<int>(renaming.usesOutside().size());
    const QString where =
        files == 1 ? tr("Also in %1, which is not loaded (%2)") : tr("Also in %1 files that are not loaded (%2)");
    const QString of =
        files == 1 ? QString::fromStdString(m_document.texts().shown(renaming.usesOutside()[0].file)) : QString::number(files);
    m_rename->offerOthers(where.arg(of, QString::number(uses)), lines.join(QLatin1Char('\n')));
}

void TextAssistance::rename(FilePage& page, ProjectRename& renaming, const QString& from, const QString& to) {
    if (to != from) {
        const Status done = renaming.apply(tr("Rename %1 to %2").arg(from, to), to.toStdString(), m_rename->renamesOthers());
        if (!done) return m_rename->showError(QString::fromStdString(done.error().message));
    }
    m_rename->hide();
    page.setFocus();
}

QMenu* TextAssistance::showFixes() {
    FilePage* page = m_pages.page();
    if (!page || !page->flush()) return nullptr;
    const std::uint32_t caret = page->edit().caret();
    const FileId file = page->id();
    if (file == kNoFile) return nullptr;
    const SourceText& text = m_document.loaded()->trees[file]->source();
    const auto lineOf = [&](std::uint32_t offset) { return text.position(offset).line; };
    std::vector<const Diagnostic*> problems;
    for (const bool exact : {true, false}) { // at the caret, else anywhere on its line
        for (const Diagnostic& problem : page->problems()) {
            const TextRange range = problem.range.range;
            const bool near =
                exact ? touches(range, caret) : lineOf(range.begin) <= lineOf(caret) && lineOf(caret) <= lineOf(range.end);
            if (near && !applicableFixes(*m_document.loaded(), problem).empty()) problems.push_back(&problem);
        }
        if (!problems.empty()) break;
    }
    if (problems.empty()) {
        showMessage(page->problems().empty() ? tr("No problems here") : tr("No fix available here"));
        return nullptr;
    }
    auto* menu = new QMenu(page);
    menu->setObjectName(QStringLiteral("fixMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* first = nullptr;
    for (const Diagnostic* problem : problems) {
        menu->addAction(withoutMnemonics(QString::fromStdString(problem->message)))->setEnabled(false);
        for (const Fix* fix : applicableFixes(*m_document.loaded(), *problem)) {
            QAction* action = menu->addAction(withoutMnemonics(QString::fromStdString(fix->title)));
            if (!first) first = action;
            connect(action, &QAction::triggered, this, [this, fix = Fix(*fix)] { (void)m_document.structure().applyFix(fix); });
        }
    }
    menu->setActiveAction(first);
    menu->popup(page->edit().viewport()->mapToGlobal(page->edit().geometry().placeOf(caret)));
    return menu;
}

void TextAssistance::formatText() {
    FilePage* page = m_pages.page();
    if (!page || !page->flush() || page->id() == kNoFile) return;
    const Tree& tree = *m_document.loaded()->trees[page->id()];
    const auto broken = std::any_of(tree.diagnostics().begin(), tree.diagnostics().end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::Error; });
    if (broken) return showMessage(tr("Fix the errors first; text with syntax errors cannot be formatted"));
    const std::string before = page->edit().bytes();
    const std::size_t signs = signsBefore(before, page->edit().caret());
    if (!m_document.edits().replaceText(tr("Format"), page->file(), format(tree))) return;
    const auto caret = static_cast<std::uint32_t>(placeBehind(page->edit().bytes(), signs));
    page->edit().select({caret, caret});
}

void TextAssistance::showMenu(FilePage& page, const QPoint& globalPos) {
    auto* menu = new QMenu(&page);
    menu->setObjectName(QStringLiteral("textMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& text, const char* id) {
        QAction* action = menu->addAction(text, this, [this, id] { (void)m_commands.apply(id); });
        action->setShortcut(m_actions.at(id).shortcut());
        action->setShortcutVisibleInContextMenu(true);
        return action;
    };
    const bool selected = page.edit().selection().size() > 0;
    add(tr("Cu&t"), "edit.cut")->setEnabled(selected);
    add(tr("&Copy"), "edit.copy")->setEnabled(selected);
    add(tr("&Paste"), "edit.paste");
    menu->addSeparator();
    for (const char* id : {"text.fix", "text.definition", "text.uses", "edit.rename"}) add(m_actions.at(id).text(), id);
    menu->addSeparator();
    for (const char* id : {"text.comment", "text.format"}) add(m_actions.at(id).text(), id);
    menu->popup(globalPos);
}

} // namespace trundle
