#pragma once
// The Library dock: robots, arenas, objects, parts and kinds with previews, to be dragged into viewports and the outline.

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
class Application;
class Registry;
class RenderService;
class Selection;
struct Locations;

class LibraryPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null without OpenGL; icons are shown instead of previews. All arguments except `places` must outlive this.
    LibraryPanel(Document& document, Selection& selection, Application& application, RenderService* render,
                 const Locations& places, QWidget* parent = nullptr);
    ~LibraryPanel() override;

    [[nodiscard]] LibraryModel& model() { return *m_model; }
    [[nodiscard]] ObjectEdits& edits() { return *m_edits; }
    /// Inserts an item at the selection, a robot or scenery near the insertion point of edits(). Used on double click.
    void insert(const LibraryItem& item);
    [[nodiscard]] bool isReading() const { return m_reading > 0; } ///< a worker thread is reading folders
    /// All folders are read and all previews are rendered. For tests.
    [[nodiscard]] bool isSettled() const;

private:
    struct Section;
    void build();
    void addSection(LibrarySection section, QVBoxLayout& layout);
    void readFolders();
    [[nodiscard]] QDateTime lastWritten() const; ///< newest modification time of the project's files
    void showItems();
    void setWords(const QString& text);
    void setAsList(bool list);
    void fitSections();
    void showModel();
    [[nodiscard]] bool fitsModel(LibrarySection section) const;
    void step(std::size_t from, int by);
    [[nodiscard]] std::string textOf(const LibraryItem& item) const;
    [[nodiscard]] std::string fittedTo(const LibraryItem& item) const;
    [[nodiscard]] std::vector<LibraryItem> ownConfigs();
    [[nodiscard]] const Kind* kindOf(const std::string& name) const;

    Document& m_document;
    Selection& m_selection;
    Application& m_application;
    const std::string m_configs, m_resources, m_modules; ///< installed with Trundle
    ObjectEdits* m_edits;
    LibraryModel* m_model;
    LibraryPictures* m_pictures;
    std::vector<Section> m_sections;
    std::vector<bool> m_openBefore; ///< while a model is edited: which sections were open before
    QLineEdit* m_search = nullptr;
    QToolButton* m_asList = nullptr;
    std::vector<LibraryItem> m_found; ///< from files
    std::map<std::string, std::string>
        m_ownPictures; ///< of configs of the opened file, when first seen after the last reading of folders
    std::vector<Kind> m_moduleKinds;
    std::shared_ptr<const Registry> m_registry; ///< of the kinds shown
    std::vector<std::string> m_ownNames;        ///< of the opened file's configs shown
    QDateTime m_readOf;                         ///< lastWritten() at the last reading of folders
    int m_reading = 0;
    std::uint64_t m_readings = 0;
    QThreadPool m_pool; // reads folders; the last member: destroyed first, it waits for its threads
};

} // namespace trundle
