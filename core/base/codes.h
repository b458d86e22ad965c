#pragma once
// The table of all diagnostic codes: E1xx text, E2xx values, E3xx model, E4xx modules, E5xx run, E6xx edits.

#include <span>
#include <string>
#include <string_view>

namespace trundle {

/// Each code has one meaning, a title in codes.cpp and an example file in tests/data/broken.
enum class Code : int {
    // text
    UnexpectedText = 101,
    UnclosedBlock,
    UnclosedString,
    UnclosedComment,
    BadNumber,
    InvalidBytes,
    MissingValue,
    MissingComma,
    StrayBrace,
    DirectivePlace,
    UnicodeMinus,
    TooDeep,
    BadExpression,
    ReservedWord,
    TooLarge,
    TooManyMistakes,
    // values
    UnknownKey = 201,
    WrongType,
    OutOfRange,
    WrongCount,
    UnknownUnit,
    WrongDimension,
    UnknownChoice,
    UnknownReference,
    MissingRequired,
    DuplicateKey,
    UnknownParam,
    ParamCycle,
    ExpressionValue,
    Conflict,
    ImportDisagrees,
    // model
    UnknownKind = 301,
    WrongPlace,
    DuplicateName,
    MissingName,
    BadMass,
    BadGeometry,
    BadJoint,
    ImportNotFound,
    ImportCycle,
    ImportDepth,
    ImportOutside,
    TooManyObjects,
    TooManyFiles,
    NoSuchPath,
    DefinedLater,
    DefaultUsed,
    PlacementFailed,
    MeshUnreadable,
    MultipleControllers,
    LooseGeom,
    ThesisSpelling,
    FileUnreadable,
    ReplaceBySingles,
    TurnRate,
    StartOverlap,
    BelowFloor,
    Unsupported,
    MassRatio,
    WheelGeometry,
    SpringTooFast,
    ImportedTwice,
    WheelOffGround,
    LooseBody,
    DoubleJoint,
    ClosedLoop,
    OddInertia,
    ThinPart,
    WeakMotor,
    UnusedDefinition,
    FailsToStand,
    MovesOtherwise,
    // modules
    ModuleNotFound = 401,
    ModuleNotTrusted,
    ModuleUnreadable,
    ModuleWrongFormat,
    ModuleNoEntry,
    ModuleVersion,
    ModuleDuplicateKind,
    ModuleUndescribed,
    ModuleMissingSymbol,
    ControllerFailed,
    UnknownPort,
    ModuleDescriptionStale,
    KindNotLoaded,
    PythonModule,
    // run
    BlowUp = 501,
    EngineFault,
    LogUnwritable,
    NoDuration,
    BigCluster,
    DroppedLines,
    DeviceSetup,
    Interrupted,
    FileUnwritable,
    NoGraphics,
    PictureFailed,
    SystemRefused,
    PassedThrough,
    NotInEngine,
    Internal = 599,
    // edits and documents
    EditRefused = 601,
    NoDocument,
};

/// "E203".
[[nodiscard]] std::string codeName(Code code);

struct CodeEntry {
    Code code;
    std::string_view title; ///< its meaning in one line
};
/// All codes in numeric order, for the manual and for the test that each code has a file in tests/data/broken.
[[nodiscard]] std::span<const CodeEntry> allCodes();

} // namespace trundle
