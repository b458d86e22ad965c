#pragma once
// Groups typed changes into entries of the history: a word with the blanks after it, a run of deletions, one paste.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

namespace trundle {

class TypingMerger {
public:
    explicit TypingMerger(std::string file) : m_file(std::move(file)) {}

    /// One complete entry: the whole text after it.
    struct Entry {
        QString name;
        std::string bytes, mergeKey;
        bool named = false; ///< by nameNext(); else the name only gives the type of change
    };

    /// A key press or a command begins: its changes become one entry.
    void beginAction() { m_newAction = true; }
    /// The next change starts a new entry: the caret moved, or the text was changed by others.
    void endWord() {
        m_sort = Sort::None;
        m_newAction = true;
    }

    /// Call it for each change before changed(). True if the change starts a new entry and typing is pending; the caller must
    /// then pass the text before the change to close().
    [[nodiscard]] bool startsEntry(std::size_t at, std::size_t removed, std::string_view inserted);
    void close(std::string bytes);
    void changed(std::size_t at, std::string_view inserted);

    [[nodiscard]] bool pending() const { return m_dirty || !m_closed.empty(); }
    /// All entries since the last call, in order; `now` is the current text.
    [[nodiscard]] std::vector<Entry> take(std::string now);
    void drop();    ///< discards pending changes
    void joinAll(); ///< makes pending changes one entry: their intermediate texts no longer fit the document
    /// Sets the name of the next entry.
    void nameNext(QString name) { m_wanted = std::move(name); }

private:
    enum class Sort { None, Typing, Deleting, Other };
    [[nodiscard]] bool joins(std::size_t at, std::size_t removed, std::string_view inserted) const;
    void begin();
    [[nodiscard]] QString name() const;
    [[nodiscard]] std::string key() const { return "text:" + m_file + ":" + std::to_string(m_serial); }

    std::string m_file;
    std::vector<Entry> m_closed;
    QString m_name, m_wanted;
    Sort m_sort = Sort::None, m_next = Sort::None;
    std::size_t m_end = 0; ///< offset at which the next character continues the word
    std::size_t m_serial = 0;
    bool m_blank = false; ///< the word ends with a blank
    bool m_dirty = false, m_newAction = true;
};

} // namespace trundle
