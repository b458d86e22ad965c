#pragma once
// The Radio dock: packets of the run as they fly, and the link between any two radios.

#include <memory>

#include <QTimer>
#include <QWidget>

#include "model/experiment_spec.h"
#include "radio/radio_nodes.h"
#include "scene/object_index.h"

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

/// Packets are kept while this is open, also behind another tab; they are fetched while it is seen, some times a second. Nothing here
/// reaches the run: it looks at what it gives out.
class RadiosPanel final : public QWidget {
    Q_OBJECT
public:
    enum Page { Packets, Budget };

    /// All outlive this.
    RadiosPanel(Document& document, Selection& selection, RunSession& session, QWidget* parent = nullptr);

    [[nodiscard]] PacketsPage& packets() { return *m_packets; }
    [[nodiscard]] BudgetPage& budget() { return *m_budget; }
    void showPage(Page page);
    /// What is seen of it is as things stand now.
    [[nodiscard]] bool isSettled() const { return !m_stale || !isSeen(); }

Q_SIGNALS:
    void said(const QString& text);

protected:
    void showEvent(QShowEvent*) override;
    void hideEvent(QHideEvent*) override;
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;

private:
    QWidget* makeWork();
    void outdate();
    void look();
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
    std::shared_ptr<const ObjectIndex> m_objects; ///< where walls take something away
    std::shared_ptr<RadioNodes> m_nodes;
    std::shared_ptr<const std::vector<RadioDefinition>> m_runRadios;
    QTimer m_next;
    bool m_chosen = false;        ///< what is selected was looked at
    bool m_stale = true;          ///< something happened since look()
    std::uint64_t m_expected = 0; ///< frames so far, seen or not

    QStackedWidget *m_pages = nullptr, *m_tools = nullptr, *m_parts = nullptr;
    QLabel* m_empty = nullptr;
    QTabBar* m_tabs = nullptr;
    QBoxLayout* m_top = nullptr;
    PacketsPage* m_packets = nullptr;
    BudgetPage* m_budget = nullptr;
};

} // namespace trundle
