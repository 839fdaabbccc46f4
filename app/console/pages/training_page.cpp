#include "app/console/pages/training_page.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/mission/exploration.h"
#include "app/mission/text/comparison_text.h"
#include "app/shell/file_dialog.h"
#include "core/learn/model/model_card.h"
#include "widgets/base/card.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

/// Returns the text of a cell. runs: waiting cells will still be trained.
QString cellText(const TrainingProgress::Cell& cell, bool runs)
{
    switch (cell.state) {
    case TrainingProgress::State::Waiting:
        return runs ? TrainingPage::tr("waiting") : format::kNothing;
    case TrainingProgress::State::Running: return TrainingPage::tr("running");
    case TrainingProgress::State::Skipped: return TrainingPage::tr("too few");
    case TrainingProgress::State::Done: break;
    }
    return cell.logLikelihood
             ? TrainingPage::tr("done (%1)").arg(format::number(*cell.logLikelihood, 0))
             : TrainingPage::tr("done");
}

/// Returns the whole text of a cell, for which the column may be too narrow.
QString cellTip(const TrainingProgress::Cell& cell, const QString& text)
{
    return cell.state == TrainingProgress::State::Done && cell.logLikelihood
             ? TrainingPage::tr("%1: the number is the log-likelihood").arg(text)
             : text;
}

/// Returns the log-likelihood of all trained parts together.
double logLikelihood(const TrainingProgress& progress)
{
    double sum = 0.0;
    for (const auto& bin : progress.cells)
        for (const TrainingProgress::Cell& cell : bin) sum += cell.logLikelihood.value_or(0.0);
    return sum;
}

/// Returns the first unused model name.
QString freeName(const QString& directory)
{
    for (int k = 1;; ++k) {
        QString name = QStringLiteral("trained-%1").arg(k);
        if (!QFileInfo::exists(directory + QLatin1Char('/') + name + QStringLiteral(".ttm")))
            return name;
    }
}

}  // namespace

QString modelsDirectory()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)
         + QStringLiteral("/terratact/models");
}

TrainingPage::TrainingPage(const Exploration& exploration, Options options, QWidget* parent)
    : Page(parent), exploration_(exploration), options_(std::move(options)), trainer_(options_.load)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 10, 12, 10);
    row->setSpacing(10);
    row->addWidget(trainCard(), 14);
    row->addWidget(compareCard(), 10);
    name_->setText(freeName(options_.directory));
    connectTrainer();
    connect(start_, &QPushButton::clicked, this, &TrainingPage::start);
    connect(cancel_, &QPushButton::clicked, &trainer_, &ModelTrainer::cancel);
    connect(compare_, &QPushButton::clicked, this, &TrainingPage::compare);
    connect(adopt_, &HoldToConfirmButton::confirmed, this, &TrainingPage::adopt);
    connect(discard_, &HoldToConfirmButton::confirmed, this, &TrainingPage::discard);
    for (QLineEdit* field : {scenes_, name_, test_})
        connect(field, &QLineEdit::textChanged, this, &TrainingPage::showButtons);
    showBins({});
    enter(Phase::Idle);
}

TrainingPage::~TrainingPage() = default;

void TrainingPage::connectTrainer()
{
    connect(&trainer_, &ModelTrainer::noticed, this,
            [this](const QString& text) { showStatus(text); });
    connect(&trainer_, &ModelTrainer::trained, this, [this](const QString& path, int scenes) {
        trained_ = path;
        showProgress();
        showStatus(tr("Trained on %1 scenes: %2").arg(scenes).arg(path));
        name_->setText(freeName(options_.directory));
        enter(Phase::Trained);
    });
    connect(&trainer_, &ModelTrainer::compared, this, [this](const ModelComparison& comparison) {
        showComparison(comparison);
        enter(Phase::Compared);
    });
    connect(&trainer_, &ModelTrainer::failed, this, [this](const QString& why) {
        ended(phase_ == Phase::Training
                  ? tr("%1. No file was written: correct this and start again.").arg(why)
                  : tr("%1. Choose another file, or discard the new model.").arg(why),
              true);
    });
    connect(&trainer_, &ModelTrainer::cancelled, this, [this] {
        ended(phase_ == Phase::Training ? tr("Cancelled: nothing was written")
                                        : tr("Comparison cancelled"),
              false);
    });
}

void TrainingPage::choose(QLineEdit* field, const QString& title)
{
    const FileWish wish{.title = title,
                        .start = QFileInfo(field->text()).path(),
                        .filter = tr("Scenes (*.csv);;All files (*)")};
    askForFile(*this, wish, [field](const QString& path) { field->setText(path); });
}

QString TrainingPage::pathOfName() const
{
    return options_.directory + QLatin1Char('/') + name_->text() + QStringLiteral(".ttm");
}

std::optional<QString> TrainingPage::whyNotStart() const
{
    if (scenes_->text().isEmpty()) return tr("Choose a file of scenes for training.");
    if (!name_->hasAcceptableInput()) return tr("Give the new model a name.");
    if (QFileInfo::exists(pathOfName()))
        return tr("%1 exists already: choose another name.").arg(pathOfName());
    return std::nullopt;
}

std::optional<QString> TrainingPage::whyBusy() const
{
    switch (phase_) {
    case Phase::Training: return tr("A model is being trained: cancel that first.");
    case Phase::Comparing: return tr("Two models are being compared: cancel that first.");
    case Phase::Adopting: return tr("Loading the new model …");
    case Phase::Idle:
    case Phase::Trained:
    case Phase::Compared: break;
    }
    return std::nullopt;
}

std::optional<QString> TrainingPage::whyNotDiscard() const
{
    if (auto why = whyBusy()) return why;
    if (trained_.isEmpty()) return tr("There is no new model.");
    return std::nullopt;
}

std::optional<QString> TrainingPage::whyNotCompare() const
{
    if (auto why = whyBusy()) return why;
    if (trained_.isEmpty()) return tr("Train a model first.");
    if (test_->text().isEmpty()) return tr("Choose a file of scenes to test on.");
    return std::nullopt;
}

std::optional<QString> TrainingPage::whyNotAdopt() const
{
    if (auto why = whyBusy()) return why;
    if (trained_.isEmpty()) return tr("Train a model first.");
    if (phase_ != Phase::Compared) return tr("Compare the new model before it is adopted.");
    if (exploring(exploration_.state().phase))
        return tr("An exploration is running: the model stays until it has ended (Esc ends it).");
    return std::nullopt;
}

void TrainingPage::start()
{
    const std::string file = scenes_->text().toStdString();
    trained_.clear();
    clearComparison();
    showStatus(tr("Training on %1; driving is not affected").arg(scenes_->text()));
    TrainingPlan plan;
    plan.robot = options_.robot;
    plan.data = file;
    plan.seed = static_cast<std::uint64_t>(seed_->value());
    plan.commandLine =
        "terratact-console, page Training: --data " + file + " --seed " + std::to_string(plan.seed);
    trainer_.train(std::move(plan), pathOfName());
    enter(Phase::Training);
}

void TrainingPage::compare()
{
    clearComparison();
    ComparisonPlan plan;
    plan.robot = options_.robot;
    plan.oldModel = options_.model.toStdString();
    plan.newModel = trained_.toStdString();
    plan.data = test_->text().toStdString();
    plan.settings = exploration_.options().settings;
    trainer_.compare(std::move(plan));
    enter(Phase::Comparing);
}

void TrainingPage::adopt()
{
    if (whyNotAdopt()) return;
    enter(Phase::Adopting);
    emit adopted(trained_);
}

void TrainingPage::adoptionDone()
{
    if (phase_ != Phase::Adopting) return;
    options_.model = std::exchange(trained_, QString());
    clearComparison();
    showStatus(tr("%1 is in use now").arg(format::fileName(options_.model)));
    enter(Phase::Idle);
}

void TrainingPage::adoptionFailed(const Message& why)
{
    if (phase_ != Phase::Adopting) return;
    showStatus(tr("Not adopted, the model in use stays: %1").arg(translated(why)), true);
    enter(Phase::Compared);
}

void TrainingPage::discard()
{
    if (!QFile::remove(trained_) && QFile::exists(trained_))
        return showStatus(tr("%1 could not be deleted: delete it by hand").arg(trained_), true);
    QFile::remove(QString::fromStdString(cardPath(trained_.toStdString())));
    showStatus(tr("%1 discarded").arg(format::fileName(trained_)));
    trained_.clear();
    clearComparison();
    name_->setText(freeName(options_.directory));
    enter(Phase::Idle);
}

void TrainingPage::ended(const QString& what, bool bad)
{
    showStatus(what, bad);
    enter(trained_.isEmpty() ? Phase::Idle : Phase::Trained);
}

void TrainingPage::showStatus(const QString& text, bool bad)
{
    status_->setText(text);
    setTone(*status_, bad ? Tone::Bad : Tone::Plain);
}

void TrainingPage::enter(Phase phase)
{
    phase_ = phase;
    const QString old = format::fileName(options_.model);
    newModel_->setText(trained_.isEmpty()
                           ? tr("in use: %1; no new model yet").arg(old)
                           : tr("in use: %1; new: %2").arg(old, format::fileName(trained_)));
    showProgress();
    showButtons();
}

void TrainingPage::showButtons()
{
    const auto offer = [](QPushButton* button, const std::optional<QString>& whyNot,
                          const QString& tip) {
        button->setEnabled(!whyNot);
        setTip(*button, whyNot.value_or(tip));
    };
    const auto busy = whyBusy(), whyNot = whyNotStart(), why = whyNotAdopt();
    const bool runs = phase_ == Phase::Training || phase_ == Phase::Comparing;
    offer(start_, busy ? busy : whyNot, tr("Trains the model in the background"));
    const bool mustShow = !scenes_->text().isEmpty() || status_->text().isEmpty();
    if (phase_ == Phase::Idle && whyNot && mustShow) showStatus(*whyNot);
    offer(cancel_, runs ? std::nullopt : std::optional(tr("No training or comparison is running.")),
          tr("Cancels the training or comparison; no file is written"));
    for (QWidget* field : std::initializer_list<QWidget*>{scenes_, name_, seed_})
        field->setEnabled(!busy);
    offer(chooseScenes_, busy, chooseScenes_->accessibleName());
    test_->setEnabled(phase_ != Phase::Comparing);
    offer(chooseTest_, phase_ == Phase::Comparing ? busy : std::nullopt,
          chooseTest_->accessibleName());
    offer(compare_, whyNotCompare(), tr("Estimate the test scenes with both models"));
    adopt_->setEnabled(!why);
    setTip(*adopt_, why.value_or(tr("Use the new model from now on")));
    offer(discard_, whyNotDiscard(), tr("Delete the new model's file"));
    if (const QString text = why.value_or(QString()); reason_->text() != text)
        reason_->setText(text);
    reason_->setVisible(why && !runs);  // while it trains or compares, the bar says so
}

void TrainingPage::refresh(double /*now*/)
{
    if (trainer_.busy()) showProgress();
    showButtons();
}

void TrainingPage::changeEvent(QEvent* event)
{
    Page::changeEvent(event);
    if (event->type() != QEvent::StyleChange || !bins_) return;
    keepRoomForStatus();
    showBins(trainer_.progress());
}

void TrainingPage::showProgress()
{
    const TrainingProgress progress = trainer_.progress();
    showBins(progress);
    QString text;
    int value = 0;
    if (trainer_.busy()) {
        value = static_cast<int>(kPerMille * std::clamp(progress.share, 0.0, 1.0));
        const auto left = progress.secondsLeft();
        const QString what =
            phase_ == Phase::Comparing ? tr("comparing: %1 %") : tr("training: %1 %");
        text = what.arg(format::percent(progress.share))
             + (left ? tr(", about %1 left").arg(format::countdown(*left))
                     : tr(", time left not known yet"));
    } else if (phase_ == Phase::Trained || phase_ == Phase::Compared) {
        value = kPerMille;
        text =
            tr("Idle · done (log-likelihood %1)").arg(format::number(logLikelihood(progress), 0));
    } else {
        text = tr("Idle");
    }
    if (bar_->value() != value) bar_->setValue(value);
    if (bar_->format() != text) bar_->setFormat(text);
}

void TrainingPage::showBins(const TrainingProgress& progress)
{
    for (int bin = 0; bin < kBins; ++bin)
        for (std::size_t kind = 0; kind < kTrainingKinds.size(); ++kind) {
            const auto& cell = progress.cells[static_cast<std::size_t>(bin)][kind];
            QTableWidgetItem* item = bins_->item(bin, 1 + static_cast<int>(kind));
            const QString text = cellText(cell, phase_ == Phase::Training);
            const QColor colour =
                cell.state == TrainingProgress::State::Waiting ? theme().muted : theme().text;
            QFont font = this->font();
            font.setBold(cell.state == TrainingProgress::State::Running);
            if (item->text() == text && item->foreground().color() == colour
                && item->font() == font)
                continue;
            item->setText(text);
            setTip(*item, cellTip(cell, text));
            item->setFont(font);
            item->setForeground(colour);
        }
}

void TrainingPage::showComparison(const ModelComparison& comparison)
{
    const auto rows = ComparisonWords::rows(comparison);
    for (int row = 0; row < rows.size(); ++row) {
        comparison_->item(row, kColumnBefore)->setText(rows[row].before);
        comparison_->item(row, kColumnAfter)->setText(rows[row].after);
        comparison_->item(row, kColumnDifference)->setText(rows[row].difference);
    }
    verdict_->setText(ComparisonWords::sentence(comparison));
    caution_->setText(ComparisonWords::caution(comparison));
    verdict_->setVisible(true);
    caution_->setVisible(!caution_->text().isEmpty());
    showStatus(tr("Compared on %1 scenes").arg(comparison.scenes));
}

void TrainingPage::clearComparison()
{
    for (int row = 0; row < comparison_->rowCount(); ++row)
        for (const int column : {kColumnBefore, kColumnAfter, kColumnDifference})
            comparison_->item(row, column)->setText(format::kNothing);
    verdict_->hide();
    caution_->hide();
}

}  // namespace terratact
