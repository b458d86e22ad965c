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
    setSource(QUrl::fromLocalFile(resourcePath(QStringLiteral("guide/index.md"))), QTextDocument::MarkdownResource);
}

QVariant HelpPanel::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::MarkdownResource) return QTextBrowser::loadResource(type, name);
    QFile file(name.toLocalFile());
    if (!file.open(QIODevice::ReadOnly)) return tr("# Not found\n\nThere is no page %1.").arg(name.fileName());
    return QString::fromUtf8(file.readAll());
}

void HelpPanel::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !source().isEmpty()) reload();
}

} // namespace trundle
