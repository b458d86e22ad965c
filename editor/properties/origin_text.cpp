#include "editor/properties/origin_text.h"

#include <algorithm>

#include <QObject>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "model/dotted_path.h"
#include "project/edits/edit_target.h"
#include "project/loading/search.h"
#include "project/objects/part_values.h"

namespace trundle {

QString placeWords(const LoadedProject& loaded, const SourceRange& place) {
    if (!place.known() || place.file >= loaded.sources.size()) return {};
    const SourceText& source = *loaded.sources[place.file].text;
    const std::string& file = place.file < loaded.paths.size() ? loaded.paths[place.file] : source.path();
    const QString name = QString::fromStdString(shownInProject(file, loaded.projectFolder));
    return QStringLiteral("%1:%2").arg(name, QString::number(source.position(place.range.begin).line));
}

QString overrideWords(const FieldValue& value) {
    constexpr qsizetype kMost = 40;
    const QString config = QString::fromStdString(value.config);
    QString inherited = QString::fromStdString(value.inherited).simplified();
    if (inherited.size() > kMost) inherited = inherited.left(kMost - 1) + QStringLiteral("…");
    const QString where = value.setForAll.empty()
                              ? QObject::tr("override here")
                              : QObject::tr("override for all, %1").arg(QString::fromStdString(value.setForAll));
    if (config.isEmpty()) return where;
    return inherited.isEmpty() ? QObject::tr("%1; %2 has no value").arg(where, config)
                               : QObject::tr("%1; %2 has %3").arg(where, config, inherited);
}

namespace {

/// The shipped config of which a change of the object makes a copy; nullptr: none. Of what a Part has, that which has the Part.
const Part* copiedConfig(const ObjectValues& object) {
    const Part *config = object.config(), *instance = object.instance();
    const LoadedProject& loaded = object.loaded();
    if (!instance) return config && isShippedFile(loaded, config->file) ? config : nullptr;
    const Part* holder = instance->isPartUse() || instance->is(Role::Config) ? holderOf(loaded, *instance) : nullptr;
    return holder && isShippedFile(loaded, holder->file) ? holder : nullptr;
}

} // namespace

QString targetWords(const ObjectValues& object, Document& document) {
    const Part *config = object.config(), *instance = object.instance();
    const LoadedProject& loaded = object.loaded();
    const auto fileOf = [&](FileId file) { return QString::fromStdString(document.texts().shown(loaded.paths.at(file))); };
    const std::string definition = shippedDefinitionAt(loaded, object.path());
    const Part* copied = copiedConfig(object);
    if (copied || !definition.empty()) {
        const std::string name = definition.empty() ? copied->name : std::string(lastWord(definition));
        return QObject::tr("%1 came with Trundle and is read-only: a change makes a copy of it in %2.")
            .arg(QString::fromStdString(name), fileOf(0));
    }
    if (!config || !object.kind()) return {};
    const QString name = QString::fromStdString(config->name);
    if (!instance) {
        const std::size_t instances = instancesOf(loaded, *config).size();
        return instances < 2 ? QString() : QObject::tr("A change here is for all %1 instances of %2.").arg(instances).arg(name);
    }
    if (!object.inConfig() && !object.isInstance()) return {};
    std::vector<std::string> keys; // of values set in the config
    if (object.inConfig())
        for (const Property& p : object.kind()->properties) keys.push_back(p.name);
    for (const SourceParam& p : object.isInstance() ? config->params : std::vector<SourceParam>()) keys.push_back(p.name->text);
    if (object.isInstance() && config->kind)
        for (const Property& p : config->kind->properties)
            if (!object.kind()->find(p.name)) keys.push_back(p.name);
    const std::optional<ObjectLocation> place = placeOf(loaded, object.path());
    const auto key = std::ranges::find_if(keys, [&](const std::string& k) { return place && !overrideAt(loaded, *place, k); });
    if (key == keys.end()) return {};
    const EditTarget target = document.structure().targetOf(object.path() + "." + *key);
    if (!target.config) return {};
    const QString from = QString::fromStdString(target.config->name);
    const QString owner = QString::fromStdString((target.instance ? target.instance : instance)->name);
    if (target.isOverride)
        return QObject::tr("Values of %1 that are changed here become overrides of %2 in %3.")
            .arg(from, owner, fileOf(target.file));
    return QObject::tr("Values of %1 that are changed here go into %1 in %2: only %3 is created from it.")
        .arg(from, fileOf(target.file), owner);
}

QString originWords(const FieldValue& value) {
    switch (value.origin) {
    case ValueOrigin::Default: return value.text.empty() ? QObject::tr("not set") : QObject::tr("the default");
    case ValueOrigin::Own: return QObject::tr("set here");
    case ValueOrigin::Override: return overrideWords(value);
    case ValueOrigin::Config: return QObject::tr("set in the config");
    case ValueOrigin::CommandLine: return QObject::tr("set on the command line");
    }
    return {};
}

} // namespace trundle
