#pragma once
// Cuts what a person types into entries of the history: a word with the blanks after it, a run of deletions, one paste.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

namespace trundle {

class Typing {
public:
    explicit Typing(std::string file) : m_file(std::move(file)) {}

    /// One entry that is ready for the document: the whole text after it.
    struct Entry {
        QString name;
        std::string bytes, mergeKey;
        bool named = false; ///< by nameNext(); else the name says only what sort of change it is
    };

    /// A key press or a command begins: what it changes belongs together.
    void beginAction() { m_newAction = true; }
    /// Whatever comes next is an entry of its own: the caret moved away, or somebody else edited.
    void endWord() {
        m_sort = Sort::None;
        m_newAction = true;
    }

    /// To be asked of each change before changed(). True where it starts an entry of its own and something was typed before it: the
    /// text as it was before the change has then to be given to close().
    [[nodiscard]] bool startsEntry(std::size_t at, std::size_t removed, std::string_view inserted);
    void close(std::string bytes);
    void changed(std::size_t at, std::string_view inserted);

    [[nodiscard]] bool pending() const { return m_dirty || !m_closed.empty(); }
    /// All that was typed since the last time, in order; `now` is the text as it is.
    [[nodiscard]] std::vector<Entry> take(std::string now);
    void drop();    ///< forgets what is pending
    void joinAll(); ///< what is pending becomes one entry: the texts in between no longer fit the document's
    /// The next entry carries this name.
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
    std::size_t m_end = 0; ///< where the next character of the word would be typed
    std::size_t m_serial = 0;
    bool m_blank = false; ///< the word has ended with a blank
    bool m_dirty = false, m_newAction = true;
};

} // namespace trundle
