#include "app/robot_files.h"

#include <filesystem>
#include <utility>

#include "app/module_template.h"
#include "base/clean_text.h"
#include "base/platform/atomic_file.h"
#include "project/wizard/robot_text.h"

namespace trundle {

std::string robotNameFault(const std::string& name) { return configNameFault("a robot", name, "Rover", "OpenFloor"); }

Result<NewRobot> makeRobot(const RobotDesign& design, const std::string& parent) {
    namespace fs = std::filesystem;
    if (const std::string fault = robotNameFault(design.name); !fault.empty()) return Error{Code::FileUnreadable, fault};
    const Result<MotorChoice> choice = chooseMotor(design);
    if (!choice) return choice.error();
    const std::string file = moduleNameFor(design.name);
    const fs::path folder = fs::path(parent) / file;
    std::error_code ec;
    if (!fs::create_directory(folder, ec))
        return Error{Code::FileUnreadable, cleanLine(folder.string()) + " cannot be made: " +
                                               (ec ? cleanLine(ec.message()) : "it exists; choose another name or folder")};
    NewRobot made{folder.string(), {}, (folder / (file + "_square.sim")).string(), choice.value()};
    for (const auto& [name, text] : {std::pair{file + ".sim", robotText(design, choice.value())},
                                     {file + "_square.sim", squareExperimentText(design, file)},
                                     {file + "_square.py", squareControllerText(design, file)}}) {
        if (const Status written = writeFileAtomically((folder / name).string(), text); !written) {
            fs::remove_all(folder, ec); // made above, so all in it is ours
            return written.error();
        }
        made.files.push_back(name);
    }
    return made;
}

} // namespace trundle
