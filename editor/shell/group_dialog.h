#pragma once
#include <string>
#include <vector>

class QWidget;

namespace trundle {

class Document;

/// Asks for a name and makes the objects one piece of that name, see planGroup(): one entry of the history. What cannot be grouped is said
/// through Document::refused, before anything is asked. `shippedConfigs`: the folder of the program's own configs.
void askForGroup(QWidget* parent, Document& document, const std::vector<std::string>& paths, const std::string& shippedConfigs);

} // namespace trundle
