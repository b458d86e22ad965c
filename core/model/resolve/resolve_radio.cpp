// Resolves antenna patterns and the radio medium.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/kinds/radio_fields.h"
#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr double kMaxRadiated = 1.02; ///< tolerance for tables with rounded gains

std::vector<GainPoint> pointsOf(const std::vector<double>& pairs) {
    std::vector<GainPoint> points;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) points.push_back({pairs[i] * std::numbers::pi / 180, pairs[i + 1]});
    return points;
}

class AntennaReader {
public:
    AntennaReader(ResolveContext& context, const Part& part) : m_context(context), m_part(part) {
        ParamScope scope(&context.globals);
        scope.declare(part.params);
        m_record = context.read(part, scope, nullptr, Origin::Config);
        m_fields = fieldsFrom<AntennaPatternFields>(m_record);
    }

    std::shared_ptr<const AntennaPattern> read() {
        const bool cuts = m_record.given("Azimuth") || m_record.given("Elevation");
        if (m_record.given("Model") + cuts + m_record.given("File") > 1) {
            m_context.diagnostics.error(Code::Conflict, m_part.nameRange(),
                                        m_part.title() + " is given twice: by Model, by Azimuth and Elevation, or by File");
            return nullptr;
        }
        AntennaPattern pattern;
        if (m_record.given("File")) {
            if (!readFile(pattern)) return nullptr;
        } else if (cuts) {
            if (!arePairs("Azimuth", m_fields.azimuth) || !arePairs("Elevation", m_fields.elevation)) return nullptr;
            pattern = AntennaPattern::fromCuts(pointsOf(m_fields.azimuth), pointsOf(m_fields.elevation));
        } else {
            pattern = AntennaPattern::of(*antennaModelNamed(m_fields.model), m_fields.peakGain, m_fields.beamWidth);
        }
        checkPower(pattern, cuts);
        return std::make_shared<const AntennaPattern>(std::move(pattern));
    }

private:
    bool arePairs(const char* key, const std::vector<double>& numbers) {
        if (numbers.size() % 2 == 0) return true;
        m_context.diagnostics.error(Code::WrongCount, m_record.rangeOf(key, m_part.nameRange()),
                                    std::string(key) + " has an angle without a gain: it takes pairs of them");
        return false;
    }

    bool readFile(AntennaPattern& pattern) {
        const SourceRange place = m_record.rangeOf("File", m_part.nameRange());
        if (!m_context.assets.table) return true;
        const Result<std::string> text = m_context.assets.table(*m_fields.file, place.file);
        Result<AntennaPattern> read = text ? AntennaPattern::fromCsv(text.value()) : Result<AntennaPattern>(text.error());
        if (read) {
            pattern = std::move(read).value();
            return true;
        }
        m_context.diagnostics.error(read.error().code, place, (text ? *m_fields.file + ", " : "") + read.error().message);
        return false;
    }

    void checkPower(const AntennaPattern& pattern, bool cuts) {
        if (!cuts && !m_fields.file && !m_fields.peakGain) return; // a lossless model
        const double radiated = pattern.radiated();
        if (radiated <= kMaxRadiated) return;
        const SourceRange whole = m_part.nameRange();
        const SourceRange place = m_fields.file               ? m_record.rangeOf("File", whole)
                                  : !m_fields.azimuth.empty() ? m_record.rangeOf("Azimuth", whole)
                                  : cuts                      ? m_record.rangeOf("Elevation", whole)
                                                              : m_record.rangeOf("PeakGain", whole);
        const double over = std::ceil(100 * std::log10(radiated)) / 10;
        m_context.diagnostics.warning(Code::OutOfRange, place,
                                      m_part.title() + " radiates " + numberText(std::round(100 * radiated)) +
                                          " % of what it gets: its gains are at least " + numberText(over) + " dB too high");
    }

    ResolveContext& m_context;
    const Part& m_part;
    Record m_record;
    AntennaPatternFields m_fields;
};

MediumSettings settingsFrom(const RadioMediumFields& f) {
    MediumSettings m;
    m.model = f.model == "two_ray"        ? PropagationModel::TwoRay
              : f.model == "log_distance" ? PropagationModel::LogDistance
                                          : PropagationModel::Ideal;
    m.csma = f.mac == "csma";
    m.frequency = f.frequency;
    m.exponent = f.exponent;
    m.shadowing = f.shadowing;
    m.correlation = f.correlation;
    m.permittivity = f.permittivity;
    m.wallLoss = f.wallLoss;
    m.noiseFloor = f.noiseFloor;
    m.packetErrors = f.packetErrors;
    m.implementationLoss = f.implementationLoss;
    m.collisions = f.collisions;
    m.captureMargin = f.captureMargin;
    m.carrierSense = f.carrierSense;
    m.offsets = f.offsets;
    m.clockDrift = f.clockDrift;
    return m;
}

} // namespace

void resolveRadio(ResolveContext& context) {
    for (const Part* part : context.outline.patterns.all())
        if (auto pattern = AntennaReader(context, *part).read())
            context.out.antennas.push_back({part->name, std::move(pattern), part->range});
    const Part* first = nullptr;
    for (const Part* part : context.outline.world.all()) {
        if (!part->is(Role::Medium)) continue;
        if (first) {
            context.diagnostics
                .error(Code::DuplicateName, part->nameRange(), "there is one RadioMedium already, shared by all radios")
                .notes.emplace_back("the first one", first->nameRange());
            continue;
        }
        first = part;
        ParamScope scope(&context.globals);
        scope.declare(part->params);
        context.out.medium = settingsFrom(fieldsFrom<RadioMediumFields>(context.read(*part, scope, nullptr, Origin::Config)));
    }
    context.out.medium.seed = context.out.settings.seed;
}

std::string mirroredAntenna(ResolveContext& context, const std::string& name) {
    auto& antennas = context.out.antennas;
    const auto named = [&](const std::string& wanted) { return std::ranges::find(antennas, wanted, &AntennaSpec::name); };
    const std::string image = name + " mirrored"; // no name in a text has a blank
    if (named(image) != antennas.end()) return image;
    const auto described = named(name);
    if (described == antennas.end() || described->pattern->isSymmetric()) return name;
    antennas.push_back({image, std::make_shared<const AntennaPattern>(described->pattern->mirrored()), described->range});
    return image;
}

std::shared_ptr<const AntennaPattern> antennaNamed(const ExperimentSpec& experiment, const std::string& name) {
    for (const AntennaSpec& antenna : experiment.antennas)
        if (antenna.name == name) return antenna.pattern;
    const std::optional<AntennaModel> model = antennaModelNamed(name);
    return model ? std::make_shared<const AntennaPattern>(AntennaPattern::of(*model)) : nullptr;
}

} // namespace trundle
