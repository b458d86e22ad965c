#pragma once
// The Library dock: robots, arenas, objects, parts and kinds to be dragged into views and tree, with pictures.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QDateTime>
#include <QThreadPool>
#include <QWidget>

#include "editor/outline/library_item.h"
#include "schema/kind.h"

class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace trundle {

class Document;
class LibraryList;
class LibraryModel;
class LibraryPictures;
class LibrarySectionFilter;
class ObjectEdits;
class Parts;
class Registry;
class RenderService;
class Selection;
struct Locations;

class LibraryPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null where no OpenGL is to be had: icons stand for pictures. All outlive this but `places`.
    LibraryPanel(Document& document, Selection& selection, Parts& parts, RenderService* render, const Locations& places,
                 QWidget* parent = nullptr);
    ~LibraryPanel() override;

    [[nodiscard]] LibraryModel& model() { return *m_model; }
    /// Puts an item in where the selection is, a robot or scenery at the origin: what a double click does.
    void insert(const LibraryItem& item);
    [[nodiscard]] bool isReading() const { return m_reading > 0; } ///< folders are being looked through
    /// All that can be found is there, and all pictures of it.
    [[nodiscard]] bool isSettled() const;

private:
    struct Section;
    void build();
    void addSection(LibrarySection section, QVBoxLayout& layout);
    void readFolders();
    [[nodiscard]] QDateTime lastWritten() const; ///< any file of what is open
    void showItems();
    void setWords(const QString& text);
    void setAsList(bool list);
    void fitSections();
    void step(std::size_t from, int by);
    [[nodiscard]] std::string textOf(const LibraryItem& item) const;
    [[nodiscard]] std::string fittedTo(const LibraryItem& item) const;
    [[nodiscard]] std::vector<LibraryItem> ownConfigs() const;
    [[nodiscard]] const Kind* kindOf(const std::string& name) const;

    Document& m_document;
    Selection& m_selection;
    Parts& m_parts;
    const std::string m_configs, m_resources, m_modules; ///< folders of the program
    ObjectEdits* m_edits;
    LibraryModel* m_model;
    LibraryPictures* m_pictures;
    std::vector<Section> m_sections;
    QLineEdit* m_search = nullptr;
    QToolButton* m_asList = nullptr;
    std::vector<LibraryItem> m_found;                 ///< in files
    std::map<std::string, std::string> m_ownPictures; ///< of configs of the opened file, as they were when folders were read last
    std::vector<Kind> m_moduleKinds;
    std::shared_ptr<const Registry> m_registry; ///< of the kinds that are shown
    std::vector<std::string> m_ownNames;        ///< of configs of the opened file that are shown
    QDateTime m_readOf;                         ///< what was written last when the folders were read
    int m_reading = 0;
    std::uint64_t m_readings = 0;
    QThreadPool m_pool; // reads folders; the last member, so that it ends first
};

} // namespace trundle
