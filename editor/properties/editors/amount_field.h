#pragma once
#include <optional>

#include <QWidget>

#include "schema/kind.h"

class QLabel;

namespace trundle {

class ValueField;

/// A number outside of a document, edited as in a property row: with a unit of its dimension or arithmetic, by the arrow keys, or by
/// dragging its label. For dialogs: its value follows each key.
class AmountField final : public QWidget {
    Q_OBJECT
public:
    /// `property`: one number, with its unit and range.
    explicit AmountField(Property property, QWidget* parent = nullptr);

    void setValue(double si);
    /// SI, of the text as typed so far; empty if it is no value of the property, see fault().
    [[nodiscard]] const std::optional<double>& value() const { return m_value; }
    [[nodiscard]] const QString& fault() const { return m_fault; }
    void selectAll(); ///< so that what is typed replaces it
    /// Its buddy is this field. Belongs to the caller.
    [[nodiscard]] QLabel* makeLabel(const QString& text);

Q_SIGNALS:
    void changed();
    void submitted(); ///< the Enter key
    void focused();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void read();
    void step(const QString& from, double steps);

    Property m_property;
    ValueField* m_field;
    QString m_before; ///< when a drag of the label began
    std::optional<double> m_value;
    QString m_fault;
};

} // namespace trundle
