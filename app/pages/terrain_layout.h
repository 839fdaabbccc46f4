#pragma once

#include <QObject>
#include <QSize>

#include "app/shell/preferences/preferences.h"

class QBoxLayout;
class QSpacerItem;
class QWidget;

namespace terratact {

class AtemPanel;
class Card;
class ConsoleWindow;
class DrivePad;
class DriveStrip;
class EstimateStrip;
class ProbeCard;
class RobotReadout;
class TerrainProfileView;
class VerdictStrip;

/// Arranges the parts of a TerrainPage. Verdict, drive strip and terrain are at the left, the decisions beside them;
/// forces, robot and events stand below. Cards leave the page if they do not fit.
class TerrainLayout final : public QObject {
    Q_OBJECT
public:
    struct Parts {
        VerdictStrip* verdict = nullptr;
        DriveStrip* driving = nullptr;
        Card* terrainCard = nullptr;
        EstimateStrip* strip = nullptr;  ///< in the title of the terrain card
        TerrainProfileView* terrain = nullptr;
        AtemPanel* atem = nullptr;
        ProbeCard* probe = nullptr;
        Card* forces = nullptr;
        Card* robot = nullptr;
        RobotReadout* readout = nullptr;  ///< in the robot's card
        DrivePad* drive = nullptr;        ///< in the robot's card
        Card* events = nullptr;
    };
    TerrainLayout(QWidget& page, const Parts& parts);

    /// Arranges the parts; does nothing if they already are. fontScale: current font scale [%].
    void arrange(Layout layout, int fontScale);
    Layout layout() const { return layout_; }
    int fontScale() const { return fontScale_; }

    /// Returns the panel with forces, robot and events. A window that moves it elsewhere returns it with placeLower().
    QWidget* lower() const { return lowerPanel_; }
    void placeLower();
    void stackLower(bool stacked);  ///< stacks robot and events, at half the width
    /// Returns the panel with exploration and probe beside the terrain; placeDecisions() puts it back.
    QWidget* decisions() const { return decisions_; }
    void placeDecisions();
    /// Puts verdict and decisions in a column beside the terrain, which then gets the full height. columnWidth: [px at
    /// 100 %].
    void setVerdictBeside(int columnWidth);
    /// Enables the tight arrangement. Cards below the terrain that do not fit move to another place (tightened()). The
    /// decisions then get a narrow column. The window's banner moves no card: its line is taken from the terrain.
    void allowTight(const ConsoleWindow& window);
    bool isTight() const { return tight_; }
    /// Returns the size needed when tight [px]; invalid if tight is not enabled.
    QSize tightNeeds() const { return tightNeeds_; }
    void fit();                       ///< call after a change of the page's size
    void measure();                   ///< call after a change of the size that a part needs
    void setProposes(bool proposes);  ///< true while a probe is proposed or done

signals:
    void tightened(bool tight);  ///< emitted when lower() must leave or may return: placeLower()

private:
    QSize needs(bool tight);
    void setTight(bool tight);
    void fitTightness();
    QSize leastTerrain(bool tight) const;
    void setColumn();
    void placeVerdict();
    void share();
    void showDrive();

    QWidget& page_;
    Parts parts_;
    Layout layout_ = Layout::Probe;
    int fontScale_ = 100;
    bool verdictBeside_ = false;
    bool stacked_ = false;                   ///< robot and events
    const ConsoleWindow* window_ = nullptr;  ///< null: tight is not enabled
    bool tight_ = false;
    bool measures_ = false;          ///< arranged temporarily, to measure sizes
    QSize roomyNeeds_, tightNeeds_;  ///< [px]
    int columnWidth_ = 404;          ///< [px] at 100 %

    // Qt's parents own the widgets.
    QBoxLayout* ground_ = nullptr;  ///< verdict and terrain
    QBoxLayout* rows_ = nullptr;    ///< terrain and decisions, the cards below
    QBoxLayout* upper_ = nullptr;   ///< the terrain and the decisions
    QBoxLayout* column_ = nullptr;  ///< column of the decisions
    /// Reserves the height of a probe proposal beside the decisions.
    QSpacerItem* question_ = nullptr;
    QWidget* decisions_ = nullptr;
    bool proposes_ = false;
    QBoxLayout* decide_ = nullptr;  ///< the decisions
    QWidget* lowerPanel_ = nullptr;
    QBoxLayout* lower_ = nullptr;   ///< forces, and the cards beside them
    QBoxLayout* recent_ = nullptr;  ///< robot and events
};

}  // namespace terratact
