#include "editor/shell/saved_window_state.h"

#include <cmath>
#include <numbers>

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "editor/viewport/overlays/pinned_values.h"
#include "project/journal/state_folder.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

constexpr int kMaxKept = 200; // experiments
constexpr std::size_t kMaxPins = 64;
constexpr int kSaveSoonMs = 500; // delay, since dragging a label changes its position many times

QString folder() { return QString::fromStdString(userStateFolder()) + QStringLiteral("/windows"); }

QString fileOf(const std::string& path) {
    const QByteArray hash = QCryptographicHash::hash(QByteArray::fromStdString(path), QCryptographicHash::Sha1).toHex();
    return folder() + QLatin1Char('/') + QLatin1String(hash.left(16)) + QStringLiteral(".ini");
}

QStringList listOf(const ObjectMarks::Paths& paths) {
    QStringList list;
    for (const std::string& path : paths) list += QString::fromStdString(path);
    return list;
}

/// The marks of existing objects only: an object created later with the same name must not be hidden.
std::vector<std::string> marksIn(const QVariant& list, const LoadedProject& loaded) {
    std::vector<std::string> paths;
    for (const QString& text : list.toStringList())
        if (std::string path = text.toStdString(); placeOf(loaded, path)) paths.push_back(std::move(path));
    return paths;
}

QVariantList numbersOf(const CameraView& camera) {
    QVariantList numbers;
    for (const Vec3& v : {camera.eye, camera.target})
        for (int k = 0; k < 3; ++k) numbers += v[k];
    return numbers << camera.orthographicWidth << camera.fieldOfView;
}

std::optional<CameraView> cameraFrom(const QVariantList& numbers) {
    constexpr int kCount = 8;
    double n[kCount] = {0, 0, 0, 0, 0, 0, 0, std::numbers::pi / 4}; // earlier files have no field of view
    if (numbers.size() != kCount && numbers.size() != kCount - 1) return std::nullopt;
    for (int i = 0; i < numbers.size(); ++i) {
        n[i] = numbers[i].toDouble();
        if (!std::isfinite(n[i]) || std::abs(n[i]) > 1e6) return std::nullopt;
    }
    CameraView camera;
    camera.eye = {n[0], n[1], n[2]};
    camera.target = {n[3], n[4], n[5]};
    camera.orthographicWidth = n[6];
    camera.fieldOfView = n[7];
    return isUsable(camera) ? std::optional(camera) : std::nullopt;
}

/// Each as its path and, if its label was moved, the label's position.
QVariantList listOf(const std::vector<Pin>& pins) {
    QVariantList list;
    for (const Pin& pin : pins) {
        QStringList words{QString::fromStdString(pin.path)};
        if (pin.position) words << QString::number(pin.position->x()) << QString::number(pin.position->y());
        list << words;
    }
    return list;
}

std::vector<Pin> pinsFrom(const QVariantList& list, const LoadedProject& loaded) {
    std::vector<Pin> pins;
    for (const QVariant& item : list) {
        const QStringList words = item.toStringList();
        if (words.isEmpty() || pins.size() >= kMaxPins) continue;
        Pin pin{words[0].toStdString(), std::nullopt};
        if (!placeOf(loaded, pin.path)) continue;
        const double x = words.size() == 3 ? words[1].toDouble() : -1, y = words.size() == 3 ? words[2].toDouble() : -1;
        if (x >= 0 && x <= 1 && y >= 0 && y <= 1) pin.position = QPointF(x, y);
        pins.push_back(std::move(pin));
    }
    return pins;
}

/// Removes the oldest files beyond the limit.
void tidy() {
    const QFileInfoList files = QDir(folder()).entryInfoList({QStringLiteral("*.ini")}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : files.mid(kMaxKept)) QFile::remove(file.filePath());
}

} // namespace

SavedWindowState::SavedWindowState(Document& document, ObjectMarks& marks, ViewportPanel& viewport, PinnedValues& sensorPins,
                                   QObject* parent)
    : QObject(parent), m_document(document), m_marks(marks), m_viewport(viewport), m_sensorPins(sensorPins) {
    connect(&document, &Document::opened, this, &SavedWindowState::onOpened);
    connect(&document, &Document::changed, this, &SavedWindowState::onChanged);
    for (const auto signal : {&ObjectMarks::hiddenChanged, &ObjectMarks::lockedChanged})
        connect(&marks, signal, this, [this] {
            if (!m_fresh) save();
        });
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(kSaveSoonMs);
    connect(&m_saveSoon, &QTimer::timeout, this, &SavedWindowState::save);
    for (PinnedValues* pins : {&viewport.pinned(), &sensorPins})
        connect(pins, &PinnedValues::changed, this, [this] {
            if (!m_fresh) m_saveSoon.start();
        });
}

void SavedWindowState::start() {
    m_on = true;
    m_fresh = m_document.isOpen();
    onChanged();
}

/// The viewports still have the state of the previous project, so it is saved first.
void SavedWindowState::onOpened() {
    save();
    m_path.clear();
    m_fresh = true;
}

void SavedWindowState::onChanged() {
    const bool fresh = std::exchange(m_fresh, false);
    m_path = m_document.isOpen() && !m_document.isNew() ? m_document.path() : std::string(); // changes with Save As
    if (m_on && fresh && !m_path.empty()) restore();
}

void SavedWindowState::restore() {
    if (!QFileInfo::exists(fileOf(m_path))) return;
    const QSettings kept(fileOf(m_path), QSettings::IniFormat);
    const std::vector<std::string> hidden = marksIn(kept.value(QStringLiteral("hidden")), *m_document.loaded()),
                                   locked = marksIn(kept.value(QStringLiteral("locked")), *m_document.loaded());
    const std::vector<Pin> pins = pinsFrom(kept.value(QStringLiteral("pins")).toList(), *m_document.loaded());
    const std::vector<Pin> sensors = pinsFrom(kept.value(QStringLiteral("sensors")).toList(), *m_document.loaded());
    std::vector<ViewState> viewStates;
    for (int i = 0; i < 4; ++i) {
        const QString view = QStringLiteral("view%1/").arg(i);
        const int kind = kept.value(view + QStringLiteral("kind"), -1).toInt();
        const auto camera = cameraFrom(kept.value(view + QStringLiteral("camera")).toList());
        if (camera && kind >= 0 && kind <= int(ViewKind::Chase))
            viewStates.push_back({ViewKind(kind), *camera, kept.value(view + QStringLiteral("named")).toString().toStdString()});
    }
    if (viewStates.size() == 4) m_viewport.views().setViewStates(viewStates, kept.value(QStringLiteral("views"), 1).toInt());
    m_marks.setHidden(hidden, true);
    m_marks.setLocked(locked, true);
    m_viewport.pinned().setPins(pins);
    m_sensorPins.setPins(sensors);
}

void SavedWindowState::save() const {
    if (!m_on || m_path.empty()) return;
    QDir().mkpath(folder());
    QSettings kept(fileOf(m_path), QSettings::IniFormat);
    kept.setValue(QStringLiteral("file"), QString::fromStdString(m_path)); // for readers of the file; not read by the program
    kept.setValue(QStringLiteral("hidden"), listOf(m_marks.hidden()));
    kept.setValue(QStringLiteral("locked"), listOf(m_marks.locked()));
    kept.setValue(QStringLiteral("pins"), listOf(m_viewport.pinned().pins()));
    kept.setValue(QStringLiteral("sensors"), listOf(m_sensorPins.pins()));
    kept.setValue(QStringLiteral("views"), m_viewport.views().viewCount());
    const std::vector<ViewState> viewStates = m_viewport.views().viewStates();
    for (std::size_t i = 0; i < viewStates.size(); ++i) {
        const QString view = QStringLiteral("view%1/").arg(i);
        kept.setValue(view + QStringLiteral("kind"), int(viewStates[i].kind));
        kept.setValue(view + QStringLiteral("camera"), numbersOf(viewStates[i].camera));
        kept.setValue(view + QStringLiteral("named"), QString::fromStdString(viewStates[i].named));
    }
    tidy();
}

} // namespace trundle
