#include "editor/shell/help_panel.h"

#include <QEvent>
#include <QFile>
#include <QTextBlock>
#include <QTextDocument>

#include "editor/widgets/resources.h"
#include "editor/widgets/theme.h"

namespace trundle {

HelpPanel::HelpPanel(QWidget* parent) : QTextBrowser(parent) {
    setObjectName(QStringLiteral("guide"));
    setOpenExternalLinks(true);
    document()->setDocumentMargin(14);
    connect(this, &QTextBrowser::sourceChanged, this, &HelpPanel::setType);
    setSource(QUrl::fromLocalFile(resourcePath(QStringLiteral("guide/index.md"))), QTextDocument::MarkdownResource);
}

/// Markdown comes without room between its paragraphs, and in fonts that are not the window's.
void HelpPanel::setType() {
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat room = block.blockFormat();
        const bool heading = room.headingLevel() > 0;
        room.setLineHeight(heading ? 100 : 120, QTextBlockFormat::ProportionalHeight);
        room.setTopMargin(heading && block.position() > 0 ? 14 : 2);
        room.setBottomMargin(block.textList() ? 2 : 6);
        cursor.setBlockFormat(room);
        std::vector<QTextFragment> parts;
        for (auto part = block.begin(); !part.atEnd(); ++part) parts.push_back(part.fragment());
        for (const QTextFragment& part : parts) {
            QTextCharFormat own;
            if (part.charFormat().fontWeight() > QFont::DemiBold) own.setFontWeight(QFont::DemiBold);
            if (part.charFormat().fontFixedPitch()) own.setFontFamilies({monospaceFont().family()});
            if (own.isEmpty()) continue;
            cursor.setPosition(part.position());
            cursor.setPosition(part.position() + part.length(), QTextCursor::KeepAnchor);
            cursor.mergeCharFormat(own);
        }
    }
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
