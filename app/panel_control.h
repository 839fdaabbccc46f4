#pragma once

#include <memory>

#include "app/exploration.h"
#include "app/panel_reader.h"

namespace terratact {

/// Means by the panel's buttons what the window's buttons mean, and lights its lamps.  GUI thread only.
class PanelControl final : public QObject {
    Q_OBJECT
public:
    static constexpr double kAnswersWithin = 0.1;  ///< [s]

    /// Exploration and source must outlive it.
    PanelControl(std::unique_ptr<OperatorPanel> panel, MeasurementSource& source,
                 Exploration& exploration);

    /// mayExplore: the button that asks for an exploration would do so, too.
    void tick(double now, bool mayExplore);

    /// The panel is there and was read lately: what an armed robot needs of it.
    bool answers(double now) const;
    bool stopPressed() const { return report_.state.stop; }
    const PanelState& state() const { return report_.state; }
    Precondition precondition(double now) const;
    const PanelReader& reader() const { return reader_; }
    const PanelReport& report() const { return report_; }

signals:
    void happened(const QString& text, terratact::Weight weight);

private:
    void press(bool mayExplore);
    void light();

    Exploration& exploration_;
    PanelReader reader_;
    PanelReport report_;
    bool wasStopped_ = true;
    QString trouble_;
};

}  // namespace terratact
