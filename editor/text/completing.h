#pragma once
// Completion while typing: when the list comes, how it narrows, what a choice puts into the text.

#include <functional>

#include <QObject>
#include <QPointer>

#include "editor/text/completion.h"
#include "editor/text/file_page.h"

class QKeyEvent;

namespace trundle {

class CompletionPopup;
class Document;

class Completing final : public QObject {
    Q_OBJECT
public:
    /// `folders` is asked each time, since it depends on what is open.
    Completing(Document& document, std::function<FileFolders()> folders, QWidget* owner);
    ~Completing() override;

    void watch(FilePage& page);
    /// Lists what may stand at the caret, also where nothing is typed yet.
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
    [[nodiscard]] bool takesKey(const QKeyEvent& event);
    [[nodiscard]] bool isThereAlready(const QString& typed);
    [[nodiscard]] bool goesOn(const QKeyEvent& event);
    [[nodiscard]] std::string typed(FilePage& page) const;

    Document& m_document;
    std::function<FileFolders()> m_folders;
    CompletionPopup* m_popup;
    QPointer<FilePage> m_page; ///< the one the list is for
    Completions m_found;
    std::vector<const Completion*> m_shown; ///< of m_found
    std::uint32_t m_behind = 0;             ///< bytes of the word that stand behind the caret
    bool m_wanted = false;                  ///< what was typed calls for the list once the document has it
    bool m_asked = false;
    QString m_brought;            ///< signs that the last choice put before the caret, while nothing else was typed
    QPointer<FilePage> m_namedIn; ///< where a block came whose name is being typed
    std::string m_afterName;      ///< what stands between that name and the first place to fill in behind it; empty: nothing is
    bool m_accepting = false;
};

} // namespace trundle
