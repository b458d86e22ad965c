#include "editor/shell/help_panel.h"

#include <algorithm>

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QImageReader>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextTable>

#include "editor/shell/guide_bar.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/theme.h"

namespace trundle {

static QString guideFolder() { return resourcePath(QStringLiteral("guide")); }

HelpPanel::HelpPanel(QWidget* parent)
    : QTextBrowser(parent), m_index(guideFolder()),
      m_bar(new GuideBar(*this, {[this] { showKind(nullptr); }, [this](const QString& words) { return findNext(words); }})) {
    setObjectName(QStringLiteral("guide"));
    setOpenExternalLinks(true);
    document()->setDocumentMargin(14);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // a scroll bar that appears would change the size of the images
    QScrollBar* bar = verticalScrollBar();
    bar->setEnabled(false); // disabled while there is nothing to scroll
    connect(bar, &QScrollBar::rangeChanged, bar, [bar](int least, int most) { bar->setEnabled(most > least); });
    placeBar();
    connect(this, &QTextBrowser::sourceChanged, this, &HelpPanel::onSourceChanged);
    showKind(nullptr);
}

void HelpPanel::showKind(const Kind* kind) { showPlace(kind ? m_index.placeOf(*kind) : QString()); }

void HelpPanel::showConstruct(const QString& word) { showPlace(m_index.placeOf(word)); }

/// "language.md#geoms"; empty: the first page.
void HelpPanel::showPlace(const QString& place) {
    QUrl url = QUrl::fromLocalFile(guideFolder() + QLatin1Char('/') +
                                   (place.isEmpty() ? QStringLiteral("index.md") : place.section(QLatin1Char('#'), 0, 0)));
    if (place.contains(QLatin1Char('#'))) url.setFragment(place.section(QLatin1Char('#'), 1));
    if (url == source()) scrollToAnchor(url.fragment());
    else setSource(url, QTextDocument::MarkdownResource);
}

/// A link within the current page does not reload it. source() still returns the previous URL here.
void HelpPanel::onSourceChanged(const QUrl& source) {
    const QTextBlock title = document()->begin(); // setType() has run if the title has its anchor
    if (title.begin().atEnd() || !title.begin().fragment().charFormat().isAnchor()) setType();
    if (source.hasFragment()) scrollToAnchor(source.fragment()); // the headings have no anchors before setType()
}

/// Replaces the format of Markdown tables, which have a white double frame, and removes an empty header row.
static void setTable(QTextTable& table) {
    QTextTableFormat format = table.format();
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(ink(Ink::Line));
    format.setCellPadding(4);
    format.setCellSpacing(0);
    format.setTopMargin(6);
    format.setBottomMargin(10);
    table.setFormat(format);
    bool empty = table.rows() > 1;
    for (int column = 0; column < table.columns(); ++column) {
        const QTextTableCell cell = table.cellAt(0, column);
        empty = empty && cell.firstCursorPosition() == cell.lastCursorPosition();
    }
    if (empty) table.removeRows(0, 1);
}

/// Sets paragraph spacing, fonts and heading anchors, which Markdown documents lack.
void HelpPanel::setType() {
    QTextCursor all(document());
    all.beginEditBlock(); // a single layout at the end
    for (QTextFrame* frame : document()->rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) setTable(*table);
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat room = block.blockFormat();
        const bool heading = room.headingLevel() > 0;
        const auto isCode = [](const QTextBlock& b) { return b.isValid() && b.blockFormat().nonBreakableLines(); };
        const bool code = isCode(block), inTable = cursor.currentTable() != nullptr;
        const bool picture = block.text().contains(QChar::ObjectReplacementCharacter); // no extra height for images
        room.setLineHeight(heading || picture ? 100 : 120, QTextBlockFormat::ProportionalHeight);
        room.setTopMargin(heading && block.position() > 0 ? 14 : code || inTable ? 0 : 2);
        room.setBottomMargin(inTable || (code && isCode(block.next())) ? 0 : block.textList() ? 2 : 6);
        cursor.setBlockFormat(room);
        if (heading) {
            QTextCharFormat anchor;
            anchor.setAnchor(true);
            anchor.setAnchorNames({headingAnchor(block.text())});
            cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
            cursor.mergeCharFormat(anchor);
        }
        std::vector<QTextFragment> context;
        for (auto part = block.begin(); !part.atEnd(); ++part) context.push_back(part.fragment());
        for (const QTextFragment& part : context) {
            QTextCharFormat own;
            if (part.charFormat().fontWeight() > QFont::DemiBold) own.setFontWeight(QFont::DemiBold);
            if (part.charFormat().fontFixedPitch()) own.setFontFamilies({monospaceFont().family()});
            if (own.isEmpty()) continue;
            cursor.setPosition(part.position());
            cursor.setPosition(part.position() + part.length(), QTextCursor::KeepAnchor);
            cursor.mergeCharFormat(own);
        }
    }
    fitPictures();
    all.endEditBlock();
}

/// Scales images down to the width of the panel.
void HelpPanel::fitPictures() {
    const int room = std::max(120, viewport()->width() - 2 * int(document()->documentMargin()));
    QTextCursor all(document());
    all.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        std::vector<QTextFragment> pictures;
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().isImageFormat()) pictures.push_back(part.fragment());
        for (const QTextFragment& part : pictures) {
            QTextImageFormat format = part.charFormat().toImageFormat();
            const QSize size = QImageReader(source().resolved(QUrl(format.name())).toLocalFile()).size();
            if (size.isEmpty()) continue;
            QTextCursor cursor(block);
            const int width = std::min(size.width(), cursor.currentTable() ? room / 2 - 12 : room);
            if (format.width() == width) continue;
            format.setWidth(width);
            format.setHeight(double(size.height()) * width / size.width());
            cursor.setPosition(part.position());
            cursor.setPosition(part.position() + part.length(), QTextCursor::KeepAnchor);
            cursor.setCharFormat(format);
        }
    }
    all.endEditBlock();
}

void HelpPanel::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    placeBar();
    fitPictures();
}

void HelpPanel::placeBar() {
    const int height = m_bar->sizeHint().height();
    if (viewportMargins().top() != height) setViewportMargins(0, height, 0, 0);
    m_bar->setGeometry(0, 0, viewport()->width(), height);
}

/// The Find of a page is that of the guide.
bool HelpPanel::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Find)) {
        m_bar->focusSearch();
        event->accept();
        return true;
    }
    return QTextBrowser::event(event);
}

bool HelpPanel::findNext(const QString& words) {
    if (find(words)) return true;
    const QDir folder(guideFolder());
    const QStringList pages = folder.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
    const qsizetype here = pages.indexOf(source().fileName());
    for (qsizetype i = 1; i <= pages.size(); ++i) {
        const QString& page = pages[(std::max<qsizetype>(here, 0) + i) % pages.size()];
        QFile file(folder.filePath(page));
        if (!file.open(QIODevice::ReadOnly) || !QString::fromUtf8(file.readAll()).contains(words, Qt::CaseInsensitive)) continue;
        showPlace(page);
        moveCursor(QTextCursor::Start);
        if (find(words)) return true;
    }
    return false;
}

QVariant HelpPanel::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::MarkdownResource) return QTextBrowser::loadResource(type, name);
    QFile file(name.toLocalFile());
    if (!file.open(QIODevice::ReadOnly)) return tr("# Not found\n\nThere is no page %1.").arg(name.fileName());
    return QString::fromUtf8(file.readAll());
}

void HelpPanel::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || source().isEmpty()) return;
    reload();
    setType();
}

} // namespace trundle
