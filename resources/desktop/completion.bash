# Completion of terratact and terratact-console for bash 4 or later; needs nothing of bash-completion.

# Each of these adds to COMPREPLY what begins with $word.

# Files with one of the given suffixes, and folders.
_terratact_files() {
  local suffix
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
    compgen -d -- "$word"
    for suffix; do compgen -f -X "!*.$suffix" -- "$word"; done
  )
}

_terratact_words() {
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$*" -- "$word")
}

# Of a list with commas: what is before the last comma stays.
_terratact_list() {
  local before=
  [[ $word != *,* ]] || before=${word%,*},
  compopt -o nospace 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -P "$before" -W "$*" -- "${word##*,}")
}

# KIND:SENSORS of a sensor that lies or is lost; the other words, $@, come first.  A colon parts words where
# COMP_WORDBREAKS says so.
_terratact_faults() {
  local kinds="stuck stuck-at-scene zero offset drift spikes scatter flipped swapped swapped-axles late out-of-range \
    full-scale lost"
  local sensors="front-current rear-current currents front-left-current front-right-current rear-left-current \
    rear-right-current forces force-1 force-2 force-3 force-4 force-5 force-6 odometry all left-forces left-force-1 \
    left-force-2 left-force-3 left-force-4 left-force-5 left-force-6 right-forces right-force-1 right-force-2 \
    right-force-3 right-force-4 right-force-5 right-force-6"
  [[ "${COMP_WORDS[*]}" =~ \ lost\ ?: ]] ||  # the others cannot be lost
    sensors+=" pitch roll attitude front rear angles front-left front-right rear-left rear-right"
  if [[ $parted == : ]]; then
    _terratact_words "$sensors"
  elif [[ $word == *:* ]]; then
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -P "${word%%:*}:" -W "$sensors" -- "${word#*:}")
  else
    compopt -o nospace 2>/dev/null
    _terratact_words "$*"
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -S : -W "$kinds" -- "$word")
  fi
}

# CAN interfaces, which Linux gives the type 280.
_terratact_buses() {
  local type names=()
  for type in /sys/class/net/*/type; do
    [[ $(<"$type") != 280 ]] || names+=("$(basename "${type%/type}")")
  done 2>/dev/null
  _terratact_words "${names[@]}"
}

# COMPREPLY for the value of option $1 of command $2; fails where the option is a flag.
_terratact_value() {
  local methods="pa pac pafc pafac clearance joint local"
  case $2:$1 in
    *:--help | *:--version | *:-h | *:--full | *:--blocks | *:--matrix | *:--return | *:--exact-truth | simulate:--tracks | simulate:--floor-poses | reconstruct:--tracks | evaluate:--tracks | hazards:--tracks | hazards:--memory | hazards:--manoeuvres | *:--blind | "session scenes":--tracks | "session scenes":--drives | *:--probes | *:--missing | *:--lamps | *:--watch | \
      *:--summary | *:--transmit | *:--safe-mode | *:--errors-in-window | *:--no-record | *:--measured | *:--card | "session report":--mission | \
      "model show:--csv" | import:--probe | import:--check | truth:--scans | truth:--align) return 1 ;;
    *:--robot | *:--panel | *:--mapping) _terratact_files toml ;;
    *:--model | train:--plane) _terratact_files ttm ;;
    train:--tracks | train:--generated | train:--drives | train:--track-drives | evaluate:--drives | *:--data | *:--classes | *:--csv) _terratact_files csv ;;
    simulate:--out | reconstruct:--out | simulate:--poses | truth:--out | *:--support | truth:--scenes) _terratact_files csv ;;
    truth:--poses) _terratact_files tum txt csv mcap bag db3 ;;
    truth:--session) _terratact_files tts ;;
    truth:--decisions) _terratact_files csv ;;
    truth:--review) _terratact_files truth ;;
    *:--cloud) _terratact_files pcd ;;
    *:--recording) _terratact_files mcap ;;
    *:--sheet | *:--picture) _terratact_files png svg pdf ;;
    train:--out | merge:--out) _terratact_files ttm ttp ttn ;;
    evaluate:--trail) _terratact_files ttn ;;
    "session strip:--out") _terratact_files csv ply ;;
    "session merge:--out" | "session import:--out" | import:--out) _terratact_files tts ;;
    "session export:--out") _terratact_files log asc csv mcap ;;
    "session scenes:--out" | "session what-if:--out" | import:--scenes) _terratact_files csv ;;
    "session report:--out") _terratact_files pdf svg png html ;;
    *:--format) _terratact_words candump asc csv mcap ;;
    *:--what) _terratact_words frames signals estimates events ;;
    "robot check:--out") _terratact_files toml ;;
    "robot check:--recordings") _terratact_files tts ;;
    *:--out) _terratact_files ;;
    console:--terrain | robot:--terrain) _terratact_files csv && _terratact_words varied ;;
    "model card:--terrain" | *:--trained) ;;
    faults:--terrain) _terratact_files csv && _terratact_words boxes varied ;;
    *:--terrain) _terratact_files csv && _terratact_words boxes varied hazards ;;
    *:--replay) _terratact_files log asc trc csv gz ;;
    *:--dbc) _terratact_files dbc ;;
    *:--screenshot) _terratact_files png ;;
    *:--sessions) _terratact_files ;;
    *:--can | *:--interface) _terratact_buses ;;
    feel-forward:--method | strip:--method | "session what-if":--method) _terratact_words "$methods" trail ;;
    *:--method) _terratact_words "$methods" ;;
    evaluate:--methods | tradeoff:--methods) _terratact_list "$methods trail" ;;
    *:--ceiling) _terratact_words truncate clamp none ;;
    *:--contacts) _terratact_words isolated any none ;;
    *:--quality) _terratact_words fast balanced accurate ;;
    *:--precision) _terratact_words single double ;;
    *:--scan) _terratact_words forward reverse random ;;
    *:--protocol) _terratact_words terratact absolem ;;
    *:--theme) _terratact_words day night-red high-contrast ;;
    *:--layout) _terratact_words drive probe review ;;
    *:--language) _terratact_words en cs de ;;
    *:--length-unit) _terratact_words m cm ;;
    *:--angle-unit) _terratact_words deg rad ;;
    *:--fault) _terratact_faults none silence stuck-imu dead-element refuse-probe slow-arm reboot ;;
    *:--disturb)
      _terratact_faults none imu-noise forces-high forces-low dead-element soft-ground light-robot heavy-robot \
        friction-free
      ;;
    *:--*) ;;  # a number or a word of the user's own
    *) return 1 ;;
  esac
}

_terratact_options() {
  local estimates="--ceiling --contacts --threshold --sweeps --chains --burn-in --inducing --precision --quality
    --full --seconds --scan --hazard-rate --seed"
  case $1 in
    console) echo --version --model --robot --terrain --fault --can --transmit --replay --interface --at --speed --panel --dbc --seed \
      --screenshot --size --theme --layout --font-scale --language --length-unit --angle-unit --safe-mode --sessions --no-record --errors-in-window ;;
    simulate) echo --robot --terrain --out --seed --count --step --blocks --exact-truth --soft-drives --tracks --disturb \
      --drives --spacing --slip --drive-slip --pitch-bias --press-share --press-torque --gap \
      --cloud --poses --recording --floor-poses --cloud-noise --cloud-holes --cloud-offset --cloud-tilt --cloud-own ;;
    train) echo --robot --data --tracks --generated --plane --drives --track-drives --networks --epochs --out --seed --scanner-sd \
      --conditional-rows --bins --inducing ;;
    reconstruct) echo --robot --model --data --out --tracks --method "$estimates" ;;
    evaluate) echo --robot --model --data --drives --trail --out --methods --step-limit --card --shard --tracks --classes --class-column --probes --missing \
      "$estimates" ;;
    strip) echo --robot --model --terrain --drives --spacing --step --blocks --seed --method ;;
    hazards) echo --robot --model --drives --step-limit --rates --tracks --memory --manoeuvres --seed --method ;;
    feel-forward) echo --robot --model --drives --step-limit --estimate-seconds --blind --seed --method ;;
    tradeoff) echo --robot --model --data --out --methods --reference-sweeps --seed ;;
    merge) echo --robot --out ;;
    contacts) echo --robot --data --threshold ;;
    faults) echo --robot --model --terrain --drives --spacing --step --blocks --matrix --return --seed ;;
    probes) echo --data ;;
    calibrate) echo --data --robot ;;
    "model show") echo --csv ;;
    "model card") echo --trained --terrain ;;
    "model predict") echo --data ;;
    "panel check") echo --lamps --watch --seconds ;;
    demo) echo --robot --model --out --method "$estimates" ;;
    robot) echo --robot --can --terrain --fault --seed --speed --seconds ;;
    "robot check") echo --picture --recordings --out ;;
    "can decode") echo --interface --csv --summary --protocol --dbc ;;
    "can monitor") echo --seconds --bitrate --interface --speed --protocol --dbc ;;
    "session verify") echo --link ;;
    "session export") echo --out --format --what --from --to --dbc ;;
    "session recover") echo --out ;;
    "session scenes") echo --out --measured --tracks --drives ;;
    "session strip") echo --out --section ;;
    "session report") echo --scene --mission --dbc --out ;;
    "session merge") echo --out ;;
    "session what-if") echo --estimate --method --quality --threshold --seed --model --out ;;
    "session import") echo --out --interface --robot ;;
    import) echo --mapping --robot --out --scenes --probe --check ;;
    truth) echo --scenes --poses --mapping --topic --robot --scans --session --start --run --out --support --sheet --review --decisions --pose-mount \
      --sensor-mount --tf-base --percentile --max-sd --align --max-speed --max-gap ;;
    "") echo --version ;;
  esac
  echo --help
}

# What may stand where no option does.
_terratact_argument() {
  case $1 in
    "") _terratact_words simulate train reconstruct evaluate hazards strip feel-forward merge tradeoff contacts faults probes calibrate model panel \
      demo robot can session import truth ;;
    model) _terratact_words show card predict ;;
    panel | robot) _terratact_words check ;;
    can) _terratact_words decode monitor check ;;
    session) _terratact_words info list verify recover export scenes strip report merge what-if import ;;
    "session list") _terratact_files ;;
    "session import") _terratact_files log asc trc csv gz ;;
    "session "*) _terratact_files tts ;;
    import) _terratact_files mcap bag db3 csv ;;
    truth) _terratact_files pcd ply xyz csv txt pts mcap bag db3 ;;
    "model "*) _terratact_files ttm ;;
    "panel check" | "robot check") _terratact_files toml ;;
    "can check") _terratact_files log asc trc csv gz && _terratact_buses ;;
    "can monitor") _terratact_files log asc trc csv gz && _terratact_buses ;;
    "can decode" | console) _terratact_files log asc trc csv gz ;;
    merge) _terratact_files ttp tte ;;
  esac
}

_terratact() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= parted=
  if [[ $word == = ]]; then  # "--seed=" comes as two words, "--seed=1" as three
    word=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  elif [[ $word == : ]]; then  # "stuck:pi" comes as three words, too
    word= parted=: previous=${COMP_WORDS[COMP_CWORD - 2]}
  elif [[ $previous == : ]]; then
    parted=: previous=${COMP_WORDS[COMP_CWORD - 3]}
  fi
  if [[ $1 == *terratact-console ]]; then
    command=console
  elif [ "$COMP_CWORD" -gt 1 ] && [[ ${COMP_WORDS[1]} != -* ]]; then
    command=${COMP_WORDS[1]}
    if [[ $command =~ ^(model|panel|robot|can|session)$ ]] && [ "$COMP_CWORD" -gt 2 ] && [[ ${COMP_WORDS[2]} != -* ]]; then
      command+=" ${COMP_WORDS[2]}"
    fi
  fi
  COMPREPLY=()
  _terratact_value "$previous" "$command" && return
  if [[ $word == -* ]]; then
    _terratact_words "$(_terratact_options "$command")"
  else
    _terratact_argument "$command"
  fi
}

complete -F _terratact terratact terratact-console
