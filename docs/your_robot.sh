#!/bin/bash
# Runs the commands of docs/your_robot.md in order: from a recording and a laser map to a model and its evaluation.
# Usage: docs/your_robot.sh path/to/terratact FOLDER [SCENES]
#   FOLDER   a new folder for every file
#   SCENES   of each simulation, default 400: some minutes on two cores
set -euo pipefail
terratact=$(realpath "$1")
folder=$2
scenes=${3:-400}
here=$(realpath "$(dirname "$0")")
mkdir "$folder"
cd "$folder"
ln -s "$here/../resources" resources
PATH=$(dirname "$terratact"):$PATH
sed -n 's/^    \$ //p' "$here/your_robot.md" | sed -E "s/--count [0-9]+/--count $scenes/" >commands
while IFS= read -r command <&3; do
  echo "\$ $command"
  case $command in
    *--probe) eval "$command" | tail -n 60 ;;
    *--check) eval "$command" || true ;;  # doubts are listed and fail it
    *) eval "$command" ;;
  esac
done 3<commands
