#pragma once

#include <QLabel>
#include <QList>
#include <QPushButton>

#include "app/pages/terrain_page.h"
#include "widgets/base/held_button.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"

/// What a review must not offer.
namespace terratact {

inline bool saysThatStopIsDead(const QWidget& window)
{
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->text().startsWith("STOP HAS NO EFFECT HERE")) return true;
    return false;
}

inline QList<QPushButton*> commandButtons(const TerrainPage& page)
{
    return {page.atemPanel()->requestButton(), page.atemPanel()->abortButton(),
            page.atemPanel()->releaseButton(), page.atemPanel()->overrideButton(),
            page.atemPanel()->probeButton(),   page.probeCard()->approveButton(),
            page.probeCard()->refuseButton(),  page.drivePad()->forwardButton(),
            page.drivePad()->backButton(),     page.drivePad()->feelButton()};
}

}  // namespace terratact
