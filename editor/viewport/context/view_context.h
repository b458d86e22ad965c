#pragma once

namespace trundle {

class Document;
class FloorDrawing;
class Measurement;
class PinnedValues;
class RadioOverlays;
class RenderService;
class RunSession;
class Selection;
class Trails;
class ViewSettings;
class ViewportScene;

/// Shared by the views of a panel. `render` may be null.
struct ViewContext {
    Document& document;
    Selection& selection;
    RunSession& session;
    ViewportScene& world;
    ViewSettings& settings;
    Measurement& measurement;
    FloorDrawing& drawing;
    RenderService* render = nullptr;
    Trails* trails = nullptr;
    RadioOverlays* radios = nullptr;
    PinnedValues* pinned = nullptr;
};

} // namespace trundle
