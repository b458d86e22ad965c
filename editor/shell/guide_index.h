#pragma once
#include <QHash>
#include <QString>

#include "schema/kind.h"

namespace trundle {

/// The anchor of a heading in links: "bodies-and-mass" for "Bodies and mass".
[[nodiscard]] QString headingAnchor(const QString& heading);

/// Maps each kind to the section of the guide that explains it: the heading above a comment such as `<!-- kinds: Box Sphere
/// -->`. The words `controller` and `device` in it stand for module kinds of these roles. Other constructs are in `<!-- words:
/// #import Param -->`.
class GuideIndex {
public:
    /// Reads the Markdown files of a folder.
    explicit GuideIndex(const QString& folder);
    /// "language.md#geoms"; empty if the guide does not explain the kind.
    [[nodiscard]] QString placeOf(const Kind& kind) const;
    /// The same for a construct that is not a kind: "#import", "Param".
    [[nodiscard]] QString placeOf(const QString& word) const { return m_places.value(word); }

private:
    QHash<QString, QString> m_places; // by the name of the kind
};

} // namespace trundle
