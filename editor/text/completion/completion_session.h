#pragma once
// Completion while typing: when the list opens, how it is filtered, and what a chosen item inserts.

#include <functional>

#include <QObject>
#include <QPointer>

#include "editor/text/completion/completion.h"
#include "editor/text/pages/file_page.h"

class QKeyEvent;

namespace trundle {

class CompletionPopup;
class Document;

class CompletionSession final : public QObject {
    Q_OBJECT
public:
    /// `folders` is called each time, since the result depends on the open project.
    CompletionSession(Document& document, std::function<FileFolders()> folders, QWidget* owner);
    ~CompletionSession() override;

    void watch(FilePage& page);
    /// Lists the completions at the caret, even if nothing is typed yet.
    void ask(FilePage& page) { list(page, true, true); }
    void close();
    [[nodiscard]] bool isShown() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void list(FilePage& page, bool asked, bool fresh);
    void onEdited(FilePage& page, std::string_view inserted);
    void narrow(FilePage& page);
    void show(FilePage& page);
    void accept();
    [[nodiscard]] bool canHandleKey(const QKeyEvent& event);
    [[nodiscard]] bool isThereAlready(const QString& typed);
    [[nodiscard]] bool continueBlock(const QKeyEvent& event);
    [[nodiscard]] std::string typed(FilePage& page) const;

    Document& m_document;
    std::function<FileFolders()> m_folders;
    CompletionPopup* m_popup;
    QPointer<FilePage> m_page; ///< the page that the list belongs to
    Completions m_found;
    std::vector<const Completion*> m_shown; ///< subset of m_found
    std::uint32_t m_behind = 0;             ///< bytes of the word after the caret
    bool m_wanted = false;                  ///< open the list when the document has the typed text
    bool m_asked = false;
    QString m_insertedSuffix;     ///< characters before the caret that the last completion inserted; cleared by other typing
    QPointer<FilePage> m_namedIn; ///< the page with a new block whose name is being typed
    std::string m_afterName;      ///< text between that name and the next value to fill in; empty: none
    bool m_accepting = false;
};

} // namespace trundle
