#pragma once

#include "app/review/review_payload.h"
#include "app/shell/page.h"

class QLabel;

namespace terratact {

class DbcFiles;
class PreferenceStore;
class SignalTable;

/// Signals of other devices, such as gas sensors or batteries, up to a time of the session.
class ReviewSignalsPage final : public Page {
    Q_OBJECT
public:
    /// Session and preferences must outlive the page.
    ReviewSignalsPage(SessionReader& session, PreferenceStore& preferences,
                      QWidget* parent = nullptr);

    /// Sets the time to show; the page reads it once it is visible.
    void setTime(SessionTime time);
    void refresh(double now) override;

    SignalTable* table() const { return table_; }
    QLabel* headline() const { return headline_; }
    DbcFiles* dbc() const { return dbc_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    ReviewPayload payload_;
    SessionTime time_ = 0;
    DbcFiles* dbc_ = nullptr;
    QLabel* headline_ = nullptr;
    SignalTable* table_ = nullptr;
};

}  // namespace terratact
