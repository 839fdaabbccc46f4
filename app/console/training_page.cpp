#include "app/console/training_page.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/mission/comparison_text.h"
#include "app/mission/exploration.h"
#include "app/shell/file_dialog.h"
#include "core/learn/model/model_card.h"
#include "display/format.h"
#include "widgets/base/card.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

constexpr int kColumnBefore = 1, kColumnAfter = 2, kColumnDifference = 3;
constexpr int kPerMille = 1000;  // range of the progress bar

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
             ? TrainingPage::tr("done %1").arg(format::number(*cell.logLikelihood, 0))
             : TrainingPage::tr("done");
}

QTableWidget* makeTable(int rows, const QStringList& columns, const QString& name, QWidget* parent)
{
    auto* table = new HeadedTable(rows, static_cast<int>(columns.size()), parent);
    table->setAccessibleName(name);
    table->setHorizontalHeaderLabels(columns);
    table->verticalHeader()->hide();
    table->verticalHeader()->setMinimumSectionSize(20);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setHighlightSections(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->setAlternatingRowColors(true);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight)
                                   | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    return table;
}

QPushButton* makeButton(const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setAccessibleName(text);
    button->setFocusPolicy(Qt::TabFocus);
    setTip(*button, tip);
    return button;
}

QLabel* makeSentence(const QString& name, QWidget* parent)
{
    auto* label = new PlainLabel(parent);
    label->setWordWrap(true);
    label->setAccessibleName(name);
    return label;
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

QPushButton* TrainingPage::addFile(QBoxLayout* column, const QString& what, const QString& title,
                                   QLineEdit*& field)
{
    field = new QLineEdit(this);
    field->setAccessibleName(title);
    field->setMinimumHeight(kTarget);
    field->setPlaceholderText(tr("scenes as CSV, with heights"));
    auto* label = new PlainLabel(what, this);
    label->setBuddy(field);
    auto* button = makeButton(tr("Choose …"), title, this);
    button->setAccessibleName(title);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(field, 1);
    row->addWidget(button);
    column->addLayout(row);
    connect(button, &QPushButton::clicked, this, [this, field, title] { choose(field, title); });
    return button;
}

QWidget* TrainingPage::trainCard()
{
    auto* card = new Card(tr("1  Train a new model"), this);
    card->note()->setText(tr("robot: the one in use"));
    chooseScenes_ =
        addFile(card->body(), tr("Learn from"), tr("Choose the scenes to learn from"), scenes_);
    name_ = new QLineEdit(freeName(options_.directory), card);
    name_->setAccessibleName(tr("Name of the new model"));
    name_->setMinimumHeight(kTarget);
    name_->setMaxLength(60);
    name_->setValidator(new QRegularExpressionValidator(
        QRegularExpression(QStringLiteral("[A-Za-z0-9_][A-Za-z0-9_.-]*")), name_));
    setTip(*name_,
           tr("Letters, digits, - _ and .; the file is %1/NAME.ttm").arg(options_.directory));
    seed_ = new QSpinBox(card);
    seed_->setRange(0, std::numeric_limits<int>::max());
    seed_->setValue(1);
    seed_->setMinimumHeight(kTarget);
    seed_->setAccessibleName(tr("Seed of the search"));
    setTip(*seed_, tr("Same scenes and seed: the same model"));
    start_ = makeButton(tr("Start"), {}, card);  // showButtons() sets the tips
    start_->setProperty("role", "primary");
    cancel_ = makeButton(tr("Cancel"), {}, card);
    auto* what = new QHBoxLayout;
    what->setSpacing(8);
    auto* nameLabel = new PlainLabel(tr("Name"), card);
    nameLabel->setBuddy(name_);
    auto* seedLabel = new PlainLabel(tr("Seed"), card);
    seedLabel->setBuddy(seed_);
    what->addWidget(nameLabel);
    what->addWidget(name_, 1);
    what->addWidget(seedLabel);
    what->addWidget(seed_);
    what->addWidget(start_);
    what->addWidget(cancel_);
    card->body()->addLayout(what);

    bar_ = new QProgressBar(card);
    bar_->setRange(0, kPerMille);
    bar_->setAccessibleName(tr("Progress"));
    status_ = makeSentence(tr("State of the training"), card);
    status_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    keepRoomForStatus();
    card->body()->addWidget(bar_);
    card->body()->addWidget(status_);

    bins_ =
        makeTable(kBins,
                  {tr("bin"), tr("with\nforces"), tr("without\nforces"), tr("surface\nbelow robot"),
                   tr("surface\nahead"), tr("clearance\nbelow robot"), tr("clearance\nahead")},
                  tr("Training, bin by bin"), card);
    const QStringList tips{
        tr("Centre of the bin"),
        tr("Gaussian process given pose, currents and forces, and its log likelihood"),
        tr("Gaussian process given the pose alone, and its log likelihood"),
        tr("Surface where the robot is above the bin"),
        tr("Surface elsewhere"),
        tr("Clearance given the other bins, where the robot is above the bin; log likelihood"),
        tr("The same elsewhere"),
    };
    for (int column = 0; column < tips.size(); ++column)
        setTip(*bins_->horizontalHeaderItem(column), tips[column]);
    for (int bin = 0; bin < kBins; ++bin) bins_->item(bin, 0)->setText(format::binName(bin));
    for (const int wide : {0, 3, 5, 6})  // columns with names
        bins_->horizontalHeader()->setSectionResizeMode(wide, QHeaderView::ResizeToContents);
    card->body()->addWidget(bins_, 1);
    return card;
}

/// Reserves the status's height, so that the table does not move.
void TrainingPage::keepRoomForStatus()
{
    status_->setMinimumHeight(2 * fontMetrics().lineSpacing());
}

QWidget* TrainingPage::compareCard()
{
    auto* card = new Card(tr("2  Compare it with the one in use, then adopt it"), this);
    card->note()->hide();
    newModel_ = makeSentence(tr("Models"), card);
    card->body()->addWidget(newModel_);
    chooseTest_ = addFile(card->body(), tr("Test on"), tr("Choose the scenes to test on"), test_);
    compare_ = makeButton(tr("Compare"), {}, card);
    card->body()->addWidget(compare_);
    const auto rows = ComparisonWords::rows({});
    comparison_ = makeTable(static_cast<int>(rows.size()),
                            {tr("error"), tr("old"), tr("new"), tr("new − old")},
                            tr("Old and new model"), card);
    for (int number = 1; number <= kColumnDifference; ++number)
        comparison_->horizontalHeader()->setSectionResizeMode(number,
                                                              QHeaderView::ResizeToContents);
    for (int row = 0; row < rows.size(); ++row) {
        comparison_->item(row, 0)->setText(rows[row].what);
        setTip(*comparison_->item(row, 0), rows[row].what);
    }
    card->body()->addWidget(comparison_, 1);
    verdict_ = makeSentence(tr("Outcome"), card);
    setTone(*verdict_, Tone::Strong);
    caution_ = makeSentence(tr("What to keep in mind"), card);
    setTone(*caution_, Tone::Doubt);
    reason_ = makeSentence(tr("Why not"), card);
    setTone(*reason_, Tone::Muted);
    adopt_ = new HoldToConfirmButton(tr("Adopt (hold)"), &Theme::decide, card);
    adopt_->setAccessibleName(tr("Use the new model from now on"));
    adopt_->setFocusPolicy(Qt::TabFocus);
    discard_ = new HoldToConfirmButton(tr("Discard (hold)"), &Theme::caution, card);
    discard_->setAccessibleName(tr("Discard the new model"));
    discard_->setFocusPolicy(Qt::TabFocus);
    auto* decide = new QHBoxLayout;
    decide->setSpacing(8);
    decide->addWidget(adopt_, 1);
    decide->addWidget(discard_, 1);
    for (QWidget* widget : {verdict_, caution_, reason_}) card->body()->addWidget(widget);
    card->body()->addLayout(decide);
    clearComparison();
    return card;
}

void TrainingPage::connectTrainer()
{
    connect(&trainer_, &ModelTrainer::noticed, this, [this](const QString& text) { say(text); });
    connect(&trainer_, &ModelTrainer::trained, this, [this](const QString& path, int scenes) {
        trained_ = path;
        showProgress();
        say(tr("Trained on %1 scenes: %2").arg(scenes).arg(path));
        name_->setText(freeName(options_.directory));
        enter(Phase::Trained);
    });
    connect(&trainer_, &ModelTrainer::compared, this, [this](const ModelComparison& comparison) {
        showComparison(comparison);
        enter(Phase::Compared);
    });
    connect(&trainer_, &ModelTrainer::failed, this, [this](const QString& why) {
        ended(phase_ == Phase::Training
                  ? tr("%1. Nothing was written: put that right and start again.").arg(why)
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

QString TrainingPage::whyNotStart() const
{
    if (scenes_->text().isEmpty()) return tr("Choose a file of scenes to learn from.");
    if (!name_->hasAcceptableInput()) return tr("Give the new model a name.");
    if (QFileInfo::exists(pathOfName()))
        return tr("%1 exists already: choose another name.").arg(pathOfName());
    return {};
}

QString TrainingPage::whyBusy() const
{
    switch (phase_) {
    case Phase::Training: return tr("A model is being trained: cancel that first.");
    case Phase::Comparing: return tr("Two models are being compared: cancel that first.");
    case Phase::Adopting: return tr("Loading the new model …");
    case Phase::Idle:
    case Phase::Trained:
    case Phase::Compared: break;
    }
    return {};
}

QString TrainingPage::whyNotDiscard() const
{
    if (QString why = whyBusy(); !why.isEmpty()) return why;
    return trained_.isEmpty() ? tr("There is no new model.") : QString();
}

QString TrainingPage::whyNotCompare() const
{
    if (QString why = whyBusy(); !why.isEmpty()) return why;
    if (trained_.isEmpty()) return tr("Train a model first.");
    return test_->text().isEmpty() ? tr("Choose a file of scenes to test on.") : QString();
}

QString TrainingPage::whyNotAdopt() const
{
    if (phase_ == Phase::Adopting) return whyBusy();
    if (trained_.isEmpty()) return tr("Train a model first.");
    if (phase_ == Phase::Training || phase_ == Phase::Comparing) return {};
    if (phase_ != Phase::Compared) return tr("Compare the new model before it is adopted.");
    if (exploring(exploration_.state().phase))
        return tr("An exploration is running: the model stays until it has ended (Esc ends it).");
    return {};
}

void TrainingPage::start()
{
    const std::string file = scenes_->text().toStdString();
    trained_.clear();
    clearComparison();
    say(tr("Training on %1; the robot goes on meanwhile").arg(scenes_->text()));
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
    if (!whyNotAdopt().isEmpty()) return;
    enter(Phase::Adopting);
    emit adopted(trained_);
}

void TrainingPage::adoptionDone()
{
    if (phase_ != Phase::Adopting) return;
    options_.model = std::exchange(trained_, QString());
    clearComparison();
    say(tr("%1 is in use now").arg(format::fileName(options_.model)));
    enter(Phase::Idle);
    emit adoptionFinished(options_.model);
}

void TrainingPage::adoptionFailed(const QString& why)
{
    if (phase_ != Phase::Adopting) return;
    say(tr("Not adopted, the model in use stays: %1").arg(why), true);
    enter(Phase::Compared);
}

void TrainingPage::discard()
{
    if (!QFile::remove(trained_) && QFile::exists(trained_))
        return say(tr("%1 could not be deleted: delete it by hand").arg(trained_), true);
    QFile::remove(QString::fromStdString(cardPath(trained_.toStdString())));
    say(tr("%1 discarded").arg(format::fileName(trained_)));
    trained_.clear();
    clearComparison();
    name_->setText(freeName(options_.directory));
    enter(Phase::Idle);
}

void TrainingPage::ended(const QString& what, bool bad)
{
    say(what, bad);
    enter(trained_.isEmpty() ? Phase::Idle : Phase::Trained);
}

void TrainingPage::say(const QString& text, bool bad)
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
    const auto offer = [](QPushButton* button, const QString& whyNot, const QString& tip) {
        button->setEnabled(whyNot.isEmpty());
        setTip(*button, whyNot.isEmpty() ? tip : whyNot);
    };
    const QString busy = whyBusy(), whyNot = whyNotStart(), why = whyNotAdopt();
    const bool runs = phase_ == Phase::Training || phase_ == Phase::Comparing;
    offer(start_, busy.isEmpty() ? whyNot : busy, tr("Train the model, beside everything else"));
    if (phase_ == Phase::Idle && !whyNot.isEmpty() && !scenes_->text().isEmpty()) say(whyNot);
    if (phase_ == Phase::Idle && status_->text().isEmpty()) say(whyNot);
    offer(cancel_, runs ? QString() : tr("Nothing runs that could be cancelled."),
          tr("End what runs; nothing is written"));
    for (QWidget* field : std::initializer_list<QWidget*>{scenes_, name_, seed_})
        field->setEnabled(busy.isEmpty());
    offer(chooseScenes_, busy, chooseScenes_->accessibleName());
    test_->setEnabled(phase_ != Phase::Comparing);
    offer(chooseTest_, phase_ == Phase::Comparing ? busy : QString(),
          chooseTest_->accessibleName());
    offer(compare_, whyNotCompare(), tr("Estimate the test scenes with both models"));
    adopt_->setEnabled(phase_ == Phase::Compared && why.isEmpty());
    setTip(*adopt_, !why.isEmpty() ? why : runs ? busy : tr("Use the new model from now on"));
    offer(discard_, whyNotDiscard(), tr("Delete the new model's file"));
    if (reason_->text() != why) reason_->setText(why);
    reason_->setVisible(!why.isEmpty());
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
        text = phase_ == Phase::Trained ? tr("trained") : tr("compared");
    } else {
        text = tr("nothing runs");
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
            setTip(*item, text);  // the column may be too narrow for the text
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
    say(tr("Compared on %1 scenes").arg(comparison.scenes));
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
