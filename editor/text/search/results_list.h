#pragma once
#include <string>
#include <vector>

#include <QWidget>

#include "base/source_range.h"

class QLabel;
class QTreeWidget;

namespace trundle {

/// A list of source ranges, one per row: the uses of a name, or search results. Child widgets are named after `name`.
class ResultsList final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsList(const QString& name, QWidget* parent = nullptr);

    struct Row {
        std::string file, shown; ///< path; path for display
        std::uint32_t line = 0;
        TextRange range;
        std::string text; ///< the line's text
        bool given = false;
    };
    void showRows(const QString& title, std::vector<Row> rows);
    void setCurrent(int row);                      ///< an invalid row clears the selection; emits nothing
    [[nodiscard]] QSize sizeHint() const override; ///< a few rows: the text above needs the room
    [[nodiscard]] const std::vector<Row>& rows() const { return m_rows; }

Q_SIGNALS:
    void chosen(const std::string& file, TextRange range, bool focus);
    void closed(); ///< by the user

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitColumns();
    void choose(bool focus);
    void closeByHand();

    QLabel* m_title;
    QTreeWidget* m_list;
    std::vector<Row> m_rows;
};

} // namespace trundle
