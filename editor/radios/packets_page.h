#pragma once
#include <QWidget>

#include "editor/radios/frame_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QTableView;
class QToolButton;

namespace trundle {

class FateBar;

/// The frames of a run as they fly, newest last; follows the end until one scrolls up.
class PacketsPage final : public QWidget {
    Q_OBJECT
public:
    explicit PacketsPage(QWidget* parent = nullptr);

    [[nodiscard]] FrameModel& model() { return *m_model; }
    [[nodiscard]] QWidget* tools() { return m_tools; } ///< its row of controls, to be put where there is room
    void add(LiveRadio fresh);
    void clear();
    /// Radios to choose from.
    void setRadios(const std::vector<RadioDefinition>& radios);
    /// What stands in place of packets while there are none.
    void setHint(const QString& words);
    /// As the file's ending says: .pcap, else CSV.
    void exportTo(const QString& path);
    void copySelected();

Q_SIGNALS:
    void budgetWanted(const QString& from, const QString& to, double power);
    /// Where to is to be asked; `ending` is "csv" or "pcap".
    void exportWanted(const QString& ending);
    void said(const QString& text);

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
    void fitFates();
    void showDetails();
    void showMenu(const QPoint& at);
    void wantBudget();

    FrameModel* m_model;
    QWidget *m_tools = nullptr, *m_details = nullptr;
    QComboBox *m_from = nullptr, *m_to = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel *m_counts = nullptr, *m_hint = nullptr, *m_facts = nullptr;
    QToolButton *m_export = nullptr, *m_clear = nullptr;
    FateBar* m_fates;
    QTableView* m_view = nullptr;
    QPlainTextEdit* m_bytes = nullptr;
    QString m_hintWords;
    QStringList m_countWords; ///< how many packets there are, in ever fewer words
    bool m_follows = true;    ///< the end
};

} // namespace trundle
