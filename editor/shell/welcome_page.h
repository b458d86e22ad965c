#pragma once
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

/// Shown while nothing is open: samples with images, templates, and recent files.
class WelcomePage final : public QWidget {
    Q_OBJECT
public:
    WelcomePage(const Actions& actions, const QString& configs, QWidget* parent = nullptr);

    void refresh(); ///< updates the list of recent files

Q_SIGNALS:
    void openRequested(const QString& path);
    void tryRequested(const QString& path); ///< a robot or an arena

protected:
    void changeEvent(QEvent* event) override;

private:
    void fitStart();
    QWidget* makeStart(const Actions& actions);
    QWidget* makeSamples(const Actions& actions, const QString& configs);

    QWidget* m_start = nullptr; ///< left column; as wide as the font needs
    QVBoxLayout* m_recent = nullptr;
};

} // namespace trundle
