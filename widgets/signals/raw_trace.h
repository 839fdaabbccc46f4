#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/display/trace_text.h"
#include "core/wire/frame_trouble.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace terratact {

class PlainTable;

/// Filter of the frames to show: an identifier in hexadecimal ("22", "0x022") or a part of the frame's name. An empty
/// filter shows all frames.
class TraceFilter {
public:
    explicit TraceFilter(const QString& text = {});
    bool passes(const CanFrame& frame, const QString& name) const;

private:
    QString text_;
    std::optional<std::uint32_t> id_;
};

class TraceModel;

/// The newest raw frames, newest first. Pausing stops the display; reception continues.
class RawTrace final : public QWidget {
    Q_OBJECT
public:
    using Words = std::function<TraceText(const CanFrame&)>;  ///< called for visible frames only
    /// Called for every frame, so it must be cheap.
    using Name = std::function<QString(const CanFrame&)>;

    RawTrace(Words words, Name name, QWidget* parent = nullptr);

    /// Sets the frames, oldest first. Ignored while paused.
    void setFrames(std::vector<TracedFrame> frames);

    bool isPaused() const;
    QLineEdit* filter() const { return filter_; }
    QPushButton* pauseButton() const { return pause_; }
    PlainTable* view() const { return view_; }
    QString summary() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyFilter();
    void resizeToFont();

    std::vector<TracedFrame> frames_;
    Name name_;
    TraceModel* model_ = nullptr;
    QLineEdit* filter_ = nullptr;
    QPushButton* pause_ = nullptr;
    QLabel* summary_ = nullptr;
    PlainTable* view_ = nullptr;
};

}  // namespace terratact
