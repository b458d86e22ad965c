#pragma once
#include <functional>
#include <memory>
#include <optional>

#include <QGridLayout>
#include <QWidget>

#include "radio/radio_nodes.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace trundle {

class LevelDiagram;

/// The link budget between two radios at their current poses, term by term.
class BudgetPage final : public QWidget {
    Q_OBJECT
public:
    explicit BudgetPage(QWidget* parent = nullptr);

    [[nodiscard]] QWidget* tools() { return m_tools; }
    /// The radios to select from; the caller sets their poses. Null: there are none.
    void setNodes(std::shared_ptr<const RadioNodes> nodes);
    /// Sets the function that returns a radio's last transmit power (dBm), used as the default.
    void setLastPower(std::function<std::optional<double>(const QString&)> lastPower) { m_lastPower = std::move(lastPower); }
    /// Selects sender and receiver by their paths; an unknown path changes nothing. `power`: transmit power (dBm); none: the
    /// last one used, else the default.
    void choose(const QString& from, const QString& to, std::optional<double> power = {});
    void swap();
    void setPower(double dbm);
    [[nodiscard]] double power() const;
    [[nodiscard]] QString from() const;
    [[nodiscard]] QString to() const;
    /// Recomputes: something moved.
    void refresh();
    [[nodiscard]] const std::optional<LinkReport>& report() const { return m_report; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent*) override;

private:
    enum Term {
        Output,
        SendGain,
        PathLoss,
        Shadow,
        Walls,
        ReceiveGain,
        Received,
        Rssi,
        Lqi,
        Noise,
        Snr,
        Least,
        Margin,
        Loss,
        Terms
    };

    void makeTools();
    void addTerm(QGridLayout& grid, int row, Term term, const QString& name, const QString& help);
    void fillPowers();
    [[nodiscard]] double ownOffset() const;
    void show(Term term, const QString& value, const QString& note = {});
    void showTerms(RadioId from, RadioId to);

    std::shared_ptr<const RadioNodes> m_nodes;
    std::function<std::optional<double>(const QString&)> m_lastPower;
    std::optional<LinkReport> m_report;
    QWidget *m_tools = nullptr, *m_terms = nullptr;
    QComboBox *m_from = nullptr, *m_to = nullptr, *m_levels = nullptr;
    QToolButton* m_swap = nullptr;
    QDoubleSpinBox* m_anyPower = nullptr;
    QSpinBox* m_payload = nullptr;
    QLabel *m_values[Terms]{}, *m_notes[Terms]{};
    QLabel* m_words = nullptr;
    LevelDiagram* m_diagram = nullptr;
    QBoxLayout* m_halves = nullptr;
};

} // namespace trundle
