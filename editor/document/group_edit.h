#pragma once
#include <QString>

#include "base/result.h"

namespace trundle {

class Document;
struct GroupPlan;

/// Creates the file of a piece and puts its instance in the place of the grouped objects, which is selected then: one entry of the
/// history, all or nothing.
Status applyGroup(Document& document, const QString& name, const GroupPlan& group);

} // namespace trundle
