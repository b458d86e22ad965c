#pragma once
#include <memory>
#include <optional>

#include <QDialog>
#include <QImage>

#include "app/arena_files.h"
#include "app/locations.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;

namespace trundle {

class AmountField;
class ResultLabel;

/// Asks for the picture of a floor plan and its size, shows which of it becomes walls, and writes the arena's files. Deletes itself
/// when it is closed.
class NewArenaDialog final : public QDialog {
    Q_OBJECT
public:
    /// `folder`: proposed for the arena's own folder to be made in.
    NewArenaDialog(Locations locations, const QString& folder, QWidget* parent);

    /// The arena whose files are written, once the dialog was accepted.
    [[nodiscard]] const NewArena& made() const { return *m_made; }

public Q_SLOTS:
    void accept() override; ///< stays open and says why if the files cannot be written

private:
    void makeLayout();
    [[nodiscard]] QWidget* withButton(QLineEdit* field, const QString& tip, void (NewArenaDialog::*choose)());
    void choosePicture();
    void chooseFolder();
    void readPicture();
    void check();
    [[nodiscard]] QString planFault();
    [[nodiscard]] QString placeFault() const;
    void showPlan();

    const Locations m_locations;
    std::shared_ptr<const HeightMap> m_map; ///< null: no picture that can be read
    QString m_unreadable;
    std::optional<FloorPlan> m_plan;
    std::optional<NewArena> m_made;
    QLineEdit *m_file, *m_name, *m_folder;
    AmountField *m_width, *m_height;
    QSlider* m_threshold;
    QCheckBox* m_light;
    QLabel* m_preview;
    ResultLabel* m_result;
    QPushButton* m_create = nullptr;
};

} // namespace trundle
