#pragma once
#include <QWidget>

#include "editor/sensors/reading.h"
#include "editor/sensors/trace.h"
#include "run/number_scale.h"

namespace trundle {

/// One reading: its name and numbers, a bar against its limits, and a trace of its last values; the true values beside them.
/// Its height depends only on the reading and on whether true values are shown.
class ReadingRow final : public QWidget {
    Q_OBJECT
public:
    explicit ReadingRow(Reading reading, QWidget* parent = nullptr);

    /// Takes over another binding of the same quantity and keeps the trace. False if it is another one.
    [[nodiscard]] bool rebind(const Reading& reading);
    /// Takes the values of a snapshot. Without `measured`: the sensor has no reading yet.
    void take(const LiveSnapshot& snapshot, bool measured);
    void showTrue(bool shown);
    void interrupt() { m_trace.interrupt(); } ///< what follows is not connected with the trace

    [[nodiscard]] const Reading& reading() const { return m_reading; }
    [[nodiscard]] const Trace& trace() const { return m_trace; }
    /// "0.521 m"; "–" before the first reading.
    [[nodiscard]] QString text() const { return textOf(m_numbers); }
    [[nodiscard]] QString trueText() const { return textOf(m_trueNumbers); } ///< "–" if not shown
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] bool hasTrue() const { return m_showsTrue && m_reading.readTrue; }
    [[nodiscard]] bool hasTrace() const;
    [[nodiscard]] QString numberText(double number) const;
    [[nodiscard]] QString textOf(const std::vector<double>& numbers) const;
    void paintNumbers(QPainter& painter, QRectF line, const std::vector<double>& numbers, const QColor& colour) const;
    void paintBar(QPainter& painter, const QRectF& bar) const;
    void paintTrace(QPainter& painter, const QRectF& area) const;
    [[nodiscard]] std::pair<double, double> traceLimits() const;
    void describe();

    Reading m_reading;
    Trace m_trace; ///< of the numbers and, behind them, of the true ones
    NumberScale m_scale;
    std::vector<double> m_numbers, m_trueNumbers; ///< empty: none yet
    bool m_showsTrue = false;
};

} // namespace trundle
