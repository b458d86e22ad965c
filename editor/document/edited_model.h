#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include <QObject>

#include "project/loading/project.h"

namespace trundle {

class DocumentLoading;
class ProjectOpening;
class Selection;
struct DocumentState;

/// The RobotConfig or StaticConfig that the model editor shows and edits alone. None: the window shows the whole experiment. It
/// follows the config when an edit renames or copies it, and closes when the config is removed or another project is opened.
class EditedModel final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    EditedModel(const DocumentState& state, const DocumentLoading& loading, const ProjectOpening& opening);

    [[nodiscard]] const std::string& path() const { return m_path; } ///< "RobotConfig.Rover"; empty: none
    [[nodiscard]] bool isOpen() const { return !m_path.empty(); }
    /// Its block; nullptr without one, or without one now because of an error in the text.
    [[nodiscard]] const Part* config() const;
    /// The RobotConfig or StaticConfig that an object belongs to, or is an instance of; empty: none.
    [[nodiscard]] std::string modelOf(const std::string& path) const;
    /// Where a new object is inserted: at the selection, or in the model if what is selected is not in it.
    [[nodiscard]] std::string insertionPlace(const Selection& selection) const;

    void open(const std::string& path); ///< the path of a config as from modelOf()
    void close() { open({}); }

Q_SIGNALS:
    void changed(); ///< path()

private:
    void follow();
    void remember();
    [[nodiscard]] std::string followed() const;

    const DocumentState& m_state;
    std::string m_path;
    std::vector<std::string> m_before;         // its earlier paths: undo returns to them
    std::unordered_set<std::string> m_configs; // paths of all configs at the last change of the document
};

} // namespace trundle
