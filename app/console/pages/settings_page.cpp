#include "app/console/pages/settings_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/display/units.h"
#include "app/mission/text/method_text.h"
#include "app/mission/text/preset_text.h"
#include "app/shell/file_dialog.h"
#include "app/shell/font_fit.h"
#include "app/shell/number_box.h"
#include "app/shell/second_press.h"
#include "widgets/base/card.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

namespace terratact {
namespace {

const std::array<QString, 4> kLanguages{QString(), QStringLiteral("en"), QStringLiteral("cs"),
                                        QStringLiteral("de")};

template <class Range, class Value>
int indexOf(const Range& range, const Value& value)
{
    const auto found = std::find(std::begin(range), std::end(range), value);
    return found == std::end(range) ? 0 : static_cast<int>(found - std::begin(range));
}

QString chooseTip()
{
    return SettingsPage::tr("Use this file from now on");
}

QString shippedTip()
{
    return SettingsPage::tr("Back to the shipped file");
}

QString shippedInUseTip()
{
    return SettingsPage::tr("The shipped files are in use already");
}

QString reopensTip()
{
    return SettingsPage::tr("Restarts the console");
}

QString defaultsTip()
{
    return SettingsPage::tr("Resets this page, the model and the robot to their defaults");
}

}  // namespace

SettingsPage::SettingsPage(PreferenceStore& store, QWidget* parent) : Page(parent), store_(store)
{
    const auto card = [this](const QString& title) {
        auto* made = new Card(title, this);
        auto* form = new QFormLayout;
        form->setHorizontalSpacing(16);
        form->setVerticalSpacing(8);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        form->setRowWrapPolicy(QFormLayout::WrapLongRows);  // on a small screen
        made->body()->addLayout(form);
        made->body()->addStretch(1);
        return std::pair(made, form);
    };
    const auto [estimate, estimateForm] = card(tr("Estimate"));
    buildEstimate(estimateForm);
    const auto [look, lookForm] = card(tr("Look and sound"));
    buildLook(lookForm);
    defaults_ = new QPushButton(tr("Restore all defaults"), look);
    setTip(*defaults_, defaultsTip());
    files_ = new QPushButton(tr("Profiles, export and import …"), look);
    setTip(*files_, tr("All settings as named profiles or as one file (Ctrl+,)"));
    connect(files_, &QPushButton::clicked, this, &SettingsPage::filesWanted);
    look->body()->addWidget(files_);
    look->body()->addWidget(defaults_);
    auto* asks = new SecondPress(*defaults_, tr("Press again to reset all settings"));
    connect(asks, &SecondPress::confirmed, this, [this] {
        store_.change([](Preferences& p) {
            Preferences plain;
            plain.window = p.window;
            plain.dbc = p.dbc;
            plain.pad = p.pad;  // the page Gamepad resets it
            p = plain;
        });
    });

    const auto [recording, recordingForm] = card(tr("Recording"));
    buildRecording(recordingForm);

    auto* right = new QVBoxLayout;
    right->setSpacing(10);
    right->addWidget(look);
    right->addWidget(recording);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(10);
    columns->addWidget(estimate, 1);
    columns->addLayout(right, 1);
    auto* inside = new QWidget;
    auto* all = new QVBoxLayout(inside);
    all->setContentsMargins(12, 10, 12, 10);
    all->setSpacing(10);
    all->addLayout(columns);
    all->addWidget(buildFiles());
    all->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setAccessibleName(tr("Settings"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(inside);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    show();
    connect(&store_, &PreferenceStore::changed, this, &SettingsPage::show);
}

void SettingsPage::change(const std::function<void(Preferences&)>& edit)
{
    if (!showing_) store_.change(edit);
}

QComboBox* SettingsPage::choice(QFormLayout* form, const QString& label, const QStringList& names,
                                const QString& tip, std::function<int(const Preferences&)> get,
                                std::function<void(Preferences&, std::size_t)> set)
{
    auto* box = new QComboBox(this);
    box->addItems(names);
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(label);
    setTip(*box, tip);
    addField(*form, label, box);
    shows_.emplace_back(
        [box, get = std::move(get)](const Preferences& p) { box->setCurrentIndex(get(p)); });
    connect(box, &QComboBox::currentIndexChanged, this, [this, set = std::move(set)](int index) {
        if (index >= 0) change([&](Preferences& p) { set(p, static_cast<std::size_t>(index)); });
    });
    return box;
}

QDoubleSpinBox* SettingsPage::number(QFormLayout* form, const QString& label, PreferenceRange range,
                                     int decimals, const QString& suffix, const QString& tip,
                                     double Preferences::*value, double unit)
{
    QDoubleSpinBox* box = numberBox(this, {label, range, decimals, suffix, tip, unit});
    addField(*form, label, box);
    shows_.emplace_back([=](const Preferences& p) { box->setValue(p.*value / unit); });
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [=, this](double shown) { change([&](Preferences& p) { p.*value = shown * unit; }); });
    return box;
}

QDoubleSpinBox* SettingsPage::number(QFormLayout* form, const QString& label, PreferenceRange range,
                                     ShownIn quantity, const QString& tip,
                                     double Preferences::*value)
{
    if (quantity == ShownIn::Angle) {
        const bool isRadian = units().angle == AngleUnit::Radian;
        return number(form, label, range, isRadian ? 3 : 1,
                      isRadian ? QStringLiteral("rad") : QStringLiteral("°"), tip, value,
                      isRadian ? 1.0 : kDegree);
    }
    const bool isCentimetre = units().length == LengthUnit::Centimetre;
    return number(form, label, range, isCentimetre ? 0 : 2, format::lengthUnit(), tip, value,
                  isCentimetre ? kPercent : 1.0);
}

QSpinBox* SettingsPage::whole(QFormLayout* form, const QString& label, int least, int most,
                              const QString& suffix, const QString& tip, int Preferences::*value)
{
    auto* box = new RoomyBox<QSpinBox>(this);
    box->setRange(least, most);
    box->setSuffix(QLatin1Char(' ') + suffix);
    box->setKeyboardTracking(false);
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(label);
    setTip(*box, tip);
    addField(*form, label, box);
    shows_.emplace_back([=](const Preferences& p) { box->setValue(p.*value); });
    connect(box, &QSpinBox::valueChanged, this,
            [=, this](int shown) { change([&](Preferences& p) { p.*value = shown; }); });
    return box;
}

QCheckBox* SettingsPage::flag(QFormLayout* form, const QString& text, const QString& tip,
                              bool Preferences::*value)
{
    auto* box = new QCheckBox(text, this);
    box->setMinimumHeight(kTarget);
    setTip(*box, tip);
    addField(*form, QString(), box);
    shows_.emplace_back([=](const Preferences& p) { box->setChecked(p.*value); });
    connect(box, &QCheckBox::toggled, this,
            [=, this](bool shown) { change([&](Preferences& p) { p.*value = shown; }); });
    return box;
}

void SettingsPage::buildEstimate(QFormLayout* form)
{
    QStringList methods, presets;
    for (const Method method : offeredMethods()) methods << format::text(name(method));
    for (const QualityPreset preset : kQualityPresets) presets << translated(describe(preset));
    method_ = choice(
        form, tr("Method"), methods, methodLines(offeredMethods()),
        [](const Preferences& p) { return indexOf(offeredMethods(), p.method); },
        [](Preferences& p, std::size_t i) { p.method = offeredMethods().at(i); });
    auto* uses = new PlainLabel(this);
    setTone(*uses, Tone::Muted);
    uses->setWordWrap(true);
    uses->setObjectName(QStringLiteral("methodUses"));
    uses->setAccessibleName(tr("What the method uses"));
    addField(*form, QString(), uses);
    shows_.emplace_back([uses](const Preferences& p) { uses->setText(methodUses(p.method)); });
    quality_ = choice(
        form, tr("Quality"), presets,
        tr("Measured by terratact tradeoff: time, mean error, and in brackets the distance of the "
           "quantiles from a long run's"),
        [](const Preferences& p) { return indexOf(kQualityPresets, p.preset); },
        [](Preferences& p, std::size_t i) { p.preset = kQualityPresets.at(i); });
    seconds_ = whole(form, tr("An estimate may take at most"), 0, kMaxEstimateSeconds, tr("s"),
                     tr("Sampling then ends with fewer draws, and the result says so"),
                     &Preferences::estimateSeconds);
    seconds_->setSpecialValueText(tr("no limit"));
    obstacle_ = number(form, tr("An obstacle is a step above"), kObstacleRange, ShownIn::Length,
                       tr("Step height that the verdict asks about (PgUp, PgDown)"),
                       &Preferences::obstacleLimit);
    threshold_ = number(form, tr("An element counts as contact above"), kForceRange, 1, tr("N"),
                        tr("Weaker forces count as noise"), &Preferences::forceThreshold);
    probes_ = choice(
        form, tr("The arm is offered"),
        {tr("where the terrain is uncertain"), tr("there, unless the verdict is decided"),
         tr("where it helps the verdict")},
        tr("Uncertain: by the variance, as in the paper. About the verdict: by the entropy of the "
           "step question, and only while it is open"),
        [](const Preferences& p) { return indexOf(kProbePolicies, p.probes); },
        [](Preferences& p, std::size_t i) { p.probes = kProbePolicies.at(i); });
    number(form, tr("The arm is offered above a sd of"), kProbeAboveRange, ShownIn::Length,
           tr("A bin less certain than this asks for a probe"), &Preferences::probeAbove);
    number(
        form,
        tr("Rate of hazards per %1 of ground that is not felt").arg(format::length(kBinWidth, 1)),
        kHazardRateRange, 1, tr("%"),
        tr("Drops and walls. At 5 % or more, CLEAR needs every bin felt up to the front flippers' "
           "reach; lower rates accept ground that the flippers span"),
        &Preferences::hazardRate, kPercent);
    number(form, tr("The verdict is withheld above a roll of"), kRollRange, ShownIn::Angle,
           tr("Then left and right ground differ"), &Preferences::rollLimit);
    number(form, tr("… or left and right flippers differ by"), kAsymmetryRange, ShownIn::Angle,
           tr("Then left and right ground differ"), &Preferences::asymmetryLimit);
    number(form, tr("Pitch or roll is steep from"), kTiltRange, ShownIn::Angle,
           tr("Amber alarm; at the latest %1 before the robot tips over")
               .arg(format::plainAngle(kAmberReserve, 0)),
           &Preferences::tiltAmber);
    number(form, tr("Pitch or roll is dangerous from"), kTiltRange, ShownIn::Angle,
           tr("Red alarm with sound; at the latest %1 before the robot tips over")
               .arg(format::plainAngle(kRedReserve, 0)),
           &Preferences::tiltRed);
}

void SettingsPage::buildLook(QFormLayout* form)
{
    theme_ = choice(
        form, tr("Theme"), {tr("day"), tr("night, red"), tr("high contrast")},
        tr("Night, red: keeps the eyes adapted to the dark"),
        [](const Preferences& p) { return static_cast<int>(p.theme); },
        [](Preferences& p, std::size_t i) { p.theme = static_cast<ThemeName>(i); });
    whole(form, tr("Size of text"), kSmallestFont, kLargestFont, QStringLiteral("%"),
          tr("Ctrl + and Ctrl −"), &Preferences::fontScale)
        ->setSingleStep(10);
    fontNote_ = new PlainLabel(this);
    setTone(*fontNote_, Tone::Warning);
    fontNote_->setWordWrap(true);
    fontNote_->hide();
    addField(*form, QString(), fontNote_);
    language_ = choice(
        form, tr("Language"),
        {tr("the system's"), QStringLiteral("English"), QStringLiteral("Čeština"),
         QStringLiteral("Deutsch")},
        reopensTip(), [](const Preferences& p) { return indexOf(kLanguages, p.language); },
        [](Preferences& p, std::size_t i) { p.language = kLanguages.at(i); });
    lengths_ = choice(
        form, tr("Lengths"), {tr("metres"), tr("centimetres")}, reopensTip(),
        [](const Preferences& p) { return static_cast<int>(p.units.length); },
        [](Preferences& p, std::size_t i) { p.units.length = static_cast<LengthUnit>(i); });
    angles_ = choice(
        form, tr("Angles"), {tr("degrees"), tr("radians")}, reopensTip(),
        [](const Preferences& p) { return static_cast<int>(p.units.angle); },
        [](Preferences& p, std::size_t i) { p.units.angle = static_cast<AngleUnit>(i); });
    choice(
        form, tr("Layout"), {tr("Drive"), tr("Probe"), tr("Review")},
        tr("What the terrain page makes large"),
        [](const Preferences& p) { return static_cast<int>(p.layout); },
        [](Preferences& p, std::size_t i) { p.layout = static_cast<Layout>(i); });
    flag(form, tr("Alarm sound"), tr("Off: alarms are only seen"), &Preferences::sound);
    whole(form, tr("Contact tick volume"), 0, 100, tr("%"),
          tr("Ticks while a flipper touches the ground: higher towards the tip, faster with the "
             "force"),
          &Preferences::contactSound)
        ->setSpecialValueText(tr("off"));
}

void SettingsPage::buildRecording(QFormLayout* form)
{
    record_ =
        flag(form, tr("Everything is recorded"),
             tr("Frames, scenes, estimates, what was shown and decided, in one file per session"),
             &Preferences::record);
    whole(form, tr("Delete a session after"), 0, kMaxDays, tr("days"),
          tr("Applies ten seconds after the change. Never: nothing is deleted"),
          &Preferences::keepDays)
        ->setSpecialValueText(tr("never"));
    whole(form, tr("Delete the oldest beyond"), 0, kMaxGigabytes, tr("GB"),
          tr("For all closed sessions together; applies ten seconds after the change"),
          &Preferences::keepGigabytes)
        ->setSpecialValueText(tr("never"));
    flag(form, tr("Sessions beyond these limits may be deleted"),
         tr("Until this is ticked, the console only lists what it would delete"),
         &Preferences::mayDelete);
}

QWidget* SettingsPage::buildFiles()
{
    auto* card = new Card(tr("Model and robot"), this);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setColumnStretch(0, 1);
    const auto file = [&](int row, const QString& name, QLabel*& text, QPushButton*& choose,
                          QPushButton*& shipped) {
        text = new PlainLabel(card);
        text->setAccessibleName(name);
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        choose = new QPushButton(tr("Choose a file …"), card);
        choose->setAccessibleName(tr("Choose a file: %1").arg(name));
        setTip(*choose, chooseTip());
        shipped = new QPushButton(tr("Shipped"), card);
        shipped->setAccessibleName(tr("Shipped: %1").arg(name));
        setTip(*shipped, shippedTip());
        grid->addWidget(text, row, 0);
        grid->addWidget(choose, row, 1, Qt::AlignTop);
        grid->addWidget(shipped, row, 2, Qt::AlignTop);
    };
    file(0, tr("Model"), model_, chooseModel_, shippedModel_);
    file(1, tr("Robot"), robot_, chooseRobot_, shippedRobot_);
    card->body()->addLayout(grid);
    auto* connects = new QPushButton(tr("Connect to a bus, log or session …"), card);
    setTip(*connects, tr("Connections, their faults and repairs (Ctrl+L)"));
    connect(connects, &QPushButton::clicked, this, &SettingsPage::connectWanted);
    card->body()->addWidget(connects, 0, Qt::AlignLeft);
    connect(chooseModel_, &QPushButton::clicked, this, [this] {
        askForFile(
            *this,
            {.title = tr("Model"), .start = store_.current().model, .filter = tr("Models (*.ttm)")},
            [this](const QString& path) {
                store_.change([path](Preferences& p) { p.model = path; });
            });
    });
    connect(chooseRobot_, &QPushButton::clicked, this, [this] {
        askForFile(*this,
                   {.title = tr("Robot"),
                    .start = store_.current().robot,
                    .filter = tr("Robots (*.toml)")},
                   [this](const QString& path) { emit robotChosen(path); });
    });
    const auto forget = [this](QString Preferences::*which) {
        store_.change([which](Preferences& p) { (p.*which).clear(); });
    };
    connect(shippedModel_, &QPushButton::clicked, this, [forget] { forget(&Preferences::model); });
    connect(shippedRobot_, &QPushButton::clicked, this, [forget] { forget(&Preferences::robot); });
    return card;
}

void SettingsPage::show()
{
    showing_ = true;
    for (const auto& showOne : shows_) showOne(store_.current());
    showing_ = false;
    showCosts();
}

void SettingsPage::showCosts()
{
    const QSignalBlocker quiet(quality_);
    const QStringList entries = presetEntries(store_.current().method, presets_);
    for (int i = 0; i < quality_->count(); ++i) quality_->setItemText(i, entries.at(i));
}

void SettingsPage::setPresets(std::vector<PresetCost> presets)
{
    presets_ = std::move(presets);
    showCosts();
}

void SettingsPage::setModelCard(const QString& card)
{
    if (model_->text() != card) model_->setText(card);
}

void SettingsPage::setRobotCard(const QString& card)
{
    if (robot_->text() != card) robot_->setText(card);
}

void SettingsPage::setReopenBlocked(const QString& why)
{
    const auto block = [&why](QWidget* control, const QString& tip, bool mayBe = true) {
        control->setEnabled(why.isEmpty() && mayBe);
        setTip(*control, why.isEmpty() ? tip : why);
    };
    block(chooseRobot_, chooseTip());
    const bool own = !store_.current().robot.isEmpty();
    block(shippedRobot_, own ? shippedTip() : shippedInUseTip(), own);
    block(defaults_, defaultsTip());
    for (QComboBox* const box : {language_, lengths_, angles_}) block(box, reopensTip());
}

QString SettingsPage::modelCard() const
{
    return model_->text();
}

void SettingsPage::refresh(double /*now*/)
{
    const bool own = !store_.current().model.isEmpty();
    shippedModel_->setEnabled(own);
    setTip(*shippedModel_, own ? shippedTip() : shippedInUseTip());
    fontNote_->setText(terratact::fontNote(store_.current().fontScale));
    fontNote_->setVisible(!fontNote_->text().isEmpty());
}

}  // namespace terratact
