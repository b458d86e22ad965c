#include "editor/document/history.h"

#include <algorithm>

namespace trundle {

bool History::canDiscardMerge(const std::string& mergeKey) const {
    return m_mayMerge && m_position > 0 && !mergeKey.empty() && m_entries[m_position - 1].mergeKey == mergeKey;
}

void History::join(const HistoryEntry& entry) {
    Step& last = m_entries[m_position - 1];
    last.name = entry.name; // the latest name describes the merged edit
    for (const auto& [file, after] : entry.after) {
        const std::string& now = *entry.before.at(file);
        const auto known = last.splices.find(file);
        TextSplice whole = spliceBetween(now, *after);
        if (known != last.splices.end()) whole = joined(known->second, whole, now);
        if (whole.empty()) last.splices.erase(file);
        else last.splices.insert_or_assign(file, std::move(whole));
    }
    if (!last.splices.empty()) return;
    --m_position; // the merged edits cancel out: there is nothing to undo
    dropDiscarded();
}

void History::dropDiscarded() {
    m_entries.resize(m_position);
    std::move(m_forgotten.begin(), m_forgotten.end(), std::back_inserter(m_entries));
    endMerge();
}

void History::push(HistoryEntry entry) {
    if (canDiscardMerge(entry.mergeKey)) {
        join(entry);
    } else {
        const auto undone = m_entries.begin() + static_cast<std::ptrdiff_t>(m_position);
        m_forgotten.assign(std::make_move_iterator(undone), std::make_move_iterator(m_entries.end()));
        m_entries.erase(undone, m_entries.end());
        Step step{std::move(entry.name), {}, std::move(entry.mergeKey)};
        for (const auto& [file, after] : entry.after) step.splices.emplace(file, spliceBetween(*entry.before.at(file), *after));
        m_entries.push_back(std::move(step));
        ++m_position;
        m_mayMerge = true;
    }
    for (const auto& [file, after] : entry.after) m_now.insert_or_assign(file, after);
}

void History::endMerge() {
    m_mayMerge = false;
    m_forgotten.clear();
}

void History::clear() { *this = {}; }

void History::renameFile(const std::string& from, const std::string& to) {
    if (from == to) return;
    const auto rename = [&](auto& map) {
        auto node = map.extract(from);
        map.erase(to);
        if (node.empty()) return;
        node.key() = to;
        map.insert(std::move(node));
    };
    rename(m_now);
    for (std::vector<Step>* steps : {&m_entries, &m_forgotten})
        for (Step& step : *steps) rename(step.splices);
}

FileTexts History::moveTo(std::size_t position) {
    position = std::min(position, m_entries.size());
    m_mayMerge = false;
    FileTexts changed;
    const auto put = [&](const std::string& file, std::string text) {
        m_now[file] = std::make_shared<const std::string>(std::move(text));
        changed[file] = m_now[file];
    };
    while (m_position > position) {
        --m_position;
        for (const auto& [file, splice] : m_entries[m_position].splices) put(file, unspliced(*m_now.at(file), splice));
    }
    while (m_position < position) {
        for (const auto& [file, splice] : m_entries[m_position].splices) put(file, spliced(*m_now.at(file), splice));
        ++m_position;
    }
    return changed;
}

} // namespace trundle
