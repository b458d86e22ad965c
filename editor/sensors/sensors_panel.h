#pragma once
// The Sensors dock: what the selected and the pinned devices measure in a run.

#include <memory>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "editor/sensors/sensor_device.h"

class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace trundle {

class CardColumns;
class Document;
class PinnedValues;
class RenderService;
class RunSession;
class Selection;
class SensorCard;

/// Reads what the run publishes, at most 30 times a second, and only while it is visible. Many cards take turns, so that they leave time
/// for the 3D view.
class SensorsPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null without OpenGL. All must outlive this object.
    SensorsPanel(Document& document, Selection& selection, RunSession& session, RenderService* render, QWidget* parent = nullptr);
    ~SensorsPanel() override;

    [[nodiscard]] PinnedValues& pins() { return *m_pins; } ///< devices that are shown whatever is selected
    [[nodiscard]] const std::vector<SensorCard*>& cards() const { return m_cards; } ///< pinned ones first
    void showTrue(bool shown);
    /// The visible content is up to date. For tests.
    [[nodiscard]] bool isSettled() const;
    /// Number of updates so far. For tests.
    [[nodiscard]] int updateCount() const { return m_updates; }
    static constexpr std::size_t kCardsAtOnce = 6; ///< at most so many in one update

protected:
    void showEvent(QShowEvent*) override;
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTools();
    void markStale();
    void markChanged();
    void updateCards();
    void displayTurn(bool wasHidden);
    void rebuild();
    [[nodiscard]] std::vector<std::string> shownPaths();
    [[nodiscard]] SensorCard* makeCard(SensorDevice device);
    void showHint();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] bool isSeen() const;

    Document& m_document;
    Selection& m_selection;
    RunSession& m_session;
    RenderService* m_render;
    std::unique_ptr<PinnedValues> m_pins;
    std::shared_ptr<const ExperimentSpec> m_experiment; ///< of the cards
    std::shared_ptr<const SignalLayout> m_layout;       ///< of the cards
    std::vector<SensorCard*> m_cards;
    std::size_t m_omitted = 0; ///< devices beyond the limit
    QTimer m_next;
    QElapsedTimer m_sinceUpdate;
    bool m_stale = true, m_changed = true; ///< values; which devices are shown
    std::size_t m_turn = 0, m_turnsLeft = 0; ///< of the cards; until all show the newest values
    int m_updates = 0;

    QStackedWidget* m_pages = nullptr;
    QScrollArea* m_scroll = nullptr;
    QLabel *m_empty = nullptr, *m_facts = nullptr;
    QToolButton *m_true = nullptr, *m_unpin = nullptr;
    CardColumns* m_columns = nullptr;
};

} // namespace trundle
