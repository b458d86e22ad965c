#pragma once
#include <QHash>
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// The name of a heading in a link: "bodies-and-mass" of "Bodies and mass".
[[nodiscard]] QString headingAnchor(const QString& heading);

/// Which place of the guide explains each kind: the heading above a comment such as `<!-- kinds: Box Sphere -->`. The words `controller`
/// and `device` in it are for kinds of these roles that modules bring. Constructs that are no kinds stand in `<!-- words: #import Param -->`.
class GuideIndex {
public:
    /// Reads the Markdown files of a folder.
    explicit GuideIndex(const QString& folder);
    /// "language.md#geoms"; empty where the guide does not explain the kind.
    [[nodiscard]] QString placeOf(const Kind& kind) const;
    /// The same of a word of the language that is no kind: "#import", "Param".
    [[nodiscard]] QString placeOf(const QString& word) const { return m_places.value(word); }

private:
    QHash<QString, QString> m_places; // by the name of the kind
};

} // namespace trundle
