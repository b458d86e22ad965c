// The internalId of an index identifies its parent: 0 for a diagnostic, its row + 1 for its children. Children: notes, then
// fixes, then suggestions without a fix.
#include "editor/problems/problems_model.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "editor/document/problems_in_code.h"
#include "editor/problems/problem_icons.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"
#include "project/edits/edit_target.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

/// Suggestions for which no fix is listed.
std::vector<std::string> bareSuggestions(const Diagnostic& d) {
    std::vector<std::string> bare;
    for (const std::string& word : d.suggestions)
        if (std::none_of(d.fixes.begin(), d.fixes.end(), [&](const Fix& fix) { return fix.title == word; })) bare.push_back(word);
    return bare;
}

bool isInCode(const Diagnostic& d) { return d.place.isKnown(); }

bool before(const SourceRange& a, const SourceRange& b) {
    if (a.known() != b.known()) return b.known(); // diagnostics without a location come first: they concern the whole project
    return a < b;
}

} // namespace

QString problemPlace(const LoadedProject& loaded, const SourceRange& place) {
    if (!place.known() || place.file >= loaded.sources.size()) return {};
    const SourceText& source = *loaded.sources[place.file].text;
    const bool file = place.file < loaded.paths.size() && !loaded.paths[place.file].empty();
    const QString name = toQString(file ? shownInProject(loaded.paths[place.file], loaded.projectFolder) : source.path());
    const LineColumn at = source.position(place.range.begin);
    return QStringLiteral("%1:%2:%3").arg(name, QString::number(at.line), QString::number(at.column));
}

void ProblemsModel::setLoaded(std::shared_ptr<const LoadedProject> loaded, bool isSame) {
    // Most edits do not change the list; avoiding a reset then keeps the scroll position and the expanded rows.
    const std::shared_ptr<const LoadedProject> kept = std::exchange(m_loaded, std::move(loaded));
    std::vector<Diagnostic> inCode;
    if (m_loaded) std::ranges::copy_if(m_loaded->diagnostics.all(), std::back_inserter(inCode), isInCode);
    const std::shared_ptr<const ProblemsInCode> inCodeBefore =
        std::exchange(m_inCode, std::make_shared<const ProblemsInCode>(shownInCode(std::move(inCode), m_loaded)));
    const std::vector<Entry> before = m_entries;
    std::vector<Diagnostic> modelBefore;
    if (m_modelTexts != m_loaded) modelBefore.swap(m_modelProblems); // `before` has pointers into it
    rebuildAfter(before, isSame && modelBefore.empty());
}

/// Rebuilds the list, with a model reset only if its content differs. The diagnostics that `before` points to must still exist.
void ProblemsModel::rebuildAfter(const std::vector<Entry>& before, bool isSame) {
    rebuild();
    if (isSame || looksAs(before)) {
        if (!m_entries.empty()) Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(m_entries.size()) - 1, ColumnCount - 1));
    } else {
        std::vector<Entry> now = std::exchange(m_entries, before);
        beginResetModel();
        m_entries = std::move(now);
        endResetModel();
    }
    Q_EMIT countsChanged(m_errors, m_warnings);
}

bool ProblemsModel::looksAs(const std::vector<Entry>& before) const {
    return std::equal(m_entries.begin(), m_entries.end(), before.begin(), before.end(), [&](const Entry& a, const Entry& b) {
        const Diagnostic &x = *a.diagnostic, &y = *b.diagnostic;
        return a.source == b.source && x.severity == y.severity && x.code == y.code && x.message == y.message &&
               childCount(a) == childCount(b);
    });
}

void ProblemsModel::setRun(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts) {
    beginResetModel();
    m_run = std::move(problems);
    m_runTexts = std::move(texts);
    rebuild();
    endResetModel();
    Q_EMIT countsChanged(m_errors, m_warnings);
}

void ProblemsModel::setBuild(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> sources) {
    beginResetModel();
    m_build = std::move(problems);
    m_buildTexts = std::move(sources);
    rebuild();
    endResetModel();
    Q_EMIT countsChanged(m_errors, m_warnings);
}

void ProblemsModel::setModelProblems(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts) {
    const std::shared_ptr<const LoadedProject> kept = std::exchange(m_modelTexts, std::move(texts));
    if (m_modelProblems.empty() && problems.empty()) return;
    const std::vector<Diagnostic> modelBefore = std::exchange(m_modelProblems, std::move(problems));
    rebuildAfter(std::vector<Entry>(m_entries));
}

const std::shared_ptr<const LoadedProject>& ProblemsModel::textsOf(const Entry& entry) const {
    switch (entry.source) {
    case Source::Run: return m_runTexts;
    case Source::Model: return m_modelTexts;
    case Source::Build: return m_buildTexts;
    case Source::Code: return m_inCode->texts;
    case Source::Texts: break;
    }
    return m_loaded;
}

void ProblemsModel::setFilter(bool errors, bool warnings, const QString& words) {
    beginResetModel();
    m_showErrors = errors;
    m_showWarnings = warnings;
    m_words = words.trimmed();
    rebuild();
    endResetModel();
}

void ProblemsModel::setOrder(ProblemOrder order) {
    beginResetModel();
    m_order = order;
    rebuild();
    endResetModel();
}

bool ProblemsModel::wanted(const Diagnostic& d) const {
    if (d.severity == Severity::Error ? !m_showErrors : !m_showWarnings) return false;
    return m_words.isEmpty() || toQString(d.message).contains(m_words, Qt::CaseInsensitive) ||
           toQString(codeName(d.code)).contains(m_words, Qt::CaseInsensitive);
}

void ProblemsModel::rebuild() {
    m_entries.clear();
    m_errors = m_warnings = 0;
    const auto take = [&](const Diagnostic& d, Source source) {
        if (d.severity == Severity::Error) ++m_errors;
        else ++m_warnings;
        if (!wanted(d)) return;
        m_entries.push_back({&d, source, {}});
        if (source == Source::Build) return; // without fixes
        if (const auto& texts = textsOf(m_entries.back())) m_entries.back().fixes = applicableFixes(*texts, d);
        if (source == Source::Texts && d.code == Code::ModuleNotTrusted) m_entries.back().fixes.push_back(&m_trust);
    };
    const auto refuses = [](const Diagnostic& d) { return d.severity == Severity::Error && d.code == Code::DeviceSetup; };
    // If a run was refused for an error that the model check also found in these texts, show only the latter, which has a
    // location and a fix.
    const bool sameTexts = m_runTexts && m_runTexts == m_modelTexts,
               known = sameTexts && std::ranges::any_of(m_modelProblems, refuses);
    const auto isAmong = [](const std::vector<Diagnostic>& all, const Diagnostic& d) {
        return std::ranges::any_of(all, [&](const Diagnostic& each) { return each.code == d.code && each.message == d.message; });
    };
    for (const Diagnostic& d : m_run)
        if (!(known && refuses(d)) && (isInCode(d) || !sameTexts || !isAmong(m_modelProblems, d))) take(d, Source::Run);
    for (const Diagnostic& d : m_build) take(d, Source::Build);
    const std::size_t ofRun = m_entries.size();
    if (m_loaded)
        for (const Diagnostic& d : m_loaded->diagnostics.all())
            if (!isInCode(d)) take(d, Source::Texts);
    if (m_inCode)
        for (const Diagnostic& d : m_inCode->problems) take(d, Source::Code);
    std::vector<Diagnostic> inCode; // of the run: with the place in the source of a module, which the check has not
    std::ranges::copy_if(m_run, std::back_inserter(inCode), [](const Diagnostic& d) { return isInCode(d); });
    for (const Diagnostic& d : m_modelProblems)
        if (!isAmong(inCode, d)) take(d, Source::Model);
    std::stable_sort(m_entries.begin() + static_cast<std::ptrdiff_t>(ofRun), m_entries.end(),
                     [](const Entry& a, const Entry& b) { return before(a.diagnostic->range, b.diagnostic->range); });
    if (m_order == ProblemOrder::Severity)
        std::stable_sort(m_entries.begin(), m_entries.end(),
                         [](const Entry& a, const Entry& b) { return a.diagnostic->severity < b.diagnostic->severity; });
}

const ProblemsModel::Entry* ProblemsModel::entryAt(const QModelIndex& index) const {
    if (!index.isValid()) return nullptr;
    const auto row =
        index.internalId() == 0 ? static_cast<std::size_t>(index.row()) : static_cast<std::size_t>(index.internalId() - 1);
    return row < m_entries.size() ? &m_entries[row] : nullptr;
}

const Diagnostic* ProblemsModel::diagnosticAt(const QModelIndex& index) const {
    const Entry* entry = entryAt(index);
    return entry ? entry->diagnostic : nullptr;
}

std::shared_ptr<const LoadedProject> ProblemsModel::textsAt(const QModelIndex& index) const {
    const Entry* entry = entryAt(index);
    return entry ? textsOf(*entry) : nullptr;
}

SourceRange ProblemsModel::placeAt(const QModelIndex& index) const {
    const Diagnostic* d = diagnosticAt(index);
    if (!d) return {};
    const auto row = static_cast<std::size_t>(index.row());
    return index.internalId() != 0 && row < d->notes.size() ? d->notes[row].second : d->range;
}

const Fix* ProblemsModel::fixAt(const QModelIndex& index) const {
    const Entry* entry = entryAt(index);
    if (!entry || textsOf(*entry) != m_loaded) return nullptr;
    const Diagnostic& d = *entry->diagnostic;
    const std::vector<const Fix*>& fixes = entry->fixes;
    if (index.internalId() == 0) return fixes.empty() ? nullptr : fixes.front();
    const std::size_t row = static_cast<std::size_t>(index.row());
    if (row < d.notes.size()) return nullptr;
    return row - d.notes.size() < fixes.size() ? fixes[row - d.notes.size()] : nullptr;
}

QModelIndex ProblemsModel::index(int row, int column, const QModelIndex& parent) const {
    if (row < 0 || column < 0 || column >= ColumnCount || row >= rowCount(parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : quintptr{0});
}

QModelIndex ProblemsModel::parent(const QModelIndex& child) const {
    if (!child.isValid() || child.internalId() == 0) return {};
    return createIndex(static_cast<int>(child.internalId() - 1), 0, quintptr{0});
}

std::size_t ProblemsModel::childCount(const Entry& entry) const {
    const Diagnostic& d = *entry.diagnostic;
    return d.notes.size() + entry.fixes.size() + bareSuggestions(d).size();
}

int ProblemsModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return static_cast<int>(m_entries.size());
    if (parent.internalId() != 0 || parent.column() != 0) return 0;
    const Entry* entry = entryAt(parent);
    return entry ? static_cast<int>(childCount(*entry)) : 0;
}

int ProblemsModel::columnCount(const QModelIndex&) const { return ColumnCount; }

QString ProblemsModel::placeText(const SourceRange& place, const Entry& entry) const {
    const auto& texts = textsOf(entry);
    const QString where = texts ? problemPlace(*texts, place) : QString();
    return where.isEmpty() && entry.source == Source::Run ? tr("run") : where;
}

QVariant ProblemsModel::data(const QModelIndex& index, int role) const {
    const Entry* entry = entryAt(index);
    if (!entry) return {};
    const Diagnostic& d = *entry->diagnostic;
    if (index.internalId() != 0) return childData(d, *entry, index.row(), index.column(), role);
    if (role == Qt::DecorationRole && index.column() == Message) return severityIcon(d.severity);
    if (role == Qt::ForegroundRole && index.column() != Message) return ink(Ink::Faint);
    if (role == Qt::ToolTipRole && index.column() == Place) return placeText(d.range, *entry);
    const QString code = entry->source == Source::Build ? tr("build") : toQString(codeName(d.code)); // a compiler has codes of its own
    if (role == Qt::ToolTipRole) return QStringLiteral("%1  %2").arg(code, toQString(d.message));
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
    if (role == Qt::AccessibleTextRole && index.column() == Message)
        return severityWord(d.severity) + QStringLiteral(": ") + toQString(d.message);
    switch (index.column()) {
    case Message: return toQString(d.message);
    case CodeColumn: return code;
    default: return placeText(d.range, *entry);
    }
}

QVariant ProblemsModel::childData(const Diagnostic& d, const Entry& entry, int row, int column, int role) const {
    auto i = static_cast<std::size_t>(row);
    if (i < d.notes.size()) {
        if (role == Qt::DisplayRole && column == Message) return toQString(d.notes[i].first);
        if ((role == Qt::DisplayRole || role == Qt::ToolTipRole) && column == Place) return placeText(d.notes[i].second, entry);
        return role == Qt::ForegroundRole ? QVariant(ink(Ink::Faint)) : QVariant();
    }
    i -= d.notes.size();
    const std::vector<const Fix*>& fixes = entry.fixes;
    if (i < fixes.size()) {
        if (column == Message && role == Qt::DisplayRole) return tr("Fix: %1").arg(toQString(fixes[i]->title));
        if (column == Message && role == Qt::DecorationRole) return themedIcon(QStringLiteral("fix"));
        return role == Qt::ForegroundRole ? QVariant(ink(Ink::Accent)) : QVariant();
    }
    i -= fixes.size();
    const std::vector<std::string> bare = bareSuggestions(d);
    if (i < bare.size() && column == Message && role == Qt::DisplayRole) return tr("Suggestion: %1").arg(toQString(bare[i]));
    return role == Qt::ForegroundRole ? QVariant(ink(Ink::Faint)) : QVariant();
}

QVariant ProblemsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == Message ? tr("Problem") : section == CodeColumn ? tr("Code") : tr("Place");
}

} // namespace trundle
