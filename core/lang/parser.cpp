#include "lang/parser.h"

namespace trundle {
namespace {

constexpr int kMaxRuns = 4; ///< the first run and three with an assumed `}`

} // namespace

Parser::Parser(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens)
    : m_tree(std::make_shared<Tree>()), m_report(file), m_tokens(*source, m_tree->m_tokens, m_report, mostTokens),
      m_balance(m_tokens, m_report), m_checks(m_tokens, m_report), m_items(m_tokens, m_report, m_balance) {
    m_tree->m_file = file;
    m_tree->m_source = std::move(source);
}

std::shared_ptr<const Tree> Parser::parse() {
    m_tokens.start(!m_checks.isUtf16());
    run();
    for (int i = 1; i < kMaxRuns && m_tokens.extent() == Tree::Extent::Whole && m_balance.assume([this] { run(); }); ++i) {}
    m_tree->m_extent = m_tokens.extent();
    m_tree->m_readTo = m_tokens.readTo();
    m_tree->m_diagnostics = m_report.takeSorted();
    return m_tree;
}

/// Parses all tokens once.
void Parser::run() {
    m_tokens.rewind();
    m_balance.beginRun();
    m_report.clear();
    m_tree->m_items.clear();
    m_checks.checkBytes();
    if (m_checks.isUtf16() || m_checks.isOtherLanguage()) return;
    m_items.items(m_tree->m_items, 0);
    m_checks.checkTokens();
}

std::shared_ptr<const Tree> parse(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens) {
    return Parser(std::move(source), file, mostTokens).parse();
}

} // namespace trundle
