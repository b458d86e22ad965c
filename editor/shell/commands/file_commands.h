#pragma once
#include <functional>

#include <QMenu>
#include <QObject>
#include <QPointer>
#include <QProgressDialog>
#include <QWidget>

#include "editor/document/document.h"
#include "editor/widgets/actions.h"

namespace trundle {

/// New, open, save and close: the commands of the File menu with their questions. Unsaved changes are discarded only after a
/// question.
class FileCommands final : public QObject {
    Q_OBJECT
public:
    FileCommands(QWidget& window, Document& document, Actions& actions, QString configs);

    /// Asks about unsaved changes, then starts to open a file. False if the user cancelled.
    bool open(const QString& path);
    /// A new experiment with one instance of a robot or arena installed with Trundle, so that it can be viewed and driven: its
    /// file has no instance.
    void tryOut(const QString& path);
    /// True if nothing is unsaved any more, or the user discards it.
    [[nodiscard]] bool confirmClose();
    /// Writes every changed file; asks where to if the experiment has no file of its own yet. False if something is not saved.
    bool save();
    /// A menu of recent files.
    [[nodiscard]] QMenu* makeRecentMenu();
    /// Called before texts are saved or their state is queried: panels must pass pending text to the document.
    void setFlush(std::function<void()> flush) { m_flush = std::move(flush); }

public Q_SLOTS:
    void reportNotOpened(const QString& path, const QString& reason);

private:
    void close();
    void newFrom(const char* templateName);
    void makeNew(const QString& subject, const QByteArray& text);
    void choose();
    void showOpening(const QString& path);
    void endOpening();
    bool saveAs();
    void report(const QString& title, const Status& status);

    QWidget& m_window;
    Document& m_document;
    QString m_configs;
    std::function<void()> m_flush = [] {};
    QPointer<QProgressDialog> m_progress; ///< shown while a file is opened
};

} // namespace trundle
