#pragma once
#include <array>
#include <memory>

#include <QDialog>

#include "app/locations.h"
#include "base/triangle_mesh.h"

class QLineEdit;
class QPushButton;

namespace trundle {

class AmountField;
class PlanPreview;
class ResultLabel;

/// Asks for a grey picture and the size of the ground that it becomes, and shows it. Deletes itself when it is closed.
class HeightsDialog final : public QDialog {
    Q_OBJECT
public:
    /// `folder`: of the project, for the words; where the dialog for files begins.
    HeightsDialog(Locations locations, const QString& folder, QWidget* parent);

    [[nodiscard]] QString picture() const;             ///< whole path
    [[nodiscard]] std::array<double, 3> sizes() const; ///< along x, along y, height of white, m

private:
    void makeLayout();
    void choose();
    void read();
    void check();

    const Locations m_locations;
    const QString m_projectFolder;
    std::shared_ptr<const HeightMap> m_map; ///< null: no picture that can be read
    QString m_unreadable;
    QLineEdit* m_file;
    AmountField *m_length, *m_width, *m_height;
    PlanPreview* m_preview;
    ResultLabel* m_result;
    QPushButton* m_insert = nullptr;
};

} // namespace trundle
