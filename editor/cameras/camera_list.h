#pragma once
// The cameras of an experiment, with a filter and a check box for each that is shown.

#include <string>
#include <vector>

#include <QWidget>

class QLineEdit;
class QListWidget;

namespace trundle {

/// Until the user checks something, the first few cameras are chosen.
class CameraList final : public QWidget {
    Q_OBJECT
public:
    explicit CameraList(QWidget* parent = nullptr);

    /// For another document: forgets the user's choice and the filter.
    void reset();
    /// Chosen cameras that are still there stay chosen.
    void setCameras(const std::vector<std::string>& cameras);
    /// Selects the cameras to show; unknown ones are ignored.
    void setChosen(const std::vector<std::string>& cameras);
    [[nodiscard]] std::vector<std::string> chosen() const;

Q_SIGNALS:
    void chosenChanged();
    void currentChanged(const std::string& camera);

private:
    [[nodiscard]] bool lists(const std::vector<std::string>& cameras) const;
    void filter();

    bool m_untouched = true; ///< no choice by the user
    QLineEdit* m_filter = nullptr;
    QListWidget* m_list = nullptr;
};

} // namespace trundle
