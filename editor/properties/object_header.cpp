#include "editor/properties/object_header.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "editor/document/structure_edits.h"
#include "editor/properties/editors/value_field.h"
#include "editor/properties/origin_text.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"
#include "model/dotted_path.h"
#include "project/edits/plans.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

QString link(const QString& to, const QString& shown) {
    return QStringLiteral("<a href='%1' style='color:%2; text-decoration:none'>%3</a>")
        .arg(to.toHtmlEscaped(), ink(Ink::Accent).name(), shown.toHtmlEscaped());
}

QString faint(const QString& html) {
    return QStringLiteral("<span style='color:%1'>%2</span>").arg(ink(Ink::Faint).name(), html);
}

/// How many leading components of the path name one object: both of "Material.red", one of "robot0".
qsizetype firstPathStep(const ObjectValues& object, const QStringList& words) {
    const bool byKind =
        !object.instance() && words.size() > 1 && object.loaded().registry->find(words[0].toStdString()) != nullptr;
    return byKind ? 2 : 1;
}

/// The Repeat at the top level of which the path names a member: the text has one block for all of them. Empty: it names none.
QString repeatOf(const ObjectValues& object) {
    const auto place = placeOf(object.loaded(), object.shownPath());
    if (!place) return {};
    for (const auto& [repeat, member] : place->members)
        if (repeat->isInWorld) return toQString(repeat->name);
    return {};
}

} // namespace

ObjectHeader::ObjectHeader(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_name(new ValueField(this)), m_kind(new QLabel(this)), m_path(new QLabel(this)),
      m_config(new QLabel(this)), m_singles(new QPushButton(this)) {
    setObjectName(QStringLiteral("objectHeader"));
    m_name->setObjectName(QStringLiteral("objectName"));
    m_name->setAccessibleName(tr("Name"));
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    m_name->setFont(bold);
    m_kind->setObjectName(QStringLiteral("objectKind"));
    m_path->setObjectName(QStringLiteral("objectPath"));
    m_config->setObjectName(QStringLiteral("objectConfig"));
    m_singles->setObjectName(QStringLiteral("replaceBySingles"));
    m_singles->setText(tr("Replace by single instances"));
    m_singles->setToolTip(tr("Writes each member as a separate instance with the same pose"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(10, 8, 10, 6);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    grid->addWidget(m_name, 0, 0);
    grid->addWidget(m_kind, 0, 1, Qt::AlignRight);
    grid->addWidget(m_path, 1, 0, 1, 2);
    grid->addWidget(m_config, 2, 0, 1, 2);
    grid->addWidget(m_singles, 3, 0, 1, 2, Qt::AlignLeft);
    grid->setColumnStretch(0, 1);
    for (QLabel* label : {m_kind, m_path, m_config}) {
        label->setTextFormat(Qt::RichText);
        label->setWordWrap(label != m_kind);
        connect(label, &QLabel::linkActivated, this, &ObjectHeader::follow);
    }
    connect(m_name, &ValueField::entered, this, &ObjectHeader::rename);
    connect(m_name, &ValueField::refusedChanged, m_name, &QWidget::setToolTip);
    connect(m_singles, &QPushButton::clicked, this, [this] {
        const std::string path = m_object;
        const Status done = m_document.edits().apply(tr("Replace %1 by single instances").arg(toQString(path)),
                                                     planReplaceBySingles(*m_document.loaded(), path));
        if (!done) m_singles->setToolTip(toQString(done.error().message));
    });
}

void ObjectHeader::rename(const QString& name) {
    const std::string path = m_object;
    const QPointer<ValueField> field(m_name);
    const Status done = m_document.structure().rename(tr("Rename %1 to %2").arg(m_name->value(), name.trimmed()), path,
                                                      name.trimmed().toStdString());
    if (!done && field) field->setError(toQString(done.error().message));
}

void ObjectHeader::display(const Objects& objects) {
    if (objects.size() == 1) showOne(*objects[0]);
    else showSeveral(objects);
}

void ObjectHeader::showOne(const ObjectValues& object) {
    if (m_object != object.path()) m_name->restore(); // a name typed for the previous object must not apply to this one
    m_object = object.path();
    const Kind* kind = object.kind();
    const Part* part = object.part();
    const bool experiment = !part;
    m_help = kind ? toQString(kind->help) : tr("Unknown kind: the module that provides it is not loaded or could not be read.");
    m_name->setReadOnly(experiment);
    m_name->setFocusPolicy(experiment ? Qt::NoFocus : Qt::StrongFocus);
    m_name->setFaint(part && !part->block->name);
    m_name->setValue(experiment ? tr("Experiment") : toQString(part->name));
    m_kind->setText(faint(experiment ? QString() : toQString(part->block->type.text).toHtmlEscaped()));
    m_kind->setToolTip(m_help);
    const auto place = placeOf(object.loaded(), object.path());
    const bool isInRepeat = place && !place->around.empty();
    m_singles->setVisible(part && part->is(Role::Layout) && object.isInstance() && !isInRepeat);
    showPath(object);
    showConfig(object);
}

void ObjectHeader::showSeveral(const Objects& objects) {
    m_object.clear();
    m_name->restore();
    m_name->setReadOnly(true);
    m_name->setFocusPolicy(Qt::NoFocus);
    m_name->setFaint(false);
    m_name->setValue(tr("%1 objects").arg(objects.size()));
    QStringList kinds;
    for (const auto& object : objects) {
        const QString kind = object->part() ? toQString(object->part()->block->type.text) : QString();
        if (!kinds.contains(kind)) kinds << kind;
    }
    m_help = tr("Properties that all of them have. A change applies to all of them.");
    const QString shown = kinds.size() > 3 ? tr("%1 kinds").arg(kinds.size()) : kinds.join(QStringLiteral(", "));
    m_kind->setText(faint(shown.toHtmlEscaped()));
    m_kind->setToolTip(m_help);
    for (QWidget* w : std::initializer_list<QWidget*>{m_path, m_config, m_singles}) w->hide();
}

void ObjectHeader::showPath(const ObjectValues& object) {
    QStringList words;
    const DottedPath path(object.shownPath());
    for (const std::string& word : path.words()) words << toQString(word);
    m_path->setVisible(!words.isEmpty());
    if (words.isEmpty()) return;
    QStringList steps{link(QStringLiteral("select:"), tr("experiment"))};
    for (qsizetype used = firstPathStep(object, words); used <= words.size(); ++used) {
        const QString name = words.mid(0, used).join(QLatin1Char('.'));
        const QString shown = used == firstPathStep(object, words) ? name : words[used - 1];
        steps << (used == words.size() ? faint(shown.toHtmlEscaped()) : link(QStringLiteral("select:") + name, shown));
    }
    m_path->setText(steps.join(faint(QStringLiteral(" › "))));
}

void ObjectHeader::showConfig(const ObjectValues& object) {
    QString line;
    const Part *config = object.isInstance() ? object.config() : object.definedIn(), *part = object.part();
    m_configPlace = {};
    if (config && part && (object.isInstance() || object.inConfig())) {
        m_configPlace = object.isInstance() ? config->nameRange() : part->nameRange();
        const QString path = toQString((config->kind ? config->kind->name : std::string("RobotConfig")) + "." + config->name);
        line = faint(tr("created from")) + QLatin1Char(' ') + link(QStringLiteral("select:") + path, toQString(config->name)) +
               QLatin1Char(' ') + faint(tr("in")) + QLatin1Char(' ') +
               link(QStringLiteral("jump"), placeWords(object.loaded(), m_configPlace));
    } else if (part) {
        m_configPlace = part->nameRange();
        line = faint(tr("in")) + QLatin1Char(' ') + link(QStringLiteral("jump"), placeWords(object.loaded(), m_configPlace));
    }
    if (const QString target = targetWords(object, m_document); !target.isEmpty() && !object.member())
        line += QStringLiteral("<br>") + faint(target.toHtmlEscaped());
    const QString of = object.member() ? toQString(object.path()) : repeatOf(object);
    if (!of.isEmpty())
        line += QStringLiteral("<br>") + faint(tr("One of %1: a change here applies to all of them.").arg(of).toHtmlEscaped());
    m_config->setText(line);
    m_config->setVisible(!line.isEmpty());
}

void ObjectHeader::follow(const QString& link) {
    if (link == QLatin1String("jump")) Q_EMIT jumpRequested(m_configPlace);
    else if (link.startsWith(QLatin1String("select:"))) Q_EMIT selectRequested(link.mid(7).toStdString());
}

} // namespace trundle
