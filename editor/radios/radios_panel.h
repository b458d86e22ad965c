#pragma once
// The Radio dock: packets of the run, and the link budget between any two radios.

#include <memory>

#include <QTimer>
#include <QWidget>

#include "model/experiment_spec.h"
#include "radio/radio_nodes.h"
#include "scene/queries/object_index.h"

class QBoxLayout;
class QLabel;
class QStackedWidget;
class QTabBar;

namespace trundle {

class BudgetPage;
class Document;
class PacketsPage;
class RunSession;
class Selection;

/// Packets are recorded while the dock is open, also behind another tab; they are fetched while it is visible, some times a
/// second. The panel only reads data published by the run.
class RadiosPanel final : public QWidget {
    Q_OBJECT
public:
    enum Page { Packets, Budget };

    /// All must outlive this object.
    RadiosPanel(Document& document, Selection& selection, RunSession& session, QWidget* parent = nullptr);

    [[nodiscard]] PacketsPage& packets() { return *m_packets; } ///< for tests
    [[nodiscard]] BudgetPage& budget() { return *m_budget; }
    void showPage(Page page);
    /// The visible content is up to date. For tests.
    [[nodiscard]] bool isSettled() const { return !m_stale || !isSeen(); }

Q_SIGNALS:
    void messageRequested(const QString& text);

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    QWidget* makeWork();
    void markStale();
    void updatePages();
    void follow();
    void useExperiment(std::shared_ptr<const ExperimentSpec> experiment);
    void placeNodes();
    void fetchPackets();
    void showHint();
    void followSelection();
    void askAndExport(const QString& ending);
    [[nodiscard]] bool isSeen() const;

    Document& m_document;
    Selection& m_selection;
    RunSession& m_session;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<const ObjectIndex> m_objects; ///< for attenuation by walls
    std::shared_ptr<RadioNodes> m_nodes;
    std::shared_ptr<const std::vector<RadioDefinition>> m_runRadios;
    QTimer m_next;
    bool m_chosen = false;        ///< the selection has been applied to the link
    bool m_stale = true;          ///< something changed since updatePages()
    std::uint64_t m_expected = 0; ///< number of frames so far, fetched or not

    QStackedWidget *m_pages = nullptr, *m_tools = nullptr, *m_parts = nullptr;
    QLabel* m_empty = nullptr;
    QTabBar* m_tabs = nullptr;
    QBoxLayout* m_top = nullptr;
    PacketsPage* m_packets = nullptr;
    BudgetPage* m_budget = nullptr;
};

} // namespace trundle
