#pragma once
// Find and replace in the current text or in all files of the document, with a list of results.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "editor/text/search/project_texts.h"
#include "editor/text/search/text_search.h"
#include "lang/source_text.h"

namespace trundle {

class Document;
class FindBar;
class ResultsList;
class TextPages;

class FindSession final : public QObject {
    Q_OBJECT
public:
    FindSession(Document& document, TextPages& pages, FindBar& bar, ResultsList& list, QObject* parent = nullptr);

    void open(bool replacing); ///< searches for the selected text
    void openInFiles();
    void close();

private:
    struct FileMatches {
        std::string file;
        TextMatch match;
    };
    void searchProject(const TextSearch& search);
    void updateMatches(); ///< searches, and updates marks and list
    void list();
    void count(); ///< shows the index of the selected match
    void step(int direction);
    void findAsTyped();
    void go(FileMatches found);
    [[nodiscard]] std::ptrdiff_t here() const; ///< index of the selected match; -1: none
    void replaceOne();
    void replaceAll();

    Document& m_document;
    TextPages& m_pages;
    FindBar& m_bar;
    ResultsList& m_list;
    ProjectTexts m_project;
    std::map<std::string, std::shared_ptr<const SourceText>> m_others; ///< texts with matches that the experiment does not load
    std::vector<FileMatches> m_found;                                  ///< by file and offset
    std::string m_fromFile;                                            ///< file of the caret when the search began
    std::uint32_t m_from = 0;
};

} // namespace trundle
