#pragma once
#include <string>

#include "base/diagnostic.h"
#include "lang/source_text.h"

namespace trundle {

/// The whole diagnostic as text for the user:
///   file:14:52: error E203: Radius is -3 cm, it must be above 0
///      14 |     Cylinder tyre { Radius=-3cm Length=0.03 HPR=0,0,90 }
///         |                            ^~~~  fix: 3cm
///   imported from configs/experiments/linear_motion.sim:4
/// Carets are below the code points of the range (tabs kept); control bytes are shown as U+FFFD; long lines are cut around the
/// caret.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, const SourceTable& sources);

} // namespace trundle
