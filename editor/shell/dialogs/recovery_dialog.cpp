#include "editor/shell/dialogs/recovery_dialog.h"

#include <algorithm>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/shell/dialogs/line_diff.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

QByteArray onDisk(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

RecoveryDialog::RecoveryDialog(Document& document, std::vector<Recovery> found, std::function<bool()> confirmClose,
                               QWidget* parent)
    : QDialog(parent), m_document(document), m_found(std::move(found)), m_confirmClose(std::move(confirmClose)) {
    setObjectName(QStringLiteral("recovery"));
    setWindowTitle(tr("Unsaved work was found"));
    resizeToFont(*this, {760, 480});
    auto* text = new QLabel(tr("Trundle closed unexpectedly. These edits were not saved; their changes are shown below."));
    text->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("recoveries"));
    m_list->setMaximumHeight(scaledToFont(110));
    m_preview->setObjectName(QStringLiteral("recoveryPreview"));
    m_preview->setOpenLinks(false);
    useMonospaceFont(*m_preview);
    m_preview->setFrameShape(QFrame::StyledPanel);
    auto* back = new QPushButton(tr("Restore"));
    auto* drop = new QPushButton(tr("Discard"));
    auto* later = new QPushButton(tr("Later"));
    back->setObjectName(QStringLiteral("restoreEdits"));
    drop->setObjectName(QStringLiteral("discardEdits"));
    back->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(drop);
    buttons->addStretch(1);
    buttons->addWidget(later);
    buttons->addWidget(back);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(m_list);
    layout->addWidget(m_preview, 1);
    layout->addLayout(buttons);
    connect(m_list, &QListWidget::currentRowChanged, this, &RecoveryDialog::show);
    connect(back, &QPushButton::clicked, this, &RecoveryDialog::restore);
    connect(drop, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    // After the list was inserted, since the style determines the row height.
    for (const Recovery& r : m_found) {
        const QFileInfo file(QString::fromStdString(r.head.opened));
        const QString name =
            r.head.name.empty()
                ? tr("%1 in %2").arg(shownLine(file.fileName().toStdString()), shownLine(file.dir().dirName().toStdString()))
                : shownLine(r.head.name);
        const QString when = QLocale().toString(QDateTime::fromSecsSinceEpoch(r.time), QLocale::ShortFormat);
        const std::size_t files = r.files.size();
        m_list->addItem(files == 1 ? tr("%1, %2").arg(name, when)
                                   : tr("%1, %2, %3 files").arg(name, when, QString::number(files)));
    }
    m_list->setCurrentRow(0);
}

void RecoveryDialog::show(int row) {
    if (row < 0 || row >= int(m_found.size())) return m_preview->clear();
    const Recovery& recovery = m_found[std::size_t(row)];
    const std::vector<std::string> outside = filesOutside(recovery, m_document.recovery().foldersOf(recovery.project));
    const auto isOutside = [&](const std::string& path) { return std::ranges::find(outside, path) != outside.end(); };
    const auto heading = [](const std::string& path) { return shownLine(path).toHtmlEscaped(); };
    QString html = QStringLiteral("<p>%1</p><ul>")
                       .arg(recovery.files.size() == 1 ? tr("This file changes:").toHtmlEscaped()
                                                       : tr("These files change:").toHtmlEscaped());
    for (const auto& [path, recovered] : recovery.files) {
        html += QStringLiteral("<li>%1").arg(heading(path));
        if (isOutside(path))
            html += QStringLiteral(" <span style='color:%1'>%2</span>")
                        .arg(ink(Ink::Error).name(), tr("– not restored: it is outside the project").toHtmlEscaped());
        else if (recovered.isCreated && recovered.text.empty())
            html += u' ' + tr("– removed by the next save, since the edit that created it was undone").toHtmlEscaped();
        html += QStringLiteral("</li>");
    }
    html += QStringLiteral("</ul>");
    for (const auto& [path, recovered] : recovery.files) {
        html += QStringLiteral("<p style='font-weight:600'>%1</p>").arg(heading(path));
        html += isOutside(path)
                    ? diffAsHtml(diffLines(recovered.base, recovered.text)) // its file is not read
                    : diffAsHtml(diffLines(onDisk(path).toStdString(), DocumentRecovery::recoveredText(path, recovered)));
    }
    m_preview->setHtml(html);
}

void RecoveryDialog::restore() {
    const int row = m_list->currentRow();
    if (row < 0) return;
    if (m_document.recovery().isReplacedBy(m_found[std::size_t(row)]) && !m_confirmClose()) return;
    if (const Status done = m_document.recovery().recover(m_found[std::size_t(row)]); !done) {
        QMessageBox::warning(this, tr("Not restored"), QString::fromStdString(done.error().message));
        return;
    }
    accept();
}

void RecoveryDialog::discard() {
    const int row = m_list->currentRow();
    if (row < 0) return;
    QMessageBox question(QMessageBox::Warning, tr("Discard?"), tr("These edits cannot be restored afterwards."),
                         QMessageBox::Discard | QMessageBox::Cancel, this);
    question.setObjectName(QStringLiteral("discardQuestion"));
    question.setDefaultButton(QMessageBox::Cancel);
    if (question.exec() != QMessageBox::Discard) return;
    discardRecovery(m_found[std::size_t(row)]);
    m_found.erase(m_found.begin() + row);
    delete m_list->takeItem(row);
    if (m_found.empty()) accept();
    else show(m_list->currentRow());
}

} // namespace trundle
