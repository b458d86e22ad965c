#pragma once
#include <QString>

#include "base/result.h"

namespace trundle {

class Document;
struct GroupPlan;

/// Creates the file of the new config and replaces the grouped objects by an instance of it, which is then selected: one
/// entry of the history, all or nothing.
Status applyGroup(Document& document, const QString& name, const GroupPlan& group);

} // namespace trundle
