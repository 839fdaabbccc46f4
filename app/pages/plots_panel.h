#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/pages/plots_state.h"
#include "app/plotting/plot_source.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace terratact {

class PlotValues;
class PreferenceStore;
class SignalList;
class TimePlots;

/// Plots of chosen signals over time, with the list of signals, saved sets and the numbers. It shows a running console
/// or a session, whatever the source is. GUI thread only.
class PlotsPanel final : public QWidget {
    Q_OBJECT
public:
    /// Live: follows the newest values. Review: shows the whole session, and its cursor is the time under review.
    enum class Kind : std::uint8_t { Live, Review };
    /// Source and preferences must outlive the panel.
    PlotsPanel(PlotSource& source, PreferenceStore& preferences, Kind kind,
               QWidget* parent = nullptr);

    /// Shows the newest state. force: at once, else at most every kRefresh.
    void refresh(double now, bool force = false);
    /// Sets the time under review [s]; it is the cursor.
    void setTime(double seconds);
    /// In the dock, only plots and the keys for their span are shown.
    void setDocked(bool docked);

    PlotsState& state() { return state_; }
    TimePlots* plots() const { return plots_; }
    SignalList* list() const { return list_; }
    PlotValues* values() const { return values_; }
    QComboBox* sets() const { return sets_; }
    QPushButton* dockButton() const { return dock_; }
    QPushButton* saveButton() const { return save_; }
    QPushButton* removeButton() const { return remove_; }
    QPushButton* liveButton() const { return live_; }
    QLabel* note() const { return note_; }

    static constexpr double kRefresh = 0.08;  ///< [s] of a live picture

signals:
    void seekWanted(double seconds);  ///< a click in a review
    void dockWanted(bool docked);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* builtSide();
    void buildTools(QHBoxLayout& row);
    QPushButton* button(const QString& text, const QString& name, const QString& tip);
    void connectPlots();
    void addSignal(const QString& key, int row);
    void removeChosen();
    void chosenChanged();
    void chooseSignals();
    void showRows();
    void showSignals();
    void showNote();
    void showSets();
    void useSet(const QString& name);
    void saveSet();
    void deleteSet();
    void showNow();
    double cursor() const;
    void resizeToFont();

    PlotSource& source_;
    PreferenceStore& preferences_;
    Kind kind_;
    PlotsState state_;
    std::map<std::string, PlotSignal> known_;  // by key
    std::optional<double> pointer_;            ///< [s] time under the pointer
    bool isChosen_ = false;                    ///< the source knows what is plotted
    double refreshedAt_ = 0.0;                 ///< [s]
    double listedAt_ = 0.0;                    ///< [s]
    std::uint64_t shownVersion_ = 0;
    QString full_;  ///< why the last signal was not added

    // Qt's parents own the widgets.
    QWidget* side_ = nullptr;
    SignalList* list_ = nullptr;
    TimePlots* plots_ = nullptr;
    PlotValues* values_ = nullptr;
    QComboBox* sets_ = nullptr;
    QPushButton *save_ = nullptr, *delete_ = nullptr, *newPlot_ = nullptr, *addTo_ = nullptr,
                *remove_ = nullptr, *live_ = nullptr, *numbers_ = nullptr, *dock_ = nullptr;
    QLabel* note_ = nullptr;
};

}  // namespace terratact
