#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>

#include "app/imports/truth_rows.h"
#include "app/imports/truth_view.h"
#include "app/modelling/truth/truth_choices.h"
#include "app/modelling/truth/truth_file.h"

class QComboBox;
class QLabel;
class QLayout;
class QPushButton;
class QTableView;

namespace terratact {

class Card;
class KeyTable;

/// The scenes of a truth file, and the decisions on them: accept, exclude, nudge. Decisions are saved beside the truth
/// file by themselves. A decisions file that does not fit is left alone; nothing is saved then.
class TruthPage final : public QWidget {
    Q_OBJECT
public:
    explicit TruthPage(TruthFile file, QWidget* parent = nullptr);
    ~TruthPage() override;  ///< saves what is not saved yet

    void showScene(std::size_t row);  ///< clamped to the last scene
    std::size_t scene() const { return row_; }
    void addKeys(KeyTable& keys);

    /// Writes the scenes with the decisions applied, as `terratact truth --decisions` does.
    void exportTo(const QString& path);
    void save();  ///< the decisions, if there are new ones

    static constexpr double kHeightStep = 0.005;      ///< [m]
    static constexpr double kTiltStep = 0.005;        ///< [rad]
    static constexpr double kAlongStep = kTruthCell;  ///< [m]

    QString decisionsPath() const;
    const TruthChoices& choices() const { return choices_; }
    QTableView* table() const { return table_; }
    TruthView* view() const { return view_; }
    QPushButton* acceptButton() const { return accept_; }
    QPushButton* aheadButton() const { return ahead_; }
    QPushButton* backButton() const { return back_; }
    QPushButton* undoButton() const { return undo_; }
    QPushButton* exportButton() const { return export_; }
    QComboBox* sidesChoice() const { return sides_; }
    QLabel* sceneLabel() const { return sceneText_; }
    QLabel* stateLabel() const { return state_; }

private:
    void build();
    Card* makeList();
    Card* makeScene();
    QLayout* makeControls(QWidget* parent);
    void makeButtons();
    QPushButton* button(const QString& text, const QString& tip, void (TruthPage::*act)());
    void fitColumns();
    /// Hides the last columns where the list is narrow; the line of the scene has what they show.
    void showColumnsThatFit();
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void loadDecisions();
    void decided(bool goesOn);
    void accept();
    void exclude();
    void nudge(double offset, double tilt);
    void nudgeAlong(double along);
    void heightUp();
    void heightDown();
    void tiltUp();
    void tiltDown();
    void moveAhead();
    void moveBack();
    static QString noCellsText();
    /// Reads the slice of the current scene; after a nudge along, heights and slice are sampled again.
    Status findScene(SceneTruth& found, std::vector<SlicePoint>& slice,
                     const TruthDecision* decision);
    Status checkCells(const std::vector<TruthDecision>& decisions) const;
    void resetNudge();
    void undo();
    void askForExport();
    void go(int by);
    void showCurrent();
    void showState(const QString& text);
    QString summary() const;

    TruthFile file_;
    TruthChoices choices_;
    bool mayDecide_ = true;  ///< the decisions file is ours
    bool isSaved_ = true;
    std::size_t row_ = 0;
    QTimer saveSoon_;

    TruthRows* rows_ = nullptr;
    QTableView* table_ = nullptr;
    std::array<int, TruthRows::kColumns> widths_{};  ///< [px] of the columns
    TruthView* view_ = nullptr;
    QLabel* sceneText_ = nullptr;
    QLabel* state_ = nullptr;
    QComboBox* sides_ = nullptr;
    QPushButton* accept_ = nullptr;
    QPushButton* exclude_ = nullptr;
    QPushButton* ahead_ = nullptr;
    QPushButton* back_ = nullptr;
    QPushButton* undo_ = nullptr;
    QPushButton* export_ = nullptr;
    QList<QPushButton*> deciding_;  ///< off while mayDecide_ is false
};

}  // namespace terratact
