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

/// New, open, save, close: the flows of the File menu with their questions. Nothing is lost without an answer.
class FileCommands final : public QObject {
    Q_OBJECT
public:
    FileCommands(QWidget& window, Document& document, Actions& actions, QString configs);

    /// Begins to open a file, after asking about unsaved changes. False where it did not come to that.
    bool open(const QString& path);
    /// A new experiment with a robot or an arena that came with the program, so that it is seen and can be driven: a plan alone
    /// stands nowhere.
    void tryOut(const QString& path);
    /// True where nothing is unsaved any more, or the user lets it go.
    [[nodiscard]] bool mayLeave();
    /// A menu of files opened lately.
    [[nodiscard]] QMenu* makeRecentMenu();
    /// Called before texts are written or asked for: parts that hold typed text hand it over.
    void setFlush(std::function<void()> flush) { m_flush = std::move(flush); }

public Q_SLOTS:
    void sayNotOpened(const QString& path, const QString& reason);

private:
    void close();
    void newFrom(const char* templateName);
    void makeNew(const QString& subject, const QByteArray& text);
    void choose();
    void showOpening(const QString& path);
    bool save();
    bool saveAs();
    void tell(const QString& title, const Status& status);

    QWidget& m_window;
    Document& m_document;
    QString m_configs;
    std::function<void()> m_flush = [] {};
    QPointer<QProgressDialog> m_progress; ///< of what is being opened
};

} // namespace trundle
