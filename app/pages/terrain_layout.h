#pragma once

#include <QObject>
#include <QSize>

#include "app/shell/preferences.h"

class QBoxLayout;
class QSpacerItem;
class QWidget;

namespace terratact {

class AtemPanel;
class Card;
class ConsoleWindow;
class DrivePad;
class EstimateStrip;
class ProbeCard;
class TerrainProfileView;
class VerdictStrip;

/// Where the parts of a TerrainPage stand: verdict and terrain, the decisions beside them, forces, robot and events
/// below; and what leaves where there is no room.
class TerrainLayout final : public QObject {
    Q_OBJECT
public:
    struct Parts {
        VerdictStrip* verdict = nullptr;
        Card* terrainCard = nullptr;
        EstimateStrip* strip = nullptr;  ///< in the terrain's title
        TerrainProfileView* terrain = nullptr;
        AtemPanel* atem = nullptr;
        ProbeCard* probe = nullptr;
        Card* forces = nullptr;
        Card* robot = nullptr;
        DrivePad* drive = nullptr;  ///< in the robot's card
        Card* events = nullptr;
    };
    TerrainLayout(QWidget& page, const Parts& parts);

    /// Does nothing where it stands like that.  fontScale: [%] of the letters in force.
    void arrange(Layout layout, int fontScale);
    Layout layout() const { return layout_; }
    int fontScale() const { return fontScale_; }

    /// Forces, robot and events, below the terrain; whoever takes them into a layout of its own gives them back so.
    QWidget* lower() const { return lowerPanel_; }
    void placeLower();
    void stackLower(bool stacked);  ///< robot and events one above the other: half as wide
    /// Likewise exploring and the arm, beside the terrain.
    QWidget* decisions() const { return decisions_; }
    void placeDecisions();
    /// Verdict and decisions in a column beside the terrain, which gets all the height; columnWidth: at 100 %.
    void setVerdictBeside(int columnWidth);
    /// From now on, where there is no room for the cards below the terrain, they leave it for somebody else's place
    /// (tightened()), and what is to be decided stands in a narrow column.  A banner of the window, the page's own,
    /// moves no card: its line is the terrain's.
    void allowTight(const ConsoleWindow& window);
    bool isTight() const { return tight_; }
    QSize tightNeeds() const { return tightNeeds_; }  ///< [px]; invalid where it does not tighten
    void fit();                                       ///< the page has another size

signals:
    void tightened(bool tight);  ///< lower() has to leave, or may come back: placeLower()

private:
    QSize needs(bool tight);
    void setTight(bool tight);
    void fitTightness();
    void setColumn();
    void placeVerdict();
    void share();

    QWidget& page_;
    Parts parts_;
    Layout layout_ = Layout::Probe;
    int fontScale_ = 100;
    bool verdictBeside_ = false;
    bool stacked_ = false;                   ///< robot and events
    const ConsoleWindow* window_ = nullptr;  ///< null: it does not tighten
    bool tight_ = false;
    bool measures_ = false;          ///< arranged for a moment only
    QSize roomyNeeds_, tightNeeds_;  ///< [px]
    int columnWidth_ = 404;          ///< [px] at 100 %

    // Qt's parents own the widgets.
    QBoxLayout* ground_ = nullptr;     ///< verdict and terrain
    QBoxLayout* rows_ = nullptr;       ///< terrain and decisions, the cards below
    QBoxLayout* upper_ = nullptr;      ///< the terrain and the decisions
    QBoxLayout* column_ = nullptr;     ///< of the decisions
    QSpacerItem* question_ = nullptr;  ///< the height that a probe's question needs, beside them
    QWidget* decisions_ = nullptr;
    QBoxLayout* decide_ = nullptr;  ///< of them
    QWidget* lowerPanel_ = nullptr;
    QBoxLayout* lower_ = nullptr;   ///< forces, and beside them
    QBoxLayout* recent_ = nullptr;  ///< robot and events
};

}  // namespace terratact
