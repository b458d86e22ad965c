// needs: an instance whose config can be evaluated with other Params (InstanceVariants).
// assumes: near its present value a Param changes the extents smoothly; a Param that is not a number has no effect.
// method: each Param is varied slightly in both directions while the others are fixed; the change of the bounding box gives the
//   axes it affects and which side moves. An axis is assigned the only Param that affects it; of several, the only one whose
//   effect on this axis is as large as on any other. The value for a wanted extent is found by the secant method, which takes one
//   step where the config is linear.
// data: axes of the config's frame; Param values in their own units.
#include "editor/viewport/gizmo/param_sizes.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "base/units.h"
#include "lang/number_text.h"
#include "scene/shapes/extents.h"

namespace trundle {
namespace {

constexpr double kShare = 1e-3;     // of a Param's value, variation for the numerical derivative
constexpr double kLeastStep = 1e-4; // m (or another unit), minimum variation
constexpr double kNoChange = 1e-4;  // fraction of the largest possible change; smaller changes count as none
constexpr double kAsMuch = 0.99;    // fraction of the change along another axis
constexpr double kExact = 1e-9;     // m
constexpr int kSecants = 12;

QString trSizes(const char* text) { return QCoreApplication::translate("ParamSizes", text); }

} // namespace

std::optional<ParamSizes> ParamSizes::of(const LoadedProject& loaded, const std::string& path) {
    const auto place = placeOf(loaded, path);
    if (!place || !place->part || place->member) return std::nullopt;
    const Part* config = configOf(loaded, *place->part);
    std::optional<InstanceVariants> variants = config ? variantsOf(loaded, *place) : std::nullopt;
    if (!variants) return std::nullopt;
    ParamSizes sizes(path, std::move(*variants));
    sizes.m_config = config->name;
    const InstanceVariants::Params all = sizes.m_variants.params();
    for (const auto& [name, value] : all) {
        if (value.elements.size() != 1 || value.elements[0].kind != GivenElement::Kind::Number) continue;
        Param param{name, {}, value, convertUnit(1, value.elements[0].unit, "m").value_or(1), false};
        const SourceAssignment* own = place->part->assignments.find(name);
        const SourceParam* there = config->param(name);
        const Value& written = own ? *own->value : *there->value;
        param.written = written.elements.size() == 1 && written.elements[0].kind == Element::Kind::Number;
        // A formula of the config may have another meaning, or be invalid, in the instance.
        if (own || param.written)
            param.text = loaded.outline->texts().slice(own ? own->valueRange() : SourceRange{there->valueFile, written.range});
        sizes.m_params.push_back(std::move(param));
    }
    const auto now = sizes.m_variants.geoms({});
    if (!now || now->empty()) return std::nullopt;
    sizes.m_shapes = now->size();
    const auto box = sizes.boxWith({});
    if (!box || box->empty()) return std::nullopt; // only a floor
    sizes.m_box = *box;
    sizes.findAxes(all);
    if (now->size() == 1 && !sizes.canSizeAny() && sizes.refusal().isEmpty()) {
        const GeomSpec& geom = now->front().geom;
        const Part* body = config->find(geom.name) ? nullptr : &config->parts.front();
        for (const Part& part : config->parts)
            if (part.is(Role::Body) && part.find(geom.name)) body = &part;
        sizes.m_onlyShape = (body ? body->name + "." : std::string()) + geom.name;
    }
    return sizes;
}

std::optional<Bounds> ParamSizes::boxWith(const InstanceVariants::Params& changed) const {
    const auto geoms = m_variants.geoms(changed);
    if (!geoms || geoms->size() != m_shapes) return std::nullopt; // a value is invalid
    Bounds box;
    for (const bool hiddenToo : {false, true}) {
        for (const ConfigGeom& each : *geoms)
            if (each.geom.visible || hiddenToo) box.add(boundsOf(each.geom, each.body));
        if (!box.empty()) break;
    }
    return box;
}

InstanceVariants::Params ParamSizes::with(const Param& param, double number) const {
    GivenValue value = param.value;
    value.elements[0].number = number;
    return {{param.name, value}};
}

void ParamSizes::findAxes(const InstanceVariants::Params& all) {
    std::vector<Effect> effects;
    for (const Param& param : m_params) effects.push_back(effectOf(param, all));
    for (int k = 0; k < 3; ++k) m_axes[std::size_t(k)] = axisFrom(k, effects);
}

/// Measured with the Param a little smaller and larger.
ParamSizes::Effect ParamSizes::effectOf(const Param& param, const InstanceVariants::Params& all) const {
    const double number = param.value.elements[0].number, step = std::max(std::abs(number) * kShare, kLeastStep / param.metres);
    const auto moved = [&](double to) {
        InstanceVariants::Params held = all;
        for (auto& [name, value] : held)
            if (name == param.name) value.elements[0].number = to;
        return boxWith(held);
    };
    const std::optional<Bounds> less = moved(number - step), more = moved(number + step);
    Effect effect;
    if (!less && !more) return effect;
    const double span = (less && more ? 2 : 1) * step;
    const Bounds &from = less ? *less : m_box, &to = more ? *more : m_box;
    effect.low = (to.low - from.low) / span;
    effect.high = (to.high - from.high) / span;
    return effect;
}

/// The Param that sets the extent along an axis: the only one that changes it, or the only one that changes it most.
ParamSizes::Axis ParamSizes::axisFrom(int k, const std::vector<Effect>& effects) const {
    std::vector<int> setters, own;
    for (int i = 0; i < int(effects.size()); ++i) {
        const Vec3 slope = effects[i].slope();
        if (std::abs(slope[k]) < kNoChange * m_params[i].metres) continue;
        setters.push_back(i);
        if (std::abs(slope[k]) >= kAsMuch * slope.cwiseAbs().maxCoeff()) own.push_back(i);
    }
    Axis axis;
    const std::vector<int>& meant = setters.size() == 1 ? setters : own;
    if (meant.size() != 1) {
        for (const int i : setters) axis.several.push_back(m_params[i].name);
        return axis;
    }
    const Effect& effect = effects[meant[0]];
    const Vec3 slope = effect.slope();
    const auto stays = [&](double side) { return std::abs(side) < kNoChange * std::abs(slope[k]); };
    int across = 0; // number of other axes with the same effect
    for (int other = 0; other < 3; ++other)
        across += other != k && std::abs(slope[other]) >= kAsMuch * slope.cwiseAbs().maxCoeff();
    axis.param = meant[0];
    axis.slope = slope[k];
    axis.sides = stays(effect.low[k])    ? Sides::Upper
                 : stays(effect.high[k]) ? Sides::Lower
                 : across > 0            ? Sides::Middle
                                         : Sides::Both;
    return axis;
}

SizeName ParamSizes::sizeName(int axis) const {
    const Axis& set = m_axes[std::size_t(axis)];
    if (set.param < 0) return {};
    const Param& param = m_params[std::size_t(set.param)];
    const double perMetre = set.slope / param.metres, value = param.value.elements[0].number * param.metres;
    const bool proportional = std::abs(perMetre * value - m_box.size()[axis]) < 1e-6 * std::max(1.0, m_box.size()[axis]);
    // A length is shown under the Param's name and with its value; otherwise the extent is shown, with the axis.
    if (proportional && perMetre > 0) return {QString::fromStdString(param.name), 2 / perMetre, set.sides};
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    return {trSizes("%1: size along %2").arg(QString::fromStdString(param.name), QLatin1String(kAxes[axis])), 2, set.sides};
}

QString ParamSizes::refusal() const {
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    QStringList none, context;
    for (int k = 0; k < 3; ++k) {
        const Axis& axis = m_axes[std::size_t(k)];
        if (axis.param >= 0) continue;
        if (axis.several.empty()) {
            none += QLatin1String(kAxes[k]);
            continue;
        }
        QStringList names;
        for (const std::string& name : axis.several) names += QString::fromStdString(name);
        context += trSizes("along %1 it depends on %2").arg(QLatin1String(kAxes[k]), names.join(trSizes(" and ")));
    }
    if (none.isEmpty() && context.isEmpty()) return {};
    if (m_shapes == 1 && !canSizeAny() && context.isEmpty()) return {}; // its only shape can be scaled directly
    const QString who = QString::fromStdString(m_path), config = QString::fromStdString(m_config);
    if (m_params.empty())
        return trSizes("%1 cannot be scaled: %2 has no Params. Give it some, or scale its shapes").arg(who, config);
    if (!none.isEmpty()) context += trSizes("along %1 no Param sets it").arg(none.join(QStringLiteral(", ")));
    QStringList names;
    for (const Param& param : m_params) names += QString::fromStdString(param.name);
    return trSizes("Size of %1: %2 · Params of %3: %4. Set them in Properties")
        .arg(who, context.join(QStringLiteral(" · ")), config, names.join(QStringLiteral(", ")));
}

ParamSizes::Change ParamSizes::resized(int axis, double extent, double fineness) const {
    const Axis& set = m_axes[std::size_t(axis)];
    const Param& param = m_params[std::size_t(set.param)];
    const double first = param.value.elements[0].number;
    const auto box = [&](double number) { return boxWith(with(param, number)); };
    // Steps of the Param that change the extent by at most `fineness`.
    const double step = std::pow(10.0, std::floor(std::log10(fineness / std::abs(set.slope)) + 1e-9));
    double number = first, slope = set.slope;
    Bounds last = m_box;
    for (int i = 0; i < kSecants; ++i) {
        const double next = number + (extent - last.size()[axis]) / slope;
        const auto there = box(next);
        if (!there) {
            number = next; // writing it reports the reason
            break;
        }
        const double grown = there->size()[axis] - last.size()[axis];
        if (std::abs(next - number) > 1e-15 && std::abs(grown) > kExact) slope = grown / (next - number);
        number = next;
        last = *there;
        if (std::abs(extent - last.size()[axis]) < kExact) break;
    }
    number = std::abs(extent - m_box.size()[axis]) < kExact ? first : step * std::round(number / step);
    const std::string unit = param.value.elements[0].unit;
    const double before[] = {first}, after[] = {number};
    std::string text = withNumbers(param.text, before, after, unit.empty() ? "m" : unit.c_str(), step);
    if (!param.written && !unit.empty() && (number != first || param.text.empty())) text += " " + unit;
    return {param.name, text, param.text, box(number).value_or(last)};
}

} // namespace trundle
