#pragma once

#include <QCoreApplication>
#include <QString>

#include "app/display/drive_view_state.h"

namespace terratact {

/// Texts of the drive strip.
class DriveText {
    Q_DECLARE_TR_FUNCTIONS(DriveText)
public:
    /// Returns the level with its mark: "! STEEP", "✘ DANGER".
    static QString level(AttitudeLevel level);
    static QString limits(const AttitudeLimits& limits);  ///< "! 25° ✘ 35°"
    /// Returns the element with the largest force of each flipper in contact: "L5 R4", "none".
    static QString contacts(const FlipperContacts& state);
    /// Returns the text of contacts() for screen readers, with forces: "left 5: 12.0 N; right 4: 3.1 N".
    static QString contactsSpoken(const FlipperContacts& state);
    /// Returns the largest force: "12 N"; an empty text without a contact.
    static QString force(const FlipperContacts& state);
    static QString speed(double metresPerSecond);  ///< "+0.12 m/s"
};

}  // namespace terratact
