#pragma once
#include <QFrame>

#include "editor/sensors/sensor_device.h"

class QLabel;
class QToolButton;

namespace trundle {

class BatteryGauge;
class HeadingDial;
class PolarPlot;
class ReadingRow;
class RenderService;
class SensorImage;

/// One device: its name, a picture that depends on what it measures, and its readings.
class SensorCard final : public QFrame {
    Q_OBJECT
public:
    /// `render` is null without OpenGL.
    SensorCard(SensorDevice device, RenderService* render, QWidget* parent = nullptr);

    [[nodiscard]] const SensorDevice& device() const { return m_device; }
    [[nodiscard]] const std::vector<ReadingRow*>& rows() const { return m_rows; }
    /// Takes over the same device of another run or after a live edit, and keeps the traces. False if it is not the same.
    [[nodiscard]] bool rebind(const SensorDevice& device);
    void display(const RunResults& run, bool running);
    void showTrue(bool shown);
    void setPinned(bool pinned);
    /// What follows is not connected with what was displayed before.
    void interrupt();
    [[nodiscard]] bool isSettled() const;

Q_SIGNALS:
    void pinRequested(const std::string& path, bool pinned);

protected:
    void changeEvent(QEvent* event) override;

private:
    void addHeader();
    void addPicture(RenderService* render);
    void updateIcons();
    [[nodiscard]] ReadingRow* row(std::string_view name) const;

    SensorDevice m_device;
    bool m_showsTrue = false;
    QLabel *m_icon = nullptr, *m_name = nullptr;
    QToolButton* m_pin = nullptr;
    PolarPlot* m_polar = nullptr;
    HeadingDial* m_dial = nullptr;
    BatteryGauge* m_gauge = nullptr;
    SensorImage* m_image = nullptr;
    std::vector<ReadingRow*> m_rows;
};

} // namespace trundle
