#pragma once
// The document's files in tabs, the opened file first, others on demand.

#include <memory>
#include <string>
#include <vector>

#include <QTabWidget>

#include "base/source_range.h"

class QMenu;

namespace trundle {

class Document;
class FilePage;
class History;
struct Diagnostic;
struct LoadedProject;
struct ModelProblems;

class TextPages final : public QTabWidget {
    Q_OBJECT
public:
    /// `document` must outlive this object.
    explicit TextPages(Document& document, QWidget* parent = nullptr);
    ~TextPages() override;
    void abandon(); ///< drops pending text and emits nothing more; before what listens to the pages is destroyed

    [[nodiscard]] FilePage* page() const; ///< the current page; nullptr if nothing is open
    [[nodiscard]] FilePage* pageOf(const std::string& file) const;
    [[nodiscard]] std::vector<FilePage*> pages() const;

    /// Passes all typed text to the document. The pages call it themselves on any other keyboard or mouse action, and 10 to 400 ms
    /// after the first key.
    void flush();
    /// Shows the file's tab, also of a text that is not imported; nullptr if it cannot be read.
    FilePage* openFile(const std::string& file);
    /// Opens the file's tab and selects the range. Takes the focus only with `focus`.
    void reveal(const std::string& file, TextRange range, bool focus = false);
    void reveal(const SourceRange& place, bool focus);
    void setModelProblems(std::shared_ptr<const ModelProblems> problems);

    /// The messages of a build, and the texts that they are about.
    void setBuildProblems(const std::vector<Diagnostic>& found, const std::shared_ptr<const LoadedProject>& sources);

    void closeAll();     ///< the document is another one
    void showOpened();   ///< shows the document's opened file; others follow on demand
    void follow();       ///< the document changed
    void showModified(); ///< other files are modified
    /// One action for each file of the document.
    void fillFileMenu(QMenu& menu);

Q_SIGNALS:
    void pageAdded(trundle::FilePage* page);
    void refused(const QString& reason); ///< a file could not be opened

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watchForOthers();
    FilePage* addPage(const std::string& file);
    void connectPage(FilePage& page);
    void closePage(int index);
    void removePage(FilePage& page);
    void showTitles();
    void showBuild(FilePage& page) const;
    void showStep(const History& history, std::size_t before);

    Document& m_document;
    std::shared_ptr<const ModelProblems> m_modelProblems;
    std::shared_ptr<const ModelProblems> m_build; ///< of the last build
    std::string m_opened;                ///< path of the opened file at the last update
    std::vector<std::string> m_modified; ///< modified files at the last update
    std::size_t m_historyAt = 0, m_historySize = 0;
    bool m_stepping = false; ///< undo or redo is running
    bool m_watching = false;
};

} // namespace trundle
