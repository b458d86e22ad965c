#pragma once
#include <QWidget>

#include "editor/properties/rows.h"

class QLabel;
class QPushButton;

namespace trundle {

class ValueField;

/// Name (editable), kind and path of the selection, and the config of an instance.
class ObjectHeader final : public QWidget {
    Q_OBJECT
public:
    ObjectHeader(Document& document, QWidget* parent);
    void display(const Objects& objects);
    [[nodiscard]] QString kindHelp() const { return m_help; }

Q_SIGNALS:
    void selectRequested(const std::string& path);
    void jumpRequested(const trundle::SourceRange& place);

private:
    void rename(const QString& name);
    void showOne(const ObjectValues& object);
    void showSeveral(const Objects& objects);
    void showPath(const ObjectValues& object);
    void showConfig(const ObjectValues& object);
    void follow(const QString& link);

    Document& m_document;
    ValueField* m_name;
    QLabel *m_kind, *m_path, *m_config;
    QPushButton* m_singles;
    QString m_help;
    std::string m_object; ///< dotted path
    SourceRange m_configPlace;
};

} // namespace trundle
