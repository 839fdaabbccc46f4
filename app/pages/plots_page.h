#pragma once

#include "app/pages/plots_panel.h"
#include "app/shell/page.h"

namespace terratact {

class ConsoleWindow;
class KeyTable;

/// The key of the page, in the console and in a review.
inline constexpr Qt::Key kPlotsKey = Qt::Key_Y;

/// The page of the plots. The same panel is the dock below all other pages, if that is wanted: both show the same
/// plots.
class PlotsPage final : public Page {
    Q_OBJECT
public:
    /// Source and preferences must outlive the page.
    PlotsPage(PlotSource& source, PreferenceStore& preferences, PlotsPanel::Kind kind,
              QWidget* parent = nullptr);

    void refresh(double now) override { panel_->refresh(now); }
    PlotsPanel* panel() const { return panel_; }
    /// Lets the dock of the window hold the panel while another page is shown.
    void dockIn(ConsoleWindow& window);
    void addKeys(KeyTable& keys);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void place(ConsoleWindow& window);

    PlotsPanel* panel_ = nullptr;
};

}  // namespace terratact
