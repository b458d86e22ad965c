#pragma once
#include <QObject>
#include <QWidget>

namespace trundle {

class Document;
class FileCommands;

/// What the window asks and reports about the open project without being asked: unsaved edits of an earlier start, another window
/// that has it open, files that another program changed, configs with several users, crashes.
class ProjectQuestions final : public QObject {
    Q_OBJECT
public:
    /// All arguments must outlive this object.
    ProjectQuestions(QWidget& window, Document& document, FileCommands& files);

    /// Shows and removes the reports of windows that crashed, in `folder`; see keepCrashReport().
    void showCrashReports(const QString& folder);

private:
    void offerRecovery();
    void reportJournals();
    void showReadOnly(const QString& holder);
    void askAboutDiskChange(const QString& file);

    QWidget& m_window;
    Document& m_document;
    FileCommands& m_files;
    QString m_reportedJournals; ///< the last message of reportJournals()
};

} // namespace trundle
