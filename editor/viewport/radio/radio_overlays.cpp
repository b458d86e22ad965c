#include "editor/viewport/radio/radio_overlays.h"

#include <algorithm>
#include <map>

#include "editor/document/selection.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/antenna_lobes.h"
#include "model/resolve/footprint.h"

namespace trundle {
namespace {

constexpr unsigned kOfRadios = kOverlayLobes | kOverlayLinks | kOverlayCoverage;
constexpr std::size_t kMaxLobes = 300, kManyLobes = 20;
constexpr int kFineSpokes = 64, kCoarseSpokes = 32;
constexpr double kMoved = 1e-3, kTurned = 2e-3; // m, rad; smaller motions do not change the display

bool areNear(const std::vector<Pose>& a, const std::vector<Pose>& b) {
    return std::ranges::equal(a, b, [](const Pose& p, const Pose& q) {
        return (p.position - q.position).squaredNorm() < kMoved * kMoved && p.rotation.angularDistance(q.rotation) < kTurned;
    });
}

bool areSame(const std::vector<RadioNode>& a, const std::vector<RadioNode>& b) {
    return std::ranges::equal(a, b, [](const RadioNode& p, const RadioNode& q) { return p.radio.path == q.radio.path; });
}

} // namespace

RadioOverlays::RadioOverlays(const ViewportScene& world, const Selection& selection, const ViewSettings& settings,
                             QObject* parent)
    : QObject(parent), m_world(world), m_selection(selection), m_settings(settings) {
    connect(&world, &ViewportScene::replaced, this, &RadioOverlays::updateScene);
    connect(&world, &ViewportScene::posed, this, &RadioOverlays::follow);
    connect(&world, &ViewportScene::marked, this, &RadioOverlays::makeLobes);
    connect(&selection, &Selection::changed, this, &RadioOverlays::choose);
    connect(&settings, &ViewSettings::changed, this, [this] {
        unsigned shown = 0;
        for (const Overlay overlay : {kOverlayLobes, kOverlayLinks, kOverlayCoverage})
            if (m_settings.shows(overlay)) shown |= overlay;
        if (shown == m_shown) return;
        m_shown = shown;
        updateScene();
    });
}

RadioOverlays::~RadioOverlays() { m_worker.reset(); }

RadioWorker& RadioOverlays::worker() {
    if (m_worker) return *m_worker;
    // Results arrive on the worker thread, which ends before this object does.
    const auto here = [this](auto&& take) { QMetaObject::invokeMethod(this, std::move(take), Qt::QueuedConnection); };
    RadioWorker::Answers answers;
    answers.links = [this, here](std::uint64_t number, RadioLinks links) {
        here([this, number, links = std::move(links)] { takeLinks(number, links); });
    };
    answers.coverage = [this, here](std::uint64_t number, CoverageMap map, bool last) {
        here([this, number, map = std::make_shared<CoverageMap>(std::move(map)), last] {
            takeCoverage(number, std::move(*map), last);
        });
    };
    answers.coverageGivenUp = [this, here](std::uint64_t number) { here([this, number] { takeGivenUp(number); }); };
    m_worker = std::make_unique<RadioWorker>(std::move(answers));
    return *m_worker;
}

/// Restarts all overlays for another experiment or other settings.
void RadioOverlays::updateScene() {
    if (m_worker) m_worker->forget();
    m_oldest = m_number + 1;
    m_linksAwaited = m_coverageAwaited = false;
    m_linkPoses.clear();
    m_coveragePoses.clear();
    m_wanted.reset();
    const auto before =
        std::exchange(m_nodes, std::make_shared<const std::vector<RadioNode>>(
                                   m_shown ? radioNodesOf(m_world.objects()->experiment()) : std::vector<RadioNode>()));
    // While an edit is being dragged, the previous overlay stays visible until a newer one is ready.
    if (!(m_shown & kOverlayLinks) || !areSame(*before, *m_nodes)) dropLinks();
    if (!(m_shown & kOverlayCoverage) || (m_coverage && !nodeAt(m_coverage->coverage.transmitter))) dropCoverage();
    choose();
}

void RadioOverlays::choose() {
    if (!m_shown) {
        m_selected.clear();
        return makeLobes();
    }
    std::vector<bool> selected(m_nodes->size(), false);
    for (const std::string& path : m_selection.paths())
        for (std::size_t i = 0; i < m_nodes->size(); ++i) {
            const RadioNode& node = (*m_nodes)[i];
            selected[i] = selected[i] || m_world.isPartOf(path, node.robot, node.body, node.radio.path);
        }
    const auto first = std::find(selected.begin(), selected.end(), true);
    if (first != selected.end()) m_transmitter = (*m_nodes)[std::size_t(first - selected.begin())].radio.path;
    else selected.clear();
    if (selected != m_selected) m_linkPoses.clear();
    m_selected = std::move(selected);
    makeLobes();
    follow();
}

void RadioOverlays::follow() {
    requestLinks();
    requestCoverage();
}

std::optional<std::size_t> RadioOverlays::nodeAt(const std::string& path) const {
    const auto it = std::ranges::find(*m_nodes, path, [](const RadioNode& node) { return node.radio.path; });
    return it == m_nodes->end() ? std::nullopt : std::optional(std::size_t(it - m_nodes->begin()));
}

RadioPoses RadioOverlays::places() const { return {m_world.objects(), m_world.poses(), m_nodes}; }

std::vector<Pose> RadioOverlays::posesBehind(std::optional<std::size_t> transmitter) const {
    if (m_world.objects()->experiment().medium.wallLoss > 0) return *m_world.poses(); // any moving body can be a wall
    std::vector<Pose> antennas = antennasOf(places());
    return transmitter ? std::vector<Pose>{antennas[*transmitter]} : antennas;
}

/// Largest radius (m) of a robot with a radio, around its centre and for any heading.
double RadioOverlays::largestRobot() const {
    std::map<const RobotConfigSpec*, double> radii;
    double largest = 0;
    for (const RadioNode& node : *m_nodes) {
        const auto object = m_world.find(node.robot);
        const RobotSpec* robot = object ? m_world.objects()->robotOf(*object) : nullptr;
        if (!robot || !robot->config) continue;
        const auto [radius, isNew] = radii.try_emplace(robot->config.get());
        if (isNew) radius->second = discOf(*robot->config).radius;
        largest = std::max(largest, radius->second);
    }
    return largest > 0 ? largest : 0.1;
}

void RadioOverlays::makeLobes() {
    const bool had = m_inScene.shapes != nullptr;
    m_inScene.shapes = nullptr;
    m_lobeUnit = 0;
    if ((m_shown & kOverlayLobes) && !m_nodes->empty()) {
        m_lobeUnit = lobeUnitBeside(largestRobot());
        const std::size_t many = m_selected.empty() ? m_nodes->size() : std::size_t(std::ranges::count(m_selected, true));
        std::map<const AntennaPattern*, std::shared_ptr<const TintedMesh>> meshes;
        auto shapes = std::make_shared<std::vector<TintedShape>>();
        for (std::size_t i = 0; i < m_nodes->size() && shapes->size() < kMaxLobes; ++i) {
            const RadioNode& node = (*m_nodes)[i];
            const auto robot = m_world.find(node.robot);
            if ((!m_selected.empty() && !m_selected[i]) || (robot && m_world.isHidden(*robot))) continue;
            auto& mesh = meshes[node.radio.antenna.get()];
            const AntennaPattern isotropic;
            if (!mesh)
                mesh = lobeMesh(node.radio.antenna ? *node.radio.antenna : isotropic, m_lobeUnit,
                                many > kManyLobes ? kCoarseSpokes : kFineSpokes);
            shapes->push_back({mesh, node.body, node.mounting});
        }
        m_inScene.shapes = std::move(shapes);
    }
    if (had || m_inScene.shapes) Q_EMIT sceneChanged();
}

void RadioOverlays::requestLinks() {
    if (!(m_shown & kOverlayLinks) || m_nodes->empty()) return;
    std::vector<Pose> poses = posesBehind({});
    if (!m_linkPoses.empty() && areNear(poses, m_linkPoses)) return;
    m_linkPoses = std::move(poses);
    m_linkNumber = ++m_number;
    m_linksAwaited = true;
    worker().requestLinks(m_linkNumber, places(), m_selected);
}

void RadioOverlays::requestCoverage() {
    if (!(m_shown & kOverlayCoverage) || m_nodes->empty()) return;
    CoverageRequest request;
    request.places = places();
    request.transmitter = nodeAt(m_transmitter).value_or(0);
    const bool same = m_wanted && m_wanted->transmitter == request.transmitter;
    // The receiver is not changed while objects move.
    request.receiver = same ? m_wanted->receiver : typicalReceiver(request.places, request.transmitter);
    request.ground = groundAround(m_world.bounds(), m_wanted ? m_wanted->ground : Ground());
    if (request.ground.empty()) return;
    std::vector<Pose> poses = posesBehind(request.transmitter);
    if (same && request.ground == m_wanted->ground && areNear(poses, m_coveragePoses)) return;
    m_coveragePoses = std::move(poses);
    m_wanted = request;
    m_coverageNumber = ++m_number;
    m_coverageAwaited = true;
    worker().requestCoverage(m_coverageNumber, std::move(request));
}

void RadioOverlays::takeLinks(std::uint64_t number, RadioLinks links) {
    if (number < m_oldest) return;
    m_links = std::move(links);
    m_linksAwaited = number != m_linkNumber;
    Q_EMIT linksChanged();
}

void RadioOverlays::takeCoverage(std::uint64_t number, CoverageMap map, bool last) {
    if (number < m_oldest) return;
    m_inScene.floor = map.picture;
    m_coverage = std::move(map);
    m_coverageAwaited = !last || number != m_coverageNumber;
    Q_EMIT sceneChanged();
}

void RadioOverlays::takeGivenUp(std::uint64_t number) {
    ++m_givenUp;
    if (number < m_oldest || number != m_coverageNumber) return;
    m_coverageAwaited = false;
    Q_EMIT linksChanged();
}

void RadioOverlays::dropLinks() {
    if (!m_links) return;
    m_links.reset();
    Q_EMIT linksChanged();
}

void RadioOverlays::dropCoverage() {
    if (!m_coverage) return;
    m_coverage.reset();
    m_inScene.floor = nullptr;
    Q_EMIT sceneChanged();
}

} // namespace trundle
