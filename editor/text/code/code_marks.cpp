#include "editor/text/code/code_marks.h"

namespace trundle {
namespace {

using Sci = QsciScintillaBase;

int indicatorOf(Severity severity) {
    return severity == Severity::Error ? kErrorRange : severity == Severity::Warning ? kWarningRange : kHintRange;
}
int markerOf(Severity severity) {
    return severity == Severity::Error ? kErrorMark : severity == Severity::Warning ? kWarningMark : kHintMark;
}

} // namespace

void CodeMarks::mark(int indicator, long from, long to) {
    if (from >= to) return;
    m_edit.SendScintilla(Sci::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
    m_edit.SendScintilla(Sci::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), to - from);
}

void CodeMarks::clear(int indicator) {
    m_edit.SendScintilla(Sci::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
    m_edit.SendScintilla(Sci::SCI_INDICATORCLEARRANGE, 0UL, m_text.size());
}

void CodeMarks::showProblems(const std::vector<Diagnostic>& problems) {
    for (const int indicator : {kErrorRange, kWarningRange, kHintRange}) clear(indicator);
    for (const int marker : {kErrorMark, kWarningMark, kHintMark})
        m_edit.SendScintilla(Sci::SCI_MARKERDELETEALL, static_cast<unsigned long>(marker));
    for (const Diagnostic& problem : problems) {
        const TextRange range = problem.range.range;
        long from = m_text.position(range.begin), to = m_text.position(range.end);
        if (from >= to) { // the error is an omission: mark the character next to it
            to = m_edit.SendScintilla(Sci::SCI_POSITIONAFTER, static_cast<unsigned long>(from));
            if (to == from || m_edit.SendScintilla(Sci::SCI_GETCHARAT, static_cast<unsigned long>(from)) <= ' ') {
                to = from;
                from = m_edit.SendScintilla(Sci::SCI_POSITIONBEFORE, static_cast<unsigned long>(from));
            }
        }
        mark(indicatorOf(problem.severity), from, to);
        m_edit.SendScintilla(Sci::SCI_MARKERADD, m_text.lineAt(range.begin), static_cast<long>(markerOf(problem.severity)));
    }
}

void CodeMarks::showMatches(const std::vector<TextRange>& matches) {
    clear(kMatchRange);
    for (const TextRange& match : matches) mark(kMatchRange, match);
}

void CodeMarks::showBlock(TextRange block) {
    clear(kBlockRange);
    m_edit.SendScintilla(Sci::SCI_MARKERDELETEALL, static_cast<unsigned long>(kBlockMark));
    if (block.size() == 0 || !m_blocksShown) return;
    mark(kBlockRange, block);
    for (unsigned long i = m_text.lineAt(block.begin), last = m_text.lineAt(block.end); i <= last; ++i)
        m_edit.SendScintilla(Sci::SCI_MARKERADD, i, static_cast<long>(kBlockMark));
}

void CodeMarks::showLink(TextRange link) {
    clear(kLinkRange);
    mark(kLinkRange, link);
    m_edit.viewport()->setCursor(link.size() > 0 ? Qt::PointingHandCursor : Qt::IBeamCursor);
}

} // namespace trundle
