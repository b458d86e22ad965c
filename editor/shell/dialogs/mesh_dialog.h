#pragma once
#include <memory>
#include <optional>

#include <QDialog>

#include "app/locations.h"
#include "project/wizard/mesh_text.h"
#include "scene/shapes/convex_parts.h"
#include "scene/shapes/mesh_fit.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace trundle {

class AmountField;
class MeshPreview;
class ResultLabel;

/// Asks for the file of a mesh, its unit and its up axis, and for the shape or shapes that collide; shows all, and how far they differ. Deletes
/// itself when it is closed.
class MeshDialog final : public QDialog {
    Q_OBJECT
public:
    /// `folder`: where the dialog for files begins. `isOfBody`: it gets a mass.
    MeshDialog(Locations locations, const QString& folder, bool isOfBody, QWidget* parent);

    [[nodiscard]] QString file() const;                            ///< whole path
    [[nodiscard]] MeshPart part(const std::string& written) const; ///< for a file as it is written; valid when accepted
    /// If several hulls are chosen; part() has their volumes, not yet their files.
    [[nodiscard]] const ConvexParts* hulls() const;

private:
    void makeLayout();
    void choose();
    void read();
    void place();
    void listShapes();
    void check();
    [[nodiscard]] const MeshFit* fit() const;
    [[nodiscard]] bool wantsHulls() const;
    void computeHulls();
    void showShapes();
    [[nodiscard]] QString sentence() const;

    const Locations m_locations;
    const QString m_projectFolder;
    const bool m_isOfBody;
    std::shared_ptr<const TriangleMesh> m_mesh; ///< as in the file; null: none that can be read
    TriangleMesh m_placed;                      ///< in m, z up, the middle of its base in the origin
    std::array<double, 3> m_origin{};           ///< of the file, in that frame
    std::vector<MeshFit> m_fits;
    std::optional<ConvexParts> m_hulls; ///< of m_placed, once they are chosen
    QString m_unreadable;
    QLineEdit* m_file;
    QComboBox *m_unit, *m_up, *m_shape;
    AmountField* m_mass;
    MeshPreview* m_preview;
    ResultLabel* m_result;
    QPushButton* m_insert = nullptr;
};

} // namespace trundle
