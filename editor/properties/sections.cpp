#include "editor/properties/sections.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include <QObject>

namespace trundle {
namespace {

struct Section {
    const char* title;
    std::initializer_list<std::string_view> names;
};

const Section kCommon[] = {
    {QT_TRANSLATE_NOOP("QObject", "Place"), {"Pos", "HPR", "In", "Mirror", "Anchor", "Anchor2", "Axis", "Axis2"}},
    {QT_TRANSLATE_NOOP("QObject", "Mass"), {"Mass", "Density", "CenterOfMass", "Inertia"}},
    {QT_TRANSLATE_NOOP("QObject", "Appearance and contact"), {"Material", "Surface", "Collide", "Visible"}},
    {QT_TRANSLATE_NOOP("QObject", "Schedule"), {"UpdatePeriod", "Isolation", "Budget"}},
};
const Section kSettings[] = {
    {QT_TRANSLATE_NOOP("QObject", "Time"), {"Tick", "Duration", "Seed"}},
    {QT_TRANSLATE_NOOP("QObject", "Physics"), {"Engine", "Gravity", "Solver", "Iterations", "Threads", "ErrorReduction", "NoContact"}},
    {QT_TRANSLATE_NOOP("QObject", "About"), {"Title", "Description"}},
};

template <std::size_t N> const char* titleIn(const Section (&sections)[N], const std::string& name) {
    for (const Section& section : sections)
        if (std::find(section.names.begin(), section.names.end(), name) != section.names.end()) return section.title;
    return nullptr;
}

} // namespace

QString sectionOf(const Kind& kind, const Property& property) {
    if (kind.role == Role::Settings) {
        const char* title = titleIn(kSettings, property.name);
        return title ? QObject::tr(title) : QObject::tr("Controllers");
    }
    const bool geometry = kind.role == Role::Body || kind.role == Role::Geom || kind.role == Role::Joint ||
                          kind.role == Role::Instance || kind.role == Role::Layout || kind.role == Role::Repeat ||
                          kind.role == Role::Region || kind.role == Role::Device || kind.role == Role::Controller;
    const char* title = geometry ? titleIn(kCommon, property.name) : nullptr;
    return title ? QObject::tr(title) : QString::fromStdString(kind.name);
}

} // namespace trundle
