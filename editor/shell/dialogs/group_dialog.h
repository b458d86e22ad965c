#pragma once
#include <string>
#include <vector>

class QWidget;

namespace trundle {

class Document;

/// Asks for a name and groups the objects into a config of that name, see planGroup(): one entry of the history. If they cannot
/// be grouped, reports it through Document::refused() without asking. `shippedConfigs`: the folder of the configs installed with
/// Trundle.
void askForGroup(QWidget* parent, Document& document, const std::vector<std::string>& paths, const std::string& shippedConfigs);

} // namespace trundle
