#pragma once

#include "app/modelling/truth/truth_file.h"
#include "app/shell/console_window.h"

namespace terratact {

class TruthPage;

/// Shows the heights that a laser map gave to scenes, to accept, exclude or nudge them. It has no source, so it cannot
/// command a robot.
class TruthWindow final : public ConsoleWindow {
    Q_OBJECT
public:
    explicit TruthWindow(TruthFile file);

    TruthPage* page() const { return page_; }

private:
    TruthPage* page_ = nullptr;
};

}  // namespace terratact
