#pragma once
#include <string>
#include <vector>

#include <QWidget>

#include "base/source_range.h"

class QLabel;
class QTreeWidget;

namespace trundle {

/// Places in texts, one a row: where a name is used, or what a search found. Its parts are called `name` and what they are.
class ResultsList final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsList(const QString& name, QWidget* parent = nullptr);

    struct Row {
        std::string file, shown; ///< path, and as people know it
        std::uint32_t line = 0;
        TextRange range;
        std::string text; ///< of the line
        bool given = false;
    };
    void showRows(const QString& title, std::vector<Row> rows);
    void setCurrent(int row); ///< none where it is no row; nothing is chosen
    [[nodiscard]] QSize sizeHint() const override; ///< a few rows: the text above is what they are about
    [[nodiscard]] const std::vector<Row>& rows() const { return m_rows; }

Q_SIGNALS:
    void chosen(const std::string& file, TextRange range, bool focus);
    void closed(); ///< by the person

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void choose(bool focus);
    void closeByHand();

    QLabel* m_title;
    QTreeWidget* m_list;
    std::vector<Row> m_rows;
};

} // namespace trundle
