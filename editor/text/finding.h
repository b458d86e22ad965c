#pragma once
// Find and replace: in the text in front or in every file of the document, with a list of what was found.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "editor/text/project_texts.h"
#include "editor/text/text_search.h"
#include "lang/source_text.h"

namespace trundle {

class Document;
class FindBar;
class ResultsList;
class TextPanel;

class Finding final : public QObject {
    Q_OBJECT
public:
    Finding(Document& document, TextPanel& panel, FindBar& bar, ResultsList& list);

    void open(bool replacing); ///< with the words that are selected
    void openInFiles();
    void close();

private:
    struct Found {
        std::string file;
        TextMatch match;
    };
    void searchProject(const TextSearch& search);
    void look();  ///< finds all, marks and lists them
    void list();
    void count(); ///< says which of how many the selection is
    void step(int direction);
    void lookAsTyped();
    void go(const Found& found);
    [[nodiscard]] std::ptrdiff_t here() const; ///< index of the match that is selected; -1: none is
    void replaceOne();
    void replaceAll();

    Document& m_document;
    TextPanel& m_panel;
    FindBar& m_bar;
    ResultsList& m_list;
    ProjectTexts m_project;
    std::map<std::string, std::shared_ptr<const SourceText>> m_others; ///< texts with matches that the experiment does not load
    std::vector<Found> m_found; ///< in order of files and places
    std::string m_fromFile;     ///< where the caret was when one began to type
    std::uint32_t m_from = 0;
};

} // namespace trundle
