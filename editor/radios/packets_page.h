#pragma once
#include <QWidget>

#include "editor/radios/packet_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QTableView;
class QToolButton;

namespace trundle {

class OutcomeBar;

/// The frames of a run, newest last. Scrolls to the end unless the user has scrolled up.
class PacketsPage final : public QWidget {
    Q_OBJECT
public:
    explicit PacketsPage(QWidget* parent = nullptr);

    [[nodiscard]] PacketModel& model() { return *m_model; }
    [[nodiscard]] QWidget* tools() { return m_tools; } ///< its row of controls; the caller inserts it into a layout
    void add(LiveRadio fresh);
    void clear();
    /// Sets the radios of the filter.
    void setRadios(const std::vector<RadioDefinition>& radios);
    /// Text shown while there are no packets.
    void setHint(const QString& words);
    /// The format follows from the file's extension: .pcap, else CSV.
    void exportTo(const QString& path);
    void copySelected();

Q_SIGNALS:
    void budgetRequested(const QString& from, const QString& to, double power);
    /// Requests to ask for a file; `ending` is "csv" or "pcap".
    void exportRequested(const QString& ending);
    void messageRequested(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent*) override;

private:
    void makeTools();
    void makeView();
    QWidget* makeDetails();
    void applyFilter();
    void showCounts();
    void fitCounts();
    void fitOutcomes();
    void showDetails();
    void showMenu(const QPoint& at);
    void requestBudget();

    PacketModel* m_model;
    QWidget *m_tools = nullptr, *m_details = nullptr;
    QComboBox *m_from = nullptr, *m_to = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel *m_counts = nullptr, *m_hint = nullptr, *m_facts = nullptr;
    QToolButton *m_export = nullptr, *m_clear = nullptr;
    OutcomeBar* m_outcomes;
    QTableView* m_view = nullptr;
    QPlainTextEdit* m_bytes = nullptr;
    QString m_hintWords;
    QStringList m_countWords; ///< the packet count in ever shorter texts
    bool m_follows = true;    ///< scrolls to new rows
};

} // namespace trundle
