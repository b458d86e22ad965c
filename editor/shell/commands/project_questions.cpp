#include "editor/shell/commands/project_questions.h"

#include <utility>

#include <QAbstractButton>
#include <QMessageBox>
#include <QPushButton>

#include "editor/document/document.h"
#include "editor/document/found_journals.h"
#include "editor/document/structure_edits.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/dialogs/crash_reports.h"
#include "editor/shell/dialogs/line_diff.h"
#include "editor/shell/dialogs/recovery_dialog.h"
#include "editor/shell/dialogs/share_dialog.h"
#include "editor/widgets/plain_text.h"

namespace trundle {

ProjectQuestions::ProjectQuestions(QWidget& window, Document& document, FileCommands& files)
    : QObject(&window), m_window(window), m_document(document), m_files(files) {
    connect(&document.disk(), &ExternalChanges::conflictFound, this, &ProjectQuestions::askAboutDiskChange);
    connect(&document, &Document::opened, this, &ProjectQuestions::offerRecovery, Qt::QueuedConnection);
    connect(&document.access(), &ProjectAccess::changed, this, &ProjectQuestions::showReadOnly);
    document.structure().setShareQuestionHandler(
        [&window](const ShareQuestion& question, const StructureEdits::ShareAnswer& answer) {
            askAboutSharedConfig(&window, question, answer);
        });
    QMetaObject::invokeMethod(this, &ProjectQuestions::offerRecovery, Qt::QueuedConnection); // new texts that were never saved
}

void ProjectQuestions::offerRecovery() {
    if (m_document.access().isReadOnly()) return; // offered when it becomes editable
    for (const auto* report : m_window.findChildren<QMessageBox*>(QStringLiteral("crashReport")))
        if (report->isVisible()) return; // offered when it is closed
    reportJournals();
    std::vector<Recovery> found = m_document.recovery().recoveries();
    if (found.empty()) return;
    for (auto* asked : m_window.findChildren<RecoveryDialog*>()) asked->close(); // the new dialog includes their content
    auto* dialog = new RecoveryDialog(
        m_document, std::move(found), [this] { return m_files.confirmClose(); }, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void ProjectQuestions::showCrashReports(const QString& folder) {
    const QString text = takeCrashReports(folder);
    if (text.isEmpty()) return;
    auto* message = new QMessageBox(QMessageBox::Warning, tr("Trundle closed unexpectedly"), text, QMessageBox::Ok, &m_window);
    message->setObjectName(QStringLiteral("crashReport"));
    message->setInformativeText(
        tr("Logs were written up to that moment. Unsaved edits are offered when their file is opened again."));
    message->setAttribute(Qt::WA_DeleteOnClose);
    connect(message, &QDialog::finished, this, &ProjectQuestions::offerRecovery, Qt::QueuedConnection);
    message->open();
}

/// Reports each message once.
void ProjectQuestions::reportJournals() {
    const QString text = journalsNotRead(m_document);
    if (text.isEmpty() || text == std::exchange(m_reportedJournals, text)) return;
    auto* message =
        new QMessageBox(QMessageBox::Information, tr("Unsaved edits were not restored"), text, QMessageBox::Ok, &m_window);
    message->setObjectName(QStringLiteral("journalsNotRead"));
    message->setAttribute(Qt::WA_DeleteOnClose);
    message->open();
}

void ProjectQuestions::showReadOnly(const QString& holder) {
    for (auto* asked : m_window.findChildren<QMessageBox*>(QStringLiteral("lockQuestion")))
        asked->close(); // the question is obsolete
    if (holder.isEmpty()) {
        QMetaObject::invokeMethod(this, &ProjectQuestions::offerRecovery, Qt::QueuedConnection); // those of the other window
        return;
    }
    auto* question = new QMessageBox(QMessageBox::Information, tr("Open elsewhere"),
                                     tr("This project is open in %1.").arg(holder), QMessageBox::NoButton, &m_window);
    question->setObjectName(QStringLiteral("lockQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(tr("It can be viewed and run here, but not edited."));
    question->setEscapeButton(question->addButton(tr("Open Read-Only"), QMessageBox::AcceptRole));
    const auto* edit = question->addButton(tr("Edit Anyway"), QMessageBox::DestructiveRole);
    connect(question, &QMessageBox::buttonClicked, this, [this, edit](QAbstractButton* button) {
        if (button == edit) m_document.access().editAnyway();
    });
    question->open();
}

void ProjectQuestions::askAboutDiskChange(const QString& file) {
    const auto mineNow = m_document.texts().text(file.toStdString()), theirs = m_document.disk().conflicts()[file.toStdString()];
    if (!mineNow || !theirs) return;
    for (auto* asked : m_window.findChildren<QMessageBox*>(QStringLiteral("diskQuestion")))
        if (asked->property("file") == file) delete asked; // the file changed again meanwhile
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Changed on disk"),
                        tr("Another program changed %1, which has unsaved edits here, and both change the same lines.")
                            .arg(QString::fromStdString(m_document.texts().shown(file.toStdString()))),
                        QMessageBox::NoButton, &m_window);
    question->setObjectName(QStringLiteral("diskQuestion"));
    question->setProperty("file", file);
    question->setAttribute(Qt::WA_DeleteOnClose);
    setHtmlInformation(*question, tr("Loading it from disk would change this; it can be undone.") +
                                      diffAsHtml(inShort(diffLines(*mineNow, *theirs, 1))));
    QPushButton* mine = question->addButton(tr("Keep My Version"), QMessageBox::RejectRole);
    question->setDefaultButton(mine);
    question->addButton(tr("Load From Disk"), QMessageBox::AcceptRole);
    connect(question, &QMessageBox::buttonClicked, this, [this, file, mine](QAbstractButton* button) {
        (void)m_document.disk().resolve(file.toStdString(),
                                        button == mine ? ExternalChanges::Resolution::Mine : ExternalChanges::Resolution::Theirs);
    });
    question->open();
}

} // namespace trundle
